package simpleray.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simpleray.math.Colour;
import simpleray.math.Vector;
import simpleray.text.ShortestDecimal;

/**
 * A scene in motion: a still scene for each frame. A scene without frames is a film of one. <em>Constant</em>, as long as the scene does not
 * change. Any thread may call.
 */
public final class Film {
    /** The most frames of a film. */
    public static final int MAX_FRAMES = 1_000_000;
    /** The most frames a second. */
    public static final double MAX_RATE = 1000;
    /** The frames a second of a scene that says nothing of them. */
    public static final double DEFAULT_RATE = 25;

    private static final int FOV = 6;
    private static final double HALF_TURN = 180;
    /** How far beyond an object's moves it must have room, so that rounding of those within changes nothing. */
    private static final double ROOM = 4;

    private final Scene scene;
    private final Curve curve;
    private final List<Track> tracks;

    /**
     * What no scene may have, at a frame.
     *
     * @param key the index of the key from which it comes
     * @param wanted what is expected instead
     * @param found what there is
     */
    record Fault(int key, String wanted, String found) {
    }

    /**
     * Keys without which the film is the same.
     *
     * @param key the index of the first of them among the scene's keys
     * @param message what is told of them
     */
    public record Idle(int key, String message) {
    }

    /** Prepares the film of a scene. */
    Film(Scene scene) {
        this.scene = scene;
        SceneSettings settings = scene.settings;
        curve = settings.curve == null ? Curve.SMOOTH : settings.curve;
        tracks = settings.keys == null ? List.of() : Track.of(settings.keys);
    }

    /** {@return the number of frames, which are counted from 0} */
    public int frames() {
        return scene.settings.frames == null ? 1 : scene.settings.frames.count();
    }

    /** {@return the frames a second} */
    public double rate() {
        return scene.settings.frames == null ? DEFAULT_RATE : scene.settings.frames.rate();
    }

    /**
     * Tests whether the film has a frame.
     *
     * @param frame the frame, which need not be whole
     * @return whether it is from 0 to the last one
     */
    public boolean has(double frame) {
        return frame >= 0 && frame <= frames() - 1;
    }

    /**
     * Returns the scene of a frame, without frames, keys and curve. Objects and lights that are where the file puts them are the same, not
     * copies; a moved mesh has the same triangles.
     *
     * @param frame the frame, from 0 to the last one; need not be whole
     * @return the scene; the film's own if that is no film
     * @throws IllegalArgumentException if the film has no such frame, or the frame has values that no scene may have
     */
    public Scene still(double frame) {
        if (!has(frame)) {
            throw new IllegalArgumentException("the frame must be from 0 to " + (frames() - 1) + ", and is " + text(frame));
        }
        if (scene.settings.frames == null) {
            return scene;
        }
        Scene still = scene.copy();
        SceneSettings settings = scene.settings.under(new SceneSettings());
        settings.frames = null;
        settings.keys = null;
        settings.curve = null;
        still.settings = settings;
        double[] values = new double[Key.Kind.CAMERA.channels];
        for (Track track : tracks) {
            Fault fault = put(track, frame, values, still);
            if (fault != null) {
                throw new IllegalArgumentException("expected " + fault.wanted + ", found " + fault.found);
            }
        }
        return still;
    }

    /**
     * Tests whether nothing has changed from one frame to another.
     *
     * @param one a frame that the film has
     * @param other likewise
     * @return whether all things with keys are the same at both, and so the scenes are
     */
    public boolean areSame(double one, double other) {
        double[] first = new double[Key.Kind.CAMERA.channels];
        double[] second = new double[Key.Kind.CAMERA.channels];
        for (Track track : tracks) {
            track.at(one + 0.0, curve, first);
            track.at(other + 0.0, curve, second);
            if (!Arrays.equals(first, second)) {
                return false;
            }
        }
        return true;
    }

    /** {@return whether objects move, so that the scenes of two frames are of other ones} */
    public boolean movesObjects() {
        return tracks.stream().anyMatch(track -> track.thing.kind() == Key.Kind.OBJECT);
    }

    /** Sets a thing of a still scene to what it is at a frame. {@return the fault, for which it is not set; null if there is none} */
    private Fault put(Track track, double frame, double[] v, Scene still) {
        track.at(frame + 0.0, curve, v);
        int i = track.thing.number() - 1;
        String wanted = null;
        try {
            switch (track.thing.kind()) {
                case CAMERA -> {
                    PerspectiveCamera.Pose pose = new PerspectiveCamera.Pose(v[0], v[1], v[2], v[3], v[4], v[5], v[FOV]);
                    wanted = !areFinite(v, FOV + 1) ? Lengths.FINITE : pose.fault() != null ? "a " + pose.fault()
                        : pose.isAlong(scene.settings.up) ? "a view that is not along up" : null;
                    still.settings.camera = pose;
                }
                case COLOUR -> {
                    Colour colour = new Colour(v[0], v[1], v[2]);
                    wanted = !areFinite(v, 3) ? Lengths.FINITE : v[0] < 0 || v[1] < 0 || v[2] < 0 ? "components of 0 or more" : null;
                    still.replace(i, still.getLight(i).coloured(colour));
                }
                case OBJECT -> {
                    if (v[0] != 0 || v[1] != 0 || v[2] != 0) {
                        still.replace(i, scene.getObject(i).moved(new Vector(v[0], v[1], v[2])));
                    }
                }
                default -> {
                    if (v[0] != 0 || v[1] != 0 || v[2] != 0) {
                        still.replace(i, scene.getLight(i).moved(new Vector(v[0], v[1], v[2])).coloured(still.getLight(i).intensity));
                    }
                }
            }
        } catch (IllegalArgumentException e) {
            wanted = e.getMessage();
        }
        return wanted == null ? null : fault(track, frame, wanted, v);
    }

    private static Fault fault(Track track, double frame, String wanted, double[] v) {
        boolean moves = track.thing.kind() == Key.Kind.OBJECT || track.thing.kind() == Key.Kind.LIGHT;
        StringBuilder found = new StringBuilder(moves ? "it moved by" : "");
        for (int c = 0; c < track.thing.kind().channels; c++) {
            found.append(found.length() == 0 ? "" : " ").append(ShortestDecimal.of(v[c]));
        }
        return new Fault(track.place(Math.max(0, track.before(frame))), "frame " + text(frame) + "'s " + track.thing + " with " + wanted,
            found.toString());
    }

    /** {@return the keys without which the film is the same} */
    public List<Idle> idle() {
        List<Idle> idle = new ArrayList<>();
        for (Track track : tracks) {
            String same = asInTheFile(track);
            if (same != null) {
                boolean one = track.size() == 1;
                idle.add(new Idle(track.firstPlace(), "the " + (one ? "key" : track.size() + " keys") + " of " + track.thing
                    + (one ? " does nothing: " : " do nothing: ") + same));
                continue;
            }
            for (int place : track.idle(curve)) {
                idle.add(new Idle(place, "the key of " + track.thing + " for frame " + text(scene.settings.keys.get(place).frame())
                    + " does nothing: without it the film is the same"));
            }
        }
        return idle;
    }

    /** {@return what a thing that is always as in the file is; null if it is not always so} */
    private String asInTheFile(Track track) {
        int i = track.thing.number() - 1;
        return switch (track.thing.kind()) {
            case CAMERA -> {
                PerspectiveCamera.Pose pose = scene.settings.camera;
                yield pose != null && track.isAlways(pose.ex(), pose.ey(), pose.ez(), pose.lx(), pose.ly(), pose.lz(), pose.fov())
                    ? "it is the file's camera" : null;
            }
            case COLOUR -> {
                Colour colour = scene.getLight(i).intensity;
                yield track.isAlways(colour.r, colour.g, colour.b) ? "it is the light's own" : null;
            }
            default -> track.isAlways(0, 0, 0) ? "it stays where the file puts it" : null;
        };
    }

    /**
     * Checks that each frame has a picture if other settings win over the scene's own: up of these may be along the view of a frame.
     *
     * @param asked the settings that win
     * @throws IllegalArgumentException if one has none; the message names it
     */
    public void check(SceneSettings asked) {
        if (asked.up != null) {
            for (Fault fault : new Film(scene.with(scene.settings.under(asked))).faults()) {
                throw new IllegalArgumentException("expected " + fault.wanted + ", found " + fault.found);
            }
        }
    }

    /** Finds the first frame at which each thing has values that no scene may have. Frames between keys that bounds clear are not computed. */
    List<Fault> faults() {
        List<Fault> faults = new ArrayList<>();
        Scene scratch = scene.copy();
        scratch.settings = new SceneSettings();
        for (Track track : tracks) {
            Fault fault = firstFault(track, scratch);
            if (fault != null) {
                faults.add(fault);
            }
        }
        return faults;
    }

    private Fault firstFault(Track track, Scene scratch) {
        Fault fault = firstFault(track, 0, 0, scratch);       // as at its first key, all frames up to there
        for (int key = 0; fault == null && key < track.size() - 1; key++) {
            if (!isClear(track, key)) {
                fault = firstFault(track, Math.ceil(track.frame(key)), track.frame(key + 1), scratch);
            }
        }
        double last = Math.ceil(track.frame(track.size() - 1));
        return fault == null ? firstFault(track, last, last, scratch) : fault;
    }

    private Fault firstFault(Track track, double from, double to, Scene scratch) {
        double[] values = new double[Key.Kind.CAMERA.channels];
        Fault fault = null;
        for (double frame = from; fault == null && frame <= to; frame++) {
            fault = put(track, frame, values, scratch);
        }
        return fault;
    }

    /** {@return whether all that a thing can be between a key and the next one is surely right} */
    boolean isClear(Track track, int key) {
        double[] low = new double[Key.Kind.CAMERA.channels];
        double[] high = new double[Key.Kind.CAMERA.channels];
        track.bounds(key, curve, low, high);
        int channels = track.thing.kind().channels;
        if (!areFinite(low, channels) || !areFinite(high, channels)) {
            return false;
        }
        return switch (track.thing.kind()) {
            case CAMERA -> low[FOV] > 0 && high[FOV] < HALF_TURN
                && (areApart(low, high, 0) || areApart(low, high, 1) || areApart(low, high, 2)) && isApartFromUp(low, high);
            case COLOUR -> low[0] >= 0 && low[1] >= 0 && low[2] >= 0;
            default -> hasRoom(track.thing, Math.max(largest(low), largest(high)));
        };
    }

    private static boolean areApart(double[] low, double[] high, int c) {
        double gap = Math.max(low[c] - high[c + 3], low[c + 3] - high[c]);
        return gap > 1e-9 * Math.max(largest(low), largest(high));
    }

    /** {@return whether no view is along up: bounds of a component of their cross product exclude 0} */
    private boolean isApartFromUp(double[] low, double[] high) {
        if (scene.settings.up == null) {
            return true;
        }
        Vector up = scene.settings.up.normalised();
        double[] u = {up.x, up.y, up.z};
        double least = 1e-9 * Math.max(largest(low), largest(high));
        for (int c = 0; c < 3; c++) {
            int i = (c + 1) % 3;
            int j = (c + 2) % 3;
            double[] one = {(low[i + 3] - high[i]) * u[j], (high[i + 3] - low[i]) * u[j]};
            double[] other = {(low[j + 3] - high[j]) * u[i], (high[j + 3] - low[j]) * u[i]};
            if (Math.min(one[0], one[1]) - Math.max(other[0], other[1]) > least
                || Math.min(other[0], other[1]) - Math.max(one[0], one[1]) > least) {
                return true;
            }
        }
        return false;
    }

    /** {@return whether an object or light can be moved by the largest offset, and beyond, to all corners of a cube} */
    private boolean hasRoom(Key.Thing thing, double largest) {
        try {
            for (int corner = 0; corner < 8; corner++) {
                Vector t = new Vector(sign(corner, 1), sign(corner, 2), sign(corner, 4));
                t.scale(ROOM * largest);
                if (thing.kind() == Key.Kind.OBJECT) {
                    scene.getObject(thing.number() - 1).moved(t);
                } else {
                    scene.getLight(thing.number() - 1).moved(t);
                }
            }
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }

    private static double sign(int corner, int bit) {
        return (corner & bit) == 0 ? -1 : 1;
    }

    private static double largest(double[] all) {
        double largest = 0;
        for (double one : all) {
            largest = Math.max(largest, Math.abs(one));
        }
        return largest;
    }

    private static boolean areFinite(double[] all, int count) {
        for (int i = 0; i < count; i++) {
            if (!Double.isFinite(all[i])) {
                return false;
            }
        }
        return true;
    }

    /** {@return a frame's number; a whole one without a fraction} */
    static String text(double frame) {
        return frame % 1 == 0 && Math.abs(frame) < Integer.MAX_VALUE ? Integer.toString((int) frame) : ShortestDecimal.of(frame);
    }
}
