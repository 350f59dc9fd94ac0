package simpleray.cli;

import java.util.Locale;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;
import simpleray.math.Colour;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.SceneSettings.Window;
import simpleray.text.Numbers;

/** The options that say which picture is made of a scene. What they say wins over the scene file. */
final class PictureOptions {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Option(names = "--size", paramLabel = "WxH", converter = SizeConverter.class,
        description = "Width and height in pixels, 1 to " + SceneSettings.MOST_RESOLUTION + " each (default: 200x200).")
    private Resolution size;

    @Option(names = "--depth", paramLabel = "N",
        description = "The most reflections of a ray, 0 to " + SceneSettings.MOST_DEPTH + " (default: 10).")
    private Integer depth;

    @Option(names = "--samples", paramLabel = "N",
        description = "N x N samples a pixel, N from 1 to " + SceneSettings.MOST_SAMPLES + " (default: 1), for smooth edges; or adaptive: "
            + "as good as 4, but only where it is needed.")
    private String samples;

    @Option(names = "--cop", paramLabel = "Z", converter = NumberConverter.class,
        description = "The eye is at (0, 0, Z), Z > 0 (default: 2).")
    private Double cop;

    @Option(names = "--window", paramLabel = "XMIN,XMAX,YMIN,YMAX", converter = WindowConverter.class,
        description = "The piece of the plane z = 0 that fills the picture (default: -2,2,-2,2, more along the longer side).")
    private Window window;

    @Option(names = "--camera", paramLabel = "EX,EY,EZ,LX,LY,LZ,FOV", converter = CameraConverter.class,
        description = "Instead of these two: the eye, the point it looks at, and the vertical field of view in degrees.")
    private Pose camera;

    @Option(names = "--background", paramLabel = "R,G,B", converter = ColourConverter.class,
        description = "The colour where nothing is hit, 0 to 1 each (default: 0,0,0).")
    private Colour background;

    /** {@return what was asked for, with that stage and that many threads} */
    RenderRequest request(Stage stage, int threads) {
        SceneSettings asked = new SceneSettings();
        asked.resolution = size;
        asked.depth = depth;
        asked.cop = cop;
        asked.window = window;
        asked.camera = camera;
        asked.background = background;
        boolean adaptive = samples != null && samples.toLowerCase(Locale.ROOT).equals("adaptive");
        if (samples != null && !adaptive) {
            Long n = Numbers.parseInteger(samples, 1, SceneSettings.MOST_SAMPLES);
            if (n == null) {
                throw wrong("--samples must be 1 to " + SceneSettings.MOST_SAMPLES + " or adaptive, and is '" + samples + "'");
            }
            asked.samples = n.intValue();
        }
        if (camera != null && (cop != null || window != null)) {
            throw wrong("--camera takes the place of --cop and --window: give one or the other");
        }
        RenderRequest request = new RenderRequest(asked, stage, adaptive, threads);
        try {
            request.renderer(new Scene());                    // what is out of its range is known before the scene is read
            return request;
        } catch (IllegalArgumentException e) {
            throw wrong(e.getMessage());
        }
    }

    private ParameterException wrong(String message) {
        return new ParameterException(spec.commandLine(), message);
    }

    /** {@return the numbers of a list with commas; refuses another number of them} */
    private static double[] numbers(String value, int count, String wanted) {
        String[] words = value.split(",", -1);
        double[] numbers = new double[count];
        for (int i = 0; i < count; i++) {
            numbers[i] = words.length == count ? Numbers.parseDouble(words[i]) : Double.NaN;
            if (Double.isNaN(numbers[i])) {
                throw new TypeConversionException("expected " + wanted + ", found '" + value + "'");
            }
        }
        return numbers;
    }

    /** Reads {@code 640x480}. */
    static final class SizeConverter implements ITypeConverter<Resolution> {
        @Override
        public Resolution convert(String value) {
            String[] sides = value.split("[xX]", -1);
            Long width = sides.length == 2 ? Numbers.parseInteger(sides[0], 1, SceneSettings.MOST_RESOLUTION) : null;
            Long height = sides.length == 2 ? Numbers.parseInteger(sides[1], 1, SceneSettings.MOST_RESOLUTION) : null;
            if (width == null || height == null) {
                throw new TypeConversionException(
                    "expected WxH such as 640x480, 1 to " + SceneSettings.MOST_RESOLUTION + " each, found '" + value + "'");
            }
            return new Resolution(width.intValue(), height.intValue());
        }
    }

    /** Reads a number as a scene file has it. */
    static final class NumberConverter implements ITypeConverter<Double> {
        @Override
        public Double convert(String value) {
            double number = Numbers.parseDouble(value);
            if (Double.isNaN(number)) {
                throw new TypeConversionException("expected a number, found '" + value + "'");
            }
            return number;
        }
    }

    /** Reads {@code -2,2,-2,2}. */
    static final class WindowConverter implements ITypeConverter<Window> {
        @Override
        public Window convert(String value) {
            double[] n = numbers(value, 4, "four numbers such as -2,2,-2,2");
            return new Window(n[0], n[1], n[2], n[3]);
        }
    }

    /** Reads {@code 3,2,5,0,0,0,40}. */
    static final class CameraConverter implements ITypeConverter<Pose> {
        @Override
        public Pose convert(String value) {
            double[] n = numbers(value, 7, "seven numbers such as 3,2,5,0,0,0,40");
            Pose pose = new Pose(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
            if (pose.fault() != null) {
                throw new TypeConversionException("expected a " + pose.fault() + ", found '" + value + "'");
            }
            return pose;
        }
    }

    /** Reads {@code 0.1,0.2,0.4}. */
    static final class ColourConverter implements ITypeConverter<Colour> {
        @Override
        public Colour convert(String value) {
            double[] n = numbers(value, 3, "three numbers such as 0.1,0.2,0.4");
            if (n[0] < 0 || n[1] < 0 || n[2] < 0) {
                throw new TypeConversionException("expected numbers of 0 or more, found '" + value + "'");
            }
            return new Colour(n[0], n[1], n[2]);
        }
    }
}
