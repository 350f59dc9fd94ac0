package simpleray.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.image.Picture;
import simpleray.render.RenderRequest;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.Setting;
import simpleray.ui.Viewer;
import simpleray.ui.file.SceneSource;
import simpleray.ui.widget.Look;

/** Opens the window. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Opens a window in which the picture appears row by row.")
final class ViewCommand implements PlainCommand {
    /** Bytes for each pixel that a window takes beside the picture: its image, and rows on their way to it. */
    private static final long SCREEN = 8;

    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", arity = "0..1", description = SceneArgument.DESCRIPTION
        + " An OBJ model is shown in a scene made for it."
        + " Without a file, the window shows the examples.")
    private String scene;

    @Mixin
    private final PictureOptions picture = new PictureOptions();

    @Mixin
    private final StageOption stage = new StageOption();

    @Mixin
    private final OptionGroup desktop = new OptionGroup();
    private final CommandOption<Look> look = desktop.add(CommandOption.choice(Look.values(), null, "LOOK",
        "${COMPLETION-CANDIDATES}: how this window looks, system being as the desktop is set (default: as chosen in the "
            + "window before, at first system).", "--look"));

    @Mixin
    private final OutsideOption outside = new OutsideOption();

    /** As picocli makes it, which then fills in the fields. */
    ViewCommand() {
    }

    /** A command whose line is read without picocli. */
    ViewCommand(Main main) {
        this.main = main;
    }

    @Override
    public List<OptionGroup> options() {
        return List.of(picture, stage, desktop, outside);
    }

    @Override
    public void setScene(String name) {
        scene = name;
    }

    @Override
    public boolean needsScene() {
        return false;                                         // without one the window shows the examples
    }

    @Override
    public String name() {
        return "view";
    }

    @Override
    public Integer call() throws CommandException {
        RenderRequest request = picture.request(stage.stage(), Runtime.getRuntime().availableProcessors());
        String fault = WindowSupport.fault();
        if (fault != null) {
            throw new CommandException(ExitCode.UNAVAILABLE, "simpleray: " + fault + "; simpleray render works without one");
        }
        Resolution size = Setting.RESOLUTION.in(request.settings());
        HeapCheck.require("a picture of " + size.width() + 'x' + size.height(),
            Picture.bytesNeeded(size.width(), size.height(), Picture.RGB) + SCREEN * size.width() * size.height());
        Viewer.view(source(), request, look.value());
        return ExitCode.DONE;
    }

    private SceneSource source() throws CommandException {
        if (scene == null) {
            return SceneSource.NONE;
        }
        if (!scene.equals(SceneArgument.STREAM)) {
            return SceneSource.file(Path.of(scene), outside.reach());
        }
        try {
            return SceneSource.text(main.in().readAllBytes(), outside.reach());
        } catch (IOException e) {
            throw new CommandException(ExitCode.NO_SCENE, "simpleray: <stdin>: cannot be read: " + e.getMessage());
        }
    }
}
