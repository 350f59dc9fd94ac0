package simpleray.cli;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.lang.reflect.Proxy;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/**
 * How many columns the terminal has that is standard error. Java cannot tell, so {@code stty} is asked on a thread of its own: at first,
 * when the system signals a change, and now and then, since it signals only to the processes that the terminal controls. <em>Mutable;</em>
 * for one thread.
 */
final class TerminalWidth {
    private static final int USUAL = 80;
    private static final long PAUSE = TimeUnit.SECONDS.toNanos(2);    // a question takes 3 ms of a processor

    private final Map<String, String> environment;
    private volatile boolean changed;
    private volatile boolean asking;
    private volatile int columns;
    private boolean heeded;
    private long asked;

    TerminalWidth(Map<String, String> environment) {
        this.environment = environment;
    }

    /** {@return the number of columns; 0 while it is being asked for} */
    int columns() {
        if (!asking && (columns == 0 || changed || System.nanoTime() - asked > PAUSE)) {
            if (!heeded) {
                heeded = true;
                heedChanges();
            }
            columns = changed ? 0 : columns;
            changed = false;
            asking = true;
            asked = System.nanoTime();
            Thread thread = new Thread(this::ask, "width of the terminal");
            thread.setDaemon(true);
            thread.start();
        }
        return columns;
    }

    private void ask() {
        columns = columns(stty(), environment.getOrDefault("COLUMNS", ""));
        asking = false;
    }

    /**
     * Finds the width.
     *
     * @param stty what {@code stty size} says: rows and columns, which are 0 if nobody has told the terminal
     * @param variable the value of {@code COLUMNS}, which may be of another time; empty for none
     * @return the smaller of what they say, so that either fits
     */
    static int columns(String stty, String variable) {
        int least = Math.min(number(stty.strip().replaceFirst("^\\d+ ", "")), number(variable.strip()));
        return least == Integer.MAX_VALUE ? USUAL : least;
    }

    private static int number(String word) {
        return word.matches("0*[1-9]\\d{0,8}") ? Integer.parseInt(word) : Integer.MAX_VALUE;
    }

    private static String stty() {
        try {
            Process stty = new ProcessBuilder("sh", "-c", "exec stty size <&2 2>/dev/null").redirectError(Redirect.INHERIT).start();
            stty.getOutputStream().close();
            return new String(stty.getInputStream().readAllBytes(), StandardCharsets.US_ASCII);
        } catch (IOException e) {
            return "";                                        // no such program
        }
    }

    /** Has SIGWINCH noted. Its class is in no documented module, so that a Java may lack it. */
    private void heedChanges() {
        try {
            Class<?> signal = Class.forName("sun.misc.Signal");
            Class<?> handler = Class.forName("sun.misc.SignalHandler");
            signal.getMethod("handle", signal, handler).invoke(null, signal.getConstructor(String.class).newInstance("WINCH"),
                Proxy.newProxyInstance(handler.getClassLoader(), new Class<?>[] {handler}, (proxy, method, args) -> {
                    changed = true;
                    return null;
                }));
        } catch (ReflectiveOperationException e) {
            return;                                           // the next question finds the change
        }
    }
}
