package simpleray.cli;

import java.io.IOException;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import simpleray.image.Picture;
import simpleray.image.png.PngWriter;
import simpleray.io.AtomicFile;
import simpleray.math.Point;
import simpleray.rays.OutsideView;
import simpleray.rays.RayDrawing;
import simpleray.rays.RaySegment;
import simpleray.rays.RaySegment.Kind;
import simpleray.render.PixelStory;
import simpleray.render.Provenance;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Camera;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.Setting;

/** The options of a drawing of a pixel's rays. */
final class DrawOptions extends OptionGroup {
    private static final Resolution SIZE = new Resolution(960, 720);
    private static final int SAMPLES = 2;

    private final CommandOption<String> out = add(CommandOption.text("OUT.png",
        "Also draw the pixel's rays in the scene, as an eye outside sees them: a PNG file.", "--draw"));
    private final CommandOption<Point> from = add(new CommandOption<>(null, "EX,EY,EZ",
        "With --draw: where that eye is. It looks at the middle of the rays. Without it, the eye is aside of the primary ray and above.",
        "--from") {
        @Override
        Point parse(String text) {
            return Values.point(text);
        }
    });
    private final CommandOption<Resolution> size = add(new CommandOption<>(null, "WxH", "With --draw: the drawing's size in pixels "
        + "(default: " + SIZE.width() + 'x' + SIZE.height() + ").", "--draw-size") {
        @Override
        Resolution parse(String text) {
            return Setting.RESOLUTION.parse(text);
        }
    });
    private final CommandOption<Boolean> vectors = add(CommandOption.flag("With --draw: also the normals N and the halfway vectors H.",
        "--vectors"));

    boolean isAsked() throws CommandException {
        if (out.value() == null && (from.value() != null || size.value() != null || vectors.value())) {
            throw CommandException.usage("--from, --draw-size and --vectors belong to --draw OUT.png");
        }
        return out.value() != null;
    }

    /** Makes sure, before the scene is read, that the drawing may have its name. */
    void checkName(String scene) throws CommandException {
        if (OutputName.isStandardOutput(out.value())) {
            throw CommandException.usage("the drawing and the story cannot both go to standard output");
        }
        OutputName.refuseOtherFormats(out.value());
        OutputName.refuseScene(out.value(), scene);
        OutputName.refuseSceneNames(out.value());
    }

    /** Draws the rays of a pixel. */
    void draw(Main main, boolean quiet, PixelStory story, RenderRequest request, String name, SceneFile file) throws CommandException {
        OutputName.refuseNamed(out.value(), name, file);
        int width = (size.value() == null ? SIZE : size.value()).width();
        int height = (size.value() == null ? SIZE : size.value()).height();
        HeapCheck.require("a drawing of " + width + 'x' + height, 2 * Picture.bytesNeeded(width, height, Picture.RGB));
        Scene scene = request.applyTo(file.scene());
        Camera inside = scene.settings.newCamera();
        List<RaySegment> segments = RaySegment.of(story, scene);
        Set<Kind> kinds = vectors.value() ? EnumSet.allOf(Kind.class) : RayDrawing.RAYS;
        OutsideView view = OutsideView.of(scene, segments.get(0).from(),
            pose(segments, inside, width, height), width, height, Stage.FINAL, SAMPLES);
        Picture drawing = new RayDrawing(view, inside, segments, kinds).picture(story.x(), story.y());
        drawing.tell(Provenance.ofSheet(request, file, "rays: pixel " + story.x() + ',' + story.y()));
        write(main, quiet, drawing);
    }

    private Pose pose(List<RaySegment> segments, Camera inside, int width, int height) throws CommandException {
        try {
            return from.value() == null ? OutsideView.pose(segments, inside, width, height)
                : OutsideView.pose(segments, inside, from.value());
        } catch (IllegalArgumentException e) {
            throw CommandException.usage("--from must be " + e.getMessage());
        }
    }

    private void write(Main main, boolean quiet, Picture drawing) throws CommandException {
        try (AtomicFile target = TextOutput.begin(out.value(), quiet ? null : main.err())) {
            PngWriter.write(drawing, target.out());
            target.commit();
        } catch (IOException e) {
            throw new CommandException(ExitCode.WRITE_ERROR, "simpleray: " + out.value() + ": cannot be written: " + e.getMessage());
        }
    }
}
