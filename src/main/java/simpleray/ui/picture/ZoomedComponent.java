package simpleray.ui.picture;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.function.DoubleSupplier;
import java.util.function.IntUnaryOperator;
import java.util.function.Supplier;
import javax.swing.JScrollPane;
import javax.swing.JViewport;
import javax.swing.Scrollable;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import simpleray.ui.widget.DrawnComponent;

/** A component that shows a picture at the scale of a {@link Zoom}, and can be scrolled where that is larger. For the event thread. */
abstract class ZoomedComponent extends DrawnComponent implements Scrollable {
    /** The property that changes with the zoom. */
    public static final String ZOOM = "zoom";

    private static final long serialVersionUID = 1L;
    private static final int LINE = 16;
    private static final Point2D MIDDLE = new Point2D.Double(0.5, 0.5);

    private boolean wheelZooms;
    private transient IntUnaryOperator spareBeside = width -> 0;
    private int spareBelow;
    private transient Supplier<Point2D> focus = () -> MIDDLE;
    private transient Zoom.Place held;                        // from the corner of what can be seen; null if it is where the zoom says
    private Dimension heldIn;                                 // the scroll pane's size meanwhile, or since it is anchored
    private transient Point2D anchor;                         // the part of the picture that is to be near its old place; or null
    private transient Point2D anchoredAt;                     // that place, in screen pixels from the corner of what can be seen
    private Dimension anchoredIn;                             // the scroll pane's size there
    private transient Zoom zoom = Zoom.FIT;
    private transient DoubleSupplier standIn;                 // tells the scale of what is shown in its place; null if it is shown itself

    ZoomedComponent() {
        super("Picture");
        addPropertyChangeListener("graphicsConfiguration", e -> revalidate());   // a screen of another scale
    }

    /** {@return the picture's size in its pixels} */
    abstract Dimension imageSize();

    /** To be called when the picture has another size. */
    final void resized() {
        held = null;                                          // it had the place of the other size
        revalidate();
        firePropertyChange(ZOOM, null, zoom);                 // fitted, it has another scale now
    }

    /** {@return where the picture is, in screen pixels from the component's corner} */
    public final Zoom.Place placed() {
        if (isHeld()) {
            return held.at(Math.max(0, held.x()), Math.max(0, held.y()));
        }
        if (!zoom.fitted()) {
            return zoom.place(getSize(), imageSize(), ui());
        }
        int right = (int) Math.round(getWidth() * ui());
        int bottom = (int) Math.round(Math.max(1, getHeight() - spareBelow) * ui());
        Zoom.Place place = zoom.place(new Dimension(getWidth(), Math.max(1, getHeight() - spareBelow)), imageSize(), ui());
        if (isAnchored()) {
            return place.at(within(anchoredAt.getX() - anchor.getX() * place.width(), right - place.width()),
                within(anchoredAt.getY() - anchor.getY() * place.height(), bottom - place.height()));
        }
        int spare = (int) Math.round(spareBeside.applyAsInt((int) Math.ceil(place.width() / ui())) * ui());
        return place.at(within(place.x(), right - spare - place.width()), place.y());
    }

    private static int within(double place, int end) {
        return (int) Math.round(Math.max(0, Math.min(place, end)));
    }

    /**
     * Sets how much room a fitted picture leaves for what may come beside it, so that it need not move then: as far as the picture is not
     * wider.
     *
     * @param room tells the room for a picture of a width, both in units of the component's size
     */
    public final void setSpareBeside(IntUnaryOperator room) {
        spareBeside = room;
    }

    /**
     * Sets how much room a fitted picture leaves below for what may come there.
     *
     * @param height in units of the component's size
     */
    public final void setSpareBelow(int height) {
        spareBelow = height;
        repaint();
    }

    /**
     * Sets what a picture that is fitted anew beside other panes keeps as near as it can to where that was.
     *
     * @param point tells a point of the picture, from 0 to 1 across and down
     */
    public final void setFocus(Supplier<Point2D> point) {
        focus = point;
    }

    /**
     * Changes the window so that the picture stays on the screen where it is, as large as it is, until its room changes again, or its zoom.
     *
     * @param change changes the window, and lays it out
     * @param whole whether a picture that is fitted, or seen whole, is to be so still: where it does not fit at its place, it is laid out
     *     anew, a fitted one near its place; and as it had been, once there is the room of before
     */
    public final void keep(Runnable change, boolean whole) {
        if (!isShowing() || !(getParent() instanceof JViewport port) || !(port.getParent() instanceof JScrollPane pane)) {
            change.run();
            return;
        }
        Zoom.Place was = placed();
        Point2D kept = anchor;
        Dimension had = pane.getSize();
        boolean seen = zoom.fitted() || getVisibleRect().contains(place());
        Point before = getLocationOnScreen();
        change.run();
        Point now = port.getLocationOnScreen();
        int x = was.x() + (int) Math.round((before.x - now.x) * ui());
        int y = was.y() + (int) Math.round((before.y - now.y) * ui());
        Rectangle room = SwingUtilities.calculateInnerArea(pane, null);
        boolean fits = x >= 0 && y >= 0 && x + was.width() <= Math.round(room.width * ui())
            && y + was.height() <= Math.round(room.height * ui());
        heldIn = pane.getSize();
        held = null;
        if (kept != null) {
            anchor = kept;                                    // laying out may have forgotten it
        }
        if (kept != null && heldIn.width >= anchoredIn.width && heldIn.height >= anchoredIn.height) {
            forgetPlace(true);
        } else if (whole && (kept != null || seen && !fits)) {
            if (kept == null) {
                anchor = focus.get();
                anchoredIn = had;
                anchoredAt = new Point2D.Double(x + anchor.getX() * was.width(), y + anchor.getY() * was.height());
            }
        } else {
            held = was.at(x, y);
        }
        revalidate();
        pane.validate();
        port.setScrollMode(JViewport.SIMPLE_SCROLL_MODE);
        port.setViewPosition(held == null ? new Point() : hidden());
        repaint();
        firePropertyChange(ZOOM, null, zoom);                 // fitted anew, it has another scale
    }

    /** {@return whether the picture stays where it was put, whatever its zoom says} */
    final boolean isHeld() {
        forgetPlace(heldIn == null || getParent() == null || !heldIn.equals(getParent().getParent().getSize()));
        return held != null;
    }

    /** {@return whether a fitted picture is near the place that it had in a larger room} */
    private boolean isAnchored() {
        return !isHeld() && anchor != null;
    }

    private void forgetPlace(boolean really) {
        if (really) {
            held = null;
            anchor = null;
        }
    }

    /** Lets a picture that was fitted, and stayed where it was since, be fitted anew. */
    final void fitAgain() {
        if (zoom.fitted()) {
            forgetPlace(true);
            revalidate();
        }
    }

    /** {@return how much of a held picture is above and to the left of what can be seen} */
    private Point hidden() {
        return new Point((int) Math.round(Math.max(0, -held.x()) / ui()), (int) Math.round(Math.max(0, -held.y()) / ui()));
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

    /** {@return the side of the largest square that there is room for, in pixels of the screen; 0 if it is not shown in a window} */
    final int room() {
        return getParent() instanceof JViewport port ? (int) Math.round(Math.min(port.getWidth(),
            Math.max(1, port.getHeight() - spareBelow)) * ui()) : 0;
    }

    /** {@return whether the picture is larger than what can be seen of it, and not because it stays where it was fitted} */
    final boolean overflows() {
        return !(zoom.fitted() && isHeld()) && getParent() instanceof JViewport port
            && (getWidth() > port.getWidth() || getHeight() > port.getHeight());
    }

    /** {@return whether the wheel zooms without Ctrl, and moves no camera} */
    final boolean wheelZooms() {
        return wheelZooms;
    }

    final void setWheelZooms(boolean zooms) {
        wheelZooms = zooms;
    }

    final Zoom zoom() {
        return zoom;
    }

    /** {@return the largest scale of what stands in for this: infinite while pictures are fitted} */
    public final double maxScale() {
        return zoom.fitted() ? Double.POSITIVE_INFINITY : zoom.scale();
    }

    /**
     * Says that something else is shown in place of this; to be called again when its scale has changed.
     *
     * @param scale tells its scale; null if this is shown itself
     */
    public final void setStandIn(DoubleSupplier scale) {
        standIn = scale;
        firePropertyChange(ZOOM, null, zoom);
    }

    /** {@return screen pixels for a pixel of what is shown} */
    final double shownScale() {
        return standIn == null ? placed().scale() : standIn.getAsDouble();
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
        forgetPlace(true);
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
        if (isHeld()) {
            Point hidden = hidden();
            Zoom.Place place = placed();
            return new Dimension(Math.max(getParent().getWidth() + hidden.x, (int) Math.ceil((place.x() + place.width()) / ui())),
                Math.max(getParent().getHeight() + hidden.y, (int) Math.ceil((place.y() + place.height()) / ui())));
        }
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
        return !isHeld() && zoom.fitted() || getParent().getWidth() >= getPreferredSize().width;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return !isHeld() && zoom.fitted() || getParent().getHeight() >= getPreferredSize().height;
    }
}
