package simpleray.ui.inspect;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.datatransfer.StringSelection;
import java.awt.event.InputEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.tree.DefaultMutableTreeNode;
import simpleray.image.Picture;
import simpleray.math.Ray;
import simpleray.rays.Projection;
import simpleray.rays.RaySegment;
import simpleray.rays.StoryText;
import simpleray.render.Explainer;
import simpleray.render.PixelStory;
import simpleray.scene.Camera;
import simpleray.scene.RayTree;
import simpleray.scene.Scene;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.SimpleRay;
import simpleray.ui.picture.ViewerContext;
import simpleray.ui.widget.KeyBindings;
import simpleray.ui.widget.Lazy;
import simpleray.ui.widget.SidePanes;

/**
 * Explains single pixels: the one under the mouse in the status bar, the one that was clicked or that the pixel cursor is on in a pane. It
 * traces them on a thread of its own. All methods are for the event thread.
 */
public final class Inspector {
    private static final int DIVIDER = 6;
    private static final int IDLE = 700;                      // milliseconds after the first picture that nothing else has happened
    private static final double MIDDLE = 0.5;
    private static final double RAYS_SHARE = 0.6;             // of the height, above the story
    /** How far the frame of the pixel cursor is from its pixel. */
    private static final int FRAME = 4;
    private static final int OTHER_KEYS = InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK | InputEvent.ALT_DOWN_MASK
        | InputEvent.META_DOWN_MASK;

    /** A story, of which scene, in which camera's picture. */
    private record Told(PixelStory pixel, Scene scene, Camera camera) {
    }

    private final SimpleRay picture;
    private final Consumer<String> hoverLine;
    private final Consumer<String> status;
    private IntConsumer pointed = number -> { };
    private final Lazy<StoryPane> pane;
    private final Lazy<RaysPane> rays;
    private final JCheckBoxMenuItem raysItem = new JCheckBoxMenuItem(KeyBindings.action("Rays", "V", this::toggleRays));
    private final Action storyAction = KeyBindings.action("Story of the Pixel", "I", this::openStory);
    private final JCheckBoxMenuItem vectors = new JCheckBoxMenuItem(
        KeyBindings.action("Normals and Halfway Vectors", "shift V", this::showVectors));
    private final JSplitPane panes = new JSplitPane(JSplitPane.VERTICAL_SPLIT);
    private final SidePanes sides;
    private final ExecutorService teller;

    private JComponent side;                                  // what is shown beside the picture; null for nothing
    private Timer idle = new Timer(IDLE, e -> rehearse());    // null once it has come
    private boolean storyWanted;                              // a story is shown, or is to be once it is told
    private boolean dragging;                                 // the pixel cursor, by the mouse
    private Boolean untold;                                   // a story was asked for: whether to have the keys; null once it is there
    private RenderJob shown;                                  // the one whose rows are on the screen
    private boolean ended;                                    // it had, when it was last looked at
    private Point hovered;
    private int block;                                        // of that pixel, when it was last told of
    private boolean asking;                                   // an answer about a pixel under the mouse is to come
    private Point cursor;
    private Dimension cursorIn;                               // the size of the picture in which it is there
    private Future<?> telling;
    private Told story;                                       // in the pane
    private List<StoryMark> marks = List.of();                // of the line that is chosen in it
    private RenderJob explained;                              // whose explainer that is; both for the teller's thread alone
    private Explainer explainer;

    /**
     * Creates an inspector.
     *
     * @param window the window
     * @param hoverLine gets a line about the pixel under the mouse; a blank if there is none
     * @param goTo shows a line of the scene's text
     */
    public Inspector(ViewerContext window, Consumer<String> hoverLine, IntConsumer goTo) {
        picture = window.picture();
        sides = window.sides();
        status = window::say;
        teller = window.workers().stopping("simpleray-inspector");
        this.hoverLine = hoverLine;
        pane = new Lazy<>(() -> new StoryPane(this::copy, this::closeStory, this::chooseRay, goTo));
        ExecutorService drawer = window.workers().stopping("simpleray-rays");
        rays = new Lazy<>(() -> {
            JCheckBox box = new JCheckBox("N, H");
            box.setModel(vectors.getModel());
            box.setToolTipText("Normals and Halfway Vectors (Shift+V)");
            box.getAccessibleContext().setAccessibleName("Normals and Halfway Vectors");
            RaysPane made = new RaysPane(drawer, status, box, this::selectLine, this::closeRays);
            made.setVectors(vectors.isSelected());
            return made;
        });
        idle.setRepeats(false);
        panes.setBorder(BorderFactory.createEmptyBorder());
        panes.setResizeWeight(RAYS_SHARE);
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                hover(picture.isPlayed() ? null : picture.pixelAt(e.getPoint()));
            }

            @Override
            public void mouseExited(MouseEvent e) {
                hover(null);
            }

            @Override
            public void mousePressed(MouseEvent e) {
                dragging = e.getButton() == MouseEvent.BUTTON1 && isGrip(e);
            }

            @Override
            public void mouseDragged(MouseEvent e) {
                if (dragging && isRaysOpen()) {
                    drag(e.getPoint());
                }
            }

            @Override
            public void mouseReleased(MouseEvent e) {
                dragging = false;
            }

            @Override
            public void mouseClicked(MouseEvent e) {
                Point pixel = picture.pixelAt(e.getPoint());
                if (pixel != null && e.getButton() == MouseEvent.BUTTON1 && (e.getModifiersEx() & OTHER_KEYS) == 0) {
                    explain(pixel);
                }
            }
        };
        picture.addMouseListener(mouse);
        picture.addMouseMotionListener(mouse);
        picture.setMark(this::paintCursor);
        picture.setGrip(this::isGrip);
        picture.setSpareBeside(this::spare);
        picture.setFocus(this::focus);
    }

    /**
     * {@return the room that a fitted picture leaves for the rays, or if it is too wide, for the story alone} None is left where something
     * is already.
     */
    private int spare(int width) {
        return sides.isOpen() ? 0 : width + sides.widest() <= sides.getWidth() ? sides.widest() : DIVIDER + StoryPane.WIDTH;
    }

    private Point2D focus() {
        return cursor == null ? new Point2D.Double(MIDDLE, MIDDLE)
            : new Point2D.Double((cursor.x + MIDDLE) / cursorIn.width, (cursor.y + MIDDLE) / cursorIn.height);
    }

    /**
     * Shows the story of a pixel.
     *
     * @param pixel the pixel
     */
    public void explain(Point pixel) {
        if (picture.isBlank()) {
            return;
        }
        picture.requestFocusInWindow();
        setCursor(pixel);
        storyWanted = true;
        sides.raise(side);
        tell(false);
    }

    /**
     * Shows the rays of a pixel.
     *
     * @param pixel the pixel
     */
    public void showRays(Point pixel) {
        setCursor(pixel);
        raysItem.setSelected(true);
        sides.raise(side);
        tell(false);
    }

    /**
     * Finds the object at a pixel.
     *
     * @param pixel the pixel
     * @param then gets the object; null for none
     */
    public void find(Point pixel, Consumer<RayTree.Thing> then) {
        RenderJob job = picture.job();
        teller.execute(() -> {
            try {
                RayTree.Thing thing = explainer(job).objectAt(pixel.x, pixel.y);
                SwingUtilities.invokeLater(() -> then.accept(thing));
            } catch (CancellationException e) {
                return;                                       // the next rendering has begun: the pixel may be of another thing by now
            }
        });
    }

    /**
     * Adds what a pixel is looked into by.
     *
     * @param menu the Inspect menu
     */
    public void addTo(JMenu menu) {
        menu.add(storyAction);
        menu.add(KeyBindings.action("Copy Story", "control shift I", this::copy));
        menu.add(KeyBindings.action("Close Story", "shift I", this::closeStory));
        menu.addSeparator();
        menu.add(KeyBindings.action("Next Ray", "PERIOD", () -> step(1)));
        menu.add(KeyBindings.action("Previous Ray", "COMMA", () -> step(-1)));
        menu.add(vectors);
        menu.addSeparator();
        menu.add(KeyBindings.action("Pixel Cursor Left", "alt LEFT", () -> move(-1, 0)));
        menu.add(KeyBindings.action("Pixel Cursor Right", "alt RIGHT", () -> move(1, 0)));
        menu.add(KeyBindings.action("Pixel Cursor Up", "alt UP", () -> move(0, -1)));
        menu.add(KeyBindings.action("Pixel Cursor Down", "alt DOWN", () -> move(0, 1)));
    }

    /** {@return the item that shows the rays of the pixel, or hides them} */
    public JMenuItem raysItem() {
        return raysItem;
    }

    /**
     * Enables the items that can be used now.
     *
     * @param there whether there is a picture, or one to come; if not, what was asked of it is dropped
     */
    public void refresh(boolean there) {
        storyAction.setEnabled(there);
        raysItem.setEnabled(there);
        if (!there && cursor != null) {
            untold = null;
            storyWanted = false;
            closeRays();
        }
    }

    /**
     * Takes notice of a rendering: it is the one that is told of as soon as a pixel of it is shown, or earlier if nothing is shown yet.
     *
     * @param job the rendering
     */
    public void update(RenderJob job) {
        boolean over = job.state().ended();
        if (idle != null && over) {
            idle.restart();
        } else if (idle != null) {
            idle.stop();
        }
        int now = hovered == null || !picture.has(hovered) ? 0 : picture.blockAt(hovered);
        if (job == shown && (over != ended || now != block)) {
            ended = over;
            if (hovered != null) {
                hover(hovered);                               // its colour was not known, or not the last one
            }
        }
        boolean told = picture.seen() == job || !(shown != null && shown.snapshot().canExplain()) && job.snapshot().canExplain();
        if (job == shown || !told) {
            return;
        }
        shown = job;
        ended = over;
        if (hovered != null) {
            hover(hovered);
        }
        if (cursor == null && isRaysOpen()) {                 // they were asked for before there was a picture
            setCursor(start());
        }
        if (cursor != null) {
            setCursor(inThisSize(cursor, job));
            if (isOpen() || untold != null || isRaysOpen()) {
                tell(untold != null && untold);
            }
        }
    }

    /** {@return the pixel that shows what a pixel of a picture of another size showed; if that is not known, where it was} */
    private Point inThisSize(Point pixel, RenderJob job) {
        Dimension size = picture.imageSize();
        if (size.equals(cursorIn)) {
            return pixel;
        }
        if (story != null && story.pixel.x() == pixel.x && story.pixel.y() == pixel.y && job.snapshot().settings() != null) {
            Ray ray = story.camera.through(pixel.x + MIDDLE, pixel.y + MIDDLE);
            double[] at = new Projection(job.snapshot().settings().newCamera()).of(ray.getPointAt(1));
            if (at != null && at[0] >= 0 && at[0] < size.width && at[1] >= 0 && at[1] < size.height) {
                return new Point((int) at[0], (int) at[1]);
            }
        }
        return new Point(scaled(pixel.x, cursorIn.width, size.width), scaled(pixel.y, cursorIn.height, size.height));
    }

    private static int scaled(int place, int before, int now) {
        return (int) ((2L * place + 1) * now / (2L * before));
    }

    /** Makes the pane of the rays before it is asked for: the first one takes long. */
    private void rehearse() {
        idle = null;
        if (picture.isShowing()) {
            rays.get().rehearse();
        }
    }

    /** Moves the pixel cursor. It begins under the mouse, or in the middle. */
    private void move(int dx, int dy) {
        if (shown != null) {
            Point from = start();
            setCursor(cursor == null ? from : new Point(from.x + dx, from.y + dy));
            showCursor();
            if (isOpen()) {
                tell(false);
            }
            tellLine(cursor);
        }
    }

    /** Opens the story of the pixel that the pixel cursor is on, for the keyboard. */
    private void openStory() {
        setCursor(start());
        storyWanted = true;
        sides.raise(side);
        tell(true);
    }

    /** Closes the story, and takes the pixel cursor away. */
    private void closeStory() {
        storyWanted = false;
        closePanes();
    }

    private void closeRays() {
        raysItem.setSelected(false);
        closePanes();
    }

    private void toggleRays() {
        if (!raysItem.isSelected() && sides.raise(side)) {
            raysItem.setSelected(true);
        } else if (!raysItem.isSelected()) {
            closePanes();
        } else if (shown != null) {
            sides.raise(side);
            setCursor(start());
            tell(false);
        }
    }

    /** Shows what is still wanted; without that, takes the pixel cursor away. */
    private void closePanes() {
        if (storyWanted || isRaysOpen()) {
            arrange(false);
        } else {
            cancelTelling();
            story = null;
            mark(null, null);
            cursor = null;
            side = null;
            sides.showPixel(null, 0);
        }
        picture.requestFocusInWindow();
    }

    private boolean isRaysOpen() {
        return raysItem.isSelected();
    }

    private void showVectors() {
        rays.ifMade(made -> made.setVectors(vectors.isSelected()));
    }

    private void step(int by) {
        if (isRaysOpen() && story != null) {
            rays.get().step(by);
        }
    }

    private void chooseRay(RayTree ray, RayTree.Lamp lamp) {
        mark(ray, lamp);
        if (isRaysOpen() && ray != null) {
            rays.get().choose(ray, lamp);
        }
    }

    /** Marks in the picture what a line of the story, or a ray, tells about: nothing for null. */
    private void mark(RayTree ray, RayTree.Lamp lamp) {
        marks = ray == null || story == null ? List.of() : StoryMark.of(ray, lamp, story.scene, story.camera);
        picture.repaint();
    }

    private void selectLine(RaySegment segment) {
        mark(segment.ray(), segment.lamp());
        if (storyWanted) {
            pane.get().select(segment.ray(), segment.lamp());
        }
    }

    /** {@return whether the mouse takes the pixel cursor along: it is on its frame, or Ctrl is down} */
    private boolean isGrip(MouseEvent e) {
        if (!isRaysOpen() || cursor == null || shown == null) {
            return false;
        }
        int keys = e.getModifiersEx() & OTHER_KEYS;
        Rectangle frame = place(cursor);
        frame.grow(2 * FRAME, 2 * FRAME);
        return keys == InputEvent.CTRL_DOWN_MASK || keys == 0 && frame.contains(e.getPoint());
    }

    private void drag(Point to) {
        Rectangle all = picture.place();
        Dimension size = picture.imageSize();
        Point pixel = new Point((int) Math.floorDiv((long) (to.x - all.x) * size.width, all.width),
            (int) Math.floorDiv((long) (to.y - all.y) * size.height, all.height));
        Point before = cursor;
        setCursor(pixel);
        if (!cursor.equals(before)) {
            tell(false);
            hovered = cursor;                                 // what is dragged is under the mouse
            tellLine(cursor);
        }
    }

    /** Puts the story on the clipboard, as text. */
    private void copy() {
        Told told = story;
        if (told != null) {
            teller.execute(() -> {
                String text = StoryText.of(told.pixel, told.scene, told.camera);
                SwingUtilities.invokeLater(() -> {
                    try {
                        picture.getToolkit().getSystemClipboard().setContents(new StringSelection(text), null);
                        status.accept("Copied the story of pixel " + told.pixel.x() + ", " + told.pixel.y());
                    } catch (IllegalStateException e) {
                        status.accept("The clipboard is in use by another program");
                    }
                });
            });
        }
    }

    private boolean isOpen() {
        return side != null;
    }

    private Point start() {
        Dimension size = picture.imageSize();
        return cursor != null ? cursor : hovered != null ? hovered : new Point(size.width / 2, size.height / 2);
    }

    private void setCursor(Point pixel) {
        Dimension size = picture.imageSize();
        if (cursor != null) {
            repaint(cursor);
        }
        cursor = new Point(Math.max(0, Math.min(size.width - 1, pixel.x)), Math.max(0, Math.min(size.height - 1, pixel.y)));
        cursorIn = size;
        repaint(cursor);
    }

    private void repaint(Point pixel) {
        Rectangle place = place(pixel);
        place.grow(FRAME + 2, FRAME + 2);
        picture.repaint(place);
    }

    /** {@return where a pixel is in the component} */
    private Rectangle place(Point pixel) {
        Rectangle all = picture.place();
        Dimension size = picture.imageSize();
        int left = (int) ((long) pixel.x * all.width / size.width);
        int top = (int) ((long) pixel.y * all.height / size.height);
        int right = (int) ((pixel.x + 1L) * all.width / size.width);
        int bottom = (int) ((pixel.y + 1L) * all.height / size.height);
        return new Rectangle(all.x + left, all.y + top, Math.max(1, right - left), Math.max(1, bottom - top));
    }

    private void paintCursor(Graphics2D canvas) {
        if (cursor != null) {
            Rectangle frame = place(cursor);
            frame.grow(FRAME - 1, FRAME - 1);
            canvas.setColor(Color.WHITE);
            canvas.drawRect(frame.x, frame.y, frame.width - 1, frame.height - 1);
            frame.grow(1, 1);
            canvas.setColor(Color.BLACK);
            canvas.drawRect(frame.x, frame.y, frame.width - 1, frame.height - 1);
            Rectangle all = picture.place();
            Dimension size = picture.imageSize();
            marks.forEach(mark -> mark.paint(canvas, all.x + mark.x() * all.width / size.width,
                all.y + mark.y() * all.height / size.height));
        }
    }

    /**
     * Sets a listener for the object under the mouse.
     *
     * @param other gets the object's number, from 1; 0 if there is none
     */
    public void setPointed(IntConsumer other) {
        pointed = other;
    }

    private void hover(Point pixel) {
        hovered = pixel;
        if (pixel == null || shown == null) {
            pointed.accept(0);
            hoverLine.accept(" ");
        } else {
            tellLine(pixel);
        }
    }

    /** Tells colours at once, and which object it is as soon as that is known. */
    @SuppressWarnings("FutureReturnValueIgnored")             // the task itself catches all
    private void tellLine(Point pixel) {
        block = picture.has(pixel) ? picture.blockAt(pixel) : 0;
        String colours = PixelLine.colours(shown.snapshot().picture(), pixel, picture);
        hoverLine.accept(colours == null ? " " : colours);
        if (colours == null || asking) {                      // the answer that is to come asks again if the mouse has moved
            return;
        }
        asking = true;
        RenderJob job = shown;
        teller.submit(() -> {
            try {
                RayTree.Thing thing = explainer(job).objectAt(pixel.x, pixel.y);
                SwingUtilities.invokeLater(() -> answer(pixel, job, thing));
            } catch (RuntimeException | Error e) {            // the line stays without the object
                SwingUtilities.invokeLater(() -> asking = false);
            }
        });
    }

    private void answer(Point pixel, RenderJob job, RayTree.Thing thing) {
        asking = false;
        Point wanted = hovered != null ? hovered : cursor;
        if (job != shown || !pixel.equals(wanted)) {
            if (wanted != null) {
                tellLine(wanted);
            }
        } else {
            Picture light = shown.snapshot().picture();
            String colours = PixelLine.colours(light, pixel, picture);
            String nothing = light != null && light.hasAlpha() ? "no object" : "background";
            pointed.accept(hovered == null || thing == null ? 0 : thing.number());
            hoverLine.accept(colours == null ? " " : colours + "   " + (thing == null ? nothing : StoryText.object(thing)));
        }
    }

    /** Tells the story of the pixel that the cursor is on. */
    private void tell(boolean focus) {
        cancelTelling();
        untold = focus;
        if (shown == null) {
            return;                                           // it is told as soon as there is a scene
        }
        RenderJob job = shown;
        Point pixel = cursor;
        boolean wantsStory = storyWanted;
        boolean wantsRays = isRaysOpen();
        telling = teller.submit(() -> {
            Told told;
            DefaultMutableTreeNode root;
            RaysView.Rays drawn;
            try {
                PixelStory made = explainer(job).story(pixel.x, pixel.y, wantsRays);     // rays go to the points of area lights
                RenderJob.Snapshot now = job.snapshot();
                told = new Told(made, now.scene(), now.settings().newCamera());
                root = wantsStory ? StoryTree.tree(StoryText.outline(made, told.scene, told.camera)) : null;
                drawn = wantsRays ? new RaysView.Rays(told.scene, told.camera, pixel.x, pixel.y, RaySegment.of(made, told.scene)) : null;
            } catch (CancellationException e) {
                return;
            } catch (RuntimeException | Error e) {
                SwingUtilities.invokeLater(() -> status.accept("The story of this pixel cannot be told: " + e));
                return;
            }
            SwingUtilities.invokeLater(() -> show(told, root, drawn, job, focus));
        });
    }

    private void show(Told told, DefaultMutableTreeNode root, RaysView.Rays drawn, RenderJob job, boolean focus) {
        if (cursor == null || job != shown || told.pixel.x() != cursor.x || told.pixel.y() != cursor.y) {
            return;                                           // closed or moved on
        }
        story = told;
        mark(null, null);
        untold = null;
        arrange(!focus);
        if (root != null && storyWanted) {
            pane.get().show("Pixel " + cursor.x + ", " + cursor.y, root, focus);
        }
        if (drawn != null && isRaysOpen()) {
            rays.get().show(drawn);
        }
    }

    /** Puts the rays above the story, or that beside the picture which is wanted alone; what was clicked stays under the mouse. */
    private void arrange(boolean clicked) {
        JComponent above = isRaysOpen() ? rays.get() : null;
        JComponent below = storyWanted ? pane.get() : null;
        JComponent right = above != null && below != null ? panes : above != null ? above : below;
        if (side == right && (right != panes || panes.getTopComponent() == above)) {
            return;
        }
        side = right;
        for (JComponent part : new JComponent[] {above, below}) {
            if (part != null && !part.isShowing()) {
                SwingUtilities.updateComponentTreeUI(part);   // the look may have changed while it was in no window
            }
        }
        panes.updateUI();
        panes.setTopComponent(right == panes ? above : null);
        panes.setBottomComponent(right == panes ? below : null);
        int pixel = SwingUtilities.convertRectangle(picture, place(cursor), sides).x + DIVIDER * FRAME;
        if (clicked && above == null) {
            picture.keep(() -> sides.showPixel(right, pixel), false);
        } else {
            sides.showPixel(right, above == null ? pixel : 0);   // beside the rays, all of the picture is seen
        }
        if (right == panes) {
            panes.setDividerLocation(RAYS_SHARE);
            panes.validate();
        }
        showCursor();
    }

    private void showCursor() {
        Rectangle place = place(cursor);
        place.grow(FRAME, FRAME);
        picture.scrollRectToVisible(place);
    }

    private void cancelTelling() {
        untold = null;
        if (telling != null) {
            telling.cancel(true);
        }
    }

    private Explainer explainer(RenderJob job) {
        if (explained != job) {
            Explainer made = job.snapshot().explainer();
            if (made == null) {
                throw new CancellationException("the next rendering has begun");
            }
            explainer = made;
            explained = job;
        }
        return explainer;
    }
}
