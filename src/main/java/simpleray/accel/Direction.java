package simpleray.accel;

/** Where a direction meets a cube about its origin. <em>Mutable.</em> */
final class Direction {
    /** Which face, as {@link Cube} counts them. */
    int face;
    /** Where on it along its first axis, from -1 to 1. */
    double across;
    /** Where on it along its second axis, from -1 to 1. */
    double along;

    /** Sets the direction, which need not be of unit length. */
    void set(double dx, double dy, double dz) {
        double ax = Math.abs(dx);
        double ay = Math.abs(dy);
        double az = Math.abs(dz);
        if (az >= ax && az >= ay) {
            face = dz >= 0 ? 4 : 5;
            across = dx / az;
            along = dy / az;
        } else if (ay >= ax) {
            face = dy >= 0 ? 2 : 3;
            across = dx / ay;
            along = dz / ay;
        } else {
            face = dx >= 0 ? 0 : 1;
            across = dy / ax;
            along = dz / ax;
        }
    }
}
