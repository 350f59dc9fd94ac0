package simpleray.render;

import java.util.BitSet;

/**
 * Hands out the rows of a picture from the top. No row is begun far below one that is not finished: what waits for that one, to be
 * written in order, stays little. <em>Mutable</em>; any thread may call.
 */
final class Rows extends Hold {
    private static final int MAX_AHEAD = 256;
    private static final int MAX_AHEAD_A_THREAD = 4;

    private final int height;
    private final int ahead;
    private final BitSet finished;
    private int firstUnfinished;
    private int next;
    private boolean stopped;

    Rows(int height, int threads) {
        this.height = height;
        ahead = ahead(threads);
        finished = new BitSet(height);
    }

    /** {@return how many rows may at most be begun from one that is not finished on} */
    static int ahead(int threads) {
        return Math.max(MAX_AHEAD, MAX_AHEAD_A_THREAD * threads);
    }

    /** {@return a row to be rendered; -1 if there is none left} May wait until rows far above are finished. */
    synchronized int next() {
        untilFree();
        return stopped || next == height ? -1 : next++;
    }

    @Override
    synchronized boolean holds() {
        return next < height && next - firstUnfinished >= ahead && !stopped;
    }

    /** Notes that a row is finished, and all that is done with it. */
    synchronized void finished(int y) {
        finished.set(y);
        if (y == firstUnfinished) {
            firstUnfinished = finished.nextClearBit(y);
            notifyAll();
        }
    }

    /** Hands out no more rows. */
    synchronized void stop() {
        stopped = true;
        notifyAll();
    }
}
