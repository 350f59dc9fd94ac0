package simpleray.ui;

import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import javax.swing.JViewport;

/** Paints a picture at the scale of a {@link Zoom}, and keeps in place what is looked at when the scale changes. */
final class ZoomPainter {
    private ZoomPainter() {
    }

    /**
     * Paints in pixels of the screen, so that at 100 % and its multiples each pixel of the picture is a square of them.
     *
     * @param g paints a component
     * @param ui how many screen pixels a unit of the component's size has
     */
    static void paint(Graphics2D g, BufferedImage image, Zoom.Place place, double ui) {
        AffineTransform units = g.getTransform();
        Graphics2D canvas = (Graphics2D) g.create();
        double scale = units.getScaleX() / ui;                // 1, but for who paints elsewhere than on the screen
        canvas.setTransform(new AffineTransform());
        canvas.translate((double) Math.round(units.getTranslateX()), (double) Math.round(units.getTranslateY()));
        canvas.scale(scale, scale);
        canvas.setRenderingHint(RenderingHints.KEY_INTERPOLATION,
            place.scale() < 1 ? RenderingHints.VALUE_INTERPOLATION_BILINEAR : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        Rectangle clip = canvas.getClipBounds();
        if (place.scale() != Math.rint(place.scale()) || clip == null) {
            canvas.drawImage(image, place.x(), place.y(), place.width(), place.height(), null);
        } else {
            paintPiece(canvas, image, place, clip);
        }
        canvas.dispose();
    }

    /** Of a picture that may be far larger than the window, paints only the piece that is seen. */
    private static void paintPiece(Graphics2D canvas, BufferedImage image, Zoom.Place place, Rectangle clip) {
        int size = (int) place.scale();
        int left = Math.max(0, place.column(clip.x));
        int top = Math.max(0, place.row(clip.y));
        int right = Math.min(image.getWidth(), place.column(clip.x + clip.width) + 1);
        int bottom = Math.min(image.getHeight(), place.row(clip.y + clip.height) + 1);
        if (left < right && top < bottom) {
            canvas.drawImage(image, place.x() + left * size, place.y() + top * size, place.x() + right * size,
                place.y() + bottom * size, left, top, right, bottom, null);
        }
    }

    /**
     * Changes the scale of a picture that may be scrolled.
     *
     * @param about the point of the component under which the picture stays, as far as its edges stay out of the window; null for the
     *     middle of the window
     * @param change changes the scale
     */
    static void keep(ZoomedComponent picture, Point about, Runnable change) {
        Zoom.Place was = picture.placed();
        change.run();
        picture.revalidate();
        if (!(picture.getParent() instanceof JViewport port)) {
            return;
        }
        port.setScrollMode(JViewport.SIMPLE_SCROLL_MODE);     // else, on a scaled desktop, pieces are moved by parts of pixels
        Point corner = port.getViewPosition();
        Point inWindow = about == null ? new Point(port.getWidth() / 2, port.getHeight() / 2)
            : new Point(about.x - corner.x, about.y - corner.y);
        port.getParent().validate();                          // now, so that no picture is seen at the new scale in the old place
        Point kept = Zoom.kept(inWindow, was, corner, picture.placed(), picture.ui());
        port.setViewPosition(new Point(Math.max(0, Math.min(kept.x, picture.getWidth() - port.getWidth())),
            Math.max(0, Math.min(kept.y, picture.getHeight() - port.getHeight()))));
    }
}
