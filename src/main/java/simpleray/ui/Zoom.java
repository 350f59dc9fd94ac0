package simpleray.ui;

import java.awt.Dimension;
import java.awt.Point;

/**
 * How large a picture is shown: at a scale, or as large as fits into the window. <em>Constant.</em>
 *
 * <p>At 100 % a pixel of the picture is a pixel of the screen, also where the desktop shows all else larger (uiScale): of what was
 * rendered nothing is smoothed or doubled.
 *
 * @param fitted whether it is as large as fits
 * @param scale screen pixels for a pixel of the picture, unless it is fitted
 */
record Zoom(boolean fitted, double scale) {
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
    record Place(int x, int y, int width, int height, double scale) {
        /** {@return the column of the picture's pixel that shows in a column of screen pixels; it may lie outside} */
        int column(double screenX) {
            return (int) Math.floor((screenX - x) / scale);
        }

        int row(double screenY) {
            return (int) Math.floor((screenY - y) / scale);
        }
    }

    /** {@return the next larger step, or this one if there is none; now being the scale that a fitted picture has} */
    Zoom in(double now) {
        for (double step : STEPS) {
            if (step > now * (1 + SAME)) {
                return new Zoom(false, step);
            }
        }
        return this;
    }

    /** {@return the next smaller step, or this one if there is none} */
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
     * Finds where a window must be over a component, so that the point of the picture under a point of the window stays under it.
     *
     * @param inWindow the point, from the window's corner
     * @param before the picture's place before it was scaled
     * @param was where the window was over the component then
     * @param after the picture's place now
     * @param ui how many screen pixels a unit of the component's size has
     * @return where the window must be; it may lie outside, where a picture's edge is in the window
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
