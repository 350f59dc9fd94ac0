package simpleray.cli;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.scene.SceneFile;

/** Rewrites a scene in canonical form. */
@Command(mixinStandardHelpOptions = true,
    description = "Rewrites a scene in canonical form: the same scene, one line for each thing, comments aside. "
        + "IN and OUT may be one file.")
final class ConvertCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(index = "0", paramLabel = "IN", description = SceneArgument.DESCRIPTION)
    private String in;

    @Parameters(index = "1", paramLabel = "OUT", description = "The scene file to write; - is standard output.")
    private String out;

    @Mixin
    private OutsideOption outside;

    @Override
    public Integer call() throws CommandException {
        OutputName.refusePicture(out, in);
        SceneFile file = SceneArgument.read(in, main.in(), main.err(), outside.reach());
        OutputName.refuseNamed(out, in, file);
        TextOutput.writeScene(main, out, file.scene(), in);
        return ExitCode.DONE;
    }
}
