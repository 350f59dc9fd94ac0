package simpleray.text;

import java.io.IOException;
import java.util.List;
import java.util.stream.Collectors;

/** A scene file is not in the format: one error or more, each with its location, and perhaps warnings that tell of their cause. */
public final class SceneFormatException extends IOException {
    private static final long serialVersionUID = 1L;

    /** What is wrong, in the order of the file; never empty. */
    private final transient List<Diagnostic> problems;

    /**
     * Creates the exception; its message is the whole report, each problem with its source line and caret.
     *
     * @param problems what is wrong, at least one
     * @param stopped true when reading stopped because there were too many errors
     */
    public SceneFormatException(List<Diagnostic> problems, boolean stopped) {
        super(problems.stream().map(Diagnostic::toString).collect(Collectors.joining("\n"))
            + (stopped ? "\n" + problems.stream().filter(Diagnostic::error).count() + " errors: reading stopped here" : ""));
        this.problems = List.copyOf(problems);
    }

    /** Leaves out the stack trace, which takes longer than reading a small file, and tells nothing about the file. */
    @Override
    public Throwable fillInStackTrace() {
        return this;
    }

    /** {@return what is wrong, in the order of the file; never empty} */
    public List<Diagnostic> problems() {
        return problems;
    }
}
