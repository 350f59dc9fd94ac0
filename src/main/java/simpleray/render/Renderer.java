package simpleray.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.scene.Camera;
import simpleray.scene.Scene;
import simpleray.trace.CompiledScene;

/**
 * Renders one picture of a scene: rays for each pixel, rows handed out to threads (thesis, chapter 2). The scene and the camera must
 * not change meanwhile.
 */
public final class Renderer {
    // On the way of a plain rendering stands no lambda, here and elsewhere: the first ones take 10 ms of each start.
    /** Room for {@link RenderSettings#MAX_DEPTH} reflections within reflections, in bytes. */
    private static final long STACK = 8L << 20;

    /** So many rows from all over the picture are rendered first, or as many as have so many pixels, or a part of all. */
    private static final int MAX_EARLY = 64;
    private static final int MAX_EARLY_PIXELS = 64_000;
    private static final int EARLY_PART = 8;
    /** How far they are apart, as a share of the picture: the golden ratio spreads any number of them evenly. */
    private static final double APART = 0.6180339887498949;
    /** A prime: steps of so many columns, round and round, come to each of fewer columns once. */
    private static final int JUMP = 1_000_003;

    private final Scene scene;
    private final Camera camera;
    private final RenderSettings settings;
    private final AtomicReferenceArray<AdaptiveSampler.Row> firstPoints;   // null if sampling is not adaptive
    private final PreparedScene prepared;                     // null if it is to be made ready for this rendering alone
    private final Region region;                              // the piece of what the camera sees that the picture has
    private final Picture picture;
    private final ScanlineQueue rows;
    private volatile Throwable fault;                         // what a thread threw: the first; if two come at once, either
    private volatile boolean cancelled;
    private final Map<Integer, double[]> early = new ConcurrentHashMap<>();   // rows that were rendered before their turn
    private final AtomicInteger nextEarly = new AtomicInteger();
    private volatile CompiledScene ready;                            // kept for who asks about pixels
    private volatile ProgressiveRenderer passes;              // null unless it renders in passes
    private boolean paused;
    private IntFunction<double[]> known;                      // null if no row is
    private RenderStats stats;

    /**
     * Prepares a rendering, to be used once.
     *
     * @param scene the scene
     * @param camera the camera, whose resolution is the picture's
     * @param settings all else
     * @throws IllegalArgumentException if the picture does not have the region that the settings ask for
     */
    public Renderer(Scene scene, Camera camera, RenderSettings settings) {
        this(scene, camera, settings, null);
    }

    Renderer(Scene scene, Camera camera, RenderSettings settings, PreparedScene prepared) {
        this.settings = settings;
        this.scene = scene;
        this.camera = camera;
        this.prepared = prepared;
        region = settings.region() == null ? Region.whole(camera.width(), camera.height()) : settings.region();
        region.requireWithin(camera.width(), camera.height());
        firstPoints = settings.samples() == RenderSettings.ADAPTIVE ? AdaptiveSampler.rows(camera.height(), settings.threads()) : null;
        picture = new Picture(region.width(), region.height());
        rows = new ScanlineQueue(picture.height(), settings.threads());
    }

    /** {@return the picture; its rows are set one by one while it is rendered} */
    public Picture picture() {
        return picture;
    }

    /**
     * Makes rows known that need not be rendered. To be called before {@link #render}.
     *
     * @param rows gives the light of a row of this number, null for one that is not known; asked by several threads at once
     */
    public void know(IntFunction<double[]> rows) {
        known = rows;
    }

    /** {@return what the rendering did; null until it has ended} */
    public RenderStats stats() {
        return stats;
    }

    /**
     * Makes what tells about pixels of this picture. It asks what the rendering has made ready, if it has begun.
     *
     * @return one for one thread, which can ask while the picture is rendered and afterwards
     */
    public Explainer explainer() {
        return new Explainer(scene, camera, settings, ready);
    }

    /** {@return how many rows are begun at most, of which the first is not finished} */
    public int rowsAhead() {
        return Math.min(ScanlineQueue.ahead(settings.threads()), picture.height());
    }

    /** {@return the memory that rendering takes at most, in bytes, if the listener lets go of each row} */
    public long bytesNeeded() {
        int kept = firstPoints == null ? 0 : firstPoints.length();   // and the neighbours of each thread's, which are mostly of these
        return (long) (threads() + kept + earlyRows()) * Picture.bytesNeeded(picture.width(), 1);
    }

    /**
     * Renders, and returns when all rows are finished and all threads have ended.
     *
     * @param listener told of each row; what it throws ends the rendering, and is thrown here
     * @return the picture, whole but for rows that the listener let go of
     * @throws CancellationException if it was cancelled, or the calling thread was interrupted
     */
    public Picture render(RenderListener listener) {
        return renderBy(new Consumer<>() {
            @Override
            public void accept(Tracers tracers) {
                work(tracers, listener);
            }
        });
    }

    /**
     * Renders in passes, coarse ones first; the picture becomes the same. It may be {@linkplain #setPaused paused}. A row in which
     * something throws is left out, and the others go on. Returns when all threads have ended.
     *
     * @param listener told of each piece; what it throws ends the rendering, and is thrown here
     * @param first what is rendered before all else; null for nothing
     * @param alone whether that is all
     * @return the picture; rows that were left out, or not asked for as a whole, are not set
     * @throws CancellationException if it was cancelled, or the calling thread was interrupted
     * @throws IllegalArgumentException if the picture does not have that region, or is a region itself
     */
    public Picture renderPasses(PassListener listener, Region first, boolean alone) {
        if (settings.region() != null) {
            throw new IllegalArgumentException("a region is not rendered in passes");
        }
        if (first != null) {
            first.requireWithin(picture.width(), picture.height());
        }
        ProgressiveRenderer own = new ProgressiveRenderer(picture, listener, first, alone, settings.samples() == RenderSettings.ADAPTIVE);
        synchronized (this) {
            passes = own;
            own.setPaused(paused);
        }
        if (cancelled) {                                      // before there was anything to stop
            own.stop();
        }
        return renderBy(tracers -> own.run(many -> tracers.tracer(many && !cancelled), settings.samples()));
    }

    /**
     * Holds a rendering in passes, or lets it go on; it is held within the time of a pixel. Any thread may call, also before it has begun.
     *
     * @param held whether it is to be held
     */
    public synchronized void setPaused(boolean held) {
        paused = held;
        if (passes != null) {
            passes.setPaused(held);
        }
    }

    private Picture renderBy(Consumer<Tracers> work) {
        long start = System.nanoTime();
        CompiledScene compiled = settings.accel() == Accel.NONE ? null
            : prepared == null ? compile() : prepared.compiled(camera.eye(), this::compile);
        ready = compiled;
        Tracers tracers = new Tracers(scene, camera, settings, compiled);
        long begin = System.nanoTime();
        List<Thread> workers = new ArrayList<>(threads());
        for (int i = 0; i < threads(); i++) {
            try {
                Thread worker = new Thread(null, new Runnable() {
                    @Override
                    public void run() {
                        Renderer.this.run(work, tracers);
                    }
                }, "simpleray-worker-" + (i + 1), STACK);
                worker.setDaemon(true);
                worker.start();
                workers.add(worker);
            } catch (OutOfMemoryError e) {                    // the system grants no more threads: fewer do the same work
                if (workers.isEmpty()) {
                    throw e;
                }
                break;
            }
        }
        for (Thread worker : workers) {
            await(worker);
        }
        stats = new RenderStats(tracers.stats(), Progress.seconds(start, begin),
            Progress.seconds(begin, System.nanoTime()));
        if (fault instanceof Error error) {
            throw error;
        }
        if (fault instanceof RuntimeException exception) {
            throw exception;
        }
        if (cancelled) {
            throw new CancellationException("the rendering was cancelled");
        }
        return picture;
    }

    private CompiledScene compile() {
        long samples = Math.max(1, (long) settings.samples() * settings.samples());
        return new CompiledScene(scene, camera.eye(), settings.threads(), samples * picture.width() * picture.height());
    }

    private int threads() {
        return Math.min(settings.threads(), picture.height());
    }

    /** Ends the rendering soon; its threads end within the time of a pixel. Any thread may call, also before it has begun. */
    public void cancel() {
        cancelled = true;
        rows.stop();
        ProgressiveRenderer current = passes;
        if (current != null) {
            current.stop();
        }
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

    /**
     * Renders a few rows from all over the picture, pixel by pixel in an order that jumps about: the machine compiles what it has seen at work,
     * and would have to begin again for what only the other rows show. They are kept until their turn comes.
     */
    private void renderEarly(Sampler own) {
        int share = (earlyRows() + threads() - 1) / threads();
        int first = nextEarly.getAndAdd(share);
        int last = Math.min(first + share, earlyRows());
        int[] numbers = new int[Math.max(0, last - first)];
        int count = 0;
        for (int k = first; k < last; k++) {
            int y = (int) ((0.5 + k * APART) % 1 * picture.height());
            if (known == null || known.apply(y) == null) {
                numbers[count++] = y;
            }
        }
        int width = picture.width();
        double[][] lights = new double[count][3 * width];
        Colour colour = new Colour();
        for (int i = 0; i < width; i++) {
            int x = (int) ((long) i * JUMP % width);
            for (int k = 0; k < count && !cancelled; k++) {
                render(x, numbers[k], lights[k], own, colour);
            }
        }
        for (int k = 0; k < count && !cancelled; k++) {
            early.put(numbers[k], lights[k]);
        }
    }

    /** {@return how many rows are rendered before their turn} None if they would look at neighbours that are not known yet. */
    private int earlyRows() {
        return firstPoints != null ? 0 : Math.min(Math.min(MAX_EARLY, MAX_EARLY_PIXELS / picture.width()), picture.height() / EARLY_PART);
    }

    /** {@return the light of a row that need not be rendered any more; null if it must be} */
    private double[] kept(int y) {
        double[] row = early.remove(y);
        return row == null && known != null ? known.apply(y) : row;
    }

    private Sampler sampler(Tracer tracer) {
        return firstPoints == null ? new GridSampler(tracer, settings.samples())
            : new AdaptiveSampler(tracer, camera.width(), camera.height(), region, firstPoints);
    }

    private void run(Consumer<Tracers> work, Tracers tracers) {
        try {
            work.accept(tracers);
        } catch (RuntimeException | Error e) {                // reported by render(), after all threads have ended
            if (fault == null) {                              // which takes no memory: there may be none left
                fault = e;
            }
            cancel();
        }
    }

    private void work(Tracers tracers, RenderListener listener) {
        Sampler own = sampler(tracers.tracer(false));
        renderEarly(own);
        double[] spare = null;                                // a row that was let go of
        for (int y = rows.next(); y >= 0 && !cancelled; y = rows.next()) {
            double[] row = kept(y);
            boolean isNew = row == null;
            if (isNew) {
                row = spare == null ? new double[3 * picture.width()] : spare;
                spare = row;
                render(y, row, own);
            }
            if (!cancelled) {
                picture.setRow(y, row);
                listener.rowFinished(y);
                rows.finished(y);
                if (isNew && picture.row(y) != null) {
                    spare = null;
                }
            }
        }
    }

    private void render(int y, double[] light, Sampler own) {
        Colour colour = new Colour();
        for (int x = 0; x < picture.width() && !cancelled; x++) {
            render(x, y, light, own, colour);
        }
    }

    private void render(int x, int y, double[] light, Sampler own, Colour colour) {
        own.pixel(region.x() + x, region.y() + y, colour);
        light[3 * x] = colour.r;
        light[3 * x + 1] = colour.g;
        light[3 * x + 2] = colour.b;
    }
}
