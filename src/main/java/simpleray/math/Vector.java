package simpleray.math;

import java.io.IOException;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** A direction or an offset in space (thesis, chapter 5). <em>Mutable.</em> */
public final class Vector {
    /** Squared lengths outside these have lost digits, or all of them, to underflow or overflow. */
    private static final double MIN_SQUARE = 0x1p-960;
    private static final double MAX_SQUARE = 0x1p+960;

    /** The x component, to the right. */
    public double x;
    /** The y component, up. */
    public double y;
    /** The z component, towards the viewer. */
    public double z;

    /** Creates a zero vector. */
    public Vector() {
    }

    /**
     * Creates a vector.
     *
     * @param s the x component
     * @param b the y component
     * @param c the z component
     */
    public Vector(double s, double b, double c) {
        x = s;
        y = b;
        z = c;
    }

    /**
     * Creates the vector from the origin to a point.
     *
     * @param p the point
     */
    public Vector(Point p) {
        this(p.x, p.y, p.z);
    }

    /**
     * Creates a copy.
     *
     * @param v the vector to copy
     */
    public Vector(Vector v) {
        this(v.x, v.y, v.z);
    }

    /**
     * Sets the components.
     *
     * @param a the x component
     * @param b the y component
     * @param c the z component
     */
    public void set(double a, double b, double c) {
        x = a;
        y = b;
        z = c;
    }

    /**
     * Makes this a copy.
     *
     * @param a the vector to copy
     */
    public void copy(Vector a) {
        set(a.x, a.y, a.z);
    }

    /**
     * Adds to this vector.
     *
     * @param a the vector to add
     */
    public void add(Vector a) {
        add(this, this, a);
    }

    /**
     * Adds two vectors.
     *
     * @param a the first
     * @param b the second
     * @return a new vector, a + b
     */
    public static Vector add(Vector a, Vector b) {
        Vector sum = new Vector();
        add(sum, a, b);
        return sum;
    }

    /**
     * Adds two vectors.
     *
     * @param vd gets v1 + v2; may be one of them
     * @param v1 the first
     * @param v2 the second
     */
    public static void add(Vector vd, Vector v1, Vector v2) {
        vd.set(v1.x + v2.x, v1.y + v2.y, v1.z + v2.z);
    }

    /**
     * Subtracts from this vector.
     *
     * @param a the vector to subtract
     */
    public void subtract(Vector a) {
        subtract(this, this, a);
    }

    /**
     * Returns the vector from one point to another.
     *
     * @param a the end
     * @param b the start
     * @return a new vector, a - b
     */
    public static Vector subtract(Point a, Point b) {
        Vector difference = new Vector();
        subtract(difference, a, b);
        return difference;
    }

    /**
     * Computes the vector from one point to another.
     *
     * @param d gets a - b
     * @param a the end
     * @param b the start
     */
    public static void subtract(Vector d, Point a, Point b) {
        d.set(a.x - b.x, a.y - b.y, a.z - b.z);
    }

    /**
     * Subtracts two vectors.
     *
     * @param d gets a - b; may be one of them
     * @param a the vector to subtract from
     * @param b the vector to subtract
     */
    public static void subtract(Vector d, Vector a, Vector b) {
        d.set(a.x - b.x, a.y - b.y, a.z - b.z);
    }

    /**
     * Replaces this vector by its cross product with another.
     *
     * @param a the right operand
     */
    public void cross(Vector a) {
        cross(this, this, a);
    }

    /**
     * Returns the cross product, perpendicular to both by the right-hand rule.
     *
     * @param a the left operand
     * @param b the right operand
     * @return a new vector, a × b
     */
    public static Vector cross(Vector a, Vector b) {
        Vector product = new Vector();
        cross(product, a, b);
        return product;
    }

    /**
     * Computes the cross product.
     *
     * @param vd gets v1 × v2; may be one of them
     * @param v1 the left operand
     * @param v2 the right operand
     */
    public static void cross(Vector vd, Vector v1, Vector v2) {
        vd.set(v1.y * v2.z - v1.z * v2.y, v1.z * v2.x - v1.x * v2.z, v1.x * v2.y - v1.y * v2.x);
    }

    /**
     * Returns the dot product with the vector from the origin to a point.
     *
     * @param p the point
     * @return the dot product
     */
    public double dot(Point p) {
        return x * p.x + y * p.y + z * p.z;
    }

    /**
     * Returns the dot product.
     *
     * @param v the other vector
     * @return the dot product
     */
    public double dot(Vector v) {
        return dot(this, v);
    }

    /**
     * Returns the dot product.
     *
     * @param v1 one vector
     * @param v2 the other
     * @return the dot product
     */
    public static double dot(Vector v1, Vector v2) {
        return v1.x * v2.x + v1.y * v2.y + v1.z * v2.z;
    }

    /** Reverses this vector. */
    public void negate() {
        set(-x, -y, -z);
    }

    /**
     * Returns the opposite vector.
     *
     * @param a a vector
     * @return a new vector, -a
     */
    public static Vector negate(Vector a) {
        return new Vector(-a.x, -a.y, -a.z);
    }

    /**
     * Scales this vector.
     *
     * @param sc the factor
     */
    public void scale(double sc) {
        scale(this, this, sc);
    }

    /**
     * Scales a vector.
     *
     * @param a the vector
     * @param sc the factor
     * @return a new vector, sc a
     */
    public static Vector scale(Vector a, double sc) {
        Vector scaled = new Vector();
        scale(scaled, a, sc);
        return scaled;
    }

    /**
     * Scales a vector.
     *
     * @param d gets sc a; may be a
     * @param a the vector
     * @param sc the factor
     */
    public static void scale(Vector d, Vector a, double sc) {
        d.set(a.x * sc, a.y * sc, a.z * sc);
    }

    /** {@return the length, correct for every finite vector whose length is a double} */
    public double norm() {
        double square = squarednorm();
        if (isPlain(square)) {
            return Math.sqrt(square);
        }
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        return !(largest > 0 && largest <= Double.MAX_VALUE) ? largest : largest * new Vector(x / largest, y / largest, z / largest).norm();
    }

    /** {@return the squared length; 0 or infinite for lengths below 1e-162 or above 1e154} */
    public double squarednorm() {
        return dot(this, this);
    }

    /**
     * Tests whether a squared length has all its digits, so that its root is the length; else {@link #norm} and {@link #normalise} scale
     * the vector first.
     *
     * @param square the squared length, {@link #squarednorm}
     * @return whether it lost none to underflow or overflow
     */
    public static boolean isPlain(double square) {
        return square >= MIN_SQUARE && square <= MAX_SQUARE;
    }

    /** Scales this vector to length 1; a zero vector stays zero. */
    public void normalise() {
        measureAndNormalise();
    }

    /** {@return the length before this vector is scaled to length 1, as by {@link #norm}} A zero vector stays zero. */
    public double measureAndNormalise() {
        double square = squarednorm();
        if (isPlain(square)) {
            double length = Math.sqrt(square);
            set(x / length, y / length, z / length);
            return length;
        }
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (!(largest > 0 && largest <= Double.MAX_VALUE)) {
            return largest;
        }
        set(x / largest, y / largest, z / largest);
        return largest * measureAndNormalise();
    }

    /** {@return a new vector of this direction and length 1; zero for a zero vector} */
    public Vector normalised() {
        Vector unit = new Vector(this);
        unit.normalise();
        return unit;
    }

    /**
     * Reads the three components.
     *
     * @param ifs where from
     * @throws IOException if one is missing
     */
    public void read(SceneReader ifs) throws IOException {
        set(ifs.readDouble("x"), ifs.readDouble("y"), ifs.readDouble("z"));
    }

    /**
     * Writes the three components, in the form that {@link #read} reads.
     *
     * @param ofs where to
     * @throws IOException if they cannot be written
     */
    public void write(SceneWriter ofs) throws IOException {
        ofs.writeDouble(x);
        ofs.writeDouble(y);
        ofs.writeDouble(z);
    }

    /**
     * Prints the vector as {@code [x,y,z]}.
     *
     * @param ofs where to
     * @throws IOException if it cannot be written
     */
    public void print(SceneWriter ofs) throws IOException {
        new Point(x, y, z).print(ofs);
    }

    /** {@return the vector as {@code [x,y,z]}} */
    @Override
    public String toString() {
        return "[" + x + ',' + y + ',' + z + ']';
    }
}
