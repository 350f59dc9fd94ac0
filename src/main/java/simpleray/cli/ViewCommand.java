package simpleray.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.image.Picture;
import simpleray.render.RenderRequest;
import simpleray.scene.Scene;
import simpleray.ui.SceneSource;
import simpleray.ui.Viewer;

/** Opens the window. */
@Command(name = "view", mixinStandardHelpOptions = true, sortOptions = false,
    description = "Opens a window in which the picture appears row by row.")
final class ViewCommand implements Callable<Integer> {
    /** Bytes for each pixel that a window takes beside the picture: its image, and rows on their way to it. */
    private static final long SCREEN = 8;

    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", arity = "0..1", description = SceneArgument.DESCRIPTION + " Without one, the window is empty.")
    private String scene;

    @Mixin
    private PictureOptions picture;

    @Mixin
    private StageOption stage;

    @Override
    public Integer call() throws Failure {
        RenderRequest request = picture.request(stage.stage(), Runtime.getRuntime().availableProcessors());
        if (!Viewer.hasDisplay()) {
            throw new Failure(ExitCode.NO_DISPLAY, "simpleray: there is no display for a window; simpleray render works without one");
        }
        Picture asked = request.renderer(new Scene()).picture();
        Memory.require("a picture of " + asked.width() + 'x' + asked.height(),
            Picture.bytesNeeded(asked.width(), asked.height()) + SCREEN * asked.width() * asked.height());
        Viewer.view(source(), request);
        return ExitCode.DONE;
    }

    private SceneSource source() throws Failure {
        if (scene == null) {
            return SceneSource.NONE;
        }
        if (!scene.equals(SceneArgument.STREAM)) {
            return SceneSource.file(Path.of(scene));
        }
        try {
            return SceneSource.text(main.in().readAllBytes());
        } catch (IOException e) {
            throw new Failure(ExitCode.NO_SCENE, "simpleray: <stdin>: cannot be read: " + e.getMessage());
        }
    }
}
