package simpleray.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Future;
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
 * Renders one picture of a scene on several threads, each of which takes row after row (thesis, chapter 2). The scene and the camera must
 * not change meanwhile.
 */
public final class Renderer {
    // A plain rendering uses no lambda, here and elsewhere: the first ones add 10 ms to each start.
    /** The most rows that are rendered early, the most pixels in them, and the part of all rows that they are at most. */
    private static final int MAX_EARLY = 64;
    private static final int MAX_EARLY_PIXELS = 64_000;
    private static final int EARLY_PART = 8;
    /** After so many nanoseconds early rows are left as they are, so that a slow picture has whole rows to be kept. */
    private static final long MAX_EARLY_TIME = 1_000_000_000;
    /** The distance between early rows, as a share of the picture: the golden ratio spreads any number of rows evenly. */
    private static final double APART = 0.6180339887498949;
    /** The step between columns of early rows. Since it is a prime above any width, steps modulo the width reach each column once. */
    private static final int JUMP = 1_000_003;

    /** Stands for a row whose turn has come. */
    private static final EarlyRow TAKEN = new EarlyRow(0, null);

    private final Scene scene;
    private final Camera camera;
    private final RenderSettings settings;
    private final AtomicReferenceArray<AdaptiveSampler.Row> firstPoints;   // null if sampling is not adaptive
    private final PreparedScene prepared;                     // null if the scene is compiled for this rendering alone
    private final Region region;                              // the part of the camera's window that is rendered
    private final Picture picture;
    private final ScanlineQueue rows;
    private volatile Throwable fault;                         // the first exception of a thread; if two come at once, either
    private volatile boolean cancelled;
    private final Map<Integer, EarlyRow> early = new ConcurrentHashMap<>();   // by their numbers
    private long maxEarlyTime = MAX_EARLY_TIME;
    private final AtomicInteger nextEarly = new AtomicInteger();
    private volatile CompiledScene ready;                     // kept for the explainer
    private volatile boolean begun;                           // the scene is compiled, if it is to be
    private Begin at;                                         // null before it has begun, as the next one
    private RenderThreads workers;
    private List<Future<?>> tasks = List.of();
    private volatile ProgressiveRenderer passes;              // null unless rendering in passes
    private boolean paused;
    private IntFunction<double[]> known;                      // null if no row is known
    private RenderStats stats;

    /** What is known once the scene is compiled. */
    private record Begin(Tracers tracers, double readySeconds, long time) {
    }

    /** A row that a thread has begun early, and leaves to whichever thread's turn it is. */
    private static final class EarlyRow {
        private final int y;
        private final double[] light;
        private int pixels;                                   // so many are rendered, in the order of early rows
        private boolean left;

        EarlyRow(int y, double[] light) {
            this.y = y;
            this.light = light;
        }

        synchronized void leave(int pixels) {
            this.pixels = pixels;
            left = true;
            notifyAll();
        }

        /** Waits until the row is left. {@return how many pixels are rendered} */
        synchronized int await() {
            boolean interrupted = false;
            while (!left) {
                try {
                    wait();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
            return pixels;
        }
    }

    /**
     * Prepares a rendering. The renderer can be used once.
     *
     * @param scene the scene
     * @param camera the camera, whose resolution is the picture's
     * @param settings all other settings
     * @throws IllegalArgumentException if the settings have a region that is not inside the picture
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
        picture = new Picture(region.width(), region.height(), scene.settings.isTransparent() ? Picture.RGBA : Picture.RGB);
        rows = new ScanlineQueue(picture.height(), settings.threads());
    }

    /** {@return the picture, whose rows are set one by one while it is rendered} */
    public Picture picture() {
        return picture;
    }

    /**
     * Sets rows that need not be rendered. Must be called before {@link #render}.
     *
     * @param rows returns the light of the row with a given number, or null if it is unknown; several threads may call at once
     */
    public void know(IntFunction<double[]> rows) {
        known = rows;
    }

    /** {@return the statistics of the rendering; null until it has ended} */
    public RenderStats stats() {
        return stats;
    }

    /**
     * Creates an explainer of this picture's pixels. It shares the compiled scene, if rendering has begun.
     *
     * @return an explainer for one thread, for use while the picture is rendered and afterwards
     */
    public Explainer explainer() {
        return new Explainer(scene, camera, settings, ready);
    }

    /** {@return whether rays are traced or were: an explainer need not compile the scene any more} */
    public boolean hasBegun() {
        return begun;
    }

    /** {@return the most rows that are begun, counted from the first unfinished one} */
    public int rowsAhead() {
        return Math.min(ScanlineQueue.ahead(settings.threads()), picture.height());
    }

    /** {@return the most memory that rendering needs, in bytes, if the listener releases each row} */
    public long bytesNeeded() {
        int kept = firstPoints == null ? 0 : firstPoints.length();   // which include most neighbours of each thread's row
        return (long) (threads() + kept + earlyRows()) * Picture.bytesNeeded(picture.width(), 1, picture.channels());
    }

    /**
     * Renders, and returns when all rows are finished and all threads have ended.
     *
     * @param listener called for each row; an exception that it throws ends the rendering, and is thrown here
     * @return the picture, without the rows that the listener released
     * @throws CancellationException if it was cancelled, or the calling thread was interrupted
     */
    public Picture render(RenderListener listener) {
        try (RenderThreads threads = new RenderThreads(threads())) {
            begin(threads, listener);
            return end();
        }
    }

    /**
     * Begins to render, and returns at once. {@link #end} waits for the picture.
     *
     * @param threads render, after what they were given before
     * @param listener called for each row; an exception that it throws ends the rendering
     */
    public void begin(RenderThreads threads, RenderListener listener) {
        start(threads, new Consumer<>() {
            @Override
            public void accept(Tracers made) {
                work(made, listener);
            }
        });
    }

    /**
     * Renders the same picture in passes, coarse ones first. It may be {@linkplain #setPaused paused}. If an exception is thrown in a row, the
     * row is left out, and the others continue. Returns when all threads have ended.
     *
     * @param listener called for each run of pixels; an exception that it throws ends the rendering, and is thrown here
     * @param first the region to render first; null for none
     * @param alone whether only that region is rendered
     * @return the picture; rows that were left out, or only partly rendered, are not set
     * @throws CancellationException if it was cancelled, or the calling thread was interrupted
     * @throws IllegalArgumentException if the region is not inside the picture, or the picture is itself a region
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
        if (cancelled) {                                      // before there were passes to stop
            own.stop();
        }
        try (RenderThreads threads = new RenderThreads(threads())) {
            start(threads, made -> own.run(many -> made.tracer(many && !cancelled), settings.samples()));
            return end();
        }
    }

    /**
     * Pauses a rendering in passes within the time of a pixel, or resumes it. Any thread may call, also before it has begun.
     *
     * @param held whether to pause
     */
    public synchronized void setPaused(boolean held) {
        paused = held;
        if (passes != null) {
            passes.setPaused(held);
        }
    }

    private void start(RenderThreads threads, Consumer<Tracers> work) {
        long first = System.nanoTime();
        CompiledScene compiled = settings.accel() == Accel.NONE ? null
            : prepared == null ? compile() : prepared.compiled(scene, camera.eye(), this::compile);
        ready = compiled;
        begun = true;
        Tracers made = new Tracers(scene, camera, settings, compiled);
        long time = System.nanoTime();
        at = new Begin(made, Progress.seconds(first, time), time);
        workers = threads;
        tasks = threads.begin(new Runnable() {
            @Override
            public void run() {
                Renderer.this.run(work);
            }
        });
    }

    /**
     * Waits until all rows are finished of what was begun.
     *
     * @return the picture, without the rows that the listener released
     * @throws CancellationException if it was cancelled, or the calling thread was interrupted
     */
    public Picture end() {
        await();
        stats = new RenderStats(at.tracers.stats(), at.readySeconds, Progress.seconds(at.time, System.nanoTime()));
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

    /** Waits until no thread works on it any more. An interrupt cancels it, and is kept. */
    public void await() {
        boolean interrupted = false;
        for (Future<?> task : tasks) {
            while (!task.isDone()) {
                try {
                    workers.await(task);
                } catch (InterruptedException e) {
                    interrupted = true;
                    cancel();
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private CompiledScene compile() {
        long samples = Math.max(1, (long) settings.samples() * settings.samples());
        return new CompiledScene(scene, camera.eye(), settings.threads(), samples * picture.width() * picture.height());
    }

    /** {@return the most threads that can be at work} */
    public int threads() {
        return Math.min(settings.threads(), picture.height());
    }

    /** Ends the rendering: its threads end within the time of a pixel. Any thread may call, also before it has begun. */
    public void cancel() {
        cancelled = true;
        rows.stop();
        ProgressiveRenderer current = passes;
        if (current != null) {
            current.stop();
        }
    }

    /**
     * Renders a few rows from all over the picture, pixel by pixel in a scattered order, and keeps them until their turn comes. The JVM compiles
     * by the profile of what has run, and would have to compile again when lower rows show something new.
     */
    private void renderEarly(Sampler own) {
        int share = (earlyRows() + threads() - 1) / threads();
        int first = nextEarly.getAndAdd(share);
        int last = Math.min(first + share, earlyRows());
        int width = picture.width();
        List<EarlyRow> mine = new ArrayList<>();
        int pixels = 0;
        try {
            for (int k = first; k < last; k++) {
                int y = (int) ((0.5 + k * APART) % 1 * picture.height());
                if (known == null || known.apply(y) == null) {
                    EarlyRow row = new EarlyRow(y, new double[picture.channels() * width]);
                    if (early.putIfAbsent(y, row) == null) {      // else its turn has come already
                        mine.add(row);
                    }
                }
            }
            Colour colour = new Colour();
            long begin = System.nanoTime();
            while (pixels < width && System.nanoTime() - begin < maxEarlyTime) {
                int x = earlyColumn(pixels++);
                for (int k = 0; k < mine.size() && !cancelled; k++) {
                    renderPixel(x, mine.get(k).y, mine.get(k).light, own, colour);
                }
            }
        } finally {
            for (EarlyRow row : mine) {
                row.leave(pixels);
            }
        }
    }

    private int earlyColumn(int pixel) {
        return (int) ((long) pixel * JUMP % picture.width());
    }

    /** Sets how long rows are rendered early, in nanoseconds. */
    void setMaxEarlyTime(long nanoseconds) {
        maxEarlyTime = nanoseconds;
    }

    /** {@return the number of rows that are rendered early} None if sampling is adaptive, since their neighbours are not traced yet. */
    private int earlyRows() {
        return firstPoints != null ? 0 : Math.min(Math.min(MAX_EARLY, MAX_EARLY_PIXELS / picture.width()), picture.height() / EARLY_PART);
    }

    /** {@return the light of a row that is known, or was begun early and is finished now; null for others} */
    private double[] kept(int y, Sampler own) {
        EarlyRow begun = early.putIfAbsent(y, TAKEN);
        if (begun == null) {
            return known == null ? null : known.apply(y);
        }
        early.put(y, TAKEN);                                  // its light is the picture's now
        Colour colour = new Colour();
        for (int i = begun.await(); i < picture.width() && !cancelled; i++) {
            renderPixel(earlyColumn(i), y, begun.light, own, colour);
        }
        return begun.light;
    }

    private Sampler sampler(Tracer tracer) {
        return firstPoints == null ? new GridSampler(tracer, settings.samples())
            : new AdaptiveSampler(tracer, camera.width(), camera.height(), picture.channels(), region, firstPoints);
    }

    private void run(Consumer<Tracers> work) {
        try {
            work.accept(at.tracers);
        } catch (RuntimeException | Error e) {                // thrown by render(), after all threads have ended
            if (fault == null) {                              // allocates nothing: memory may have run out
                fault = e;
            }
            cancel();
        }
    }

    private void work(Tracers made, RenderListener listener) {
        Sampler own = sampler(made.tracer(true));
        renderEarly(own);
        double[] spare = null;                                // the array of a row that the listener released
        for (int y = rows.next(); y >= 0 && !cancelled; y = rows.next()) {
            double[] row = kept(y, own);
            boolean isNew = row == null;
            if (isNew) {
                row = spare == null ? new double[picture.channels() * picture.width()] : spare;
                spare = row;
                renderRow(y, row, own);
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

    private void renderRow(int y, double[] light, Sampler own) {
        Colour colour = new Colour();
        for (int x = 0; x < picture.width() && !cancelled; x++) {
            renderPixel(x, y, light, own, colour);
        }
    }

    private void renderPixel(int x, int y, double[] light, Sampler own, Colour colour) {
        double alpha = own.pixel(region.x() + x, region.y() + y, colour);
        Sampler.store(colour, alpha, light, picture.channels() * x, picture.channels());
    }
}
