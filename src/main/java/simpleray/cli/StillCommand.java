package simpleray.cli;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.scene.SceneFile;

/** Writes a frame of a film as a scene of its own. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Writes a frame of a film as a scene of its own, in the form of convert. Its picture is that of the frame, pixel for pixel.")
final class StillCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", description = SceneArgument.DESCRIPTION)
    private String scene;

    @Option(names = {"-o", "--output"}, paramLabel = "OUT.scene", required = true, description = "The scene file to write; - is standard output.")
    private String output;

    @Mixin
    private FrameOption frame;

    @Mixin
    private OutsideOption outside;

    @Override
    public Integer call() throws CommandException {
        OutputName.refuseScene(output, scene);
        SceneFile film = SceneArgument.read(scene, main.in(), main.err(), outside.reach());
        OutputName.refuseNamed(output, scene, film);
        TextOutput.writeScene(main, output, frame.of(film, scene).scene(), scene);
        return ExitCode.DONE;
    }
}
