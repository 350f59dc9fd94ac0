package simpleray.math;

import java.io.IOException;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** A place in space (thesis, chapter 5). <em>Mutable.</em> */
public final class Point {
    /** The x component, to the right. */
    public double x;
    /** The y component, up. */
    public double y;
    /** The z component, towards the viewer. */
    public double z;

    /** Creates the origin, (0, 0, 0). */
    public Point() {
    }

    /**
     * Creates a point.
     *
     * @param x the x component
     * @param y the y component
     * @param z the z component
     */
    public Point(double x, double y, double z) {
        set(x, y, z);
    }

    /**
     * Creates a copy.
     *
     * @param p the point to copy
     */
    public Point(Point p) {
        set(p.x, p.y, p.z);
    }

    /**
     * Sets the components.
     *
     * @param x the x component
     * @param y the y component
     * @param z the z component
     */
    public void set(double x, double y, double z) {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    /**
     * Makes this a copy.
     *
     * @param p the point to copy
     */
    public void copy(Point p) {
        set(p.x, p.y, p.z);
    }

    /**
     * Moves this point.
     *
     * @param v the offset
     */
    public void add(Vector v) {
        add(this, this, v);
    }

    /**
     * Returns the point at an offset from another.
     *
     * @param p the other point
     * @param v the offset
     * @return a new point, p + v
     */
    public static Point add(Point p, Vector v) {
        Point sum = new Point();
        add(sum, p, v);
        return sum;
    }

    /**
     * Computes the point at an offset from another.
     *
     * @param pd gets p + v; may be p
     * @param p the other point
     * @param v the offset
     */
    public static void add(Point pd, Point p, Vector v) {
        pd.set(p.x + v.x, p.y + v.y, p.z + v.z);
    }

    /**
     * Compares the components with those of another point. This is the thesis's method, not {@link java.lang.Object#equals}: a
     * mutable point is no key of a map.
     *
     * @param p the other point
     * @return true if all three are equal
     */
    public boolean equals(Point p) {
        return x == p.x && y == p.y && z == p.z;
    }

    /**
     * Reads the three components.
     *
     * @param is where from
     * @throws IOException if one is missing
     */
    public void read(SceneReader is) throws IOException {
        set(is.readDouble("x"), is.readDouble("y"), is.readDouble("z"));
    }

    /**
     * Writes the three components, in the form that {@link #read} reads.
     *
     * @param os where to
     * @throws IOException if they cannot be written
     */
    public void write(SceneWriter os) throws IOException {
        os.writeDouble(x);
        os.writeDouble(y);
        os.writeDouble(z);
    }

    /**
     * Prints the point as {@code [x,y,z]}.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    public void print(SceneWriter os) throws IOException {
        os.writeChar('[');
        os.writeDouble(x);
        os.writeChar(',');
        os.writeDouble(y);
        os.writeChar(',');
        os.writeDouble(z);
        os.writeChar(']');
    }

    /** {@return the point as {@code [x,y,z]}} */
    @Override
    public String toString() {
        return "[" + x + ',' + y + ',' + z + ']';
    }
}
