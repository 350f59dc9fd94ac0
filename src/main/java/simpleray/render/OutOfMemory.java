package simpleray.render;

/** Memory that has come to its end. */
public final class OutOfMemory {
    /** What to do about it. */
    public static final String MESSAGE =
        "the scene or the picture is too large for the memory: make it smaller, or give java more by -Xmx";

    private OutOfMemory() {
    }

    /**
     * Tells whether it is what is behind a fault. While memory ends other faults can come of it: of a class that cannot be loaded, or of
     * a resource that cannot be closed.
     *
     * @param fault what was thrown
     * @return whether it, or a cause of it, is a want of memory
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
