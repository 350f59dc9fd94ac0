package simpleray.cli;

import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import simpleray.image.png.PngWriter;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.render.Renderer;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.Setting;

/**
 * What a rendering will need, roughly: it is asked of an engine, which ends a task that needs more. <em>Constant.</em>
 *
 * @param heap the memory for Java's objects, in MiB
 * @param start the time before the first ray of a task, in seconds
 * @param picture the time of a picture on one thread, in seconds
 */
record JobEstimate(long heap, double start, double picture) {
    /** The memory of Java itself, in MiB: its code, the program's classes, the stacks of threads. */
    static final int JAVA = 192;
    private static final int MIN_HEAP = 256;
    private static final int STEP = 64;
    /** The time to start Java, and for whatever a node is busy with. */
    private static final double JAVA_SECONDS = 2;
    /** The pixels of a sample, and its longest time in milliseconds. */
    private static final int SAMPLE_PIXELS = 6400;
    private static final long SAMPLE_TIME = 2000;
    /** A node may be slower than this machine, and a part of a picture more work than others. */
    private static final double SAFETY = 4;
    private static final int MINUTE = 60;
    private static final int STEP_MINUTES = 5;

    /**
     * Renders a small picture of a scene, of its first frame, the one in the middle and the last, for two seconds each at most.
     *
     * @param request what is asked for; its threads do not count
     * @param scene the scene
     * @param frames the frames that are asked for; null if the scene has none
     * @param readSeconds the time that it took to read it
     */
    static JobEstimate of(RenderRequest request, Scene scene, FrameRanges frames, double readSeconds) {
        if (frames == null) {
            return of(request, scene, readSeconds);
        }
        JobEstimate first = of(request, scene.still(frames.first()), readSeconds);
        JobEstimate middle = of(request, scene.still(frames.frame(frames.count() / 2)), readSeconds);
        return first.with(middle).with(of(request, scene.still(frames.last()), readSeconds));
    }

    /** {@return what is enough for two} */
    private JobEstimate with(JobEstimate other) {
        return new JobEstimate(Math.max(heap, other.heap), Math.max(start, other.start), Math.max(picture, other.picture));
    }

    /**
     * Renders a small picture of a scene, for two seconds at most.
     *
     * @param request what is asked for; its threads do not count
     * @param scene the scene
     * @param readSeconds the time that it took to read it
     */
    private static JobEstimate of(RenderRequest request, Scene scene, double readSeconds) {
        SceneSettings asked = request.applyTo(scene).settings;
        Resolution size = Setting.RESOLUTION.in(asked);
        RenderRequest alone = new RenderRequest(asked, request.stage(), request.adaptive(), 1);
        Renderer whole = alone.renderer(scene);
        double share = Math.min(1, Math.sqrt(SAMPLE_PIXELS / ((double) size.width() * size.height())));
        SceneSettings small = asked.under(new SceneSettings());
        small.resolution = new Resolution(scaled(size.width(), share), scaled(size.height(), share));
        Renderer sample = alone.with(small).renderer(scene);
        double rendered = sampleSeconds(sample) * size.width() * size.height()
            / ((double) small.resolution.width() * small.resolution.height());
        System.gc();
        Runtime memory = Runtime.getRuntime();
        long scenes = memory.totalMemory() - memory.freeMemory();   // the scene, made ready for rendering
        double ready = sample.stats() == null ? 0 : sample.stats().readySeconds();
        long bytes = 2 * scenes + whole.bytesNeeded() + PngWriter.bytesNeeded(whole.picture(), whole.rowsAhead());
        return new JobEstimate(heap(bytes), JAVA_SECONDS + readSeconds + ready, rendered);
    }

    private static int scaled(int length, double share) {
        return Math.max(1, (int) Math.ceil(length * share));
    }

    /** {@return the heap for so many bytes, in MiB} */
    static long heap(long bytes) {
        long mebibytes = (bytes >> 20) + 1;
        return Math.max(MIN_HEAP, (mebibytes + STEP - 1) / STEP * STEP);
    }

    /** {@return the time to render all rows, in seconds, as far as two seconds of rendering tell} */
    private static double sampleSeconds(Renderer sample) {
        AtomicInteger rows = new AtomicInteger();
        Timer timer = new Timer("simpleray-sample", true);
        timer.schedule(new TimerTask() {
            @Override
            public void run() {
                sample.cancel();
            }
        }, SAMPLE_TIME);
        long begin = System.nanoTime();
        try {
            sample.render(new RenderListener() {
                @Override
                public void rowFinished(int y) {
                    rows.incrementAndGet();
                }
            });
            return sample.stats().renderSeconds();
        } catch (CancellationException e) {
            return (System.nanoTime() - begin) * 1e-9 * sample.picture().height() / Math.max(1, rows.get());
        } finally {
            timer.cancel();
        }
    }

    /** {@return the memory to ask for, in MiB} */
    long memory() {
        return heap + JAVA;
    }

    /**
     * Finds how long a task may take.
     *
     * @param pictures the pictures of a task; less than 1 for a band
     * @return the time to ask for, in minutes
     */
    long minutes(double pictures) {
        double seconds = SAFETY * (Math.ceil(pictures) * start + pictures * picture);
        return ((long) Math.floor(seconds / MINUTE / STEP_MINUTES) + 1) * STEP_MINUTES;
    }
}
