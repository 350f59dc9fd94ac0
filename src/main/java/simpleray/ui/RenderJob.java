package simpleray.ui;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CancellationException;
import simpleray.image.Picture;
import simpleray.render.Explainer;
import simpleray.render.OutOfMemory;
import simpleray.render.PreparedScene;
import simpleray.render.Progress;
import simpleray.render.Provenance;
import simpleray.render.Region;
import simpleray.render.RenderRequest;
import simpleray.render.Renderer;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.text.Diagnostic;

/**
 * One rendering for a window, on a thread of its own: reads the scene or takes the one that was read before, renders it, and leaves
 * finished pieces in a queue. The window polls; nothing here waits for it.
 */
final class RenderJob {
    private static final long PATIENCE = 1000;                // milliseconds

    private final SceneSource source;
    private final RenderRequest request;
    private RenderJob before;                                 // whose scene is rendered again; null if it is to be read
    private final SceneReport known;                             // to be shown beside it in place of those of the scene; none for these
    private volatile Region region;                           // what comes first; null for nothing
    private volatile boolean alone;
    private final PixelRunQueue runs = new PixelRunQueue();
    private final Thread thread;

    private volatile State state;
    private volatile SceneReport findings = SceneReport.NONE;       // about the scene
    private volatile String failure = "";                     // what was not rendered
    private volatile PreparedScene scene;
    private volatile SceneFile file;                          // that of the scene
    private volatile Renderer renderer;
    private volatile SceneSettings settings;
    private volatile Progress progress;
    private volatile ProgressiveImage image;
    private volatile long begun;
    private volatile double seconds;
    private volatile boolean cancelled;
    private boolean paused;

    /** How far a rendering is. */
    enum State {
        /** The scene is being read. */
        READING,
        /** Rows are being rendered. */
        RENDERING,
        /** The picture is whole. */
        FINISHED,
        /** It was cancelled before it was whole. */
        CANCELLED,
        /** The scene could not be read, or the program failed; {@link #problems} says how. */
        FAILED;

        boolean ended() {
            return this == FINISHED || this == CANCELLED || this == FAILED;
        }
    }

    /** Reads a scene and renders it. */
    RenderJob(SceneSource source, RenderRequest request, Region region, boolean alone) {
        this(source, request, null, SceneReport.NONE, region, alone);
    }

    /**
     * Renders a scene that another rendering has read, once that has ended.
     *
     * @param before the other; it {@linkplain #hasScene has its scene}
     * @param known what is wrong with a scene that was to be read since, and is to be shown all the same; nothing for the other's own
     */
    RenderJob(RenderJob before, SceneReport known, RenderRequest request, Region region, boolean alone) {
        this(before.source, request, before, known, region, alone);
    }

    private RenderJob(SceneSource source, RenderRequest request, RenderJob before, SceneReport known, Region region, boolean alone) {
        this.source = source;
        this.request = request;
        this.before = before;
        this.known = known;
        this.region = region;
        this.alone = alone && region != null;
        state = before == null ? State.READING : State.RENDERING;
        thread = new Thread(this::work, "simpleray-rendering");
        thread.setDaemon(true);
    }

    /** Sets what is done once the picture is there in coarse blocks, on some thread; before the start. */
    void whenCoarse(Runnable task) {
        runs.whenCoarse(task);
    }

    void start() {
        thread.start();
    }

    void cancel() {
        cancelled = true;
        Renderer current = renderer;
        if (current != null) {
            current.cancel();
        }
    }

    /** Holds the rendering, or lets it go on; its clock stands meanwhile. */
    synchronized void setPaused(boolean hold) {
        if (state.ended()) {
            return;
        }
        paused = hold;
        if (renderer != null) {
            progress.pause(hold, System.nanoTime());
            renderer.setPaused(hold);
        }
    }

    synchronized boolean isPaused() {
        return paused && !state.ended();
    }

    /**
     * Waits until all threads of this rendering have ended; not for the event thread while it runs. One that still reads is not waited
     * for long: nothing stops it, and a pipe may never end.
     */
    void await() throws InterruptedException {
        thread.join(PATIENCE);
        if (state != State.READING) {
            thread.join();
        }
    }

    State state() {
        return state;
    }

    RenderRequest request() {
        return request;
    }

    SceneSource source() {
        return source;
    }

    /** {@return whether the scene is there, so that it can be rendered again} */
    boolean hasScene() {
        return scene != null;
    }

    /** {@return errors, or warnings once the scene was read; in the end also what was not rendered; empty for none} */
    String problems() {
        String now = failure;
        String scene = findings.text();
        return now.isEmpty() ? scene : scene.isEmpty() ? now : now + "\n" + scene;
    }

    /** {@return the errors or warnings that have a place; each stands as it is in {@link #problems}} */
    List<Diagnostic> places() {
        return findings.places();
    }

    /** {@return what is wrong with the scene: errors, or warnings once it was read} */
    SceneReport findings() {
        return findings;
    }

    /** Lets go of all but the scene, after it was cancelled. */
    void forget() {
        renderer = null;
        image = null;
        runs.clear();
    }

    /** {@return what is finished and not yet painted} */
    PixelRunQueue runs() {
        return runs;
    }

    /** {@return a blank image of the picture's size; null before rendering has begun} */
    ProgressiveImage image() {
        return image;
    }

    /** {@return whether all of what is rendered is there in coarse blocks} */
    boolean isCoarse() {
        return runs.isCoarse();
    }

    /** {@return the nanoseconds since rendering began; negative before} */
    long age(long now) {
        return begun == 0 ? -1 : now - begun;
    }

    /** {@return what comes first, or alone; null for nothing} */
    Region region() {
        return region;
    }

    boolean isAlone() {
        return alone;
    }

    /** {@return the picture; rows are set as they are finished; null before it is begun} */
    Picture picture() {
        Renderer current = renderer;
        return current == null ? null : current.picture();
    }

    /** {@return the scene, not to be changed; null until it is read} */
    Scene scene() {
        SceneFile current = file;
        return current == null ? null : current.scene();
    }

    /** {@return the settings that the picture is made with, of the scene and of what was asked for; null until the scene is read} */
    SceneSettings settings() {
        return settings;
    }

    /** {@return what tells about the picture's pixels; null before it is begun} Not for the event thread: it may have to be made. */
    Explainer explainer() {
        Renderer current = renderer;
        return current == null ? null : current.explainer();
    }

    /** {@return the progress; null before rendering has begun} */
    Progress progress() {
        return progress;
    }

    /** {@return how many seconds rendering took so far, or in all, without pauses} */
    double seconds() {
        Progress current = progress;
        return current == null || state.ended() ? seconds : current.elapsed(System.nanoTime());
    }

    private void work() {
        State end;
        double took = Double.NaN;
        try {
            boolean first = before == null;
            end = render(prepared());
            took = progress.elapsed(System.nanoTime());
            if (first && end == State.FINISHED && !cancelled) {   // what is odd about a picture that is whole
                findings = SceneReport.ofWhole(file, source.name());
            }
        } catch (CancellationException e) {
            end = State.CANCELLED;
        } catch (IOException e) {
            findings = SceneReport.of(e, source.name());
            end = State.FAILED;
        } catch (RuntimeException | Error e) {
            failure = OutOfMemory.isBehind(e) ? OutOfMemory.MESSAGE
                : "The program failed, which should not happen whatever the scene: " + e;
            end = State.FAILED;
        }
        Progress counted = progress;
        seconds = counted == null ? 0 : Double.isNaN(took) ? counted.elapsed(System.nanoTime()) : took;
        state = end;
    }

    /** Reads the scene; or takes that of the rendering before, when that has let go of it. */
    private PreparedScene prepared() throws IOException {
        RenderJob last = before;
        before = null;                                        // else each would keep all before it
        if (last == null) {
            SceneFile file = source.read();
            this.file = file;
            findings = SceneReport.of(file.warnings());
            scene = new PreparedScene(file.scene());
        } else {
            last.cancel();
            try {
                last.thread.join();
            } catch (InterruptedException e) {
                throw new CancellationException("interrupted");
            }
            findings = known.isEmpty() ? last.findings : known;
            scene = last.scene;
            file = last.file;
        }
        return scene;
    }

    private State render(PreparedScene prepared) {
        Renderer current = prepared.renderer(request);
        Picture picture = current.picture();
        picture.tell(Provenance.of(request, file));
        settings = file.scene().settings;
        if (region != null && !region.isWithin(picture.width(), picture.height())) {
            region = null;                                    // that of a larger picture
            alone = false;
        }
        Progress counter = new Progress(alone ? region.height() : picture.height(), System.nanoTime());
        image = new ProgressiveImage(picture.width(), picture.height());
        synchronized (this) {
            progress = counter;
            renderer = current;
            counter.pause(paused, System.nanoTime());
            current.setPaused(paused);
        }
        if (cancelled) {                                      // cancel() came before there was a renderer to tell
            return State.CANCELLED;
        }
        begun = System.nanoTime();
        state = State.RENDERING;
        runs.count(counter, alone ? region.width() : picture.width());
        current.renderPasses(runs, region, alone);
        failure = runs.failedRows().text();
        return runs.failedRows().isEmpty() ? State.FINISHED : State.FAILED;
    }
}
