package simpleray.cli;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.IModelTransformer;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.pov.PovChannel;
import simpleray.pov.PovExporter;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.Setting;

/** Writes a scene for another renderer. */
@Command(mixinStandardHelpOptions = true, sortOptions = false, modelTransformer = ExportCommand.Fewer.class,
    description = "Writes a scene for POV-Ray 3.7, which makes the same picture of it, as nearly as it can.")
final class ExportCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", description = SceneArgument.DESCRIPTION)
    private String scene;

    @Option(names = "--pov", required = true, description = "For POV-Ray 3.7.")
    @SuppressWarnings("unused")                               // required, so it says nothing more
    private boolean pov;

    @Option(names = {"-o", "--output"}, paramLabel = "OUT.pov", required = true,
        description = "The file to write; - is standard output.")
    private String output;

    @Option(names = "--channel", paramLabel = "CHANNEL", defaultValue = "all",
        description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}): one colour channel, as a grey picture, is exact; in all "
            + "of them at once coloured highlights turn grey.")
    private PovChannel channel;

    @Mixin
    private OutsideOption outside;

    @Mixin
    private FrameOption frame;

    @Mixin
    private PictureOptions picture;

    @Override
    public Integer call() throws CommandException {
        RenderRequest request = picture.request(Stage.FINAL, 1);
        OutputName.refuseScene(output, scene);
        SceneFile file = SceneArgument.read(scene, main.in(), main.err(), outside.reach());
        OutputName.refuseNamed(output, scene, file);
        Scene asked = request.applyTo(frame.of(file, scene).scene());
        PovExporter exported = new PovExporter(asked, asked.settings.newCamera(), Setting.DEPTH.in(asked.settings), channel);
        try {
            TextOutput.write(main, output, exported::write);
        } catch (UnsupportedOperationException e) {
            throw new CommandException(ExitCode.BAD_SCENE, "simpleray: " + scene + ": " + e.getMessage());
        }
        for (String warning : exported.warnings()) {
            main.err().println(scene + ": warning: " + warning);
        }
        return ExitCode.DONE;
    }

    /** Takes out the picture option that an exported scene cannot hold: POV-Ray smooths edges by +A. */
    static final class Fewer implements IModelTransformer {
        @Override
        public CommandSpec transform(CommandSpec spec) {
            spec.remove(spec.findOption("--samples"));
            return spec;
        }
    }
}
