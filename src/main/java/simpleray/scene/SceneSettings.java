package simpleray.scene;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import simpleray.math.Colour;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;
import simpleray.text.SourceSpan;

/**
 * The settings of camera and renderer, from a scene file or its user; null if not set. <em>Mutable.</em>
 */
public final class SceneSettings {
    /** The longest side of a picture in pixels. */
    public static final int MAX_RESOLUTION = 65535;
    /** The most reflections of a primary ray; each takes a piece of a thread's stack. */
    public static final int MAX_DEPTH = 1000;
    /** The most samples of a pixel, along each side. */
    public static final int MAX_SAMPLES = 16;

    private static final Set<String> KEYWORDS = Set.of("background", "window", "cop", "camera", "resolution", "depth", "samples");

    /** The colour of a ray that hits nothing. */
    public Colour background;
    /** The viewport window of {@link SimpleCamera}. */
    public Window window;
    /** The centre of projection of {@link SimpleCamera}, above 0. */
    public Double cop;
    /** A {@link PerspectiveCamera}, instead of these two. */
    public PerspectiveCamera.Pose camera;
    /** The size of the picture. */
    public Resolution resolution;
    /** The most reflections of a primary ray, 0 to {@link #MAX_DEPTH}. */
    public Integer depth;
    /** Samples along each side of a pixel, 1 to {@link #MAX_SAMPLES}. */
    public Integer samples;

    /** The place of each keyword with its values in the file. */
    final Map<String, SourceSpan> places = new TreeMap<>();
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
     * Overrides these settings by others. A camera and a centre of projection or window exclude each other.
     *
     * @param other the settings that win
     * @return new settings
     */
    public SceneSettings under(SceneSettings other) {
        SceneSettings both = new SceneSettings();
        boolean simple = other.cop != null || other.window != null;
        both.background = first(other.background, background);
        both.window = other.camera != null ? null : first(other.window, window);
        both.cop = other.camera != null ? null : first(other.cop, cop);
        both.camera = simple ? null : first(other.camera, camera);
        both.resolution = first(other.resolution, resolution);
        both.depth = first(other.depth, depth);
        both.samples = first(other.samples, samples);
        return both;
    }

    /**
     * Creates the camera of these settings.
     *
     * @return a new camera
     * @throws IllegalArgumentException if one of its values is out of range
     */
    public Camera newCamera() {
        int width = resolution == null ? SimpleCamera.DEFAULT_RESOLUTION : resolution.width;
        int height = resolution == null ? SimpleCamera.DEFAULT_RESOLUTION : resolution.height;
        if (camera != null) {
            return new PerspectiveCamera(camera, width, height);
        }
        SimpleCamera simple = new SimpleCamera(width, height);
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
        return space > 0 && KEYWORDS.contains(line.substring(0, space)) && !line.endsWith(" adaptive");
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

    /** Reads keywords and their values up to the first other word. */
    void read(SceneReader is) throws IOException {
        Set<String> seen = places.keySet();
        last = SourceSpan.last(is);
        for (String word = is.takeKeyword(KEYWORDS); word != null; word = is.takeKeyword(KEYWORDS)) {
            if (!is.isFirstOnLine()) {
                is.reject("keyword " + word + " on a line of its own");
            }
            SourceSpan keyword = SourceSpan.last(is);
            if (seen.contains(word)) {
                is.reject("keyword " + word + " only once");
            }
            if (word.equals("camera") ? seen.contains("window") || seen.contains("cop") : seen.contains("camera") && isSimple(word)) {
                is.reject("either a camera, or a window and a cop");
            }
            is.enter(word + "'s");
            readValue(is, word);
            is.leave();
            last = SourceSpan.last(is);
            places.put(word, new SourceSpan(keyword.start(), last.end()));
        }
    }

    private static boolean isSimple(String word) {
        return word.equals("window") || word.equals("cop");
    }

    private void readValue(SceneReader is, String word) throws IOException {
        switch (word) {
            case "background" -> {
                background = new Colour();
                background.read(is);
            }
            case "window" -> window = readWindow(is);
            case "cop" -> {
                cop = is.readDouble("z");
                if (cop <= 0) {
                    is.reject("z above 0");
                }
            }
            case "camera" -> camera = readCamera(is);
            case "resolution" -> resolution = new Resolution(
                is.readInt("width from 1 to " + MAX_RESOLUTION, 1, MAX_RESOLUTION),
                is.readInt("height from 1 to " + MAX_RESOLUTION, 1, MAX_RESOLUTION));
            case "depth" -> depth = is.readInt("number from 0 to " + MAX_DEPTH, 0, MAX_DEPTH);
            default -> samples = is.readInt("number from 1 to " + MAX_SAMPLES, 1, MAX_SAMPLES);
        }
    }

    private static Window readWindow(SceneReader is) throws IOException {
        is.group();
        Window w = new Window(is.readDouble("xmin"), is.readDouble("xmax"), is.readDouble("ymin"), is.readDouble("ymax"));
        if (w.xmin >= w.xmax || w.ymin >= w.ymax || Double.isInfinite(w.xmax - w.xmin) || Double.isInfinite(w.ymax - w.ymin)) {
            is.rejectGroup("xmin below its xmax and ymin below its ymax");
        }
        return w;
    }

    private static PerspectiveCamera.Pose readCamera(SceneReader is) throws IOException {
        is.group();
        PerspectiveCamera.Pose pose = new PerspectiveCamera.Pose(is.readDouble("eye x"), is.readDouble("eye y"), is.readDouble("eye z"),
            is.readDouble("look-at x"), is.readDouble("look-at y"), is.readDouble("look-at z"), is.readDouble("field of view"));
        if (PerspectiveCamera.Pose.FOV.equals(pose.fault()) && !Double.isNaN(pose.fov())) {
            is.reject(PerspectiveCamera.Pose.FOV);
        } else if (PerspectiveCamera.Pose.LOOK_AT.equals(pose.fault())) {
            is.rejectGroup(PerspectiveCamera.Pose.LOOK_AT);
        }
        return pose;
    }

    /** Writes the settings, a line each, in the form that {@link #read} reads. */
    void write(SceneWriter os) throws IOException {
        if (background != null) {
            line(os, "background", background.r, background.g, background.b);
        }
        if (window != null) {
            line(os, "window", window.xmin, window.xmax, window.ymin, window.ymax);
        }
        if (cop != null) {
            line(os, "cop", cop);
        }
        if (camera != null) {
            line(os, "camera", camera.ex(), camera.ey(), camera.ez(), camera.lx(), camera.ly(), camera.lz(), camera.fov());
        }
        if (resolution != null) {
            os.writeString("resolution " + resolution.width + ' ' + resolution.height + '\n');
        }
        if (depth != null) {
            os.writeString("depth " + depth + '\n');
        }
        if (samples != null) {
            os.writeString("samples " + samples + '\n');
        }
    }

    private static void line(SceneWriter os, String keyword, double... values) throws IOException {
        os.writeString(keyword + ' ');
        for (double value : values) {
            os.writeDouble(value);
        }
        os.writeNewline();
    }

    private static <T> T first(T one, T other) {
        return one != null ? one : other;
    }
}
