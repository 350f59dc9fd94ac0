package simpleray.scene;

import java.io.IOException;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.text.SceneReader;

/**
 * The points of a shape as they are read and moved, and the limits of its numbers. Hits are computed by products of up to three of them. Beyond
 * 1e308 a product is infinite, and rays would miss the shape without an error.
 */
final class Lengths {
    /** The largest. */
    static final double MAX = 1e100;
    /** The largest factor of the coordinates of a mesh; scaled, they are no larger than other lengths. */
    static final double MAX_SCALE = 1e60;
    /** What numbers without another limit must be, for messages. */
    static final String FINITE = "finite numbers";

    private Lengths() {
    }

    /** Notes an error if one of the numbers of the current group is too large. */
    static void check(SceneReader is, String what, double... lengths) throws IOException {
        for (double length : lengths) {
            if (Math.abs(length) > MAX) {
                is.rejectGroup(what + " of numbers from -1e100 to 1e100");
                return;
            }
        }
    }

    /** {@return a point, read under this name, of any numbers} */
    static Point readPoint(SceneReader is, String name) throws IOException {
        Point point = new Point();
        is.enter(name);
        point.read(is);
        is.leave();
        return point;
    }

    /** {@return a point moved by t} Throws an IllegalArgumentException if it is then beyond the limit. */
    static Point moved(Point p, Vector t) {
        Point moved = Point.add(p, t);
        checkMoved(moved.x);
        checkMoved(moved.y);
        checkMoved(moved.z);
        return moved;
    }

    /** Throws an IllegalArgumentException if a number that was moved is beyond the limit, or none. */
    static void checkMoved(double length) {
        if (!(Math.abs(length) <= MAX)) {
            throw new IllegalArgumentException("numbers from -1e100 to 1e100");
        }
    }

    /** Notes an error if a radius is not above 0 or is too large. */
    static void checkRadius(SceneReader is, double radius) throws IOException {
        if (radius <= 0) {
            is.reject("radius above 0");
        } else if (radius > MAX) {
            is.reject("radius of 1e100 or less");
        }
    }
}
