package simpleray.scene;

import java.io.IOException;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * An infinite plane, all P with P·N = c (thesis, chapters 3 and 5). The textbook form a x + b y + c z + d = 0 has d = -c: the sign of
 * the constant is the scene file's, as in chapter 6.
 */
public final class Plane extends Object {
    /** The constant c of P·N = c. */
    public double constant;
    /** The normal N, of any length but 0. */
    public Vector normal;

    private final UnitVector unit = new UnitVector();

    /** Creates the floor y = 0, of the default material. */
    public Plane() {
        this(new Material(), new Vector(0, 1, 0), 0);
    }

    /**
     * Creates a plane. The values are referenced, not copied.
     *
     * @param n the material
     * @param v the normal, of any length but 0
     * @param c the constant
     */
    public Plane(Material n, Vector v, double c) {
        super(n);
        normal = v;
        constant = c;
    }

    /** {@inheritDoc} A ray along the plane misses it. The equation is t = (c - O·N) / (D·N) of the thesis's chapter 3. */
    @Override
    public double intersect(Ray ray) {
        return hit(constant - normal.dot(ray.origin), normal.dot(ray.direction));
    }

    /**
     * Returns the hit of a ray on a plane.
     *
     * @param height the height of the plane above the ray's origin, c - O·N
     * @param slope the height that the ray gains per t, D·N
     * @return t of the hit, or {@link #MISS}
     */
    public static double hit(double height, double slope) {
        double t = height / slope;                            // infinite or NaN for a ray along the plane
        return t > THRESHOLD && t < Double.POSITIVE_INFINITY ? t : MISS;
    }

    @Override
    public Vector normal(Point p) {
        return normal.normalised();
    }

    @Override
    public void normal(Point p, Vector out) {
        unit.of(normal, out);
    }

    /** {@return null: a plane is infinite} */
    @Override
    public Bounds bounds() {
        return null;
    }

    /** {@inheritDoc} N·t is added to the constant. */
    @Override
    public Object moved(Vector t) {
        double c = constant + normal.dot(t);
        Lengths.checkMoved(c);
        return new Plane(surfaceMaterial, normal, c);
    }

    @Override
    public void print(SceneWriter os) throws IOException {
        os.writeString("Plane with normal: ");
        normal.print(os);
        os.writeString(" and constant: ");
        os.writeDouble(constant);
        os.writeNewline();
        surfaceMaterial.print(os);
    }

    @Override
    public void read(SceneReader is) throws IOException {
        normal = new Vector();
        Directions.read(is, "normal", normal);
        Lengths.check(is, "normal", normal.x, normal.y, normal.z);
        constant = is.readDouble("constant");
        if (Math.abs(constant) > Lengths.MAX) {
            is.reject("constant from -1e100 to 1e100");
        }
        readMaterial(is);
    }

    @Override
    public void write(SceneWriter os) throws IOException {
        normal.write(os);
        os.writeDouble(constant);
        os.writeString("  ");
        surfaceMaterial.write(os);
    }
}
