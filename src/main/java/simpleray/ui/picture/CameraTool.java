package simpleray.ui.picture;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import simpleray.render.RenderRequest;
import simpleray.scene.FreeView;
import simpleray.scene.Orbit;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.ui.file.SceneSource;

/**
 * Moves the camera by mouse: the left button orbits round the pivot, the middle one, or Space and the left one, pans, the wheel
 * dollies to what is under it, or zooms if rays are parallel. The eye stops before a surface and slides along it. Steps can be undone: a drag
 * is one. For the event thread.
 *
 * <p>Until it is moved, the camera is the scene's own, or the one asked for; then the free camera that shows the same takes its place
 * ({@link FreeView}). Each move is asked for at once; {@link SimpleRay#restart} takes as many as can be seen, and the last one in any case.
 */
final class CameraTool extends MouseAdapter {
    /** Fewer pixels of movement are a click. */
    private static final int DRAG = 4;
    /** Degrees for a drag across all that is shown of the picture. */
    private static final double TURN = 180;
    /** Nanoseconds between two notches of the wheel that are one step. */
    private static final long PAUSE = 500_000_000;
    /** The share of the distance to the pivot, or of the height of parallel rays, that a notch of the wheel leaves. */
    private static final double NOTCH = 0.9;

    private final SimpleRay picture;
    private Orbit orbit;                                      // null while the camera was not moved
    private SceneSettings home;                               // the settings asked for before it was moved; null likewise
    private boolean aimed;                                    // the pivot is the point in the middle of the picture
    private Scene scene;                            // the last that was read; what stops the eye
    private final Deque<Optional<Orbit>> undone = new ArrayDeque<>();
    private final Deque<Optional<Orbit>> done = new ArrayDeque<>();   // where the camera was before each step; empty for the scene's own
    private boolean fresh;                                    // the next move begins a step
    private long wheeled;                                     // when the wheel was last turned
    private Runnable listener = () -> { };
    private Point last;                                       // of the mouse while a button is down; null for a button of others
    private boolean dragging;
    private boolean panning;
    private boolean space;

    CameraTool(SimpleRay picture) {
        this.picture = picture;
        picture.addMouseListener(this);
        picture.addMouseMotionListener(this);
        picture.addMouseWheelListener(this);
        picture.addKeyListener(new KeyAdapter() {
            @Override
            public void keyPressed(KeyEvent e) {
                if (e.getKeyCode() == KeyEvent.VK_SPACE) {
                    if (space) {
                        e.consume();                          // held down, it repeats itself: once is enough for other listeners
                    }
                    space = true;
                }
            }

            @Override
            public void keyReleased(KeyEvent e) {
                space = space && e.getKeyCode() != KeyEvent.VK_SPACE;
            }
        });
        picture.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent e) {
                space = false;                                // its release goes to another component
            }
        });
    }

    /** Sets what is told when the camera is moved, or is the scene's own again. */
    void setListener(Runnable other) {
        listener = other;
    }

    /** {@return whether the camera was moved} */
    boolean isMoved() {
        return home != null;
    }

    /** {@return whether a drag was begun, or another move made, in this window} */
    boolean isKnown() {
        return !done.isEmpty() || !undone.isEmpty();
    }

    /** Goes round the pivot, to the right and up. */
    void turn(double degreesRight, double degreesUp) {
        fresh = true;
        move(o -> o.turned(degreesRight, degreesUp));
    }

    /** Goes sideways; 1 is the height of the picture. */
    void pan(double right, double up) {
        fresh = true;
        slide(right, up);
    }

    private void slide(double right, double up) {
        move(o -> o.panned(right, up));
        aimed = false;                                        // the middle shows something else now
    }

    /** Goes nearer by a number of notches of the wheel; negative for farther. */
    void dolly(double notches) {
        fresh = true;
        move(o -> o.dollied(Math.pow(NOTCH, notches)));
    }

    /** Goes nearer to what is at a point of the component, or away from it. */
    private void dolly(double notches, Point to) {
        long now = System.nanoTime();
        fresh |= done.isEmpty() || now - wheeled > PAUSE;
        wheeled = now;
        Zoom.Place place = picture.placed();
        Dimension size = picture.imageSize();
        double x = (to.x * picture.ui() - place.x()) / place.scale();
        double y = (to.y * picture.ui() - place.y()) / place.scale();
        double factor = Math.pow(NOTCH, notches);
        boolean inside = x >= 0 && y >= 0 && x < size.width && y < size.height;
        move(o -> inside && scene != null ? o.dollied(factor, o.seenAt(scene, size.width, size.height, x, y)) : o.dollied(factor));
        aimed = false;
    }

    /** Looks at what a pixel shows, or that way if it is no object. */
    void lookAt(Point pixel) {
        fresh = true;
        Dimension size = picture.imageSize();
        move(o -> scene == null ? o : o.lookingAt(o.seenAt(scene, size.width, size.height, pixel.x + 0.5, pixel.y + 0.5)));
        aimed = true;
    }

    /** Goes back to the scene's own camera. */
    void reset() {
        if (isMoved()) {
            step(done, undone);
            go(Optional.empty());
        }
    }

    /** Takes the last step back. */
    void undo() {
        if (!done.isEmpty()) {
            undone.push(Optional.ofNullable(isMoved() ? orbit : null));
            go(done.pop());
        }
    }

    /** Takes the step again that was taken back last. */
    void redo() {
        if (!undone.isEmpty()) {
            done.push(Optional.ofNullable(isMoved() ? orbit : null));
            go(undone.pop());
        }
    }

    private void step(Deque<Optional<Orbit>> on, Deque<Optional<Orbit>> off) {
        on.push(Optional.ofNullable(isMoved() ? orbit : null));
        off.clear();
    }

    private void go(Optional<Orbit> to) {
        aimed = false;
        if (to.isEmpty()) {
            drop();
        } else {
            show(to.get());
        }
        picture.showOrRestart();
        listener.run();
    }

    /**
     * Forgets the moves: another scene comes, or they led to the scene's own camera.
     *
     * @return whether there were any
     */
    boolean forget() {
        done.clear();
        undone.clear();
        scene = null;
        boolean moved = drop();
        listener.run();
        return moved;
    }

    private boolean drop() {
        boolean moved = isMoved();
        if (moved) {
            picture.setRequest(with(home));
        }
        orbit = null;
        home = null;
        return moved;
    }

    /** Takes the camera that is shown for the scene's own: it was written into the scene's file. */
    void adopt() {
        release();
        picture.start();                                      // the scene as it was read has its old camera
    }

    /** Asks for no camera but the scene's own, from the next start on. */
    void release() {
        forget();
        picture.setRequest(with(new SceneSettings()));
    }

    /** {@return whether the camera is another than the one in the scene's file} */
    boolean isOther() {
        return home != null || picture.request().settings().hasCamera();
    }

    /** {@return settings that say where the camera is; null while no scene is read} */
    SceneSettings view() {
        if (orbit == null) {
            RenderJob.Snapshot now = shown();
            return now == null ? null : now.settings();
        }
        return orbit.settings();
    }

    /** {@return how far the rendering is, if it has read a scene; else null} */
    private RenderJob.Snapshot shown() {
        RenderJob.Snapshot now = picture.job() == null ? null : picture.job().snapshot();
        return now == null || picture.source() == SceneSource.NONE || now.settings() == null ? null : now;
    }

    private void move(UnaryOperator<Orbit> how) {
        RenderJob.Snapshot now = shown();
        if (orbit == null) {
            if (now == null) {
                return;
            }
            orbit = Orbit.of(FreeView.alone(now.settings()));
            aimed = now.settings().isFree();                  // such a camera says itself what it looks at
        }
        scene = now == null ? scene : now.scene();
        if (!aimed && scene != null) {
            orbit = orbit.aimed(scene);
            aimed = true;
        }
        if (fresh) {
            step(done, undone);
            fresh = false;
        }
        Orbit moved = how.apply(orbit);
        show(scene == null ? moved : moved.stopped(orbit, scene));
        picture.restart();
        listener.run();
    }

    private void show(Orbit other) {
        orbit = other;
        if (home == null) {
            home = picture.request().settings();
        }
        picture.setRequest(with(orbit.settings()));
    }

    /** {@return the request with the camera of other settings} */
    private RenderRequest with(SceneSettings camera) {
        SceneSettings all = new SceneSettings().under(picture.request().settings());
        all.setCamera(camera);
        return picture.request().with(all);
    }

    @Override
    public void mousePressed(MouseEvent e) {
        picture.requestFocusInWindow();
        int others = InputEvent.SHIFT_DOWN_MASK | InputEvent.CTRL_DOWN_MASK | InputEvent.ALT_DOWN_MASK | InputEvent.META_DOWN_MASK;
        boolean left = SwingUtilities.isLeftMouseButton(e) && (e.getModifiersEx() & others) == 0 && !picture.isGrip(e);
        boolean middle = SwingUtilities.isMiddleMouseButton(e);
        last = left || middle ? e.getLocationOnScreen() : null;
        panning = middle || space;
        dragging = false;
    }

    /** Measures on the screen: the picture may scroll or change its size under the mouse. */
    @Override
    public void mouseDragged(MouseEvent e) {
        Point now = e.getLocationOnScreen();
        if (last == null || !dragging && now.distance(last) < DRAG) {
            return;
        }
        fresh |= !dragging;
        dragging = true;
        int right = now.x - last.x;
        int down = now.y - last.y;
        if (panning) {
            double height = picture.placed().height() / picture.ui();
            slide(-right / height, down / height);
        } else {
            double degrees = TURN / Math.max(1, picture.place().intersection(picture.getVisibleRect()).width);
            move(o -> o.turned(-right * degrees, down * degrees));
        }
        last = now;
        picture.setCursor(Cursor.getPredefinedCursor(panning ? Cursor.HAND_CURSOR : Cursor.MOVE_CURSOR));
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        last = null;
        dragging = false;
        picture.setCursor(null);
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        boolean plain = e.getModifiersEx() == 0;
        if (plain && picture.wheelZooms()) {
            return;                                           // it is the zoom's
        }
        if (plain && !picture.overflows()) {
            dolly(-e.getPreciseWheelRotation(), e.getPoint());
        } else if (plain || e.isShiftDown() && !e.isControlDown()) { // a large picture is scrolled still
            JScrollPane pane = (JScrollPane) SwingUtilities.getAncestorOfClass(JScrollPane.class, picture);
            pane.dispatchEvent(SwingUtilities.convertMouseEvent(picture, e, pane));
        }
    }
}
