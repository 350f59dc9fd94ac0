package simpleray.cli;

import java.io.Console;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import simpleray.render.Progress;
import simpleray.render.RenderListener;

/** Shows on standard error how far a rendering has come. Any thread may call. */
final class ProgressPrinter implements RenderListener {
    private static final int CELLS = 30;
    private static final long PAUSE = 100_000_000;            // between two states of the bar, in nanoseconds
    private static final int STEP = 10;                       // per cent between two plain lines
    /** Clears the rest of a terminal's line. */
    private static final String CLEAR = "\u001B[K";

    private final Progress progress;
    private final PrintStream err;
    private final Style style;
    private long shown;
    private int step;

    /** How progress is shown. */
    enum Style {
        /** A bar on a terminal, nothing elsewhere. */
        AUTO,
        /** One line that changes, which only a terminal can show; plain elsewhere. */
        BAR,
        /** A line for every tenth. */
        PLAIN,
        /** Not at all. */
        NONE;

        private Style shown(boolean terminal) {
            return switch (this) {
                case AUTO -> terminal ? BAR : NONE;
                case BAR -> terminal ? BAR : PLAIN;
                default -> this;
            };
        }

        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    ProgressPrinter(Progress progress, PrintStream err, Style style) {
        this.progress = progress;
        this.err = err;
        this.style = style.shown(isTerminal());
        shown = System.nanoTime();
    }

    @Override
    public synchronized void rowFinished(int y) {
        progress.rowFinished();
        long now = System.nanoTime();
        if (style == Style.BAR && now - shown >= PAUSE) {
            shown = now;
            int full = CELLS * progress.finished() / progress.rows();
            err.print("\r[" + "#".repeat(full) + "-".repeat(CELLS - full) + "] " + state(now) + CLEAR);
            err.flush();
        } else if (style == Style.PLAIN && progress.percent() / STEP > step) {
            step = progress.percent() / STEP;
            err.println(state(now));
        }
    }

    /** Removes the bar. */
    synchronized void end() {
        if (style == Style.BAR) {
            err.print("\r" + CLEAR);
            err.flush();
        }
    }

    private String state(long now) {
        return String.format(Locale.ROOT, "%3d %%, %d of %d rows, %s left",
            progress.percent(), progress.finished(), progress.rows(), Progress.time(progress.left(now)));
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
