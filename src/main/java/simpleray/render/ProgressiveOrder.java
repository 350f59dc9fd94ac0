package simpleray.render;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Hands out a picture in passes: first one pixel of each block of 8 × 8, then the missing ones of 4 × 4, of 2 × 2, and all others, so that the
 * whole is seen early and no pixel is traced twice. One region may come before the rest, or alone. If sampling is adaptive, previews of
 * all pixels come first. <em>Mutable</em>; any thread may call.
 */
final class ProgressiveOrder {
    private static final int COARSEST = 8;
    /** More than there are threads. */
    private static final int MAX_OPEN = 1 << 16;

    private final List<Pass> passes = new ArrayList<>();
    private final Deque<PixelRun> cut = new ArrayDeque<>();   // the runs to be handed out next
    private int pass;
    private int row;                                          // the row of the pass, 0 for its first
    private final Semaphore open = new Semaphore(MAX_OPEN);   // a run that is handed out holds a permit until it is finished
    private final AtomicInteger coarse = new AtomicInteger(); // runs of the first pass that are not finished
    private volatile boolean stopped;

    /**
     * One pass over an area.
     *
     * @param except the part of the area that is left out; null for none
     * @param size the side of the blocks
     * @param after whether all earlier runs must be finished first
     */
    private record Pass(Region area, Region except, int size, boolean rows, boolean preview, boolean after) {
        /** {@return the pixels of its k-th row, in up to two runs} */
        List<PixelRun> runs(int k) {
            int y = area.y() + k * size;
            boolean begun = !rows && size < COARSEST && k % 2 == 0;     // the pass before had every second pixel of this row
            int x = begun ? area.x() + size : area.x();
            int step = begun ? 2 * size : size;
            List<PixelRun> runs = new ArrayList<>(2);
            if (except == null || y < except.y() || y >= except.bottom()) {
                add(runs, y, x, area.right(), step);
            } else {
                add(runs, y, x, Math.min(except.x(), area.right()), step);
                int behind = Math.max(x, except.right());
                add(runs, y, behind + Math.floorMod(x - behind, step), area.right(), step);
            }
            return runs;
        }

        private void add(List<PixelRun> runs, int y, int x, int end, int step) {
            if (x < end) {
                runs.add(new PixelRun(y, x, end, step, size, preview));
            }
        }

        int count() {
            return (area.height() + size - 1) / size;
        }
    }

    /**
     * Plans the passes.
     *
     * @param first the region that comes first; null for none
     * @param alone whether only that region comes
     * @param previews whether the last pass needs previews of each pixel and of its neighbours
     */
    ProgressiveOrder(int width, int height, Region first, boolean alone, boolean previews) {
        Region all = Region.whole(width, height);
        if (first != null) {
            plan(first, null, previews ? first.grown(width, height) : null, null);
        }
        if (first == null || !alone) {
            plan(all, first, previews ? all : null, first == null ? null : first.grown(width, height));
        }
        for (int k = 0; k < passes.get(0).count(); k++) {
            coarse.addAndGet(passes.get(0).runs(k).size());
        }
    }

    private void plan(Region area, Region except, Region previewed, Region notPreviewed) {
        for (int size = COARSEST; size >= 1; size /= 2) {
            passes.add(previewed == null ? new Pass(area, except, size, false, false, false)
                : new Pass(previewed, notPreviewed, size, false, true, false));
        }
        if (previewed != null) {
            passes.add(new Pass(area, except, 1, true, false, true));
        }
    }

    /** {@return the next run to be traced; null if none is left} Waits until the runs that it builds on are finished. */
    synchronized PixelRun next() {
        while (!stopped && (!cut.isEmpty() || pass < passes.size())) {
            if (!cut.isEmpty()) {
                open.acquireUninterruptibly();
                return cut.poll();
            }
            Pass current = passes.get(pass);
            if (row == current.count()) {
                pass++;
                row = 0;
            } else {
                if (row == 0 && current.after()) {
                    open.acquireUninterruptibly(MAX_OPEN);
                    open.release(MAX_OPEN);
                }
                cut.addAll(current.runs(row++));
            }
        }
        return null;
    }

    /**
     * Notes that a run is finished, after the listener has it.
     *
     * @return whether it was the last of the first pass
     */
    boolean finished(PixelRun run) {
        open.release();
        return run.size() == COARSEST && coarse.decrementAndGet() == 0;
    }

    /** Hands out no more runs. */
    void stop() {
        if (!stopped) {
            stopped = true;
            open.release(MAX_OPEN);                           // for a thread that waits
        }
    }
}
