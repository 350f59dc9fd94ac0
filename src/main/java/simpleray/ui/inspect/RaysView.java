package simpleray.ui.inspect;

import java.awt.Color;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import simpleray.rays.OutsideScene;
import simpleray.rays.OutsideView;
import simpleray.rays.RayDrawing;
import simpleray.rays.RaySegment;
import simpleray.rays.RaySegment.Kind;
import simpleray.render.PixelStory;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.scene.Camera;
import simpleray.scene.Orbit;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Scene;
import simpleray.ui.file.Samples;
import simpleray.ui.widget.DrawnComponent;
import simpleray.ui.widget.KeyBindings;

/**
 * The rays of a pixel in the scene, seen by an eye outside that the mouse moves. All is drawn on a thread of its own: coarse while the eye
 * moves, fine once it rests. For the event thread.
 */
final class RaysView extends DrawnComponent {
    private static final long serialVersionUID = 1L;
    private static final double TURN = 0.5;                   // degrees for a pixel of a drag
    private static final double STEP = 5;                     // degrees for a key
    private static final double NOTCH = 0.9;                  // the share of the distance that a notch of the wheel leaves
    private static final double COARSE = 1 / 3.0;
    private static final double DENSE = 1.5;                  // from this scale on a pixel has one sample
    private static final int REST = 120;                      // milliseconds after which a view becomes fine
    private static final int REACH = 6;                       // how near to a ray a click is on it
    private static final Dimension REHEARSED = new Dimension(600, 400);
    private static final int DRAG = 4;                        // fewer pixels of movement are a click

    /** What is told of a pixel: its rays, in which scene, from which camera. */
    record Rays(Scene scene, Camera camera, int x, int y, List<RaySegment> segments) {
    }

    /** What a view depends on. */
    private record Place(Scene scene, simpleray.math.Point inside, Pose pose, Dimension size, double scale) {
    }

    /** What is to be drawn. */
    private record Order(Place place, Rays rays, Set<Kind> kinds, int count, RaySegment selected, boolean fine) {
    }

    private final transient ExecutorService drawer;
    private final transient Consumer<String> status;
    private final transient Consumer<RaySegment> chosen;
    private final transient AtomicReference<Order> next = new AtomicReference<>();
    private final transient Timer rest = new Timer(REST, e -> draw(true));

    private transient Rays rays;                              // null until there are some
    private transient List<RaySegment> shown = List.of();     // those of the kinds that are drawn
    private transient Orbit orbit;                            // null for the place from which all rays can be seen
    private transient Set<Kind> kinds = RayDrawing.RAYS;
    private int count;                                        // of the segments that are drawn
    private transient RaySegment selected;                    // null for none
    private transient BufferedImage image;                    // null until something is drawn
    private transient RayDrawing drawing;                     // what is in the image
    private transient Future<?> drawingFine;                  // null if nothing fine is drawn now

    // of the drawer's thread alone
    private transient OutsideScene outside;
    private transient Scene outsideOf;
    private transient OutsideView view;
    private transient Place viewFrom;
    private boolean viewFine;

    /** Draws on a thread, and tells which ray was clicked on. */
    RaysView(ExecutorService drawer, Consumer<String> status, Consumer<RaySegment> chosen) {
        super("Rays of the pixel");
        this.drawer = drawer;
        this.status = status;
        this.chosen = chosen;
        setName("rays");
        setFocusable(true);
        rest.setRepeats(false);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                draw(false);
            }
        });
        Mouse mouse = new Mouse();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        bind("LEFT", () -> move(o -> o.turned(-STEP, 0)));
        bind("RIGHT", () -> move(o -> o.turned(STEP, 0)));
        bind("UP", () -> move(o -> o.turned(0, STEP)));
        bind("DOWN", () -> move(o -> o.turned(0, -STEP)));
        bind("PAGE_UP", () -> move(o -> o.dollied(NOTCH)));
        bind("PAGE_DOWN", () -> move(o -> o.dollied(1 / NOTCH)));
        bind("HOME", () -> {
            orbit = null;
            draw(false);
        });
    }

    private void bind(String key, Runnable task) {
        KeyBindings.bind(this, WHEN_FOCUSED, key, task);
    }

    /** Shows the rays of a pixel, all of them. Another scene is seen from its own place. */
    void show(Rays other) {
        if (rays != null && rays.scene != other.scene) {
            orbit = null;
        }
        rays = other;
        filter();
    }

    /** Draws normals and halfway vectors, too, or not. */
    void setVectors(boolean drawn) {
        kinds = drawn ? EnumSet.allOf(Kind.class) : RayDrawing.RAYS;
        if (rays != null) {
            filter();
        }
    }

    private void filter() {
        shown = rays.segments.stream().filter(segment -> kinds.contains(segment.kind())).toList();
        select(shown.size(), null);
    }

    /** {@return the segments that can be shown, in the order of the recursion} */
    List<RaySegment> segments() {
        return shown;
    }

    /** Shows the first segments only, one of them thicker; null for none. */
    void select(int first, RaySegment one) {
        count = first;
        selected = one;
        draw(false);
    }

    /** {@return where the eye is; null before there are rays} */
    Pose pose() {
        return rays == null ? null : orbit != null ? orbit.pose()
            : OutsideView.pose(rays.segments, rays.camera, Math.max(1, getWidth()), Math.max(1, getHeight()));
    }

    /** {@return what is on the screen; null before anything is} */
    RayDrawing drawing() {
        return drawing;
    }

    private void move(UnaryOperator<Orbit> how) {
        if (rays != null) {
            orbit = how.apply(orbit == null ? Orbit.of(pose()) : orbit);
            draw(false);
        }
    }

    /** Has the latest state drawn; one that waits is not drawn any more, nor is a fine one that is not ready. */
    private void draw(boolean fine) {
        if (rays == null || getWidth() == 0 || getHeight() == 0 || !isShowing()) {
            return;
        }
        Place place = new Place(rays.scene, rays.segments.get(0).from(), pose(), getSize(), ui());
        next.set(new Order(place, rays, kinds, count, selected, fine));
        if (drawingFine != null) {
            drawingFine.cancel(true);
            drawingFine = null;
        }
        Future<?> task = drawer.submit(this::work);
        if (fine) {
            drawingFine = task;
        } else {
            rest.restart();
        }
    }

    /** Draws what was ordered last. */
    private void work() {
        Order order = next.getAndSet(null);
        if (order == null) {
            return;
        }
        try {
            BufferedImage made = draw(order);
            RayDrawing drawn = paint(order, made);
            SwingUtilities.invokeLater(() -> {
                image = made;
                drawing = drawn;
                repaint();
            });
        } catch (CancellationException e) {                   // something newer comes
        } catch (OutOfMemoryError e) {
            view = null;
            SwingUtilities.invokeLater(() -> status.accept("The memory is too short to draw the rays"));
        } catch (RuntimeException | Error e) {
            SwingUtilities.invokeLater(() -> status.accept("The rays cannot be drawn: " + e));
        }
    }

    private RayDrawing paint(Order order, BufferedImage made) {
        RayDrawing drawn = new RayDrawing(view, order.rays.camera, order.rays.segments, order.kinds);
        Graphics2D g = made.createGraphics();
        g.transform(AffineTransform.getScaleInstance(order.place.scale, order.place.scale));
        drawn.paint(g, order.rays.x, order.rays.y, order.count, order.selected);
        g.dispose();
        return drawn;
    }

    /** Draws rays of another scene that nobody sees: the first drawing of a process is slow, since classes are loaded for it. */
    void rehearse() {
        drawer.execute(() -> {
            try {
                Scene scene = Samples.template().read().scene();
                Camera camera = scene.settings.newCamera();
                PixelStory story = new Renderer(scene, camera, new RenderSettings()).explainer()
                    .story(camera.width() / 2, camera.height() / 2, true);
                List<RaySegment> all = RaySegment.of(story, scene);
                Place place = new Place(scene, all.get(0).from(),
                    OutsideView.pose(all, camera, REHEARSED.width, REHEARSED.height), REHEARSED, 1);
                Rays drawn = new Rays(scene, camera, story.x(), story.y(), all);
                Order order = new Order(place, drawn, RayDrawing.RAYS, all.size(), null, false);
                paint(order, draw(order));
            } catch (IOException | RuntimeException | OutOfMemoryError e) {
                view = null;                                  // then the first one is slow
            }
        });
    }

    /** {@return an empty image for an order, whose view is ready} */
    private BufferedImage draw(Order order) {
        Place place = order.place;
        if (!place.equals(viewFrom) || view == null || order.fine && !viewFine) {
            if (outsideOf != place.scene) {
                outside = new OutsideScene(place.scene);
                outsideOf = place.scene;
            }
            view = outside.view(place.inside, place.pose, place.size.width, place.size.height, order.fine ? place.scale : COARSE,
                order.fine ? Stage.FINAL : Stage.LIGHTING, order.fine && place.scale < DENSE ? 2 : 1);
            viewFrom = place;
            viewFine = order.fine;
        }
        return new BufferedImage((int) Math.ceil(place.size.width * place.scale), (int) Math.ceil(place.size.height * place.scale),
            BufferedImage.TYPE_INT_RGB);
    }

    @Override
    protected void paintComponent(Graphics g) {
        if (image == null) {
            g.setColor(Color.DARK_GRAY);
            g.fillRect(0, 0, getWidth(), getHeight());
            return;
        }
        Graphics2D canvas = (Graphics2D) g.create();
        canvas.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        canvas.drawImage(image, 0, 0, getWidth(), getHeight(), null);
        canvas.dispose();
    }

    /** Orbits, pans, dollies, and chooses rays. */
    private final class Mouse extends MouseAdapter {
        private Point last;                                   // null while no button is down
        private boolean dragging;

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            last = e.getPoint();
            dragging = false;
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            Point now = e.getPoint();
            if (last == null || !dragging && now.distance(last) < DRAG) {
                return;
            }
            dragging = true;
            double right = now.x - last.x;
            double down = now.y - last.y;
            double height = getHeight();
            boolean turning = SwingUtilities.isLeftMouseButton(e);
            move(o -> turning ? o.turned(-right * TURN, down * TURN) : o.panned(-right / height, down / height));
            last = now;
            setCursor(Cursor.getPredefinedCursor(turning ? Cursor.MOVE_CURSOR : Cursor.HAND_CURSOR));
        }

        @Override
        public void mouseReleased(MouseEvent e) {
            if (last != null && !dragging && SwingUtilities.isLeftMouseButton(e) && drawing != null) {
                RaySegment hit = drawing.at(e.getX(), e.getY(), REACH);
                if (hit != null) {
                    chosen.accept(hit);
                }
            }
            last = null;
            setCursor(null);
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            move(o -> o.dollied(Math.pow(NOTCH, -e.getPreciseWheelRotation())));
        }
    }
}
