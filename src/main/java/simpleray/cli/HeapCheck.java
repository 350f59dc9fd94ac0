package simpleray.cli;

import java.util.Locale;

/** Checks that there is enough memory for pictures before they are made. */
final class HeapCheck {
    /** The memory for everything but pictures. */
    private static final long SLACK = 16L << 20;

    private HeapCheck() {
    }

    /**
     * Checks that there is enough memory.
     *
     * @param what what needs it, for the message, such as {@code a picture of 640x480}
     * @param bytes the memory that pictures take
     * @throws CommandException if there is less
     */
    static void require(String what, long bytes) throws CommandException {
        long needed = bytes + SLACK;
        if (needed > free()) {
            System.gc();                                      // only after it is the free memory known
            long free = free();
            if (needed > free) {
                throw new CommandException(ExitCode.NO_MEMORY, String.format(Locale.ROOT,
                    "simpleray: %s needs %d MiB of memory, and Java has %d MiB left: make it smaller, or give java more by -Xmx",
                    what, needed >> 20, free >> 20));
            }
        }
    }

    private static long free() {
        Runtime memory = Runtime.getRuntime();
        return memory.maxMemory() - (memory.totalMemory() - memory.freeMemory());
    }
}
