package simpleray.cli;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.scene.Scene;

/** Prints how a scene file was understood. */
@Command(mixinStandardHelpOptions = true,
    description = "Prints how a scene file was understood, as the thesis's Interpretation does.")
final class PrintCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", description = SceneArgument.DESCRIPTION)
    private String scene;

    @Mixin
    private OutsideOption outside;

    @Override
    public Integer call() throws CommandException {
        Scene read = SceneArgument.read(scene, main.in(), main.err(), outside.reach()).scene();
        TextOutput.write(main, SceneArgument.STREAM, read::print);
        return ExitCode.DONE;
    }
}
