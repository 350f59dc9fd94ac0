package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Vector;

/**
 * The directions of a picture in space, each of unit length and at right angles to the others. <em>Constant.</em>
 *
 * @param forward from the eye to the middle of the picture
 * @param right from its left edge to the right one
 * @param up from its lower edge to the upper one
 */
record ViewAxes(Vector forward, Vector right, Vector up) {
    /** Below this sine of the angle between view and up, rounding decides how the picture is turned. */
    private static final double ALONG = 1e-12;

    /**
     * Finds the axes of a view.
     *
     * @param eye the eye
     * @param lookAt another point
     * @param up what is up in the picture, not along the view; null for +y, or -z if the view is along y
     * @return the axes
     */
    static ViewAxes of(Point eye, Point lookAt, Vector up) {
        Vector forward = forward(eye, lookAt);
        Vector right = Vector.cross(forward, up != null ? unit(up) : new Vector(0, isAlongY(forward) ? 0 : 1, isAlongY(forward) ? -1 : 0));
        right.normalise();
        return new ViewAxes(forward, right, Vector.cross(right, forward));
    }

    /** {@return whether a vector is along a view, forward or backward, up to rounding; false if one of them is zero} */
    static boolean isAlong(Point eye, Point lookAt, Vector up) {
        Vector forward = forward(eye, lookAt);
        Vector unit = unit(up);
        return forward.norm() * unit.norm() > 0 && Vector.cross(forward, unit).norm() <= ALONG;
    }

    private static boolean isAlongY(Vector forward) {
        return forward.x == 0 && forward.z == 0;
    }

    private static Vector forward(Point eye, Point lookAt) {
        // halves, so that no difference overflows
        return unit(new Vector(lookAt.x / 2 - eye.x / 2, lookAt.y / 2 - eye.y / 2, lookAt.z / 2 - eye.z / 2));
    }

    private static Vector unit(Vector v) {
        Vector unit = new Vector(v);
        unit.normalise();
        return unit;
    }
}
