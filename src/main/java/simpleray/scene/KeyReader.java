package simpleray.scene;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import simpleray.math.Colour;
import simpleray.scene.Key.Kind;
import simpleray.scene.Key.Thing;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.text.Diagnostic;
import simpleray.text.SceneReader;
import simpleray.text.SourceLocation;

/** Reads the keys of one scene file, and checks the film that they make. <em>Mutable,</em> for one reading. */
final class KeyReader {
    private static final Set<String> KINDS = Arrays.stream(Kind.values()).map(Kind::toString).collect(Collectors.toSet());

    private final List<Key> keys = new ArrayList<>();
    private final LineTable lines = new LineTable();
    private final List<SourceLocation> frames = new ArrayList<>();
    private final Set<At> seen = new HashSet<>();
    private SourceLocation first;
    private List<Object> objects;
    private List<Light> lights;
    private boolean noCamera;
    private boolean camera;

    private record At(double frame, Thing thing) {
    }

    private KeyReader() {
    }

    /** {@return the one of a scene file} */
    static KeyReader of(SceneReader is) {
        return is.kept(KeyReader.class, type -> new KeyReader());
    }

    /**
     * Prepares for the key whose keyword was just read.
     *
     * @param sceneObjects the objects before it; null if it belongs to no scene
     * @param sceneLights the lights, likewise
     * @param cameraIsExcluded whether a setting was read that excludes a camera
     */
    void begin(List<Object> sceneObjects, List<Light> sceneLights, boolean cameraIsExcluded) {
        objects = sceneObjects;
        lights = sceneLights;
        noCamera = cameraIsExcluded;
    }

    /** {@return whether there is a key of the camera} */
    boolean hasCamera() {
        return camera;
    }

    /** {@return the lines on which the keys begin} */
    LineTable lines() {
        return lines;
    }

    /** Reads the values behind the keyword. {@return all keys so far} */
    List<Key> read(SceneReader is) throws IOException {
        lines.add(is.line());
        if (first == null) {
            first = is.location();
        }
        is.group();
        double frame = is.readDouble("frame") + 0.0;
        frames.add(is.location());
        String word = is.readWord("camera, object, light or colour", KINDS);
        Kind kind = Kind.valueOf(word.toUpperCase(Locale.ROOT));
        Thing thing = new Thing(kind, kind == Kind.CAMERA ? 0 : readNumber(is, kind));
        if (kind == Kind.CAMERA && noCamera) {
            is.reject("camera without the settings of another one");
        }
        camera |= kind == Kind.CAMERA;
        if (!seen.add(new At(frame, thing)) && !Double.isNaN(frame)) {
            is.rejectGroup("frame " + Film.text(frame) + " only once for " + thing);
        }
        is.enter(kind == Kind.CAMERA ? "camera's" : kind.toString(), thing.number());
        keys.add(new Key(frame, thing, readValues(is, kind)));
        is.leave();
        return keys;
    }

    /** Reads the number of an object or light that is there and can have such a key. */
    private int readNumber(SceneReader is, Kind kind) throws IOException {
        List<?> all = kind == Kind.OBJECT ? objects : lights;
        int count = all == null ? Integer.MAX_VALUE : all.size();
        String what = kind == Kind.OBJECT ? "object" : "light";
        int number = is.readInt(what + (all == null ? "" : count == 0 ? " (the scene has none)" : " from 1 to " + count), 1, count);
        if (kind == Kind.LIGHT && all != null && lights.get(number - 1).isDistant()) {
            is.reject("light that is not directional: such a light cannot be moved");
        }
        return number;
    }

    private static List<Double> readValues(SceneReader is, Kind kind) throws IOException {
        if (kind == Kind.CAMERA) {
            Pose pose = Setting.CAMERA.read(is);
            return List.of(pose.ex(), pose.ey(), pose.ez(), pose.lx(), pose.ly(), pose.lz(), pose.fov());
        }
        if (kind == Kind.COLOUR) {
            Colour colour = new Colour();
            colour.read(is);
            return List.of(colour.r, colour.g, colour.b);
        }
        return List.of(is.readDouble("x"), is.readDouble("y"), is.readDouble("z"));
    }

    /** Notes the keys that are of no frame of the film. */
    void checkFrames(SceneReader is, SceneSettings.Frames film) throws IOException {
        if (film == null) {
            is.rejectAt(first, "the keyword frames, which keys need", "a key");
            return;
        }
        for (int i = 0; i < keys.size(); i++) {
            double frame = keys.get(i).frame();
            if (frame < 0 || frame > film.count() - 1) {
                is.rejectAt(frames.get(i), "key's frame from 0 to " + (film.count() - 1), Diagnostic.quoted(Film.text(frame)));
            }
        }
    }

    /** Notes the frames whose values no scene may have, of each thing the first. */
    void checkFilm(SceneReader is, Film film) throws IOException {
        for (Film.Fault fault : film.faults()) {
            is.rejectAt(frames.get(fault.key()), fault.wanted(), fault.found());
        }
    }
}
