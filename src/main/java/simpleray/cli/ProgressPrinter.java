package simpleray.cli;

import java.io.Console;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import simpleray.render.Progress;
import simpleray.render.RenderListener;

/** Shows on standard error how far a rendering has come. Any thread may call. */
final class ProgressPrinter implements RenderListener {
    private static final int CELLS = 30;
    private static final long PAUSE = 100_000_000;            // between two states of the bar, in nanoseconds
    private static final int STEP = 10;                       // per cent between two plain lines
    private static final int FEWEST_CELLS = 8;                // of a bar that is worth its room
    /** Clears a terminal's line from the cursor on, and what a narrower terminal has wrapped of it. */
    private static final String CLEAR = "\u001B[J";
    private static final Set<String> CANNOT = Set.of("", "dumb", "none", "unknown");

    private final Progress progress;
    private final PrintStream err;
    private final OpenJobLines lines;                         // null unless asked for
    private final Style style;
    private final TerminalWidth width = new TerminalWidth(System.getenv());
    private final Unit unit;
    private long shown;
    private int step;

    /** How progress is shown. */
    enum Style {
        /** On a terminal a bar, or plain if it can show none; nothing elsewhere. */
        AUTO,
        /** One line that changes; plain where that cannot be shown. */
        BAR,
        /** A line for every tenth. */
        PLAIN,
        /** A scheduler's lines on standard output: the progress for every hundredth, and the status for every tenth. */
        OPENJD,
        /** Not at all. */
        NONE;

        /** {@return how it is shown where standard error is a terminal or is none} */
        Style shown(boolean terminal, Map<String, String> environment) {
            if (this == AUTO && !terminal) {
                return NONE;
            }
            return this != AUTO && this != BAR ? this : terminal && movesCursor(environment) ? BAR : PLAIN;
        }

        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /**
     * What is counted.
     *
     * @param name its name, for many
     * @param rows how many rows one has
     */
    record Unit(String name, int rows) {
        /** The rows of a picture. */
        static final Unit ROWS = new Unit("rows", 1);
    }

    ProgressPrinter(Progress progress, PrintStream err, OpenJobLines lines, Style style) {
        this(progress, err, lines, style, Unit.ROWS);
    }

    ProgressPrinter(Progress progress, PrintStream err, OpenJobLines lines, Style style, Unit unit) {
        this.unit = unit;
        this.progress = progress;
        this.err = err;
        this.lines = lines;
        this.style = style.shown(isTerminal(), System.getenv());
        shown = System.nanoTime();
    }

    @Override
    public synchronized void rowFinished(int y) {
        progress.rowFinished();
        long now = System.nanoTime();
        if (style == Style.BAR && now - shown >= PAUSE) {
            int columns = width.columns();
            if (columns > 0) {
                shown = now;
                err.print('\r' + bar(columns - 1, now) + CLEAR + '\r');   // a line that is full to the end might wrap
                err.flush();
            }
        } else if (style == Style.PLAIN && progress.percent() / STEP > step) {
            step = progress.percent() / STEP;
            err.println(state(now));
        } else if (style == Style.OPENJD && lines != null && progress.percent() > step) {
            if (progress.percent() / STEP > step / STEP) {
                lines.status(state(now));
            }
            step = progress.percent();
            lines.progress(step);
        }
    }

    /** Removes the bar. */
    synchronized void end() {
        if (style == Style.BAR) {
            err.print("\r" + CLEAR);
            err.flush();
        }
    }

    /** {@return what there is room for of bar, share, time and rows} */
    String bar(int room, long now) {
        String share = share();
        for (String text : List.of(state(now), share + left(now), share)) {
            int cells = Math.min(CELLS, room - text.length() - "[] ".length());
            if (cells >= FEWEST_CELLS) {
                int full = (int) (cells * progress.finished() / progress.rows());
                return "[" + "#".repeat(full) + "-".repeat(cells - full) + "] " + text;
            }
        }
        return Stream.of(share, share.replace(" ", "")).filter(text -> text.length() <= room).findFirst().orElse("");
    }

    private String state(long now) {
        return share() + ", " + progress.finished() / unit.rows + " of " + progress.rows() / unit.rows + ' ' + unit.name + left(now);
    }

    private String share() {
        return String.format(Locale.ROOT, "%3d %%", progress.percent());
    }

    private String left(long now) {
        return ", " + Progress.time(progress.left(now)) + " left";
    }

    /** {@return whether a terminal is one whose cursor moves, and the user has not asked for plain text (no-color.org)} */
    private static boolean movesCursor(Map<String, String> environment) {
        return !CANNOT.contains(environment.getOrDefault("TERM", "")) && environment.getOrDefault("NO_COLOR", "").isEmpty();
    }

    /** {@return whether standard error is a terminal} Where the system does not tell, a console stands for it. */
    private static boolean isTerminal() {
        try {
            String file = Files.readSymbolicLink(Path.of("/proc/self/fd/2")).toString();
            return file.startsWith("/dev/pts/") || file.startsWith("/dev/tty");
        } catch (IOException | UnsupportedOperationException e) {
            return isTerminal(System.console());
        }
    }

    /** Since Java 22 there may be a console where there is no terminal, but it says so. */
    private static boolean isTerminal(Console console) {
        try {
            return console != null && (Boolean) Console.class.getMethod("isTerminal").invoke(console);
        } catch (ReflectiveOperationException e) {
            return true;
        }
    }
}
