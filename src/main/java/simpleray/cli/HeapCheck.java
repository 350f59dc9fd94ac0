package simpleray.cli;

import java.util.Locale;

/** Whether there is room for what is about to be made. */
final class HeapCheck {
    /** Memory that everything but pictures may take. */
    private static final long SLACK = 16L << 20;

    private HeapCheck() {
    }

    /**
     * Makes sure that there is room.
     *
     * @param what what it is needed for, to stand in the message, such as {@code a picture of 640x480}
     * @param bytes how much its pictures take
     * @throws CommandException if there is less
     */
    static void require(String what, long bytes) throws CommandException {
        long needed = bytes + SLACK;
        if (needed > free()) {
            System.gc();                                      // what is free is known only after it
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
