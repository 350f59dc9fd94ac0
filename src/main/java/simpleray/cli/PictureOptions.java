package simpleray.cli;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;
import simpleray.image.Picture;
import simpleray.render.RenderSettings;
import simpleray.render.Stage;
import simpleray.scene.SimpleCamera;
import simpleray.text.Numbers;

/** The options that say which picture is made of a scene. */
final class PictureOptions {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Option(names = "--size", paramLabel = "WxH", converter = SizeConverter.class, defaultValue = "200x200",
        description = "Width and height in pixels, 1 to " + Picture.LONGEST_SIDE + " each (default: ${DEFAULT-VALUE}).")
    private Size size;

    @Option(names = "--stage", paramLabel = "STAGE", defaultValue = "final",
        description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}): before lighting; with lighting; with shadows and "
            + "reflections; one term of lighting alone.")
    private Stage stage;

    @Option(names = "--depth", paramLabel = "N", defaultValue = "10",
        description = "The most reflections of a ray, 0 to " + RenderSettings.MOST_DEPTH + " (default: ${DEFAULT-VALUE}).")
    private int depth;

    @Option(names = "--cop", paramLabel = "Z", converter = NumberConverter.class,
        description = "The eye is at (0, 0, Z), Z > 0 (default: 2).")
    private Double cop;

    @Option(names = "--window", paramLabel = "XMIN,XMAX,YMIN,YMAX", converter = WindowConverter.class,
        description = "The piece of the plane z = 0 that fills the picture (default: -2,2,-2,2, more along the longer side).")
    private Window window;

    /** Width and height in pixels. */
    record Size(int width, int height) {
    }

    /** The edges of a viewport window. */
    record Window(double xmin, double xmax, double ymin, double ymax) {
    }

    /** {@return a camera as asked for} */
    SimpleCamera camera() {
        SimpleCamera camera = new SimpleCamera(size.width, size.height);
        try {
            if (cop != null) {
                camera.setCOP(cop);
            }
            if (window != null) {
                camera.setVPWindow(window.xmin, window.xmax, window.ymin, window.ymax);
            }
            return camera;
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        }
    }

    /** {@return the settings as asked for, with that many threads} */
    RenderSettings settings(int threads) {
        try {
            return new RenderSettings(stage, depth, threads);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        }
    }

    /** Reads {@code 640x480}. */
    static final class SizeConverter implements ITypeConverter<Size> {
        @Override
        public Size convert(String value) {
            String[] sides = value.split("[xX]", -1);
            Long width = sides.length == 2 ? Numbers.parseInteger(sides[0], 1, Picture.LONGEST_SIDE) : null;
            Long height = sides.length == 2 ? Numbers.parseInteger(sides[1], 1, Picture.LONGEST_SIDE) : null;
            if (width == null || height == null) {
                throw new TypeConversionException(
                    "expected WxH such as 640x480, 1 to " + Picture.LONGEST_SIDE + " each, found '" + value + "'");
            }
            return new Size(width.intValue(), height.intValue());
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
            String[] edges = value.split(",", -1);
            double[] numbers = new double[4];
            for (int i = 0; i < numbers.length; i++) {
                numbers[i] = edges.length == numbers.length ? Numbers.parseDouble(edges[i]) : Double.NaN;
                if (Double.isNaN(numbers[i])) {
                    throw new TypeConversionException("expected four numbers such as -2,2,-2,2, found '" + value + "'");
                }
            }
            return new Window(numbers[0], numbers[1], numbers[2], numbers[3]);
        }
    }
}
