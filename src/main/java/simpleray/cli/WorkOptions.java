package simpleray.cli;

import java.io.PrintStream;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import simpleray.image.Picture;
import simpleray.render.Progress;

/** The options that say how a command works without a window, and what it says meanwhile. The picture does not depend on them. */
final class WorkOptions {
    private static final int MOST_THREADS = 1024;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Option(names = "--threads", paramLabel = "N",
        description = "How many threads work, 1 to " + MOST_THREADS + " (default: one for each processor). The picture is the same.")
    private Integer threads;

    @Option(names = "--progress", paramLabel = "HOW", defaultValue = "auto",
        description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}: a bar if standard error is a terminal, else "
            + "none); without a terminal, bar is plain.")
    private ProgressPrinter.Style progress;

    @Option(names = {"-q", "--quiet"}, description = "Say nothing but errors.")
    private boolean quiet;

    /**
     * Finds the number of threads.
     *
     * @throws ParameterException if it is out of its range
     */
    int threads() {
        if (threads != null && (threads < 1 || threads > MOST_THREADS)) {
            throw new ParameterException(spec.commandLine(), "--threads must be 1 to " + MOST_THREADS + ", and is " + threads);
        }
        return threads == null ? Runtime.getRuntime().availableProcessors() : threads;
    }

    /** {@return where warnings go; null for nowhere} */
    PrintStream warnings(PrintStream err) {
        return quiet ? null : err;
    }

    /** {@return what shows progress on standard error, if it is to be shown} */
    ProgressPrinter printer(Progress counter, PrintStream err) {
        return new ProgressPrinter(counter, err, quiet ? ProgressPrinter.Style.NONE : progress);
    }

    /** Says that a picture is written. */
    void report(PrintStream err, String name, Picture picture, double seconds) {
        if (!quiet) {
            err.println(name + ": " + picture.width() + 'x' + picture.height() + ", " + Progress.time(seconds));
        }
    }
}
