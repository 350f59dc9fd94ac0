package simpleray.cli;

import java.io.PrintStream;
import simpleray.image.Picture;
import simpleray.render.Accel;
import simpleray.render.Progress;

/** The options that say how a command works without a window, and what it says meanwhile. The picture does not depend on them. */
final class WorkOptions extends OptionGroup {
    private static final int MAX_THREADS = 1024;
    private static final int ALL = 100;                       // per cent

    private final CommandOption<Integer> threads = add(CommandOption.integer("N",
        "How many threads work, 1 to " + MAX_THREADS + " (default: one for each processor). The picture is the same.", "--threads"));
    private final CommandOption<Accel> accel = add(CommandOption.choice(Accel.values(), Accel.AUTO, "HOW",
        "How the nearest object is found: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}); none asks all objects "
            + "in turn, as the thesis does. The picture is the same.", "--accel"));
    private final CommandOption<ProgressPrinter.Style> progress = add(CommandOption.choice(ProgressPrinter.Style.values(),
        ProgressPrinter.Style.AUTO, "HOW", "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}: a bar if standard error is a terminal, "
            + "else none); without a terminal, with TERM=dumb, or with NO_COLOR, bar is plain; openjd prints, on standard output, "
            + "the lines that Open Job Description reads.", "--progress"));
    private final CommandOption<Boolean> quiet = add(CommandOption.flag("Say nothing but errors.", "-q", "--quiet"));

    /**
     * Finds the number of threads.
     *
     * @throws CommandException if it is out of its range
     */
    int threads() throws CommandException {
        Integer asked = threads.value();
        if (asked != null && (asked < 1 || asked > MAX_THREADS)) {
            throw CommandException.usage("--threads must be 1 to " + MAX_THREADS + ", and is " + asked);
        }
        return asked == null ? Runtime.getRuntime().availableProcessors() : asked;
    }

    /** {@return how the nearest object is found} */
    Accel accel() {
        return accel.value();
    }

    /** {@return where warnings go; null for nowhere} */
    PrintStream warnings(PrintStream err) {
        return quiet() ? null : err;
    }

    boolean quiet() {
        return quiet.value();
    }

    /** {@return what shows progress, if it is to be shown} */
    ProgressPrinter printer(Progress counter, Main main) {
        return printer(counter, main, ProgressPrinter.Unit.ROWS);
    }

    /** {@return likewise, what counts something else than rows} */
    ProgressPrinter printer(Progress counter, Main main, ProgressPrinter.Unit unit) {
        return new ProgressPrinter(counter, main.err(), main.lines(), quiet() ? ProgressPrinter.Style.NONE : progress.value(), unit);
    }

    /**
     * Makes sure that standard output is free for the progress, if that is to go there.
     *
     * @param output where the picture goes
     * @throws CommandException if it goes there, too
     */
    void requireFreeOutput(String output) throws CommandException {
        if (progress.value() == ProgressPrinter.Style.OPENJD && OutputName.isStandardOutput(output)) {
            throw CommandException.usage("--progress openjd and the picture cannot both go to standard output");
        }
    }

    /** Says that a picture is written. */
    void report(Main main, String name, Picture picture, double seconds) {
        if (!quiet()) {                                       // to format a number takes its time
            say(main, name + ": " + picture.width() + 'x' + picture.height() + ", " + Progress.time(seconds));
        }
    }

    /** Says that a picture is there already. */
    void skipped(Main main, String name) {
        if (!quiet()) {
            if (main.lines() != null) {
                main.lines().progress(ALL);
            }
            say(main, name + ": is there already, whole and of the same scene and options: it is not rendered again");
        }
    }

    private static void say(Main main, String text) {
        main.err().println(text);
        if (main.lines() != null) {
            main.lines().status(text);
        }
    }
}
