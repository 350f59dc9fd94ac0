package simpleray.cli;

import java.util.Locale;
import picocli.CommandLine.Option;
import simpleray.math.Colour;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.SceneSettings.Window;
import simpleray.text.NumberParser;

/** The options that say which picture is made of a scene. What they say wins over the scene file. */
final class PictureOptions {
    @Option(names = "--size", paramLabel = "WxH",
        description = "Width and height in pixels, 1 to " + SceneSettings.MAX_RESOLUTION + " each (default: 200x200).")
    private Resolution size;

    @Option(names = "--depth", paramLabel = "N",
        description = "The most reflections of a ray, 0 to " + SceneSettings.MAX_DEPTH + " (default: 10).")
    private Integer depth;

    @Option(names = "--samples", paramLabel = "N",
        description = "N x N samples a pixel, N from 1 to " + SceneSettings.MAX_SAMPLES + " (default: 1), for smooth edges; or adaptive: "
            + "as good as 4, but only where it is needed.")
    private String samples;

    @Option(names = "--cop", paramLabel = "Z",
        description = "The eye is at (0, 0, Z), Z > 0 (default: 2).")
    private Double cop;

    @Option(names = "--window", paramLabel = "XMIN,XMAX,YMIN,YMAX",
        description = "The piece of the plane z = 0 that fills the picture (default: -2,2,-2,2, more along the longer side).")
    private Window window;

    @Option(names = "--camera", paramLabel = "EX,EY,EZ,LX,LY,LZ,FOV",
        description = "Instead of these two: the eye, the point it looks at, and the vertical field of view in degrees.")
    private Pose camera;

    @Option(names = "--background", paramLabel = "R,G,B",
        description = "The colour where nothing is hit, 0 to 1 each (default: 0,0,0).")
    private Colour background;

    /**
     * Takes an option as picocli would.
     *
     * @return whether it is one of these
     * @throws IllegalArgumentException if it cannot have that value
     */
    boolean take(String name, String value) {
        switch (name) {
            case "--size" -> size = Values.size(value);
            case "--depth" -> depth = Integer.valueOf(value);
            case "--samples" -> samples = value;
            case "--cop" -> cop = Values.number(value);
            case "--window" -> window = Values.window(value);
            case "--camera" -> camera = Values.camera(value);
            case "--background" -> background = Values.colour(value);
            default -> {
                return false;
            }
        }
        return true;
    }

    /**
     * Puts together what was asked for.
     *
     * @throws CommandException if something is out of its range
     */
    RenderRequest request(Stage stage, int threads) throws CommandException {
        SceneSettings asked = new SceneSettings();
        asked.resolution = size;
        asked.depth = depth;
        asked.cop = cop;
        asked.window = window;
        asked.camera = camera;
        asked.background = background;
        boolean adaptive = samples != null && samples.toLowerCase(Locale.ROOT).equals("adaptive");
        if (samples != null && !adaptive) {
            Long n = NumberParser.parseInteger(samples, 1, SceneSettings.MAX_SAMPLES);
            if (n == null) {
                throw CommandException.usage("--samples must be 1 to " + SceneSettings.MAX_SAMPLES + " or adaptive, and is '" + samples + "'");
            }
            asked.samples = n.intValue();
        }
        if (camera != null && (cop != null || window != null)) {
            throw CommandException.usage("--camera takes the place of --cop and --window: give one or the other");
        }
        RenderRequest request = new RenderRequest(asked, stage, adaptive, threads);
        try {
            request.renderer(new Scene());                    // what is out of its range is known before the scene is read
            return request;
        } catch (IllegalArgumentException e) {
            throw CommandException.usage(e.getMessage());
        }
    }
}
