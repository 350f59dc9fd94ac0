package simpleray.ui.film;

import java.awt.Dimension;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import simpleray.render.OutOfMemory;
import simpleray.render.PreparedScene;
import simpleray.render.RenderRequest;
import simpleray.render.Renderer;
import simpleray.scene.Film;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;

/**
 * Renders the frames of a film in the order in which they are shown, on a thread of its own. For the event thread, but for what that thread
 * does.
 */
final class FilmPlayer {
    private static final long IDLE = 10;                      // milliseconds between two looks whether a frame is wanted

    private final ExecutorService worker;
    private final Film film;
    private final RenderRequest request;
    private final Consumer<String> failed;
    private final FrameCache cache = new FrameCache();
    private final PlayPlan plan;
    private final PreparedScene prepared;                     // for the worker's thread
    private volatile boolean playing;
    private volatile boolean loop;
    private volatile int at;
    private Renderer current;                                 // null while none works

    /**
     * Prepares to play.
     *
     * @param worker the thread
     * @param scene the film's scene
     * @param request with which its frames are rendered
     * @param size the size of a frame
     * @param failed told on the event thread why no frames come any more
     */
    FilmPlayer(ExecutorService worker, Scene scene, RenderRequest request, Resolution size, Consumer<String> failed) {
        this.worker = worker;
        this.request = request;
        this.failed = failed;
        film = scene.film();
        prepared = new PreparedScene(scene);
        plan = new PlayPlan(film.frames(), film.rate(), new Dimension(size.width(), size.height()), cache);
    }

    /** {@return the pictures of the frames that are there} */
    FrameCache cache() {
        return cache;
    }

    /** Renders from a frame on, until it is told to pause. */
    void play(int from, boolean again) {
        at = from;
        loop = again;
        playing = true;
        worker.execute(this::work);
    }

    /** Notes which frame is shown now. */
    void shows(int frame) {
        at = frame;
    }

    void setLoop(boolean again) {
        loop = again;
    }

    boolean isPlaying() {
        return playing;
    }

    synchronized void pause() {
        playing = false;
        if (current != null) {
            current.cancel();
        }
    }

    private synchronized Renderer begin(Renderer next) {
        if (!playing) {
            throw new CancellationException("paused");
        }
        current = next;
        return next;
    }

    private void work() {
        try {
            while (playing) {
                PlayPlan.Choice next = plan.next(at, loop);
                if (next == null) {
                    Thread.sleep(IDLE);
                } else {
                    render(next);
                }
            }
        } catch (CancellationException e) {                   // told to pause
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();               // the window is closed
        } catch (RuntimeException | Error e) {
            fail(OutOfMemory.isBehind(e) ? OutOfMemory.MESSAGE : "The film cannot be played: " + e);
        }
    }

    private void fail(String why) {
        playing = false;
        SwingUtilities.invokeLater(() -> failed.accept(why));
    }

    private void render(PlayPlan.Choice choice) {
        long begun = System.nanoTime();
        SceneSettings settings = new SceneSettings().under(request.settings());
        Dimension sides = plan.sides(choice.divisor());
        settings.resolution = new Resolution(sides.width, sides.height);
        Renderer renderer = begin(prepared.renderer(request.with(settings), film.still(choice.frame())));
        renderer.render(y -> { });
        FrameCache.Kept made = new FrameCache.Kept(renderer.picture().toBufferedImage(), choice.divisor());
        plan.took(System.nanoTime() - begun, choice.divisor());
        int shown = at;
        cache.put(choice.frame(), made, frame -> Math.floorMod(frame - shown, film.frames()));
    }
}
