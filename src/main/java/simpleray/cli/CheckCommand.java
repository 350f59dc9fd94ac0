package simpleray.cli;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.scene.SceneFile;

/** Reads scene files and reports what is wrong or odd about them. */
@Command(name = "check", mixinStandardHelpOptions = true,
    description = "Reads scene files, and reports their errors and warnings. The exit code is that of the worst: 66, 65 or 0.")
final class CheckCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", arity = "1..*", description = "The scene files; - is standard input.")
    private List<String> scenes;

    @Override
    public Integer call() throws Failure {
        int worst = ExitCode.DONE;
        for (String scene : scenes) {
            try {
                SceneFile file = SceneArgument.read(scene, main.in(), main.err());
                int warnings = file.warnings().size();
                say(scene + ": good: " + count(file.scene().getNumberObjects(), "object") + ", "
                    + count(file.scene().getNumberLights(), "light") + (warnings > 0 ? ", " + count(warnings, "warning") : ""));
            } catch (Failure e) {
                if (e.exitCode() == ExitCode.WRITE_ERROR) {
                    throw e;
                }
                main.err().println(e.getMessage());
                worst = Math.max(worst, e.exitCode());
            }
        }
        return worst;
    }

    private void say(String line) throws Failure {
        try {
            OutputStream out = main.out();
            out.write((line + '\n').getBytes(StandardCharsets.UTF_8));
            out.flush();
        } catch (IOException e) {
            throw new Failure(ExitCode.WRITE_ERROR, "simpleray: standard output cannot be written: " + e.getMessage());
        }
    }

    private static String count(int n, String what) {
        return n + " " + what + (n == 1 ? "" : "s");
    }
}
