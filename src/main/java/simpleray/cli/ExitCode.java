package simpleray.cli;

/** What the program's exit codes mean; those above 60 are of BSD's sysexits. */
final class ExitCode {
    static final int DONE = 0;
    static final int USAGE = 2;
    static final int BAD_SCENE = 65;
    static final int NO_SCENE = 66;
    static final int NO_DISPLAY = 69;
    static final int INTERNAL = 70;
    static final int NO_MEMORY = 71;
    static final int NO_OUTPUT = 73;
    static final int WRITE_ERROR = 74;

    private ExitCode() {
    }
}
