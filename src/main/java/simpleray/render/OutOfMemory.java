package simpleray.render;

/** Recognises that memory has run out. */
public final class OutOfMemory {
    /** The message to the user. */
    public static final String MESSAGE =
        "the scene or the picture is too large for the memory: make it smaller, or give java more by -Xmx";

    private OutOfMemory() {
    }

    /**
     * Tells whether an exception comes from a lack of memory. Others than {@link OutOfMemoryError} can, such as that of a class that cannot be
     * loaded or of a resource that cannot be closed.
     *
     * @param fault the exception
     * @return whether it or one of its causes is an {@link OutOfMemoryError}
     */
    public static boolean isBehind(Throwable fault) {
        for (Throwable cause = fault; cause != null; cause = cause.getCause()) {
            if (cause instanceof OutOfMemoryError) {
                return true;
            }
        }
        return false;
    }
}
