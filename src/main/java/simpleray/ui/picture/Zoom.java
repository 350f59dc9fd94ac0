package simpleray.ui.picture;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;

/**
 * How large a picture is shown: at a scale, or as large as fits into the window. <em>Constant.</em>
 *
 * <p>At 100 % a pixel of the picture is a pixel of the screen, also where the desktop shows everything else larger (uiScale): no
 * rendered pixel is smoothed or doubled.
 *
 * @param fitted whether it is as large as fits
 * @param scale screen pixels for a pixel of the picture, unless it is fitted
 */
public record Zoom(boolean fitted, double scale) {
    static final Zoom FIT = new Zoom(true, 1);
    static final Zoom ACTUAL = new Zoom(false, 1);

    private static final double PERCENT = 100;
    /** From 100 % on whole numbers: then all pixels are shown equally large. */
    private static final double[] STEPS = {0.125, 0.25, 0.5, 0.75, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32};
    /** A fitted picture is as good as at a step if it is so close to it. */
    private static final double SAME = 1e-3;

    /**
     * Where a picture is in a component, in screen pixels from the component's corner.
     *
     * @param x the left edge
     * @param y the upper edge
     * @param width the width
     * @param height the height
     * @param scale screen pixels for a pixel of the picture
     */
    public record Place(int x, int y, int width, int height, double scale) {
        /** {@return the column of the picture's pixel that shows in a column of screen pixels; it may lie outside} */
        int column(double screenX) {
            return (int) Math.floor((screenX - x) / scale);
        }

        int row(double screenY) {
            return (int) Math.floor((screenY - y) / scale);
        }

        /** {@return the place of the same picture with its corner elsewhere} */
        Place at(int left, int top) {
            return new Place(left, top, width, height, scale);
        }

        /**
         * Paints the picture, or a coarser one in its place, in pixels of the screen, so that at 100 % and its multiples each pixel of the picture is a square of them.
         *
         * @param g paints the component
         * @param ui how many screen pixels a unit of the component's size has
         */
        void paint(Graphics2D g, BufferedImage image, double ui) {
            AffineTransform units = g.getTransform();
            Graphics2D screen = (Graphics2D) g.create();
            double shrunk = units.getScaleX() / ui;           // 1, unless something else than the screen is painted on
            screen.setTransform(new AffineTransform());
            screen.translate((double) Math.round(units.getTranslateX()), (double) Math.round(units.getTranslateY()));
            screen.scale(shrunk, shrunk);
            boolean smooth = scale < 1 || image.getWidth() < width / scale;
            screen.setRenderingHint(RenderingHints.KEY_INTERPOLATION,
                smooth ? RenderingHints.VALUE_INTERPOLATION_BILINEAR : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
            Rectangle clip = screen.getClipBounds();
            if (smooth && clip != null) {
                Rectangle part = clip.intersection(new Rectangle(x, y, width, height));
                if (!part.isEmpty()) {
                    screen.drawImage(shrunk(image, part), part.x, part.y, null);
                }
            } else if (scale != Math.rint(scale) || clip == null || image.getWidth() * scale != width) {
                screen.drawImage(image, x, y, width, height, null);
            } else {
                paintVisible(screen, image, clip);
            }
            screen.dispose();
        }

        /**
         * {@return the part of the shrunk, or coarse, picture that shows in a rectangle} The screen is given no more: it would take
         * all pixels of the picture for any part, which for a large one takes most of a second.
         */
        BufferedImage shrunk(BufferedImage image, Rectangle part) {
            BufferedImage shown = new BufferedImage(part.width, part.height, BufferedImage.TYPE_INT_ARGB);
            Graphics2D g = shown.createGraphics();
            g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
            g.drawImage(image, x - part.x, y - part.y, width, height, null);
            g.dispose();
            return shown;
        }

        /** Paints only the visible part of a picture, which may be far larger than the window. */
        private void paintVisible(Graphics2D screen, BufferedImage image, Rectangle clip) {
            int size = (int) scale;
            int left = Math.max(0, column(clip.x));
            int top = Math.max(0, row(clip.y));
            int right = Math.min(image.getWidth(), column(clip.x + clip.width) + 1);
            int bottom = Math.min(image.getHeight(), row(clip.y + clip.height) + 1);
            if (left < right && top < bottom) {
                screen.drawImage(image, x + left * size, y + top * size, x + right * size, y + bottom * size,
                    left, top, right, bottom, null);
            }
        }
    }

    /** {@return the next step larger than the present scale, which a fitted picture has from its window; this one if there is none} */
    Zoom in(double now) {
        for (double step : STEPS) {
            if (step > now * (1 + SAME)) {
                return new Zoom(false, step);
            }
        }
        return this;
    }

    /** {@return the next step smaller than the present scale; this one if there is none} */
    Zoom out(double now) {
        for (int i = STEPS.length - 1; i >= 0; i--) {
            if (STEPS[i] < now * (1 - SAME)) {
                return new Zoom(false, STEPS[i]);
            }
        }
        return this;
    }

    /**
     * Places a picture in the middle of a component, or at its corner if it is larger.
     *
     * @param room the component's size
     * @param picture the picture's size
     * @param ui how many screen pixels a unit of the component's size has
     */
    Place place(Dimension room, Dimension picture, double ui) {
        int across = (int) Math.round(room.width * ui);
        int down = (int) Math.round(room.height * ui);
        double factor = fitted ? Math.min((double) across / picture.width, (double) down / picture.height) : scale;
        int width = (int) Math.round(picture.width * factor);
        int height = (int) Math.round(picture.height * factor);
        return new Place(Math.max(0, (across - width) / 2), Math.max(0, (down - height) / 2), width, height, factor);
    }

    /** {@return the size of a component that shows all of the picture} */
    Dimension size(Dimension picture, double ui) {
        double factor = fitted ? 1 : scale;
        return new Dimension((int) Math.ceil(Math.round(picture.width * factor) / ui),
            (int) Math.ceil(Math.round(picture.height * factor) / ui));
    }

    /**
     * Returns the view position that keeps a point of the picture at the same point of the viewport when the scale changes.
     *
     * @param inWindow the point, from the viewport's corner
     * @param before the picture's place at the former scale
     * @param was the view position at the former scale
     * @param after the picture's place at the present scale
     * @param ui how many screen pixels a unit of the component's size has
     * @return the view position; it may lie outside the component where an edge of the picture is in the viewport
     */
    static Point kept(Point inWindow, Place before, Point was, Place after, double ui) {
        double u = ((was.x + inWindow.x) * ui - before.x) / before.scale;
        double v = ((was.y + inWindow.y) * ui - before.y) / before.scale;
        return new Point((int) Math.round((u * after.scale + after.x) / ui) - inWindow.x,
            (int) Math.round((v * after.scale + after.y) / ui) - inWindow.y);
    }

    /** {@return a scale as people read it: "100 %", "12.5 %"} */
    static String percent(double scale) {
        double tenths = Math.round(scale * PERCENT * 10) / 10.0;
        return (tenths == Math.rint(tenths) ? Long.toString((long) tenths) : Double.toString(tenths)) + " %";
    }
}
