package simpleray.scene;

import java.io.IOException;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import simpleray.math.Colour;
import simpleray.math.Vector;
import simpleray.scene.ParallelCamera.View;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings.Frames;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.SceneSettings.Window;
import simpleray.text.NumberParser;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * A setting of camera and renderer: its keyword in a scene file, its option on a command line, how both are read, how it is written, and
 * its default. <em>Constant.</em>
 *
 * <p>Whoever reads, writes, compares or colours settings walks this table: scene files, the command line and its help, the command line
 * that the window copies, the editor, a picture's identity and the texts that it carries. So a new setting is an entry here, which both
 * lists name, a field of {@link SceneSettings}, and its use. An entry is a class, not a few lambdas: the first lambdas take 5 ms of each
 * start.
 *
 * @param <T> the type of its value
 */
public abstract class Setting<T> {
    /** The background that is none. */
    public static final String NONE = "none";

    /** The size of the picture. */
    public static final Setting<Resolution> RESOLUTION = new Setting<>("resolution", "--size", "WxH",
        "Width and height in pixels, 1 to " + SceneSettings.MAX_RESOLUTION + " each (default: %s).",
        new Resolution(SimpleCamera.DEFAULT_RESOLUTION, SimpleCamera.DEFAULT_RESOLUTION)) {
        @Override Resolution get(SceneSettings settings) { return settings.resolution; }
        @Override public void set(SceneSettings settings, Resolution value) { settings.resolution = value; }
        @Override List<?> words(Resolution value) { return List.of(value.width(), value.height()); }
        @Override char separator() { return 'x'; }
        @Override public boolean isAlwaysTold() { return true; }

        @Override
        Resolution read(SceneReader is) throws IOException {
            return new Resolution(is.readInt("width from 1 to " + SceneSettings.MAX_RESOLUTION, 1, SceneSettings.MAX_RESOLUTION),
                is.readInt("height from 1 to " + SceneSettings.MAX_RESOLUTION, 1, SceneSettings.MAX_RESOLUTION));
        }

        @Override
        public Resolution parse(String value) {
            int x = Math.max(value.indexOf('x'), value.indexOf('X'));
            Long width = x < 0 ? null : NumberParser.parseInteger(value.substring(0, x), 1, SceneSettings.MAX_RESOLUTION);
            Long height = x < 0 ? null : NumberParser.parseInteger(value.substring(x + 1), 1, SceneSettings.MAX_RESOLUTION);
            if (width == null || height == null) {
                throw expected("WxH such as 640x480, 1 to " + SceneSettings.MAX_RESOLUTION + " each", value);
            }
            return new Resolution(width.intValue(), height.intValue());
        }
    };

    /** The most reflections of a primary ray. */
    public static final Setting<Integer> DEPTH = new Setting<>("depth", "--depth", "N",
        "The most reflections of a ray, 0 to " + SceneSettings.MAX_DEPTH + " (default: %s).", SceneSettings.DEFAULT_DEPTH) {
        @Override Integer get(SceneSettings settings) { return settings.depth; }
        @Override public void set(SceneSettings settings, Integer value) { settings.depth = value; }
        @Override public Integer parse(String value) { return Integer.valueOf(value); }
        @Override List<?> words(Integer value) { return List.of(value); }
        @Override public boolean isAlwaysTold() { return true; }

        @Override
        Integer read(SceneReader is) throws IOException {
            return is.readInt("number from 0 to " + SceneSettings.MAX_DEPTH, 0, SceneSettings.MAX_DEPTH);
        }
    };

    /** Samples along each side of a pixel. */
    public static final Setting<Integer> SAMPLES = new Setting<>("samples", "--samples", "N",
        "N x N samples a pixel, N from 1 to " + SceneSettings.MAX_SAMPLES + " (default: %s), for smooth edges; or adaptive: "
            + "as good as 4, but only where it is needed.", 1) {
        @Override Integer get(SceneSettings settings) { return settings.samples; }
        @Override public void set(SceneSettings settings, Integer value) { settings.samples = value; }
        @Override List<?> words(Integer value) { return List.of(value); }
        @Override public boolean isAlwaysTold() { return true; }

        @Override
        Integer read(SceneReader is) throws IOException {
            return is.readInt("number from 1 to " + SceneSettings.MAX_SAMPLES, 1, SceneSettings.MAX_SAMPLES);
        }

        @Override
        public Integer parse(String value) {
            Long n = NumberParser.parseInteger(value, 1, SceneSettings.MAX_SAMPLES);
            if (n == null) {
                throw new IllegalArgumentException("--samples must be 1 to " + SceneSettings.MAX_SAMPLES + " or adaptive, and is '"
                    + value + "'");
            }
            return n.intValue();
        }
    };

    /** The centre of projection of {@link SimpleCamera}. */
    public static final Setting<Double> COP = new Setting<>("cop", "--cop", "Z",
        "The eye is at (0, 0, Z), Z > 0 (default: %s).", SimpleCamera.DEFAULT_COP) {
        @Override Double get(SceneSettings settings) { return settings.cop; }
        @Override public void set(SceneSettings settings, Double value) { settings.cop = value; }
        @Override public Double parse(String value) { return numbers(value, 1, "a number")[0]; }
        @Override List<?> words(Double value) { return List.of(value); }
        @Override Set<Class<? extends Camera>> cameras() { return Set.of(SimpleCamera.class); }

        @Override
        Double read(SceneReader is) throws IOException {
            double cop = is.readDouble("z");
            if (cop <= 0) {
                is.reject("z above 0");
            }
            return cop;
        }
    };

    /** The viewport window of {@link SimpleCamera}. Its default depends on the size of the picture. */
    public static final Setting<Window> WINDOW = new Setting<>("window", "--window", "XMIN,XMAX,YMIN,YMAX",
        "The piece of the plane z = 0 that fills the picture (default: -2,2,-2,2, more along the longer side).", null) {
        @Override Window get(SceneSettings settings) { return settings.window; }
        @Override public void set(SceneSettings settings, Window value) { settings.window = value; }
        @Override List<?> words(Window w) { return List.of(w.xmin(), w.xmax(), w.ymin(), w.ymax()); }
        @Override Set<Class<? extends Camera>> cameras() { return Set.of(SimpleCamera.class); }
        @Override String unset() { return "default"; }

        @Override
        Window read(SceneReader is) throws IOException {
            is.group();
            Window w = new Window(is.readDouble("xmin"), is.readDouble("xmax"), is.readDouble("ymin"), is.readDouble("ymax"));
            if (w.xmin() >= w.xmax() || w.ymin() >= w.ymax() || Double.isInfinite(w.xmax() - w.xmin())
                || Double.isInfinite(w.ymax() - w.ymin())) {
                is.rejectGroup("xmin below its xmax and ymin below its ymax");
            }
            return w;
        }

        @Override
        public Window parse(String value) {
            double[] n = numbers(value, 4, "four numbers such as -2,2,-2,2");
            return new Window(n[0], n[1], n[2], n[3]);
        }
    };

    /** A {@link PerspectiveCamera}, instead of these two. */
    public static final Setting<Pose> CAMERA = new Setting<>("camera", "--camera", "EX,EY,EZ,LX,LY,LZ,FOV",
        "Instead of these two: the eye, the point it looks at, and the vertical field of view in degrees.", null) {
        @Override Pose get(SceneSettings settings) { return settings.camera; }
        @Override public void set(SceneSettings settings, Pose value) { settings.camera = value; }
        @Override List<?> words(Pose pose) { return List.of(pose.ex(), pose.ey(), pose.ez(), pose.lx(), pose.ly(), pose.lz(), pose.fov()); }
        @Override Set<Class<? extends Camera>> cameras() { return Set.of(PerspectiveCamera.class); }

        @Override
        Pose read(SceneReader is) throws IOException {
            is.group();
            Pose pose = new Pose(is.readDouble("eye x"), is.readDouble("eye y"), is.readDouble("eye z"),
                is.readDouble("look-at x"), is.readDouble("look-at y"), is.readDouble("look-at z"), is.readDouble("field of view"));
            if (Pose.FOV.equals(pose.fault()) && !Double.isNaN(pose.fov())) {
                is.reject(Pose.FOV);
            } else if (Pose.LOOK_AT.equals(pose.fault())) {
                is.rejectGroup(Pose.LOOK_AT);
            }
            return pose;
        }

        @Override
        public Pose parse(String value) {
            double[] n = numbers(value, 7, "seven numbers such as 3,2,5,0,0,0,40");
            Pose pose = new Pose(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
            if (pose.fault() != null) {
                throw expected("a " + pose.fault(), value);
            }
            return pose;
        }
    };

    /** A {@link ParallelCamera}, instead of these. */
    public static final Setting<View> PARALLEL = new Setting<>("parallel", "--parallel", "EX,EY,EZ,LX,LY,LZ,H",
        "Instead of these: parallel rays from an eye towards the point it looks at, H scene units from bottom to top.", null) {
        @Override View get(SceneSettings settings) { return settings.parallel; }
        @Override public void set(SceneSettings settings, View value) { settings.parallel = value; }
        @Override List<?> words(View v) { return List.of(v.ex(), v.ey(), v.ez(), v.lx(), v.ly(), v.lz(), v.height()); }
        @Override Set<Class<? extends Camera>> cameras() { return Set.of(ParallelCamera.class); }

        @Override
        View read(SceneReader is) throws IOException {
            is.group();
            View view = new View(is.readDouble("eye x"), is.readDouble("eye y"), is.readDouble("eye z"),
                is.readDouble("look-at x"), is.readDouble("look-at y"), is.readDouble("look-at z"), is.readDouble("height"));
            if (View.HEIGHT.equals(view.fault()) && !Double.isNaN(view.height())) {
                is.reject(View.HEIGHT);
            } else if (Pose.LOOK_AT.equals(view.fault())) {
                is.rejectGroup(Pose.LOOK_AT);
            }
            return view;
        }

        @Override
        public View parse(String value) {
            double[] n = numbers(value, 7, "seven numbers such as 5,4,5,0,0,0,6");
            View view = new View(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
            if (view.fault() != null) {
                throw expected("a " + view.fault(), value);
            }
            return view;
        }
    };

    /** What is up in the picture of a {@link PerspectiveCamera} or {@link ParallelCamera}. */
    public static final Setting<Vector> UP = new Setting<>("up", "--up", "X,Y,Z",
        "With camera or parallel: the direction that is up in the picture (default: 0,1,0; if the view is along y, 0,0,-1).", null) {
        @Override Vector get(SceneSettings settings) { return settings.up; }
        @Override public void set(SceneSettings settings, Vector value) { settings.up = value; }
        @Override List<?> words(Vector value) { return List.of(value.x, value.y, value.z); }
        @Override Set<Class<? extends Camera>> cameras() { return Set.of(PerspectiveCamera.class, ParallelCamera.class); }

        @Override
        Vector read(SceneReader is) throws IOException {
            Vector up = new Vector();
            Directions.read(is, "direction", up);
            return up;
        }

        @Override
        public Vector parse(String value) {
            double[] n = numbers(value, 3, "three numbers such as 0,0,1");
            if (n[0] == 0 && n[1] == 0 && n[2] == 0) {
                throw expected("a direction other than zero", value);
            }
            return new Vector(n[0], n[1], n[2]);
        }
    };

    /** The colour of a ray that hits nothing. */
    public static final Setting<Colour> BACKGROUND = new Setting<>("background", "--background", "R,G,B",
        "The colour where nothing is hit, 0 to 1 each (default: %s); or none: black for rays, and transparent in the picture.", new Colour()) {
        @Override Colour get(SceneSettings settings) { return settings.background; }
        @Override public void set(SceneSettings settings, Colour value) { settings.background = value; }
        @Override List<?> words(Colour c) { return c == SceneSettings.TRANSPARENT ? List.of(NONE) : List.of(c.r, c.g, c.b); }

        @Override
        Colour read(SceneReader is) throws IOException {
            if (is.takeKeyword(Set.of(NONE)) != null) {
                return SceneSettings.TRANSPARENT;
            }
            Colour colour = new Colour();
            colour.read(is, "red, or " + NONE);
            return colour;
        }

        @Override
        public Colour parse(String value) {
            if (value.equals(NONE)) {
                return SceneSettings.TRANSPARENT;
            }
            double[] n = numbers(value, 3, "none, or three numbers such as 0.1,0.2,0.4");
            if (n[0] < 0 || n[1] < 0 || n[2] < 0) {
                throw expected("numbers of 0 or more", value);
            }
            return new Colour(n[0], n[1], n[2]);
        }
    };

    /** The frames of a film. */
    public static final Setting<Frames> FRAMES = new Setting<>("frames") {
        @Override Frames get(SceneSettings settings) { return settings.frames; }
        @Override public void set(SceneSettings settings, Frames value) { settings.frames = value; }
        @Override List<?> words(Frames value) { return List.of(value.count(), value.rate()); }

        @Override
        Frames read(SceneReader is) throws IOException {
            int count = is.readInt("number from 1 to " + Film.MAX_FRAMES, 1, Film.MAX_FRAMES);
            double rate = is.readDouble("frames a second");
            if (rate <= 0 || rate > Film.MAX_RATE) {
                is.reject("frames a second above 0 and up to 1000");
            }
            return new Frames(count, rate);
        }
    };

    /** How values go from key to key. */
    public static final Setting<Curve> CURVE = new Setting<>("curve") {
        @Override Curve get(SceneSettings settings) { return settings.curve; }
        @Override public void set(SceneSettings settings, Curve value) { settings.curve = value; }
        @Override List<?> words(Curve value) { return List.of(value); }

        @Override
        Curve read(SceneReader is) throws IOException {
            return Curve.valueOf(is.readWord("linear or smooth", Set.of("linear", "smooth")).toUpperCase(Locale.ROOT));
        }
    };

    /** What things are at some frames; a line each. */
    public static final Setting<List<Key>> KEY = new Setting<>("key") {
        @Override List<Key> get(SceneSettings settings) { return settings.keys; }
        @Override public void set(SceneSettings settings, List<Key> value) { settings.keys = value; }
        @Override List<?> words(List<Key> keys) { return keys.stream().flatMap(key -> key.words().stream()).toList(); }
        @Override List<List<?>> lines(List<Key> keys) { return keys.stream().<List<?>>map(Key::words).toList(); }
        @Override List<Key> read(SceneReader is) throws IOException { return KeyReader.of(is).read(is); }
    };

    /** All settings, in the order of the command line's help. */
    public static final List<Setting<?>> ALL = List.of(RESOLUTION, DEPTH, SAMPLES, COP, WINDOW, CAMERA, PARALLEL, UP, BACKGROUND, FRAMES,
        CURVE, KEY);
    /** All settings, in the order in which they are written into a scene file. */
    static final List<Setting<?>> LINES = List.of(BACKGROUND, WINDOW, COP, CAMERA, PARALLEL, UP, RESOLUTION, DEPTH, SAMPLES, FRAMES,
        CURVE, KEY);

    private static final Map<String, Setting<?>> BY_KEYWORD = byKeyword();

    private final String keyword;
    private final String option;
    private final String label;
    private final String description;
    private final T normal;

    /**
     * Makes an entry of the table.
     *
     * @param option the option's name; null if there is none
     * @param label what the help calls the option's value
     * @param description the option's description for the help, with %s for the default
     * @param normal the default; null if there is none, or no single one
     */
    private Setting(String keyword, String option, String label, String description, T normal) {
        this.keyword = keyword;
        this.option = option;
        this.label = label;
        this.description = description;
        this.normal = normal;
    }

    /** Makes an entry without an option and without a default. */
    private Setting(String keyword) {
        this(keyword, null, null, "", null);
    }

    private static Map<String, Setting<?>> byKeyword() {
        Map<String, Setting<?>> all = new LinkedHashMap<>();
        for (Setting<?> setting : LINES) {
            all.put(setting.keyword, setting);
        }
        return Collections.unmodifiableMap(all);
    }

    /** {@return the keywords of all settings} */
    public static Set<String> keywords() {
        return BY_KEYWORD.keySet();
    }

    /** {@return the setting of a keyword, which must be one} */
    static Setting<?> of(String keyword) {
        return BY_KEYWORD.get(keyword);
    }

    /** {@return the word that begins its line in a scene file} */
    public final String keyword() {
        return keyword;
    }

    /** {@return the name of its option on a command line; null if it has none} */
    public final String option() {
        return option;
    }

    /** {@return what people are told it is called: its option's name without dashes} */
    public final String name() {
        return option == null ? keyword : option.substring(2);
    }

    /** {@return what the help calls the option's value} */
    public final String label() {
        return label;
    }

    /** {@return the option's description for the help} */
    public final String description() {
        return normal == null ? description : description.replace("%s", joined(normal, true));
    }

    /** {@return its value; null if it is not set} */
    abstract T get(SceneSettings settings);

    /**
     * Sets its value.
     *
     * @param settings the settings to change
     * @param value the value; null for none
     */
    public abstract void set(SceneSettings settings, T value);

    /** Reads the values behind its keyword in a scene file. */
    abstract T read(SceneReader is) throws IOException;

    /**
     * Reads the value of its option. Ranges that {@link SceneSettings#newCamera} or the renderer checks are not checked here.
     *
     * @param value the value as on a command line
     * @return the value
     * @throws IllegalArgumentException if it is none; the message says what was expected, and what was found
     * @throws NumberFormatException if it is no integer, and ought to be one
     * @throws UnsupportedOperationException if it has no option
     */
    public T parse(String value) {
        throw new UnsupportedOperationException(keyword + " has no option");
    }

    /**
     * Sets the value of its option.
     *
     * @param value the value as on a command line
     * @param settings the settings to change
     * @throws IllegalArgumentException if it is none, as by {@link #parse(String)}
     */
    public final void parse(String value, SceneSettings settings) {
        set(settings, parse(value));
    }

    /** {@return a value as words of a scene file: doubles, integers and strings} */
    abstract List<?> words(T value);

    /** {@return the words of each of its lines in a scene file} */
    List<List<?>> lines(T value) {
        return List.of(words(value));
    }

    /** {@return what is between the words in an option's value} */
    char separator() {
        return ',';
    }

    /** {@return the kinds of camera that have it; none for a setting that has nothing to do with the camera} */
    Set<Class<? extends Camera>> cameras() {
        return Set.of();
    }

    /** {@return what a picture's identity says if it is not set; null for nothing} */
    String unset() {
        return normal == null ? null : joined(normal, false);
    }

    /** {@return whether a picture tells its default, too, if it is not set} */
    public boolean isAlwaysTold() {
        return false;
    }

    /**
     * Returns its value, or the default if it is not set.
     *
     * @param settings the settings
     * @return the value, not to be changed; null if it is not set and has no default
     */
    public final T in(SceneSettings settings) {
        T value = get(settings);
        return value == null ? normal : value;
    }

    /** {@return whether it belongs to the camera} */
    public final boolean isOfCamera() {
        return !cameras().isEmpty();
    }

    /**
     * Tests whether it is set.
     *
     * @param settings the settings
     * @return whether they have a value of it
     */
    public final boolean isSet(SceneSettings settings) {
        return get(settings) != null;
    }

    /** {@return whether it and another setting exclude each other: no camera has both} */
    final boolean excludes(Setting<?> other) {
        return isOfCamera() && other.isOfCamera() && Collections.disjoint(cameras(), other.cameras());
    }

    /** {@return whether one of the settings excludes it} */
    final boolean isExcludedBy(SceneSettings settings) {
        for (Setting<?> other : ALL) {
            if (other.isSet(settings) && excludes(other)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Copies its value, also if it is not set.
     *
     * @param from where to copy from
     * @param to the settings to change
     */
    public final void copy(SceneSettings from, SceneSettings to) {
        set(to, get(from));
    }

    /**
     * Sets its default.
     *
     * @param settings the settings to change
     */
    public final void reset(SceneSettings settings) {
        set(settings, normal);
    }

    /** Reads its line of a scene file behind the keyword. */
    final void read(SceneReader is, SceneSettings settings) throws IOException {
        set(settings, read(is));
    }

    /** Writes its lines of a scene file, if it is set. */
    final void write(SceneWriter os, SceneSettings settings) throws IOException {
        T value = get(settings);
        if (value == null) {
            return;
        }
        for (List<?> line : lines(value)) {
            os.writeString(keyword);
            for (java.lang.Object word : line) {
                os.writeChar(' ');
                if (word instanceof Double number) {
                    os.writeDouble(number);
                } else {
                    os.writeString(word.toString());
                }
            }
            os.writeNewline();
        }
    }

    /**
     * Returns the value of its option on a command line.
     *
     * @param settings the settings
     * @return the value, which {@link #parse(String)} reads; null if it is not set
     */
    public final String text(SceneSettings settings) {
        T value = get(settings);
        return value == null ? null : joined(value, true);
    }

    /**
     * Says what a picture's identity has of it.
     *
     * @param settings all settings that the picture is made with
     * @return the value, or the default if it is not set; null if it does not count
     */
    public final String identity(SceneSettings settings) {
        T value = get(settings);
        return value != null ? joined(value, false) : isExcludedBy(settings) ? null : unset();
    }

    /** {@return the words of a value in one; whole numbers without a fraction, if it is to be short} */
    private String joined(T value, boolean brief) {
        StringBuilder text = new StringBuilder();
        for (java.lang.Object word : words(value)) {
            boolean whole = brief && word instanceof Double x && x == Math.rint(x) && Math.abs(x) < Integer.MAX_VALUE && !x.equals(-0.0);
            text.append(text.length() == 0 ? "" : separator()).append(whole ? Integer.toString(((Double) word).intValue()) : word);
        }
        return text.toString();
    }

    /** Reads numbers between commas. */
    private static double[] numbers(String value, int count, String wanted) {
        String[] words = value.split(",", -1);
        double[] numbers = new double[count];
        for (int i = 0; i < count; i++) {
            numbers[i] = words.length == count ? NumberParser.parseDouble(words[i]) : Double.NaN;
            if (Double.isNaN(numbers[i])) {
                throw expected(wanted, value);
            }
        }
        return numbers;
    }

    private static IllegalArgumentException expected(String wanted, String found) {
        return new IllegalArgumentException("expected " + wanted + ", found '" + found + "'");
    }
}
