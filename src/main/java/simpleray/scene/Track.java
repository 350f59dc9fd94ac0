package simpleray.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The keys of one thing, and what it is between them. <em>Constant.</em> Any thread may call. */
final class Track {
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

    /** {@return the latest key at a frame or before; -1 if there is none} */
    int before(double frame) {
        int found = Arrays.binarySearch(frames, frame);
        return found >= 0 ? found : -found - 2;
    }

    /** Computes the value of each channel at a frame. */
    void at(double frame, Curve curve, double[] out) {
        int key = before(frame);
        for (int c = 0; c < thing.kind().channels; c++) {
            out[c] = key < 0 ? values[0][c] : key == frames.length - 1 || frames[key] == frame ? values[key][c] : between(key, frame, curve, c);
        }
    }

    private double between(int key, double frame, Curve curve, int c) {
        double length = frames[key + 1] - frames[key];
        return curve.between((frame - frames[key]) / length, length, values[key][c], tangent(key, c), values[key + 1][c], tangent(key + 1, c));
    }

    /** {@return the tangent at a key, in values a frame} Catmull and Rom, "A class of local interpolating splines", 1974. */
    private double tangent(int key, int c) {
        return key == 0 || key == frames.length - 1 ? 0 : (values[key + 1][c] - values[key - 1][c]) / (frames[key + 1] - frames[key - 1]);
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
