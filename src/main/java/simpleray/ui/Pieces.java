package simpleray.ui;

import java.awt.Rectangle;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import simpleray.image.Picture;
import simpleray.render.PassListener;
import simpleray.render.PixelRun;
import simpleray.render.Progress;

/** What is finished of a picture and not yet painted: the threads that render add, the event thread takes. Neither waits for the other. */
final class Pieces implements PassListener {
    private static final int LEVEL = 0xFF;

    private final Queue<Piece> queue = new ConcurrentLinkedQueue<>();
    private final Faults faults = new Faults();
    private volatile Progress counter;
    private volatile double width;
    private volatile boolean coarse;
    private volatile Runnable coarseTask = () -> { };

    /** Finished pixels, or a row that could not be rendered. */
    private record Piece(Canvas.Strip strip, int failedRow) {
    }

    /** Sets what is done once the picture is there in coarse blocks, on some thread; before rendering. */
    void whenCoarse(Runnable task) {
        coarseTask = task;
    }

    /** Sets what counts the rows, and how many pixels one has; before rendering. */
    void count(Progress rows, int pixels) {
        counter = rows;
        width = pixels;
    }

    @Override
    public void runFinished(PixelRun run, double[] rgb) {
        byte[] levels = Picture.levels(rgb);
        int[] packed = new int[levels.length / 3];
        for (int i = 0; i < packed.length; i++) {
            packed[i] = 0xFF000000 | (levels[3 * i] & LEVEL) << 16 | (levels[3 * i + 1] & LEVEL) << 8 | levels[3 * i + 2] & LEVEL;
        }
        queue.add(new Piece(new Canvas.Strip(run.y(), run.x(), run.step(), run.size(), packed), -1));
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
        faults.add(y, fault);
        queue.add(new Piece(null, y));
    }

    @Override
    public void rowFinished(int y) {
        counter.rowFinished();
    }

    /** {@return the rows that could not be rendered} */
    Faults faults() {
        return faults;
    }

    /** {@return whether all of what is rendered is there in coarse blocks} */
    boolean isCoarse() {
        return coarse;
    }

    /**
     * Paints what was added, until a time comes.
     *
     * @param shown where to
     * @param end the time, in nanoseconds of {@link System#nanoTime}
     * @return where something has changed; empty for nowhere
     */
    Rectangle paint(Canvas shown, long end) {
        Rectangle changed = new Rectangle(0, 0, -1, -1);      // none: an empty one at 0, 0 would stay part of any sum
        while (System.nanoTime() - end < 0) {
            Piece piece = queue.poll();
            if (piece == null) {
                break;
            }
            if (piece.strip() == null) {
                shown.hatch(piece.failedRow(), changed);
            } else {
                shown.paint(piece.strip(), changed);
            }
        }
        return changed;
    }

    boolean isEmpty() {
        return queue.isEmpty();
    }

    void clear() {
        queue.clear();
    }
}
