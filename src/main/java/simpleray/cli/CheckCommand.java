package simpleray.cli;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.image.png.PictureFormatException;
import simpleray.render.SceneLint;
import simpleray.scene.SceneFile;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/** Reads scene files and reports what is wrong or odd about them. */
@Command(mixinStandardHelpOptions = true,
    description = "Reads scene files, and reports their errors and warnings. The exit code is that of the worst: 66, 65 or 0.")
final class CheckCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", arity = "1..*", description = "The scene files; - is standard input.")
    private List<String> scenes;

    @Option(names = "--errors", paramLabel = "FORMAT", defaultValue = "text",
        description = "How errors and warnings are told: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}). json is one array on "
            + "standard output, of objects with file, line, column, severity and message, for editors.")
    private Stats.Format errors;

    @Mixin
    private FrameOption frame;

    @Mixin
    private OutsideOption outside;

    @Override
    public Integer call() throws CommandException {
        return errors == Stats.Format.JSON ? json() : text();
    }

    private int text() throws CommandException {
        int worst = ExitCode.DONE;
        for (String scene : scenes) {
            try {
                SceneFile file = SceneArgument.read(scene, main.in(), main.err(), outside.reach());
                List<Diagnostic> more = SceneLint.all(meant(file, scene), SceneArgument.told(scene));
                more.forEach(main.err()::println);
                int warnings = file.warnings().size() + more.size();
                TextOutput.say(main, scene + ": good: " + count(file.scene().getNumberObjects(), "object") + ", "
                    + count(file.scene().getNumberLights(), "light") + frames(file) + (warnings > 0 ? ", " + count(warnings, "warning") : "") + '\n');
            } catch (CommandException e) {
                if (e.exitCode() == ExitCode.WRITE_ERROR || e.exitCode() == ExitCode.USAGE) {
                    throw e;
                }
                main.err().println(e.getMessage());
                worst = Math.max(worst, e.exitCode());
            }
        }
        return worst;
    }

    private int json() throws CommandException {
        int worst = ExitCode.DONE;
        List<Diagnostic> problems = new ArrayList<>();
        for (String scene : scenes) {
            String name = SceneArgument.told(scene);
            try {
                SceneFile file = SceneArgument.open(scene, main.in(), outside.reach());
                problems.addAll(file.warnings());
                problems.addAll(SceneLint.all(meant(file, scene), name));
            } catch (SceneFormatException e) {
                problems.addAll(e.problems());
                worst = Math.max(worst, ExitCode.BAD_SCENE);
            } catch (PictureFormatException e) {
                problems.add(new Diagnostic(name, 1, 1, true, e.fault(), null));
                worst = Math.max(worst, ExitCode.BAD_SCENE);
            } catch (IOException e) {
                String reason = e instanceof FileSystemException f ? f.getReason() : "cannot be read: " + e.getMessage();
                problems.add(new Diagnostic(name, 1, 1, true, reason, null));
                worst = Math.max(worst, ExitCode.NO_SCENE);
            }
        }
        TextOutput.say(main, Json.array(problems));
        return worst;
    }

    /** {@return the frame that is asked for; the whole film without one} */
    private SceneFile meant(SceneFile file, String scene) throws CommandException {
        return frame.isGiven() ? frame.of(file, scene) : file;
    }

    private static String frames(SceneFile file) {
        return file.scene().settings.frames == null ? "" : ", " + count(file.scene().settings.frames.count(), "frame");
    }

    private static String count(int n, String what) {
        return n + " " + what + (n == 1 ? "" : "s");
    }
}
