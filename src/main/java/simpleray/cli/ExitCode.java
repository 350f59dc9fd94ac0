package simpleray.cli;

/** The program's exit codes; those from 64 to 78 are of BSD's sysexits. */
final class ExitCode {
    static final int DONE = 0;
    static final int DIFFERENT = 1;
    static final int USAGE = 2;
    static final int BAD_SCENE = 65;
    static final int NO_SCENE = 66;
    static final int UNAVAILABLE = 69;
    static final int INTERNAL = 70;
    static final int NO_MEMORY = 71;
    static final int NO_OUTPUT = 73;
    static final int WRITE_ERROR = 74;
    static final int BUSY = 75;
    /** After SIGINT, Ctrl+C; the JVM itself ends with it. */
    static final int INTERRUPTED = 130;
    /** After SIGTERM, likewise. */
    static final int TERMINATED = 143;

    private ExitCode() {
    }
}
