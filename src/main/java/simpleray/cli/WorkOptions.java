package simpleray.cli;

import java.io.PrintStream;
import picocli.CommandLine.Option;
import simpleray.image.Picture;
import simpleray.render.Accel;
import simpleray.render.Progress;

/** The options that say how a command works without a window, and what it says meanwhile. The picture does not depend on them. */
final class WorkOptions {
    private static final int MAX_THREADS = 1024;

    @Option(names = "--threads", paramLabel = "N",
        description = "How many threads work, 1 to " + MAX_THREADS + " (default: one for each processor). The picture is the same.")
    private Integer threads;

    @Option(names = "--accel", paramLabel = "HOW", defaultValue = "auto",
        description = "How the nearest object is found: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}); none asks all objects "
            + "in turn, as the thesis does. The picture is the same.")
    private Accel accel = Accel.AUTO;

    @Option(names = "--progress", paramLabel = "HOW", defaultValue = "auto",
        description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}: a bar if standard error is a terminal, else "
            + "none); without a terminal, with TERM=dumb, or with NO_COLOR, bar is plain.")
    private ProgressPrinter.Style progress = ProgressPrinter.Style.AUTO;

    @Option(names = {"-q", "--quiet"}, description = "Say nothing but errors.")
    private boolean quiet;

    /** Takes an option as picocli would. */
    boolean take(String name, String value) {
        switch (name) {
            case "--threads" -> threads = Integer.valueOf(value);
            case "--accel" -> accel = Values.constant(Accel.values(), value);
            case "--progress" -> progress = Values.constant(ProgressPrinter.Style.values(), value);
            case "--quiet" -> quiet = true;
            default -> {
                return false;
            }
        }
        return true;
    }

    /**
     * Finds the number of threads.
     *
     * @throws CommandException if it is out of its range
     */
    int threads() throws CommandException {
        if (threads != null && (threads < 1 || threads > MAX_THREADS)) {
            throw CommandException.usage("--threads must be 1 to " + MAX_THREADS + ", and is " + threads);
        }
        return threads == null ? Runtime.getRuntime().availableProcessors() : threads;
    }

    /** {@return how the nearest object is found} */
    Accel accel() {
        return accel;
    }

    /** {@return where warnings go; null for nowhere} */
    PrintStream warnings(PrintStream err) {
        return quiet ? null : err;
    }

    boolean quiet() {
        return quiet;
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
