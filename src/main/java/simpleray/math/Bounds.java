package simpleray.math;

/**
 * An axis-aligned box: all points between two corners, these included. <em>Constant.</em>
 *
 * @param xmin the smallest x
 * @param ymin the smallest y
 * @param zmin the smallest z
 * @param xmax the largest x
 * @param ymax the largest y
 * @param zmax the largest z
 */
public record Bounds(double xmin, double ymin, double zmin, double xmax, double ymax, double zmax) {
    /**
     * Returns the smallest box that contains some points.
     *
     * @param first a point
     * @param others more points
     * @return the box
     */
    public static Bounds of(Point first, Point... others) {
        Bounds box = new Bounds(first.x, first.y, first.z, first.x, first.y, first.z);
        for (Point p : others) {
            box = box.with(new Bounds(p.x, p.y, p.z, p.x, p.y, p.z));
        }
        return box;
    }

    /**
     * Returns the smallest box that contains this one and another.
     *
     * @param other the other box
     * @return a new box
     */
    public Bounds with(Bounds other) {
        return new Bounds(Math.min(xmin, other.xmin), Math.min(ymin, other.ymin), Math.min(zmin, other.zmin),
            Math.max(xmax, other.xmax), Math.max(ymax, other.ymax), Math.max(zmax, other.zmax));
    }

    /**
     * Tests whether a point is in the box.
     *
     * @param p the point
     * @return true if it is inside or on the border
     */
    public boolean contains(Point p) {
        return p.x >= xmin && p.x <= xmax && p.y >= ymin && p.y <= ymax && p.z >= zmin && p.z <= zmax;
    }

    /**
     * Copies the sides.
     *
     * @param box gets xmin, ymin, zmin, xmax, ymax, zmax
     */
    public void get(double[] box) {
        box[0] = xmin;
        box[1] = ymin;
        box[2] = zmin;
        box[3] = xmax;
        box[4] = ymax;
        box[5] = zmax;
    }
}
