package simpleray.cli;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * The lines on standard output by which a task of Open Job Description tells the scheduler its progress, its status, and why it fails
 * (Open Job Description, "How Jobs Are Run", version 2023-09). Any thread may call.
 */
final class OpenJobLines {
    private static final String OPTION = "--progress";
    private static final String VALUE = "openjd";

    private final OutputStream out;

    /**
     * Begins.
     *
     * @param out standard output; that it cannot be written ends no rendering
     */
    OpenJobLines(OutputStream out) {
        this.out = out;
    }

    /** {@return whether a command line asks for them, be it right or wrong otherwise} */
    static boolean areAskedFor(String[] args) {
        for (int i = 0; i < args.length && !args[i].equals("--"); i++) {
            String value = args[i].startsWith(OPTION + '=') ? args[i].substring(OPTION.length() + 1)
                : args[i].equals(OPTION) && i + 1 < args.length ? args[i + 1] : "";
            if (value.equalsIgnoreCase(VALUE)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Tells the progress.
     *
     * @param percent from 0 to 100
     */
    void progress(double percent) {
        say("progress", String.format(Locale.ROOT, "%.1f", percent));
    }

    /** Tells what is being done. */
    void status(String text) {
        say("status", text);
    }

    /** Tells why the task fails. */
    void fail(String text) {
        say("fail", text);
    }

    /** Of a text the first line: a second one would not be read as a part of it. */
    private synchronized void say(String kind, String text) {
        try {
            out.write(("openjd_" + kind + ": " + text.lines().findFirst().orElse("").strip() + '\n').getBytes(StandardCharsets.UTF_8));
            out.flush();
        } catch (IOException e) {
            return;                                           // nobody listens
        }
    }
}
