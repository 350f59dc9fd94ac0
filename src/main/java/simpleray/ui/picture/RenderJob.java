package simpleray.ui.picture;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicReference;
import simpleray.image.Picture;
import simpleray.io.OutputTarget;
import simpleray.render.Explainer;
import simpleray.render.OutOfMemory;
import simpleray.render.PreparedScene;
import simpleray.render.Progress;
import simpleray.render.Provenance;
import simpleray.render.Region;
import simpleray.render.RenderRequest;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;
import simpleray.scene.SourceText;
import simpleray.ui.file.SceneSource;

/**
 * One rendering for a window, on a thread of its own: reads the scene or takes the one that was read before, renders it, and leaves
 * finished pixel runs in a queue. The window polls {@link #snapshot}; nothing here waits for it. Any thread may call.
 */
public final class RenderJob {
    /** Why nothing is saved under a name that {@link #reads}. */
    public static final String READ = "The scene is read from it: choose another name";
    private static final long PATIENCE = 1000;                // milliseconds

    private final SceneSource source;
    private final RenderRequest request;
    private RenderJob before;                                 // whose scene is rendered again; null if it is to be read
    private boolean checked;                                  // whether the scene was looked through for mistakes; for the working thread
    private final SceneReport known;                          // to be shown in place of the findings about that scene; none for these
    private final Region region;                              // what is asked to come first; null for nothing
    private final boolean alone;
    private int asked;                                        // the frame, if the scene is a film; not changed after the start
    private final PixelRunQueue runs;
    private final Thread thread;
    private int room;
    private SourceText earlier;                               // null for none

    private final AtomicReference<Snapshot> latest;
    private volatile boolean cancelled;
    private boolean paused;

    /** How far a rendering is. */
    public enum State {
        /** The scene is being read. */
        READING,
        /** Rows are being rendered. */
        RENDERING,
        /** The picture is whole. */
        FINISHED,
        /** It was cancelled before it was whole. */
        CANCELLED,
        /** The scene could not be read, or the program failed; {@link Snapshot#problems} says how. */
        FAILED;

        /** {@return whether nothing more comes} */
        public boolean ended() {
            return this == FINISHED || this == CANCELLED || this == FAILED;
        }
    }

    /** A scene that was read, a frame of it if it is a film, and that frame's structures. */
    private record LoadedScene(SceneFile film, int frame, SceneFile file, PreparedScene prepared) {
        /** {@return a frame of a film that was read; of a shorter film its last} */
        static LoadedScene of(SceneFile film, int asked) {
            int frame = Math.min(asked, film.scene().film().frames() - 1);
            SceneFile file = film.still(frame);
            return new LoadedScene(film, frame, file, new PreparedScene(file.scene()));
        }

        /** {@return another frame, with what stays of the structures} */
        LoadedScene at(int other) {
            LoadedScene next = of(film, other);
            return next.frame == frame ? this : new LoadedScene(film, next.frame, next.file, prepared);
        }
    }

    /** The renderer, its request with the size and its start; renderer and image are null once they are dropped. */
    private record Run(Renderer renderer, ProgressiveImage image, Progress progress, RenderRequest request, SceneSettings settings,
                       Region region, boolean alone, long begun) {
    }

    /**
     * All that is known about a rendering at one moment. <em>Constant.</em>
     *
     * @param state how far it is
     * @param loaded the scene; null until it is read
     * @param run what renders it; null before rendering has begun
     * @param findings errors, or warnings once the scene was read
     * @param failure what was not rendered; empty for nothing
     * @param took the seconds that rendering took; 0 before it has ended
     */
    public record Snapshot(State state, LoadedScene loaded, Run run, SceneReport findings, String failure, double took) {
        /** {@return whether the scene is there, so that it can be rendered again} */
        boolean hasScene() {
            return loaded != null;
        }

        /** {@return whether this is a rendering of the scene that the other one has, as it was read then} */
        @SuppressWarnings("ReferenceEquality")                // the very scene: another may have been read from the file since
        boolean isOfSceneOf(Snapshot other) {
            return loaded == other.loaded;
        }

        /** {@return the scene, not to be changed; null until it is read} */
        public Scene scene() {
            return loaded == null ? null : loaded.file.scene();
        }

        /** {@return what was asked for, with the size that it has of the window; null before rendering has begun} */
        public RenderRequest request() {
            return run == null ? null : run.request;
        }

        /** {@return the scene as it was read, with all its frames; null until then} */
        public SceneFile film() {
            return loaded == null ? null : loaded.film;
        }

        /** {@return the frame that is rendered; 0 for a scene that is no film} */
        public int frame() {
            return loaded == null ? 0 : loaded.frame;
        }

        /** {@return the settings of the picture, from the scene and from what was asked for; null before rendering has begun} */
        public SceneSettings settings() {
            return run == null ? null : run.settings;
        }

        /** {@return errors, or warnings once the scene was read; in the end also what was not rendered; empty for none} */
        public String problems() {
            String scene = findings.text();
            return failure.isEmpty() ? scene : scene.isEmpty() ? failure : failure + "\n" + scene;
        }

        /** {@return a blank image of the picture's size; null before rendering has begun} */
        ProgressiveImage image() {
            return run == null ? null : run.image;
        }

        /** {@return the picture; rows are set as they are finished; null before rendering has begun} */
        public Picture picture() {
            return run == null || run.renderer == null ? null : run.renderer.picture();
        }

        /** {@return what explains the picture's pixels; null before rendering has begun} May take long: not for the event thread. */
        public Explainer explainer() {
            return run == null || run.renderer == null ? null : run.renderer.explainer();
        }

        /** {@return whether pixels can be explained: the scene is ready for rays} */
        public boolean canExplain() {
            return run != null && run.renderer != null && run.renderer.hasBegun();
        }

        /** {@return the progress; null before rendering has begun} */
        public Progress progress() {
            return run == null ? null : run.progress;
        }

        /** {@return the region that comes first, or alone; null for none} */
        public Region region() {
            return run == null ? null : run.region;
        }

        /** {@return whether the region is rendered alone} */
        public boolean isAlone() {
            return run != null && run.alone;
        }

        /** {@return the nanoseconds since rendering began; negative before} */
        long age(long now) {
            return run == null ? -1 : now - run.begun;
        }

        /** {@return how many seconds rendering took so far, or in all, without pauses} */
        public double seconds() {
            return run == null || state.ended() ? took : run.progress.elapsed(System.nanoTime());
        }
    }

    /** Reads a scene and renders it. */
    RenderJob(SceneSource source, RenderRequest request, Region region, boolean alone) {
        this(source, request, null, SceneReport.NONE, region, alone, new PixelRunQueue());
    }

    /**
     * Renders a scene that another rendering has read, once that has ended.
     *
     * @param before the other; it {@linkplain Snapshot#hasScene has its scene}
     * @param known what is wrong with a scene that was to be read since, and is to be shown all the same; nothing for the other's own
     */
    RenderJob(RenderJob before, SceneReport known, RenderRequest request, Region region, boolean alone) {
        this(before.source, request, before, known, region, alone, new PixelRunQueue());
    }

    /**
     * Has what another rendering of the same scene has finished: it is shown again.
     *
     * @param before the last rendering of the scene, which is cancelled
     * @param finished the other
     * @param whole how that ended
     */
    RenderJob(RenderJob before, RenderRequest request, RenderJob finished, Snapshot whole) {
        this(before.source, request, before, SceneReport.NONE, null, false, finished.runs);
        latest.set(whole);
    }

    private RenderJob(SceneSource source, RenderRequest request, RenderJob before, SceneReport known, Region region, boolean alone,
                      PixelRunQueue runs) {
        this.runs = runs;
        this.source = source;
        this.request = request;
        this.before = before;
        earlier = before == null ? null : before.text();
        this.known = known;
        this.region = region;
        this.alone = alone;
        State first = before == null ? State.READING : State.RENDERING;
        latest = new AtomicReference<>(new Snapshot(first, null, null, SceneReport.NONE, "", 0));
        thread = new Thread(this::work, "simpleray-rendering");
        thread.setDaemon(true);
    }

    /** Sets the task for the moment when the picture is there in coarse blocks; some thread runs it. Call before the start. */
    void whenCoarse(Runnable task) {
        runs.whenCoarse(task);
    }

    /** Sets how many pixels each side has of a picture whose size nobody asks for; 0 for the command line's. Call before the start. */
    void setRoom(int side) {
        room = side;
    }

    /** Sets the rendering that was the last, whose files stay protected if it was of the same scene and this one fails. Call before the start. */
    void setEarlier(RenderJob last) {
        earlier = last != null && source.path() != null && source.path().equals(last.source.path()) ? last.text() : null;
    }

    /** Sets the frame that is rendered if the scene is a film; 0, unless it is set. Call before the start. */
    void setFrame(int frame) {
        asked = frame;
    }

    void start() {
        thread.start();
    }

    void cancel() {
        cancelled = true;
        Run run = snapshot().run;
        if (run != null && run.renderer != null) {
            run.renderer.cancel();
        }
    }

    /** Holds the rendering, or lets it go on; its clock stands meanwhile. */
    synchronized void setPaused(boolean hold) {
        Snapshot now = snapshot();
        if (now.state.ended()) {
            return;
        }
        paused = hold;
        if (now.run != null && now.run.renderer != null) {
            pause(now.run);
        }
    }

    private void pause(Run run) {
        run.progress.pause(paused, System.nanoTime());
        run.renderer.setPaused(paused);
    }

    /** {@return whether it is held} */
    public synchronized boolean isPaused() {
        return paused && !state().ended();
    }

    /**
     * Waits until all threads of this rendering have ended; not for the event thread while it runs. A rendering that still reads is not
     * waited for long: nothing stops it, and a pipe may never end.
     *
     * @throws InterruptedException if the thread is interrupted
     */
    public void await() throws InterruptedException {
        thread.join(PATIENCE);
        if (state() != State.READING) {
            thread.join();
        }
    }

    /** {@return what was asked for beside the scene file} */
    public RenderRequest request() {
        return request;
    }

    /** {@return where the scene comes from} */
    public SceneSource source() {
        return source;
    }

    /** {@return the pixel runs that are finished and not yet painted} */
    public PixelRunQueue runs() {
        return runs;
    }

    /** {@return all that is known now} Two calls may give two answers: take one for things that belong together. */
    public Snapshot snapshot() {
        return latest.get();
    }

    /**
     * Finds whether writing a file would overwrite the scene's own or one that the scene names.
     *
     * @param written the file to be written
     * @return whether the scene is read from it
     */
    public boolean reads(Path written) {
        Path path = source.path();
        Path home = source.home();
        SourceText text = text();
        return path != null && OutputTarget.isSame(written, path)
            || text != null && text.names(written, (home == null ? Path.of("") : home).resolveSibling(""));
    }

    /** {@return the scene's text; that of {@link #setEarlier} before it was read, or if it has errors; null if there is none} */
    private SourceText text() {
        LoadedScene loaded = snapshot().loaded;
        return loaded == null ? earlier : loaded.film.text();
    }

    /**
     * Returns the text that was last read from a file, which may be gone since.
     *
     * @param file the file
     * @return its bytes, not to be changed; null if it was not read, was too long to be kept, or was a picture
     */
    public byte[] bytesOf(Path file) {
        SourceText text = file.equals(source.path()) ? text() : null;
        return text == null || !file.endsWith(text.name()) ? null : text.bytes();
    }

    /** {@return how far it is now} */
    public State state() {
        return snapshot().state;
    }

    /** Drops all but the scene, after it was cancelled. */
    void forget() {
        latest.updateAndGet(now -> new Snapshot(now.state, now.loaded, now.run == null ? null : new Run(null, null, now.run.progress,
            now.run.request, now.run.settings, now.run.region, now.run.alone, now.run.begun), now.findings, now.failure, now.took));
        runs.clear();
    }

    private void work() {
        if (state() == State.FINISHED) {
            await(before);                                    // the next one waits for this one
            before = null;
            checked = true;
            return;
        }
        try {
            LoadedScene loaded = load();
            render(loaded);
            double took = snapshot().seconds();
            String failure = runs.failedRows().text();
            SceneReport findings = snapshot().findings;
            if (!checked && failure.isEmpty() && !cancelled) {
                SceneSettings all = loaded.film.scene().settings.under(request.settings());
                findings = SceneReport.ofWhole(loaded.film.with(all), source.name());
                checked = true;
            }
            end(failure.isEmpty() ? State.FINISHED : State.FAILED, findings, failure, took);
        } catch (CancellationException e) {
            end(State.CANCELLED, snapshot().findings, "", snapshot().seconds());
        } catch (IOException e) {
            end(State.FAILED, SceneReport.of(e, source.name()), "", snapshot().seconds());
        } catch (RuntimeException | Error e) {
            end(State.FAILED, snapshot().findings, OutOfMemory.isBehind(e) ? OutOfMemory.MESSAGE
                : "The program failed, which should not happen whatever the scene: " + e, snapshot().seconds());
        }
    }

    private void end(State state, SceneReport findings, String failure, double took) {
        latest.updateAndGet(now -> new Snapshot(state, now.loaded, now.run, findings, failure, took));
    }

    /** Waits until a rendering has ended, which it is told to. */
    private static void await(RenderJob last) {
        last.cancel();
        try {
            last.thread.join();
        } catch (InterruptedException e) {
            throw new CancellationException("interrupted");
        }
    }

    /** Reads the scene; or takes that of the rendering before, when that has ended. */
    private LoadedScene load() throws IOException {
        RenderJob last = before;
        before = null;                                        // else each would keep all before it
        if (last == null) {
            LoadedScene loaded = LoadedScene.of(source.read(), asked);
            latest.set(new Snapshot(State.READING, loaded, null, SceneReport.of(loaded.file.warnings()), "", 0));
            return loaded;
        }
        await(last);
        Snapshot end = last.snapshot();
        checked = last.checked || !known.isEmpty() || !end.failure.isEmpty();
        LoadedScene loaded = end.loaded.at(asked);
        latest.set(new Snapshot(State.RENDERING, loaded, null, known.isEmpty() ? end.findings : known, "", 0));
        return loaded;
    }

    /** {@return what was asked for; with the size of the room, if neither that nor the scene says one} */
    private RenderRequest sized(Scene scene) {
        return sized(request, scene, room);
    }

    /** {@return a request with the size of a room, if neither the request nor the scene says one} */
    static RenderRequest sized(RenderRequest request, Scene scene, int room) {
        if (room <= 0 || Setting.RESOLUTION.isSet(request.settings()) || Setting.RESOLUTION.isSet(scene.settings)) {
            return request;
        }
        SceneSettings all = new SceneSettings().under(request.settings());
        all.resolution = new SceneSettings.Resolution(room, room);
        return request.with(all);
    }

    private void render(LoadedScene scene) {
        RenderRequest sized = sized(scene.file.scene());
        Renderer renderer = scene.prepared.renderer(sized, scene.file.scene());
        Picture picture = renderer.picture();
        picture.tell(Provenance.of(sized, scene.file));
        SceneSettings settings = sized.applyTo(scene.file.scene()).settings;
        Region part = region != null && region.isWithin(picture.width(), picture.height()) ? region : null;   // not that of a larger one
        boolean only = alone && part != null;
        Progress progress = new Progress(only ? part.height() : picture.height(), System.nanoTime());
        ProgressiveImage image = new ProgressiveImage(picture.width(), picture.height(), picture.hasAlpha());
        Run run = new Run(renderer, image, progress, sized, settings, part, only, System.nanoTime());
        synchronized (this) {
            latest.updateAndGet(now -> new Snapshot(State.RENDERING, scene, run, now.findings, "", 0));
            pause(run);
        }
        if (cancelled) {                                      // cancel() came before there was a renderer to tell
            throw new CancellationException("cancelled");
        }
        runs.count(progress, only ? part.width() : picture.width(), request.adaptive() ? RenderSettings.ADAPTIVE
            : Setting.SAMPLES.in(settings));
        renderer.renderPasses(runs, part, only);
    }
}
