package simpleray.scene;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import simpleray.math.Colour;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;
import simpleray.text.SourceLocation;
import simpleray.text.SourceSpan;

/**
 * The settings of camera and renderer, from a scene file or its user; null if not set. <em>Mutable.</em>
 */
public final class SceneSettings {
    /** The longest side of a picture in pixels. */
    public static final int MAX_RESOLUTION = 65535;
    /** The most reflections of a primary ray; each takes a piece of a thread's stack. */
    public static final int MAX_DEPTH = 1000;
    /** The most reflections of a primary ray, unless set. */
    public static final int DEFAULT_DEPTH = 10;
    /** The most samples of a pixel, along each side. */
    public static final int MAX_SAMPLES = 16;
    /** The background that is none: rays that hit nothing are black, and the picture has alpha. To be compared by identity. */
    public static final Colour TRANSPARENT = new Colour();

    private static final String EITHER = "either camera, or parallel, or window and cop (up goes with the first two)";

    /** The colour of a ray that hits nothing, or {@link #TRANSPARENT}. */
    public Colour background;
    /** The viewport window of {@link SimpleCamera}. */
    public Window window;
    /** The centre of projection of {@link SimpleCamera}, above 0. */
    public Double cop;
    /** A {@link PerspectiveCamera}, instead of these two. */
    public PerspectiveCamera.Pose camera;
    /** A {@link ParallelCamera}, instead of these. */
    public ParallelCamera.View parallel;
    /** What is up in the picture of these two, of any length above 0, not along the view; not to be changed once it is set. */
    public Vector up;
    /** The size of the picture. */
    public Resolution resolution;
    /** The most reflections of a primary ray, 0 to {@link #MAX_DEPTH}. */
    public Integer depth;
    /** Samples along each side of a pixel, 1 to {@link #MAX_SAMPLES}. */
    public Integer samples;
    /** How many frames the film has; without it there is none. */
    public Frames frames;
    /** How values go from key to key. */
    public Curve curve;
    /** What things are at some frames, in the order of the file; not to be changed once it is set. */
    public List<Key> keys;

    /** The place of each keyword with its values in the file. */
    final Map<String, SourceSpan> places = new TreeMap<>();
    /** The lines of the keys in the file. */
    LineTable keyLines = new LineTable();
    /** The place of the last value in the file, of a setting or before; null if no file was read. */
    SourceSpan last;

    /** Creates settings with nothing set. */
    public SceneSettings() {
    }

    /**
     * A viewport window on the XY plane.
     *
     * @param xmin the left edge
     * @param xmax the right edge, above xmin
     * @param ymin the lower edge
     * @param ymax the upper edge, above ymin
     */
    public record Window(double xmin, double xmax, double ymin, double ymax) {
    }

    /**
     * The size of a picture.
     *
     * @param width in pixels, 1 to {@link #MAX_RESOLUTION}
     * @param height in pixels, likewise
     */
    public record Resolution(int width, int height) {
    }

    /**
     * The frames of a film.
     *
     * @param count their number, 1 to {@link Film#MAX_FRAMES}
     * @param rate the frames a second, above 0 and up to {@link Film#MAX_RATE}
     */
    public record Frames(int count, double rate) {
    }

    /**
     * Overrides these settings by others. A camera, a parallel one, and a centre of projection or window exclude each other, and any of them,
     * but not up, takes the place of the camera's keys.
     *
     * @param other the settings that win
     * @return new settings
     */
    public SceneSettings under(SceneSettings other) {
        SceneSettings both = new SceneSettings();
        for (Setting<?> setting : Setting.ALL) {
            if (!setting.isExcludedBy(other)) {
                setting.copy(setting.isSet(other) ? other : this, both);
            }
        }
        if (keys != null && both.keys == keys && Setting.ALL.stream().anyMatch(s -> s.isOfCamera() && s != Setting.UP && s.isSet(other))) {
            both.keys = keys.stream().filter(key -> key.thing().kind() != Key.Kind.CAMERA).toList();
        }
        return both;
    }

    /**
     * Replaces the camera's settings, set or not, by those of others.
     *
     * @param other the settings to copy from
     */
    public void setCamera(SceneSettings other) {
        for (Setting<?> setting : Setting.ALL) {
            if (setting.isOfCamera()) {
                setting.copy(other, this);
            }
        }
    }

    /** {@return whether the camera may stand anywhere: a perspective or parallel one} */
    public boolean isFree() {
        return camera != null || parallel != null;
    }

    /** {@return whether up is along the view, which makes no camera} */
    boolean isUpAlongView() {
        return camera != null && camera.isAlong(up) || parallel != null && parallel.isAlong(up);
    }

    /** {@return whether the camera has keys} */
    public boolean hasCameraKeys() {
        return keys != null && keys.stream().anyMatch(key -> key.thing().kind() == Key.Kind.CAMERA);
    }

    /** {@return whether the picture has alpha, and is transparent where its rays hit nothing} */
    public boolean isTransparent() {
        return background == TRANSPARENT;
    }

    /** {@return whether a setting of the camera is set} */
    public boolean hasCamera() {
        return Setting.ALL.stream().anyMatch(setting -> setting.isOfCamera() && setting.isSet(this));
    }

    /**
     * Creates the camera of these settings.
     *
     * @return a new camera
     * @throws IllegalArgumentException if one of its values is out of range
     */
    public Camera newCamera() {
        if (isUpAlongView() || up != null && !isFree() && !hasCameraKeys()) {
            throw new IllegalArgumentException(isFree() ? "up must not be along the view" : "up needs a camera or parallel");
        }
        Resolution size = Setting.RESOLUTION.in(this);
        if (camera != null) {
            return new PerspectiveCamera(camera, up, size.width, size.height);
        }
        if (parallel != null) {
            return new ParallelCamera(parallel, up, size.width, size.height);
        }
        SimpleCamera simple = new SimpleCamera(size.width, size.height);
        if (cop != null) {
            simple.setCOP(cop);
        }
        if (window != null) {
            simple.setVPWindow(window.xmin, window.xmax, window.ymin, window.ymax);
        }
        return simple;
    }

    /** {@return whether a line is one that {@link #of} reads} */
    static boolean isSetting(String line) {
        int space = line.indexOf(' ');
        return space > 0 && Setting.keywords().contains(line.substring(0, space)) && !line.endsWith(" adaptive");
    }

    /**
     * Reads settings without a scene, in the form of {@link #lines}.
     *
     * @param lines lines of a keyword and its values
     * @param name their name for messages
     * @return the settings
     * @throws IOException if the lines contain anything else
     */
    public static SceneSettings of(String lines, String name) throws IOException {
        SceneReader is = new SceneReader(new ByteArrayInputStream(lines.getBytes(StandardCharsets.UTF_8)), name,
            Path.of(""));
        SceneSettings settings = new SceneSettings();
        settings.read(is);
        is.complete("the end of the settings");
        return settings;
    }

    /** {@return the settings, a line each} */
    public String lines() {
        try (ByteArrayOutputStream bytes = new ByteArrayOutputStream()) {
            SceneWriter os = new SceneWriter(bytes);
            write(os);
            os.flush();
            return bytes.toString(StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);                // does not happen in memory
        }
    }

    private void read(SceneReader is) throws IOException {
        read(is, null, null);
    }

    /** Reads keywords and their values up to the first other word. Objects and lights of the scene are null if there is none. */
    void read(SceneReader is, List<Object> objects, List<Light> lights) throws IOException {
        last = SourceSpan.last(is);
        SourceLocation upAt = null;
        for (String word = is.takeKeyword(Setting.keywords()); word != null; word = is.takeKeyword(Setting.keywords())) {
            Setting<?> setting = Setting.of(word);
            if (!is.isFirstOnLine()) {
                is.reject("keyword " + word + " on a line of its own");
            }
            SourceSpan keyword = SourceSpan.last(is);
            upAt = setting == Setting.UP ? is.location() : upAt;
            if (setting != Setting.KEY && places.containsKey(word)) {
                is.reject("keyword " + word + " only once");
            }
            if (isExcluded(setting) || keys != null && KeyReader.of(is).hasCamera() && setting.excludes(Setting.CAMERA)) {
                is.reject(EITHER);
            }
            if (setting == Setting.KEY) {
                KeyReader.of(is).begin(objects, lights, isExcluded(Setting.CAMERA));
                keyLines = KeyReader.of(is).lines();
            }
            is.enter(word + "'s");
            setting.read(is, this);
            if (setting.isOfCamera() && isUpAlongView()) {
                is.rejectGroup(setting == Setting.UP ? "direction that is not along the view" : "view that is not along up");
            }
            is.leave();
            last = SourceSpan.last(is);
            places.put(word, new SourceSpan(keyword.start(), last.end()));
        }
        if (up != null && objects != null && !isFree() && !hasCameraKeys()) {
            is.rejectAt(upAt, "a camera or parallel, which up needs", "up alone");
        }
        if (keys != null && objects != null) {
            KeyReader.of(is).checkFrames(is, frames);
        }
    }

    /** {@return whether a keyword that was read excludes a setting} */
    private boolean isExcluded(Setting<?> setting) {
        for (String word : places.keySet()) {
            if (setting.excludes(Setting.of(word))) {
                return true;
            }
        }
        return false;
    }

    /** Writes the settings, a line each, in the form that {@link #read} reads. */
    void write(SceneWriter os) throws IOException {
        for (Setting<?> setting : Setting.LINES) {
            setting.write(os, this);
        }
    }
}
