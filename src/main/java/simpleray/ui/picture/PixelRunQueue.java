package simpleray.ui.picture;

import java.awt.Rectangle;
import java.util.Locale;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.LongAdder;
import simpleray.image.Picture;
import simpleray.render.PassListener;
import simpleray.render.PixelRun;
import simpleray.render.Progress;
import simpleray.render.RenderSettings;

/** Pixel runs that are finished and not yet painted. The threads that render add them, the event thread takes them; neither waits. */
public final class PixelRunQueue implements PassListener {
    private final Queue<Entry> queue = new ConcurrentLinkedQueue<>();
    private final FailedRows failed = new FailedRows();
    private volatile Progress counter;
    private volatile double width;
    private volatile long perPixel;                           // rays from the eye; 0 if each pixel takes as many as it needs
    private final LongAdder done = new LongAdder();           // pixels, previews too
    private volatile boolean coarse;
    private volatile Runnable coarseTask = () -> { };

    /** A finished run with its colours and their alpha, packed for the screen; or, if the run is null, the row that could not be rendered. */
    private record Entry(PixelRun run, int[] argb, int failedRow) {
    }

    /** Sets the task for the moment when the picture is there in coarse blocks; some thread runs it. Call before rendering. */
    void whenCoarse(Runnable task) {
        coarseTask = task;
    }

    /** Sets the counter of rows, how many pixels a row has, and how many samples a pixel. Call before rendering. */
    void count(Progress rows, int pixels, int samples) {
        width = pixels;
        perPixel = samples == RenderSettings.ADAPTIVE ? 0 : (long) samples * samples;
        counter = rows;
    }

    /**
     * {@return how much is traced so far, coarse passes too: rays from the eye, or a percentage if their number is not known before}
     *
     * @param whole whether it has to be all by now
     */
    public String traced(boolean whole) {
        if (counter == null) {
            return "0 rays";
        }
        long pixels = Math.round(counter.rows() * width);
        long all = perPixel == 0 ? 2 * pixels : pixels;       // adaptive sampling has previews of all of them first
        long now = Math.min(all, done.sum());
        if (perPixel == 0) {
            return 100 * now / all + " %";
        }
        String number = String.format(Locale.ROOT, "%,d", now * perPixel);
        return (whole ? number : String.format(Locale.ROOT, "%s of %,d", number, all * perPixel)) + " rays";
    }

    /** {@return how much is traced so far, 0 to 1} */
    public double share() {
        return counter == null ? 0 : Math.min(1, done.sum() / (counter.rows() * width * (perPixel == 0 ? 2 : 1)));
    }

    @Override
    public void runFinished(PixelRun run, double[] light) {
        queue.add(new Entry(run, Picture.packed(Picture.levels(light), light.length / run.count()), -1));
        done.add(run.count());
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
