package simpleray.render;

import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.Function;
import simpleray.image.Picture;
import simpleray.math.Colour;

/** Renders a picture in {@link Passes}: what all its threads share, and what each of them does. */
final class PassWork {
    private final Picture picture;
    private final PassListener listener;
    private final Passes passes;
    private final Pause pause = new Pause();
    private final double[][] previews;                        // null if no pixel is sampled by what its neighbours are
    private final AtomicReferenceArray<double[]> rows;        // as far as they are traced
    private final AtomicIntegerArray missing;                 // pixels of each row
    private final AtomicReferenceArray<Throwable> faults;     // of each row
    private final AtomicReferenceArray<Throwable> unseen;     // of each row of previews
    private final boolean wholeRows;
    private volatile boolean stopped;

    /**
     * Plans the work.
     *
     * @param picture gets each row when all its pixels are there
     * @param first what comes first; null for nothing
     * @param alone whether that is all
     * @param adaptive whether pixels are sampled by what their neighbours are
     */
    PassWork(Picture picture, PassListener listener, Region first, boolean alone, boolean adaptive) {
        this.picture = picture;
        this.listener = listener;
        int width = picture.width();
        int height = picture.height();
        passes = new Passes(width, height, first, alone, adaptive);
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

    /** Ends the work within a pixel, also if it is held. */
    void stop() {
        stopped = true;
        passes.stop();
        pause.set(false);
    }

    void setPaused(boolean held) {
        pause.set(held && !stopped);
    }

    /**
     * Works until nothing is left to do. What a pixel throws is told to the listener, and its row is left out.
     *
     * @param tracers makes a tracer; a better one if true, for the many rays of a last pass
     * @param samples as in {@link RenderSettings}
     */
    void run(Function<Boolean, Tracer> tracers, int samples) {
        Pixels sampler = sampler(tracers.apply(false), samples, true);
        boolean last = false;
        boolean preview = true;
        for (Part part = passes.next(); part != null && !stopped; part = passes.next()) {
            if (part.size() == 1 && !last || part.preview() != preview) {
                sampler = sampler(tracers.apply(part.size() == 1), samples, part.preview());
                last = part.size() == 1;
                preview = part.preview();
            }
            trace(part, sampler);
            if (passes.finished(part) && !stopped) {
                listener.coarseFinished();
            }
        }
    }

    /** What finds the colour of a pixel. */
    private interface Pixels {
        void find(int x, int y, Colour colour);
    }

    private Pixels sampler(Tracer tracer, int samples, boolean preview) {
        if (previews == null) {
            return new GridSampler(tracer, samples)::pixel;
        }
        AdaptiveSampler sampler = new AdaptiveSampler(tracer, picture.width(), picture.height(), previews);
        return preview ? sampler::first : sampler::pixel;
    }

    private void trace(Part part, Pixels sampler) {
        double[] rgb = new double[3 * part.count()];
        Throwable fault = fault(part);
        if (fault == null) {
            try {
                trace(part, sampler, rgb);
            } catch (RuntimeException | Error e) {
                fault = e;
            }
        }
        if (stopped) {
            return;
        }
        if (fault != null) {
            fail(part, fault);
            return;
        }
        keep(part, rgb);
        listener.partFinished(part, rgb);
        if (!part.preview() && missing.addAndGet(part.y(), -part.count()) == 0) {
            double[] row = rows.getAndSet(part.y(), null);
            if (wholeRows) {
                picture.setRow(part.y(), row);
            }
            listener.rowFinished(part.y());
        }
    }

    private void fail(Part part, Throwable fault) {
        if (part.preview()) {
            unseen.set(part.y(), fault);
        }
        if (faults.compareAndSet(part.y(), null, fault)) {
            listener.rowFailed(part.y(), fault);
        }
    }

    /** {@return what went wrong with a row before, or with a preview that it builds on; null for nothing} */
    private Throwable fault(Part part) {
        Throwable fault = faults.get(part.y());
        if (previews != null && !part.preview()) {
            for (int y = Math.max(0, part.y() - 1); fault == null && y <= Math.min(picture.height() - 1, part.y() + 1); y++) {
                fault = unseen.get(y);
            }
        }
        return fault;
    }

    private void trace(Part part, Pixels sampler, double[] rgb) {
        Colour colour = new Colour();
        int i = 0;
        for (int x = part.x(); x < part.end() && !stopped; x += part.step()) {
            pause.await();
            sampler.find(x, part.y(), colour);
            rgb[i++] = colour.r;
            rgb[i++] = colour.g;
            rgb[i++] = colour.b;
        }
    }

    private void keep(Part part, double[] rgb) {
        double[] row = row(part);
        for (int x = part.x(), i = 0; x < part.end(); x += part.step(), i += 3) {
            System.arraycopy(rgb, i, row, 3 * x, 3);
        }
    }

    private double[] row(Part part) {
        int y = part.y();
        if (part.preview()) {
            synchronized (previews) {
                if (previews[y] == null) {
                    previews[y] = new double[3 * picture.width()];
                }
                return previews[y];
            }
        }
        if (rows.get(y) == null) {
            rows.compareAndSet(y, null, new double[3 * picture.width()]);
        }
        return rows.get(y);
    }
}
