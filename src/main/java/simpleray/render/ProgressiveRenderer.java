package simpleray.render;

import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.Function;
import simpleray.image.Picture;
import simpleray.math.Colour;

/** Renders a picture in the passes of a {@link ProgressiveOrder}, on several threads. <em>Mutable</em>; any thread may call. */
final class ProgressiveRenderer {
    private final Picture picture;
    private final PassListener listener;
    private final ProgressiveOrder passes;
    private final double[][] previews;                        // null unless sampling is adaptive
    private final AtomicReferenceArray<double[]> rows;        // rows that are partly traced
    private final AtomicIntegerArray missing;                 // pixels of each row
    private final AtomicReferenceArray<Throwable> faults;     // of each row
    private final AtomicReferenceArray<Throwable> unseen;     // of the previews of each row
    private final boolean wholeRows;
    private volatile boolean stopped;
    private volatile Semaphore pause;                         // without permits; null unless it is paused

    /**
     * Plans the work.
     *
     * @param picture gets each row when all its pixels are traced
     * @param first the region that comes first; null for none
     * @param alone whether only that region is rendered
     * @param adaptive whether sampling is adaptive
     */
    ProgressiveRenderer(Picture picture, PassListener listener, Region first, boolean alone, boolean adaptive) {
        this.picture = picture;
        this.listener = listener;
        int width = picture.width();
        int height = picture.height();
        passes = new ProgressiveOrder(width, height, first, alone, adaptive);
        previews = adaptive ? new double[height][] : null;
        rows = new AtomicReferenceArray<>(height);
        missing = new AtomicIntegerArray(height);
        for (int y = 0; y < height; y++) {
            missing.set(y, first != null && alone ? first.width() : width);
        }
        wholeRows = missing.get(0) == width;
        faults = new AtomicReferenceArray<>(height);
        unseen = new AtomicReferenceArray<>(height);
    }

    /** Ends the work within the time of a pixel, also if it is paused. */
    synchronized void stop() {
        stopped = true;
        passes.stop();
        setPaused(false);
    }

    /** Pauses the work within the time of a pixel, or resumes it. */
    synchronized void setPaused(boolean paused) {
        Semaphore before = pause;
        pause = paused && !stopped ? new Semaphore(0) : null;
        if (before != null) {
            before.release();
        }
    }

    private void awaitResumed() {
        for (Semaphore current = pause; current != null; current = pause) {
            current.acquireUninterruptibly();
            current.release();                                // for the next thread
        }
    }

    /**
     * Renders until no run is left. If a pixel throws an exception, the listener receives it, and the pixel's row is left out.
     *
     * @param tracers creates a tracer; if true, a faster one, for the many rays of a last pass
     * @param samples as in {@link RenderSettings}
     */
    void run(Function<Boolean, Tracer> tracers, int samples) {
        Pixels sampler = sampler(tracers.apply(false), samples, true);
        boolean last = false;
        boolean preview = true;
        for (PixelRun run = passes.next(); run != null && !stopped; run = passes.next()) {
            if (run.size() == 1 && !last || run.preview() != preview) {
                sampler = sampler(tracers.apply(run.size() == 1), samples, run.preview());
                last = run.size() == 1;
                preview = run.preview();
            }
            trace(run, sampler);
            if (passes.finished(run) && !stopped) {
                listener.coarseFinished();
            }
        }
    }

    /** Computes the colour of a pixel, and its alpha. */
    private interface Pixels {
        double find(int x, int y, Colour colour);
    }

    private Pixels sampler(Tracer tracer, int samples, boolean preview) {
        if (previews == null) {
            return new GridSampler(tracer, samples)::pixel;
        }
        AdaptiveSampler sampler = new AdaptiveSampler(tracer, picture.width(), picture.height(), picture.channels(), previews);
        return preview ? sampler::first : sampler::pixel;
    }

    private void trace(PixelRun run, Pixels sampler) {
        double[] light = new double[picture.channels() * run.count()];
        Throwable fault = fault(run);
        if (fault == null) {
            try {
                trace(run, sampler, light);
            } catch (RuntimeException | Error e) {
                fault = e;
            }
        }
        if (stopped) {
            return;
        }
        if (fault != null) {
            fail(run, fault);
            return;
        }
        keep(run, light);
        listener.runFinished(run, light);
        if (!run.preview() && missing.addAndGet(run.y(), -run.count()) == 0) {
            double[] row = rows.getAndSet(run.y(), null);
            if (wholeRows) {
                picture.setRow(run.y(), row);
            }
            listener.rowFinished(run.y());
        }
    }

    private void fail(PixelRun run, Throwable fault) {
        if (run.preview()) {
            unseen.set(run.y(), fault);
        }
        if (faults.compareAndSet(run.y(), null, fault)) {
            listener.rowFailed(run.y(), fault);
        }
    }

    /** {@return the earlier exception of a run's row, or of a preview that it builds on; null for none} */
    private Throwable fault(PixelRun run) {
        Throwable fault = faults.get(run.y());
        if (previews != null && !run.preview()) {
            for (int y = Math.max(0, run.y() - 1); fault == null && y <= Math.min(picture.height() - 1, run.y() + 1); y++) {
                fault = unseen.get(y);
            }
        }
        return fault;
    }

    private void trace(PixelRun run, Pixels sampler, double[] light) {
        Colour colour = new Colour();
        int pixel = picture.channels();
        for (int x = run.x(), i = 0; x < run.end() && !stopped; x += run.step(), i += pixel) {
            awaitResumed();
            double alpha = sampler.find(x, run.y(), colour);
            Sampler.store(colour, alpha, light, i, pixel);
        }
    }

    private void keep(PixelRun run, double[] light) {
        double[] row = row(run);
        int pixel = picture.channels();
        for (int x = run.x(), i = 0; x < run.end(); x += run.step(), i += pixel) {
            System.arraycopy(light, i, row, pixel * x, pixel);
        }
    }

    private double[] row(PixelRun run) {
        int y = run.y();
        if (run.preview()) {
            synchronized (previews) {
                if (previews[y] == null) {
                    previews[y] = new double[picture.channels() * picture.width()];
                }
                return previews[y];
            }
        }
        if (rows.get(y) == null) {
            rows.compareAndSet(y, null, new double[picture.channels() * picture.width()]);
        }
        return rows.get(y);
    }
}
