package simpleray.ui.picture;

import java.awt.Cursor;
import java.awt.Point;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.function.UnaryOperator;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import simpleray.render.RenderRequest;
import simpleray.scene.FreeView;
import simpleray.scene.Orbit;
import simpleray.scene.SceneSettings;
import simpleray.ui.file.SceneSource;

/**
 * Moves the camera by mouse: the left button orbits round the pivot, the middle one, or Space and the left one, pans, the wheel
 * dollies, or zooms if rays are parallel. For the event thread.
 *
 * <p>Until it is moved, the camera is the scene's own, or the one asked for; then the free camera that shows the same takes its place
 * ({@link FreeView}). Each move is asked for at once; {@link SimpleRay#restart} takes as many as can be seen, and the last one in any case.
 */
final class CameraTool extends MouseAdapter {
    /** Fewer pixels of movement are a click. */
    private static final int DRAG = 4;
    /** Degrees for a pixel of a drag. */
    private static final double TURN = 0.5;
    /** The share of the distance to the pivot, or of the height of parallel rays, that a notch of the wheel leaves. */
    private static final double NOTCH = 0.9;

    private final SimpleRay picture;
    private Orbit orbit;                                      // null while the camera was not moved
    private SceneSettings home;                               // the settings asked for before it was moved; null likewise
    private boolean aimed;                                    // the pivot is the point in the middle of the picture
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

    /** Goes round the pivot, to the right and up. */
    void turn(double degreesRight, double degreesUp) {
        move(o -> o.turned(degreesRight, degreesUp));
    }

    /** Goes sideways; 1 is the height of the picture. */
    void pan(double right, double up) {
        move(o -> o.panned(right, up));
        aimed = false;                                        // the middle shows something else now
    }

    /** Goes nearer by a number of notches of the wheel; negative for farther. */
    void dolly(double notches) {
        move(o -> o.dollied(Math.pow(NOTCH, notches)));
    }

    /** Goes back to the scene's own camera. */
    void reset() {
        if (forget()) {
            picture.restart();
        }
    }

    /**
     * Forgets the moves: another scene comes, or they led to the scene's own camera.
     *
     * @return whether there were any
     */
    boolean forget() {
        boolean moved = home != null;
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
        if (!aimed && now != null) {
            orbit = orbit.aimed(now.scene());
            aimed = true;
        }
        orbit = how.apply(orbit);
        if (home == null) {
            home = picture.request().settings();
        }
        picture.setRequest(with(orbit.settings()));
        picture.restart();
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
        dragging = true;
        int right = now.x - last.x;
        int down = now.y - last.y;
        if (panning) {
            double height = picture.placed().height() / picture.ui();
            pan(-right / height, down / height);
        } else {
            turn(-right * TURN, down * TURN);
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
        if (e.getModifiersEx() == 0) {
            dolly(-e.getPreciseWheelRotation());
        } else if (e.isShiftDown() && !e.isControlDown()) {   // the picture takes the wheel, and a large one is to be scrolled still
            JScrollPane pane = (JScrollPane) SwingUtilities.getAncestorOfClass(JScrollPane.class, picture);
            pane.dispatchEvent(SwingUtilities.convertMouseEvent(picture, e, pane));
        }
    }
}
