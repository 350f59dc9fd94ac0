package simpleray.ui;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import javax.swing.Scrollable;
import javax.swing.SwingConstants;
import javax.swing.Timer;
import simpleray.image.Picture;
import simpleray.render.RenderRequest;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.SimpleCamera;

/**
 * The framework for the ray tracing (thesis, chapter 5), a Swing component in place of the applet: it renders on a thread of its own,
 * and a timer, the thesis's "kicker", repaints what has been finished, so that the user is kept aware of how far it is. All methods
 * are for the event thread.
 */
public final class SimpleRay extends JComponent implements Runnable, Scrollable {
    private static final long serialVersionUID = 1L;
    private static final int KICK = 40;                       // milliseconds between two looks for finished rows
    private static final long MOST_WORK = 8_000_000;          // nanoseconds that one look may take
    private static final int LINE = 16;
    private static final Color SURROUND = new Color(0x3C3F41);

    private final transient Timer kicker = new Timer(KICK, e -> run());
    private transient SceneSource source;
    private transient RenderRequest request;
    private transient BufferedImage image;                    // touched by the event thread alone
    private transient Rendering rendering;
    private transient Picture whole;                          // the picture that is shown, once all its rows are
    private transient boolean shown;                                // a row of this rendering is in the image
    private transient boolean fitted;
    private transient Runnable listener = () -> { };

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
        init();
    }

    /** Makes an empty picture, of the size that was asked for until the scene's file says another. */
    public void init() {
        Resolution asked = request.settings().resolution;
        empty(asked == null ? new Resolution(SimpleCamera.DEFAULT_RESOLUTION, SimpleCamera.DEFAULT_RESOLUTION) : asked);
    }

    private void empty(Resolution size) {
        boolean same = image != null && image.getWidth() == size.width() && image.getHeight() == size.height();
        image = new BufferedImage(size.width(), size.height(), BufferedImage.TYPE_INT_ARGB);
        whole = null;
        if (!same) {
            revalidate();
        }
        repaint();
    }

    /** Starts to render anew; what is still being rendered is cancelled. The picture before it stays until a first row is finished. */
    public void start() {
        stop();
        shown = false;
        rendering = new Rendering(source, request);
        rendering.start();
        kicker.start();
        listener.run();
    }

    /** Cancels what is being rendered. Its threads end soon; this does not wait for them. */
    public void stop() {
        if (rendering != null) {
            rendering.cancel();
        }
    }

    /** Called by the "kicker": shows the rows that were finished since, for a short time at most, and tells the listener. */
    @Override
    public void run() {
        boolean ended = rendering.state().ended();            // asked first: then no row comes after the last one seen
        long begin = System.nanoTime();
        Rectangle changed = new Rectangle(0, 0, -1, -1);      // none: an empty one at 0, 0 would stay part of any sum
        while (System.nanoTime() - begin < MOST_WORK) {
            Rendering.Row row = rendering.poll();
            if (row == null) {
                break;
            }
            if (!shown) {                                     // no row of the picture before may pass for one of this
                Picture picture = rendering.picture();
                empty(new Resolution(picture.width(), picture.height()));
                shown = true;
            }
            image.setRGB(0, row.y(), image.getWidth(), 1, row.rgb(), 0, image.getWidth());
            changed.add(new Rectangle(0, row.y(), image.getWidth(), 1));
        }
        if (!changed.isEmpty()) {
            Rectangle place = place();
            double scale = place.getWidth() / image.getWidth();
            int top = place.y + (int) Math.floor(changed.y * scale) - 1;
            repaint(0, top, getWidth(), (int) Math.ceil(changed.height * scale) + 2);
        }
        if (ended && !rendering.hasRows()) {
            kicker.stop();
            if (rendering.state() == Rendering.State.FINISHED) {
                whole = rendering.picture();
            }
        }
        listener.run();
    }

    /**
     * Paints the screen.
     *
     * @param g what to paint with
     */
    @Override
    public void paint(Graphics g) {
        Graphics2D canvas = (Graphics2D) g.create();
        canvas.setColor(SURROUND);
        canvas.fillRect(0, 0, getWidth(), getHeight());
        Rectangle place = place();
        if (image != null && !place.isEmpty()) {
            boolean shrunk = place.width < image.getWidth();
            canvas.setRenderingHint(RenderingHints.KEY_INTERPOLATION,
                shrunk ? RenderingHints.VALUE_INTERPOLATION_BILINEAR : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
            canvas.drawImage(image, place.x, place.y, place.width, place.height, null);
        }
        canvas.dispose();
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

    /** {@return where the picture is: in the middle, at 100 %, or as large as fits} */
    Rectangle place() {
        double scale = fitted ? Math.min((double) getWidth() / image.getWidth(), (double) getHeight() / image.getHeight()) : 1;
        int width = (int) Math.round(image.getWidth() * scale);
        int height = (int) Math.round(image.getHeight() * scale);
        return new Rectangle(Math.max(0, (getWidth() - width) / 2), Math.max(0, (getHeight() - height) / 2), width, height);
    }

    void setSource(SceneSource other) {
        source = other;
    }

    SceneSource source() {
        return source;
    }

    void setRequest(RenderRequest other) {
        request = other;
    }

    RenderRequest request() {
        return request;
    }

    /** Shows the picture as large as fits, or at 100 %. */
    void setFitted(boolean fit) {
        fitted = fit;
        revalidate();
        repaint();
    }

    /** Sets who is told, on the event thread, that something may have changed. */
    void setListener(Runnable other) {
        listener = other;
    }

    /** {@return the latest rendering; null before the first start} */
    Rendering rendering() {
        return rendering;
    }

    /** {@return whether rows are still to come} */
    boolean isBusy() {
        return kicker.isRunning();
    }

    /** {@return the picture that is shown, if it is whole; null if not} */
    Picture whole() {
        return whole;
    }

    /** {@return the size of what is shown} */
    Dimension size100() {
        return new Dimension(image.getWidth(), image.getHeight());
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                private static final long serialVersionUID = 1L;

                @Override
                public AccessibleRole getAccessibleRole() {
                    return AccessibleRole.CANVAS;
                }
            };
            accessibleContext.setAccessibleName("Picture");
        }
        return accessibleContext;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(image.getWidth(), image.getHeight());
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return LINE;
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return orientation == SwingConstants.VERTICAL ? visible.height : visible.width;
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return fitted || getParent().getWidth() > image.getWidth();
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return fitted || getParent().getHeight() > image.getHeight();
    }
}
