package simpleray.render;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.scene.Scene;
import simpleray.scene.Camera;

/**
 * Renders one picture of a scene: rays for each pixel, rows handed out to threads (thesis, chapter 2). The scene and the camera must
 * not change meanwhile.
 */
public final class Renderer {
    /** Room for {@link RenderSettings#MOST_DEPTH} reflections within reflections, in bytes. */
    private static final long STACK = 8L << 20;

    private final RenderSettings settings;
    private final Sampler sampler;
    private final Picture picture;
    private final AtomicInteger nextRow = new AtomicInteger();
    private final AtomicReference<Throwable> fault = new AtomicReference<>();
    private volatile boolean cancelled;

    /**
     * Prepares a rendering, to be used once.
     *
     * @param scene the scene
     * @param camera the camera, whose resolution is the picture's
     * @param settings all else
     */
    public Renderer(Scene scene, Camera camera, RenderSettings settings) {
        this.settings = settings;
        Tracer tracer = new Tracer(scene, camera, settings);
        sampler = settings.samples() == RenderSettings.ADAPTIVE ? new AdaptiveSampler(tracer, camera.width(), camera.height())
            : new GridSampler(tracer, settings.samples());
        picture = new Picture(camera.width(), camera.height());
    }

    /** {@return the picture; its rows are set one by one while it is rendered} */
    public Picture picture() {
        return picture;
    }

    /**
     * Renders, and returns when all rows are finished and all threads have ended.
     *
     * @param listener told of each row
     * @return the picture, whole
     * @throws CancellationException if it was cancelled, or the calling thread was interrupted
     */
    public Picture render(RenderListener listener) {
        List<Thread> workers = new ArrayList<>();
        int threads = Math.min(settings.threads(), picture.height());
        for (int i = 0; i < threads; i++) {
            Thread worker = new Thread(null, () -> work(listener), "simpleray-worker-" + (i + 1), STACK);
            worker.setDaemon(true);
            try {
                worker.start();
            } catch (OutOfMemoryError e) {                    // the system grants no more threads: fewer do the same work
                if (workers.isEmpty()) {
                    throw e;
                }
                break;
            }
            workers.add(worker);
        }
        workers.forEach(this::await);
        if (fault.get() instanceof Error error) {
            throw error;
        }
        if (fault.get() instanceof RuntimeException exception) {
            throw exception;
        }
        if (cancelled) {
            throw new CancellationException("the rendering was cancelled");
        }
        return picture;
    }

    /** Ends the rendering soon; its threads end within the time of a pixel. Any thread may call, also before it has begun. */
    public void cancel() {
        cancelled = true;
    }

    /** Waits for a thread; an interrupt of this one cancels, and is passed on. */
    private void await(Thread worker) {
        boolean interrupted = false;
        while (worker.isAlive()) {
            try {
                worker.join();
            } catch (InterruptedException e) {
                interrupted = true;
                cancel();
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private void work(RenderListener listener) {
        try {
            for (int y = nextRow.getAndIncrement(); y < picture.height() && !cancelled; y = nextRow.getAndIncrement()) {
                double[] row = row(y);
                if (!cancelled) {
                    picture.setRow(y, row);
                    listener.rowFinished(y);
                }
            }
        } catch (RuntimeException | Error e) {                // reported by render(), after all threads have ended
            fault.compareAndSet(null, e);
            cancel();
        }
    }

    private double[] row(int y) {
        double[] rgb = new double[3 * picture.width()];
        Colour colour = new Colour();
        for (int x = 0; x < picture.width() && !cancelled; x++) {
            sampler.pixel(x, y, colour);
            rgb[3 * x] = colour.r;
            rgb[3 * x + 1] = colour.g;
            rgb[3 * x + 2] = colour.b;
        }
        return rgb;
    }
}
