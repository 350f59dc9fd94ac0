package simpleray.scene;

import java.io.IOException;
import simpleray.text.SceneReader;

/**
 * How large the numbers of a shape may be. Where rays hit is found by products of up to three of them, and beyond 1e308 a product is no
 * number any more: the shape would be missed, and nobody told.
 */
final class Lengths {
    /** The largest. */
    static final double MAX = 1e100;
    /** The largest factor of the coordinates of a mesh; scaled, they are no larger than other lengths. */
    static final double MAX_SCALE = 1e60;

    private Lengths() {
    }

    /** Notes an error if one of the numbers just read, of the group that was begun, is too large. */
    static void check(SceneReader is, String what, double... lengths) throws IOException {
        for (double length : lengths) {
            if (Math.abs(length) > MAX) {
                is.rejectGroup(what + " of numbers from -1e100 to 1e100");
                return;
            }
        }
    }

    /** Notes an error if a radius is not above 0, or too large. */
    static void checkRadius(SceneReader is, double radius) throws IOException {
        if (radius <= 0) {
            is.reject("radius above 0");
        } else if (radius > MAX) {
            is.reject("radius of 1e100 or less");
        }
    }
}
