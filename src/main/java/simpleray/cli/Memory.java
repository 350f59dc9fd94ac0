package simpleray.cli;

import java.util.Locale;
import simpleray.image.Picture;

/** Looks whether a picture fits into the memory, before work on it begins. */
final class Memory {
    /** What everything but the picture may take, in bytes. */
    private static final long SLACK = 16L << 20;

    private Memory() {
    }

    /**
     * Requires memory for a picture.
     *
     * @param screen bytes for each pixel beside the picture's own
     * @throws Failure if there is not enough, with what is needed
     */
    static void require(int width, int height, int screen) throws Failure {
        long needed = Picture.bytesNeeded(width, height) + (long) screen * width * height + SLACK;
        if (needed > free()) {
            System.gc();                                      // what is free is known only after it
            long free = free();
            if (needed > free) {
                throw new Failure(ExitCode.NO_MEMORY, String.format(Locale.ROOT,
                    "simpleray: a picture of %dx%d needs %d MiB of memory, and Java has %d MiB left: make it smaller, or give java more "
                        + "by -Xmx", width, height, needed >> 20, free >> 20));
            }
        }
    }

    private static long free() {
        Runtime memory = Runtime.getRuntime();
        return memory.maxMemory() - (memory.totalMemory() - memory.freeMemory());
    }
}
