package simpleray.scene;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The keys of one thing, and what it is between them. <em>Constant.</em> Any thread may call. */
final class Track {
    /** A key's place depends on this many keys on each side of it. */
    private static final int NEIGHBOURS = 3;
    /** Numbers that differ by a smaller share are equal but for rounding. */
    private static final double ROUNDING = 1e-12;
    /** The number of points at which two cubics are compared: four equal ones make them equal. */
    private static final int POINTS = 4;

    /** The thing. */
    final Key.Thing thing;

    private final double[] frames;
    private final double[][] values;
    private final int[] places;

    private Track(List<Key> all, List<Integer> ofThing) {
        thing = all.get(ofThing.get(0)).thing();
        places = ofThing.stream().sorted(Comparator.comparingDouble(i -> all.get(i).frame())).mapToInt(i -> i).toArray();
        frames = Arrays.stream(places).mapToDouble(i -> all.get(i).frame()).toArray();
        values = Arrays.stream(places).mapToObj(i -> all.get(i).values().stream().mapToDouble(v -> v).toArray()).toArray(double[][]::new);
    }

    private Track(Track of, List<Integer> some) {
        thing = of.thing;
        places = some.stream().mapToInt(key -> of.places[key]).toArray();
        frames = some.stream().mapToDouble(key -> of.frames[key]).toArray();
        values = some.stream().map(key -> of.values[key]).toArray(double[][]::new);
    }

    /** {@return the tracks of the things that have keys, in the order of their first ones} */
    static List<Track> of(List<Key> keys) {
        Map<Key.Thing, List<Integer>> byThing = new LinkedHashMap<>();
        for (int i = 0; i < keys.size(); i++) {
            byThing.computeIfAbsent(keys.get(i).thing(), thing -> new ArrayList<>()).add(i);
        }
        List<Track> tracks = new ArrayList<>();
        byThing.values().forEach(ofThing -> tracks.add(new Track(keys, ofThing)));
        return tracks;
    }

    /** {@return the number of keys} */
    int size() {
        return frames.length;
    }

    /** {@return the frame of a key; keys are counted from 0, in the order of their frames} */
    double frame(int key) {
        return frames[key];
    }

    /** {@return the index of a key among those of the film} */
    int place(int key) {
        return places[key];
    }

    /** {@return the least index of its keys among those of the film} */
    int firstPlace() {
        return Arrays.stream(places).min().orElseThrow();
    }

    /** {@return the latest key at a frame or before; -1 if there is none} */
    int before(double frame) {
        int found = Arrays.binarySearch(frames, frame);
        return found >= 0 ? found : -found - 2;               // else found is -1 - the place of the next one
    }

    /** Computes the value of each channel at a frame. */
    void at(double frame, Curve curve, double[] out) {
        int key = before(frame);
        boolean constant = key < 0 || key == frames.length - 1 || frame - frames[key] == 0;
        for (int c = 0; c < thing.kind().channels; c++) {
            out[c] = constant ? values[Math.max(0, key)][c] : between(key, frame, curve, c);
        }
    }

    private double between(int key, double frame, Curve curve, int c) {
        double length = frames[key + 1] - frames[key];
        double u = (frame - frames[key]) / length;
        return curve.between(u, length, values[key][c], tangent(key, c), values[key + 1][c], tangent(key + 1, c));
    }

    /** {@return the tangent at a key, in values a frame} Catmull and Rom, "A class of local interpolating splines", 1974. */
    private double tangent(int key, int c) {
        return key == 0 || key == frames.length - 1 ? 0 : (values[key + 1][c] - values[key - 1][c]) / (frames[key + 1] - frames[key - 1]);
    }

    /** {@return whether each key has these values} */
    boolean isAlways(double... same) {
        return Arrays.stream(values).allMatch(value -> areClose(value, same));
    }

    /** Finds the keys without which the track is the same; of two of which only one is needed, the later one. {@return their places} */
    List<Integer> idle(Curve curve) {
        List<Integer> idle = new ArrayList<>();
        ArrayDeque<Integer> later = new ArrayDeque<>();       // those that are needed
        for (int key = frames.length - 1; key >= 0; key--) {
            List<Integer> around = new ArrayList<>();
            for (int i = Math.max(0, key - NEIGHBOURS); i < key; i++) {
                around.add(i);
            }
            int before = around.size();
            later.stream().limit(NEIGHBOURS).forEach(around::add);
            Track without = new Track(this, around);
            around.add(before, key);
            if (without.size() > 0 && new Track(this, around).isSame(without, before, curve)) {
                idle.add(0, places[key]);
            } else {
                later.addFirst(key);
            }
        }
        return idle;
    }

    /** {@return whether this is the same as another track, which lacks one of its keys} Only its neighbours depend on it. */
    private boolean isSame(Track without, int key, Curve curve) {
        double[] one = new double[thing.kind().channels];
        double[] other = new double[thing.kind().channels];
        for (int i = Math.max(0, key - 2); i <= Math.min(frames.length - 1, key + 2); i++) {
            double length = i < Math.min(frames.length - 1, key + 2) ? frames[i + 1] - frames[i] : 0;
            for (int point = 0; point < POINTS; point++) {
                double frame = frames[i] + length * point / POINTS;
                at(frame, curve, one);
                without.at(frame, curve, other);
                if (!areClose(one, other)) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean areClose(double[] one, double[] other) {
        for (int c = 0; c < one.length; c++) {
            if (Math.abs(one[c] - other[c]) > ROUNDING * Math.max(Math.abs(one[c]), Math.abs(other[c]))) {
                return false;
            }
        }
        return true;
    }

    /** Computes bounds of each channel between a key and the next one: those of the control points of its cubic as a Bézier curve. */
    void bounds(int key, Curve curve, double[] low, double[] high) {
        double third = (frames[key + 1] - frames[key]) / 3;
        for (int c = 0; c < thing.kind().channels; c++) {
            double v0 = values[key][c];
            double v1 = values[key + 1][c];
            double out = curve == Curve.LINEAR ? v0 : v0 + third * tangent(key, c);
            double in = curve == Curve.LINEAR ? v1 : v1 - third * tangent(key + 1, c);
            low[c] = Math.min(Math.min(v0, v1), Math.min(out, in));
            high[c] = Math.max(Math.max(v0, v1), Math.max(out, in));
        }
    }
}
