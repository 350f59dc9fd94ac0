package simpleray.ui;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.util.Queue;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.stream.Collectors;
import simpleray.image.Picture;
import simpleray.render.Progress;
import simpleray.render.RenderRequest;
import simpleray.render.Renderer;
import simpleray.scene.SceneFile;
import simpleray.text.Problem;

/**
 * One rendering for a window, on a thread of its own: reads the scene, renders it, and leaves finished rows in a queue. The window
 * polls; nothing here waits for it.
 */
final class Rendering {
    private static final long PATIENCE = 1000;                // milliseconds

    private final SceneSource source;
    private final RenderRequest request;
    private final Queue<Row> rows = new ConcurrentLinkedQueue<>();
    private final Thread thread;

    private volatile State state = State.READING;
    private volatile String problems = "";
    private volatile Renderer renderer;
    private volatile Progress progress;
    private volatile double seconds;
    private volatile boolean cancelled;

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

    /** A finished row as a screen shows it: its number, and a packed RGB number for each pixel. */
    record Row(int y, int[] rgb) {
    }

    Rendering(SceneSource source, RenderRequest request) {
        this.source = source;
        this.request = request;
        thread = new Thread(this::work, "simpleray-rendering");
        thread.setDaemon(true);
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

    /** {@return errors, or warnings once the scene was read; empty for none} */
    String problems() {
        return problems;
    }

    /** {@return the next finished row; null if there is none just now} */
    Row poll() {
        return rows.poll();
    }

    boolean hasRows() {
        return !rows.isEmpty();
    }

    /** {@return the picture, whole once the state is FINISHED; null before it is begun} */
    Picture picture() {
        Renderer current = renderer;
        return current == null ? null : current.picture();
    }

    /** {@return the progress; null before rendering has begun} */
    Progress progress() {
        return progress;
    }

    /** {@return how many seconds rendering took so far, or in all} */
    double seconds() {
        Progress current = progress;
        return current == null || state.ended() ? seconds : current.elapsed(System.nanoTime());
    }

    private void work() {
        State end;
        try {
            SceneFile file = source.read();
            problems = file.warnings().stream().map(Problem::toString).collect(Collectors.joining("\n"));
            end = render(file);
        } catch (CancellationException e) {
            end = State.CANCELLED;
        } catch (FileSystemException e) {
            problems = source.name() + ": " + e.getReason();
            end = State.FAILED;
        } catch (IOException e) {                             // a bad scene's message is its whole report
            problems = e.getMessage();
            end = State.FAILED;
        } catch (RuntimeException | Error e) {
            problems = "The program failed, which should not happen whatever the scene: " + e;
            end = State.FAILED;
        }
        Progress counted = progress;
        seconds = counted == null ? 0 : counted.elapsed(System.nanoTime());
        state = end;
    }

    private State render(SceneFile file) {
        Renderer current = request.renderer(file.scene());
        Progress counter = new Progress(current.picture().height(), System.nanoTime());
        progress = counter;
        renderer = current;
        if (cancelled) {                                      // cancel() came before there was a renderer to tell
            return State.CANCELLED;
        }
        state = State.RENDERING;
        current.render(y -> {
            rows.add(new Row(y, packed(current.picture().levels(y))));
            counter.rowFinished();
        });
        return State.FINISHED;
    }

    private static int[] packed(byte[] levels) {
        int[] rgb = new int[levels.length / 3];
        for (int x = 0; x < rgb.length; x++) {
            rgb[x] = 0xFF000000 | (levels[3 * x] & 0xFF) << 16 | (levels[3 * x + 1] & 0xFF) << 8 | levels[3 * x + 2] & 0xFF;
        }
        return rgb;
    }
}
