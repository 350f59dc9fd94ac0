package simpleray.ui.picture;

import java.awt.Dimension;
import java.awt.GraphicsConfiguration;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import javax.swing.JViewport;
import javax.swing.Scrollable;
import javax.swing.SwingConstants;
import simpleray.ui.widget.DrawnComponent;

/** A component that shows a picture at the scale of a {@link Zoom}, and can be scrolled where that is larger. For the event thread. */
abstract class ZoomedComponent extends DrawnComponent implements Scrollable {
    /** The property that changes with the zoom. */
    static final String ZOOM = "zoom";

    private static final long serialVersionUID = 1L;
    private static final int LINE = 16;

    private transient Zoom zoom = Zoom.ACTUAL;

    ZoomedComponent() {
        super("Picture");
        addPropertyChangeListener("graphicsConfiguration", e -> revalidate());   // a screen of another scale
    }

    /** {@return the picture's size in its pixels} */
    abstract Dimension imageSize();

    /** To be called when the picture has another size. */
    final void resized() {
        revalidate();
        firePropertyChange(ZOOM, null, zoom);                 // fitted, it has another scale now
    }

    /** {@return where the picture is, in screen pixels from the component's corner} */
    public final Zoom.Place placed() {
        return zoom.place(getSize(), imageSize(), ui());
    }

    /** {@return how many screen pixels a unit of the component's size has} */
    public final double ui() {
        GraphicsConfiguration screen = getGraphicsConfiguration();
        return screen == null ? 1 : screen.getDefaultTransform().getScaleX();
    }

    /** {@return where the picture is in the component: in the middle, at its scale, or as large as fits} */
    public final Rectangle place() {
        Zoom.Place place = placed();
        double ui = ui();
        return new Rectangle2D.Double(place.x() / ui, place.y() / ui, place.width() / ui, place.height() / ui).getBounds();
    }

    /** {@return the picture's pixel at a point of the component; null beside the picture} */
    public final Point pixelAt(Point inComponent) {
        Zoom.Place place = placed();
        int x = place.column(inComponent.x * ui());
        int y = place.row(inComponent.y * ui());
        return x >= 0 && y >= 0 && x < imageSize().width && y < imageSize().height ? new Point(x, y) : null;
    }

    final Zoom zoom() {
        return zoom;
    }

    /**
     * Shows the picture at another scale.
     *
     * @param about the point of the component where the picture stays, unless its edge would come into the window; null for the middle of
     *     the window
     */
    public final void setZoom(Zoom other, Point about) {
        Zoom before = zoom;
        Zoom.Place was = placed();
        zoom = other;
        revalidate();
        if (getParent() instanceof JViewport port) {
            keepInPlace(port, about, was);
        }
        repaint();
        firePropertyChange(ZOOM, before, zoom);
    }

    private void keepInPlace(JViewport port, Point about, Zoom.Place was) {
        port.setScrollMode(JViewport.SIMPLE_SCROLL_MODE);     // others move parts of pixels on a scaled desktop
        Point corner = port.getViewPosition();
        Point inWindow = about == null ? new Point(port.getWidth() / 2, port.getHeight() / 2)
            : new Point(about.x - corner.x, about.y - corner.y);
        port.getParent().validate();                          // now, so that no picture is seen at the new scale in the old place
        Point kept = Zoom.kept(inWindow, was, corner, placed(), ui());
        port.setViewPosition(new Point(Math.max(0, Math.min(kept.x, getWidth() - port.getWidth())),
            Math.max(0, Math.min(kept.y, getHeight() - port.getHeight()))));
    }

    @Override
    public Dimension getPreferredSize() {
        return zoom.size(imageSize(), ui());
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
        return zoom.fitted() || getParent().getWidth() > getPreferredSize().width;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return zoom.fitted() || getParent().getHeight() > getPreferredSize().height;
    }
}
