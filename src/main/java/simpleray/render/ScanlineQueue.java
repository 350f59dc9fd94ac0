package simpleray.render;

import java.util.BitSet;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Hands out the rows of a picture from the top. No row is begun far below one that is not finished, so that few finished rows wait to be
 * written in order. <em>Mutable</em>; any thread may call.
 */
final class ScanlineQueue {
    private static final int MAX_AHEAD = 256;
    private static final int MAX_AHEAD_PER_THREAD = 4;

    private final int height;
    private final int ahead;
    private final Semaphore begun;                            // has a permit for each row that may still be begun
    private final AtomicInteger next = new AtomicInteger();
    private final BitSet finished;
    private volatile boolean stopped;

    ScanlineQueue(int height, int threads) {
        this.height = height;
        ahead = ahead(threads);
        begun = new Semaphore(ahead);
        finished = new BitSet(height);
    }

    /** {@return the most rows that are begun, counted from the first unfinished one} */
    static int ahead(int threads) {
        return Math.max(MAX_AHEAD, MAX_AHEAD_PER_THREAD * threads);
    }

    /** {@return the next row to be rendered; -1 if there is none left} Waits while a row far above is unfinished. */
    int next() {
        if (next.get() < height && !stopped) {
            begun.acquireUninterruptibly();
        }
        int y = stopped ? height : next.getAndIncrement();
        return y < height ? y : -1;
    }

    /** Notes that a row is finished and written. */
    synchronized void finished(int y) {
        int first = finished.nextClearBit(0);
        finished.set(y);
        begun.release(finished.nextClearBit(first) - first);
    }

    /** Hands out no more rows. */
    synchronized void stop() {
        if (!stopped) {
            stopped = true;
            begun.release(ahead);                             // there are no more threads to wait for one
        }
    }
}
