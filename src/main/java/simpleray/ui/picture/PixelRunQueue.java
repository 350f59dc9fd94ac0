package simpleray.ui.picture;

import java.awt.Rectangle;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import simpleray.image.Picture;
import simpleray.render.PassListener;
import simpleray.render.PixelRun;
import simpleray.render.Progress;

/** Pixel runs that are finished and not yet painted. The threads that render add them, the event thread takes them; neither waits. */
public final class PixelRunQueue implements PassListener {
    private final Queue<Entry> queue = new ConcurrentLinkedQueue<>();
    private final FailedRows failed = new FailedRows();
    private volatile Progress counter;
    private volatile double width;
    private volatile boolean coarse;
    private volatile Runnable coarseTask = () -> { };

    /** A finished run with its colours and their alpha, packed for the screen; or, if the run is null, the row that could not be rendered. */
    private record Entry(PixelRun run, int[] argb, int failedRow) {
    }

    /** Sets the task for the moment when the picture is there in coarse blocks; some thread runs it. Call before rendering. */
    void whenCoarse(Runnable task) {
        coarseTask = task;
    }

    /** Sets the counter of rows, and how many pixels a row has. Call before rendering. */
    void count(Progress rows, int pixels) {
        counter = rows;
        width = pixels;
    }

    @Override
    public void runFinished(PixelRun run, double[] light) {
        queue.add(new Entry(run, Picture.packed(Picture.levels(light), light.length / run.count()), -1));
        if (!run.preview()) {
            counter.worked(run.count() / width);
        }
    }

    @Override
    public void coarseFinished() {
        coarse = true;
        coarseTask.run();
    }

    @Override
    public void rowFailed(int y, Throwable fault) {
        failed.add(y, fault);
        queue.add(new Entry(null, null, y));
    }

    @Override
    public void rowFinished(int y) {
        counter.rowFinished();
    }

    /** {@return the rows that could not be rendered} */
    FailedRows failedRows() {
        return failed;
    }

    /** {@return whether the whole picture, or the region that is rendered alone, is there in coarse blocks} */
    public boolean isCoarse() {
        return coarse;
    }

    /**
     * Paints the runs of the queue, until it is empty or a time comes.
     *
     * @param shown the image to paint on
     * @param end the time, in nanoseconds of {@link System#nanoTime}
     * @return the rectangle that has changed; empty for none
     */
    Rectangle paint(ProgressiveImage shown, long end) {
        Rectangle changed = new Rectangle(0, 0, -1, -1);      // none: an empty one at 0, 0 would stay part of any sum
        while (System.nanoTime() - end < 0) {
            Entry entry = queue.poll();
            if (entry == null) {
                break;
            }
            if (entry.run() == null) {
                shown.hatch(entry.failedRow(), changed);
            } else {
                shown.paint(entry.run(), entry.argb(), changed);
            }
        }
        return changed;
    }

    /** {@return whether all that is finished is painted} */
    public boolean isEmpty() {
        return queue.isEmpty();
    }

    void clear() {
        queue.clear();
    }
}
