package simpleray.cli;

import java.io.IOException;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.scene.Scene;
import simpleray.text.SceneWriter;

/** Prints how a scene file was understood. */
@Command(name = "print", mixinStandardHelpOptions = true,
    description = "Prints how a scene file was understood, as the thesis's Interpretation does.")
final class PrintCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", description = SceneArgument.DESCRIPTION)
    private String scene;

    @Override
    public Integer call() throws Failure {
        Scene read = SceneArgument.read(scene, main.in(), main.err()).scene();
        try {
            SceneWriter writer = new SceneWriter(main.out());
            read.print(writer);
            writer.flush();
        } catch (IOException e) {
            throw new Failure(ExitCode.WRITE_ERROR, "simpleray: standard output cannot be written: " + e.getMessage());
        }
        return ExitCode.DONE;
    }
}
