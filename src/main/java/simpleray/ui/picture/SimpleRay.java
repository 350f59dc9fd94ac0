package simpleray.ui.picture;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.lang.ref.SoftReference;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import simpleray.image.Picture;
import simpleray.render.Region;
import simpleray.render.RenderRequest;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.Setting;
import simpleray.ui.file.SceneSource;
import simpleray.ui.widget.Chequers;

/**
 * The framework for the ray tracing (thesis, chapter 5), a Swing component in place of the applet: it renders on a thread of its own,
 * and a timer, the thesis's "kicker", repaints the finished pixels, so that the user sees how far it is. All methods
 * are for the event thread.
 */
public final class SimpleRay extends ZoomedComponent implements Runnable {
    private static final long serialVersionUID = 1L;
    private static final int KICK = 20;                       // milliseconds between two looks for finished runs
    private static final long MAX_WORK = 8_000_000;          // nanoseconds that one look may take
    /** The longest wait for the whole coarse picture before a part of it is shown, in nanoseconds: whole it comes without flicker. */
    private static final long HOLD = 120_000_000;
    /** The longest that a new request waits until the picture before is shown, in nanoseconds. */
    private static final long MAX_WAIT = 250_000_000;
    /** The most finished pictures that can be shown again. */
    private static final int MAX_FINISHED = 8;
    /** Milliseconds without another change after which a window has its new size. */
    private static final int SETTLED = 250;
    /** The share of the memory that a picture may take whose size is the window's, and that finished ones may. */
    private static final int SHARE = 8;
    private static final Color SURROUND = new Color(0x3C3F41);

    private final transient Timer kicker = new Timer(KICK, e -> run());
    private final transient Timer settle = new Timer(SETTLED, e -> fitRoom());
    private transient int side;                               // of pictures whose size nobody asks for; 0 before there is a window
    private transient SceneSource source;
    private transient RenderRequest request;
    private transient int frame;                              // of the next rendering, if the scene is a film
    private transient ProgressiveImage progressive;           // touched by the event thread alone
    private transient BufferedImage image;                    // the progressive one's
    private transient RenderJob job;
    private final transient Deque<Finished> finished = new ArrayDeque<>();   // the latest first
    private transient RenderJob read;                         // the last one that has read the scene
    private transient boolean again;                          // another one is to follow as soon as this one is shown
    private transient boolean kept;                           // the old image stays until this one's runs come over it
    private final transient RegionTool regions = new RegionTool(this);
    private transient Picture whole;                          // the picture that is shown, once all its rows are
    private transient RenderJob seen;                         // the one whose runs are in the image; null for none
    private transient boolean shown;                          // a run of this rendering is in the image
    private transient BufferedImage played;                   // shown in place of the picture; null for nothing
    private transient RenderRequest playedFor;                // with which the frame played last is rendered; null while a film plays
    private transient BufferedImage marks;                    // painted over the picture; null for none
    private transient BufferedImage lit;                      // painted over the picture, likewise
    private transient Runnable listener = () -> { };
    private transient Consumer<Graphics2D> mark = canvas -> { };
    private transient Predicate<MouseEvent> grip = press -> false;

    /** A finished picture, which can be shown again unless the garbage collector has taken it. */
    private record Finished(RenderJob job, List<String> options, SoftReference<RenderJob.Snapshot> snapshot) {
    }

    /**
     * Creates the component; {@link #init} and {@link #start} follow.
     *
     * @param source the scene, which the applet took from its tag
     * @param request what is asked for beside the scene file
     */
    public SimpleRay(SceneSource source, RenderRequest request) {
        this.source = source;
        this.request = request;
        setName("picture");
        setOpaque(true);
        setFocusable(true);
        settle.setRepeats(false);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                settle.restart();
            }
        });
        addPropertyChangeListener(ZOOM, e -> settle.restart());
        init();
    }

    /** Makes an empty picture, of the size that was asked for until the scene's file says another. */
    public void init() {
        Resolution size = Setting.RESOLUTION.in(request.settings());
        show(new ProgressiveImage(size.width(), size.height(), false));
    }

    private void show(ProgressiveImage next) {
        boolean same = progressive != null && next.isOf(image.getWidth(), image.getHeight());
        progressive = next;
        image = next.image();
        whole = null;
        if (!same) {
            resized();
        }
        repaint();
    }

    /** Starts to render anew, and cancels the rendering before. The picture before stays until there is something to show. */
    public void start() {
        RenderJob next = new RenderJob(source, request, regions.region(), regions.isAlone());
        next.setEarlier(job());
        begin(next, false);
    }

    /** Reads the scene again and renders it; does nothing if there is none. */
    public void reload() {
        if (source != SceneSource.NONE) {
            start();
        }
    }

    /**
     * Renders the scene as is asked for now, by another camera for example; it is read only if it is another than the one that was last read.
     * May be called as often as the mouse moves: while the picture before is not yet seen, it waits for that a short time.
     */
    public void restart() {
        again = true;
        if (job == null || !kicker.isRunning() && lastRead() == null) {
            start();
        } else {
            restartIfReady();
        }
    }

    /** Shows a picture of the scene as it is asked for now: one that was finished before, or else renders it. */
    public void showOrRestart() {
        RenderJob last = job == null || regions.region() != null && regions.isAlone() ? null : lastRead();
        if (last != null) {
            List<String> asked = CommandWords.options(RenderJob.sized(request, last.snapshot().scene(), side()));
            for (Finished picture : finished) {
                RenderJob.Snapshot whole = picture.snapshot.get();
                if (whole != null && whole.frame() == frame && whole.isOfSceneOf(last.snapshot()) && picture.options.equals(asked)) {
                    showAgain(new RenderJob(last, request, picture.job, whole), whole);
                    return;
                }
            }
        }
        restart();
    }

    private void showAgain(RenderJob next, RenderJob.Snapshot now) {
        follow(next);
        kicker.stop();
        show(now.image());
        see();
        whole = now.picture();
        listener.run();
    }

    private void keep(RenderJob.Snapshot now) {
        List<String> options = CommandWords.options(now.request());
        finished.removeIf(picture -> {
            RenderJob.Snapshot other = picture.snapshot.get();
            return other == null || picture.options.equals(options) && other.isOfSceneOf(now);
        });
        finished.addFirst(new Finished(job, options, new SoftReference<>(now)));
        long room = Runtime.getRuntime().maxMemory() / SHARE;
        int number = 0;
        for (Iterator<Finished> all = finished.iterator(); all.hasNext(); number++) {
            RenderJob.Snapshot one = all.next().snapshot.get();
            room -= one == null ? 0 : Picture.bytesNeeded(one.picture().width(), one.picture().height(), one.picture().channels());
            if (number == MAX_FINISHED || room < 0) {
                all.remove();
            }
        }
    }

    @SuppressWarnings("ReferenceEquality")                    // the very request, not one like it
    private void restartIfReady() {
        RenderJob.Snapshot now = job.snapshot();
        if (again && (now.state().ended() || now.hasScene() && (shown || now.age(System.nanoTime()) > MAX_WAIT))) {
            RenderJob last = lastRead();
            if (last == null) {
                start();                                      // another text of the scene
            } else {
                SceneReport known = last == job ? SceneReport.NONE : now.findings();
                begin(new RenderJob(last, known, request, regions.region(), regions.isAlone()),
                    shown && request == job.request() && frame == now.frame());
            }
            again = false;
        }
    }

    /** {@return the side of a picture whose size nobody asks for: it fits its room, unless the user has chosen another scale} */
    private int side() {
        int room = room();
        if (room > 0 && (zoom().fitted() && !isHeld() || side == 0)) {
            double pixels = (double) Runtime.getRuntime().maxMemory() / SHARE / Picture.bytesNeeded(1, 1, Picture.RGBA);
            side = Math.max(1, (int) Math.min(room, Math.sqrt(pixels)));
        }
        return side;
    }

    /** {@return whether the picture has the size that it keeps, as far as the room tells} */
    boolean isSettled() {
        return !settle.isRunning();
    }

    /** {@return whether there is a picture whose place is to be kept: not one that is about to follow its window's size} */
    @SuppressWarnings("ReferenceEquality")                    // the very request, unless it got the room's size
    public boolean isPlaced() {
        return seen != null && (isSettled() || placed().scale() == 1 || job.snapshot().request() == job.request());
    }

    /** Renders a picture anew that has the size of the room there was before. */
    @SuppressWarnings("ReferenceEquality")                    // the very request, unless it got the room's size
    private void fitRoom() {
        RenderJob.Snapshot now = job == null ? null : job.snapshot();
        if (now == null || !isDisplayable() || now.state() == RenderJob.State.FAILED || now.state() == RenderJob.State.CANCELLED) {
            return;
        }
        if (now.request() == null) {
            settle.restart();                                 // it is not known yet whether it has a size of its own
        } else if (now.request() != job.request() && side() != now.settings().resolution.width()) {
            restart();
        }
    }

    /** {@return the last rendering that has read the present source; null if none did} */
    private RenderJob lastRead() {
        RenderJob last = job.snapshot().hasScene() ? job : read;
        return last != null && last.source() == source ? last : null;
    }

    private void begin(RenderJob next, boolean keep) {
        next.setRoom(side());
        next.whenCoarse(() -> SwingUtilities.invokeLater(this));   // at once, not when the kicker comes
        kept = keep;
        follow(next);
        kicker.start();
        listener.run();
    }

    private void follow(RenderJob next) {
        stop();
        if (job != null && job.snapshot().hasScene()) {
            read = job;
            if (job != seen) {
                job.forget();
            }
        }
        shown = false;
        job = next;
        next.setFrame(frame);
        next.start();
    }

    /** Cancels the rendering. Its threads end soon; this does not wait for them. */
    public void stop() {
        again = false;
        if (job != null) {
            job.cancel();
        }
    }

    /**
     * Holds the rendering, or lets it go on.
     *
     * @param hold whether to hold it
     */
    public void setPaused(boolean hold) {
        if (job != null) {
            job.setPaused(hold);
            listener.run();
        }
    }

    /** {@return whether the rendering is held} */
    public boolean isPaused() {
        return job != null && job.isPaused();
    }

    /** Called by the "kicker": shows the runs that were finished since, for a short time at most, and calls the listener. */
    @SuppressWarnings("ReferenceEquality")                    // the very request, not one like it
    @Override
    public void run() {
        RenderJob.Snapshot now = job.snapshot();              // asked first: if it has ended, no run comes after the last one seen
        boolean ended = now.state().ended();
        boolean unseen = now.state() == RenderJob.State.CANCELLED && !shown;
        long time = System.nanoTime();
        if (!job.runs().isEmpty() && !unseen && (shown || ended || job.runs().isCoarse() || now.age(time) > HOLD)) {
            showRuns(time + MAX_WORK);
        }
        if (playedFor != null && shown && (ended || playedFor != request || played.getWidth() < image.getWidth())) {
            play(null);
        }
        if (ended && (unseen || job.runs().isEmpty())) {
            kicker.stop();
            if (now.state() == RenderJob.State.FINISHED && !now.isAlone()) {
                whole = now.picture();
                keep(now);
            }
        }
        listener.run();
        restartIfReady();
    }

    private void showRuns(long end) {
        if (!shown) {                                         // no pixel of the picture before may pass for one of this
            showFirst();
        }
        Rectangle changed = job.runs().paint(progressive, end);
        if (!changed.isEmpty()) {
            Rectangle place = place();
            double scale = place.getWidth() / image.getWidth();
            int top = place.y + (int) Math.floor(changed.y * scale) - 1;
            repaint(0, top, getWidth(), (int) Math.ceil(changed.height * scale) + 2);
        }
    }

    /** If only the region is another, the runs go into the image that is there already. */
    private void showFirst() {
        RenderJob.Snapshot now = job.snapshot();              // with an image, since there are runs
        ProgressiveImage next = now.image();
        regions.fit(next.image().getWidth(), next.image().getHeight());
        if (kept && next.isOf(image.getWidth(), image.getHeight())) {
            finished.removeIf(picture -> picture.snapshot.get() == null || picture.snapshot.get().image() == progressive);
            progressive.reopen(now.isAlone() ? now.region() : Region.whole(image.getWidth(), image.getHeight()));
            whole = null;
        } else {
            show(next);
        }
        see();
    }

    private void see() {
        shown = true;
        if (seen != null) {
            seen.forget();
        }
        seen = job;
    }

    /**
     * Paints the screen.
     *
     * @param g what to paint with
     */
    @Override
    public void paint(Graphics g) {
        Graphics2D screen = (Graphics2D) g.create();
        screen.setColor(SURROUND);
        screen.fillRect(0, 0, getWidth(), getHeight());
        Rectangle place = place();
        if (!place.isEmpty()) {
            if (progressive.hasAlpha()) {
                Chequers.paint(screen, place);
            }
            placed().paint(screen, played == null ? image : played, ui());
            if (marks != null && played == null) {
                placed().paint(screen, marks, ui());
            }
            if (lit != null) {
                placed().paint(screen, lit, ui());
            }
            regions.paint(screen, place);
            mark.accept(screen);
        }
        screen.dispose();
    }

    /**
     * Paints the screen without clearing it first.
     *
     * @param g what to paint with
     */
    @Override
    public void update(Graphics g) {
        paint(g);
    }

    /**
     * Sets a painter of marks over the picture.
     *
     * @param other the painter
     */
    public void setMark(Consumer<Graphics2D> other) {
        mark = other;
    }

    /**
     * Sets which presses of the mouse take something along that is not the camera.
     *
     * @param other tells whether a press does
     */
    public void setGrip(Predicate<MouseEvent> other) {
        grip = other;
    }

    /** {@return whether a press of the mouse takes something along that is not the camera} */
    boolean isGrip(MouseEvent press) {
        return grip.test(press);
    }

    /** {@return the region that is rendered first, or alone, and the mouse that draws it} */
    public RegionTool regions() {
        return regions;
    }

    /**
     * Sets the scene that the next start reads.
     *
     * @param other the scene
     */
    public void setSource(SceneSource other) {
        if (!Objects.equals(other.path(), source.path())) {
            fitAgain();                                       // the room is another than that of the scene before
        }
        source = other;
    }

    /** {@return the scene} */
    public SceneSource source() {
        return source;
    }

    /**
     * Sets the request of the next rendering.
     *
     * @param other the request
     */
    public void setRequest(RenderRequest other) {
        request = other;
    }

    /**
     * Sets the frame of the next rendering, if the scene is a film.
     *
     * @param other the frame, 0 or more; of a shorter film its last is rendered
     */
    public void setFrame(int other) {
        frame = other;
    }

    /** {@return the frame of the next rendering, if the scene is a film} */
    public int frame() {
        return frame;
    }

    /**
     * Shows the picture of a frame in place of the rendered one, whatever its size, while a film is played.
     *
     * @param image the frame's picture, not to be changed; null for the rendered one
     */
    public void play(BufferedImage image) {
        boolean other = (played == null) != (image == null);
        playedFor = null;
        if (played != image) {
            played = image;
            repaint();
        }
        if (other) {
            listener.run();                                   // there is a whole picture now, or there is none
        }
    }

    /**
     * Ends that as soon as the next rendering has something as good to show.
     *
     * @param of the request with which the frame was rendered
     */
    public void endPlay(RenderRequest of) {
        playedFor = of;
    }

    /** {@return whether a frame's picture is shown in place of the rendered one} */
    public boolean isPlayed() {
        return played != null;
    }

    /** {@return the request of the next rendering} */
    public RenderRequest request() {
        return request;
    }

    /**
     * Sets an image that is painted over the picture, of its size.
     *
     * @param other the image; null for nothing
     */
    public void setMarks(BufferedImage other) {
        if (marks != other) {
            marks = other;
            repaint();
        }
    }

    /** Sets an image that is painted over the picture and its marks, of its size; null for nothing. */
    void setLit(BufferedImage other) {
        if (lit != other) {
            lit = other;
            repaint();
        }
    }

    /**
     * Sets a listener for anything that may have changed.
     *
     * @param other called on the event thread
     */
    public void setListener(Runnable other) {
        listener = other;
    }

    /** {@return the latest rendering; null before the first start} */
    public RenderJob job() {
        return job;
    }

    /** {@return the rendering whose pixels are shown; null for none} */
    public RenderJob seen() {
        return seen;
    }

    /** {@return whether there is no picture, and none to come: no scene was opened, or it could not be read} */
    public boolean isBlank() {
        return job == null || seen == null && job.state() == RenderJob.State.FAILED;
    }

    /**
     * {@return whether the picture has a pixel}
     *
     * @param pixel the pixel
     */
    public boolean has(Point pixel) {
        return pixel.x >= 0 && pixel.y >= 0 && pixel.x < image.getWidth() && pixel.y < image.getHeight();
    }

    /**
     * {@return how a pixel is shown: the side of its block in pixels, 1 if it was traced itself; 0 if its row failed, negative if it is blank}
     *
     * @param pixel a pixel of the picture
     */
    public int blockAt(Point pixel) {
        return progressive.blockAt(pixel.x, pixel.y);
    }

    /**
     * {@return the colour that a pixel is shown in, packed}
     *
     * @param pixel a pixel of the picture
     */
    public int levelsAt(Point pixel) {
        return image.getRGB(pixel.x, pixel.y);
    }

    /** {@return whether there is more to come} */
    public boolean isBusy() {
        return kicker.isRunning();
    }

    /** {@return the picture that is shown, if it is whole and of no film that plays; null if not} */
    public Picture whole() {
        return played == null ? whole : null;
    }

    /** {@return the image that is shown; pixels that were not painted are transparent, and so may others be} Not to be changed. */
    BufferedImage painted() {
        return image;
    }

    @Override
    public Dimension imageSize() {
        return new Dimension(image.getWidth(), image.getHeight());
    }
}
