package simpleray.scene;

import java.io.IOException;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** A triangle. Both sides are visible; the outside is that from which its vertices run counter-clockwise. */
public final class Triangle extends Object {
    /** The rounding error of a sum of products, as a share of it: four half units in the last place. */
    private static final double ROUNDING = 0x1p-51;
    private static final String NOT_ON_ONE_LINE = "three vertices not on one line";

    /** The first vertex. */
    public Point a;
    /** The second vertex. */
    public Point b;
    /** The third vertex; the three are not on one line. */
    public Point c;

    /** Creates half of the unit square of the XY plane, its outside towards the viewer, of the default material. */
    public Triangle() {
        this(new Material(), new Point(), new Point(1, 0, 0), new Point(0, 1, 0));
    }

    /**
     * Creates a triangle. The values are referenced, not copied.
     *
     * @param n the material
     * @param a the first vertex
     * @param b the second vertex
     * @param c the third vertex, not on one line with the others
     */
    public Triangle(Material n, Point a, Point b, Point c) {
        super(n);
        this.a = a;
        this.b = b;
        this.c = c;
    }

    /**
     * {@inheritDoc} A ray through an edge or a vertex hits; one within the triangle's own plane misses.
     *
     * <p>No ray slips between two triangles that share an edge, in whichever order each names its vertices: Woop, Benthin and Wald,
     * "Watertight Ray/Triangle Intersection", Journal of Computer Graphics Techniques 2(1), 2013.
     */
    @Override
    public double intersect(Ray ray) {
        Point o = ray.origin;
        Vector d = ray.direction;
        double dx = Math.abs(d.x);
        double dy = Math.abs(d.y);
        double dz = Math.abs(d.z);
        if (dz >= dx && dz >= dy) {
            return hit(a.x - o.x, a.y - o.y, a.z - o.z, b.x - o.x, b.y - o.y, b.z - o.z, c.x - o.x, c.y - o.y, c.z - o.z, d.x, d.y, d.z);
        }
        return dy >= dx
            ? hit(a.z - o.z, a.x - o.x, a.y - o.y, b.z - o.z, b.x - o.x, b.y - o.y, c.z - o.z, c.x - o.x, c.y - o.y, d.z, d.x, d.y)
            : hit(a.y - o.y, a.z - o.z, a.x - o.x, b.y - o.y, b.z - o.z, b.x - o.x, c.y - o.y, c.z - o.z, c.x - o.x, d.y, d.z, d.x);
    }

    /**
     * Returns the hit of a ray from the origin whose largest component is along the third axis. Each vertex is sheared and scaled so that the
     * ray becomes the unit vector of that axis; the result depends only on the vertex and the ray, and so is the same for each triangle there.
     */
    private static double hit(double ax, double ay, double az, double bx, double by, double bz, double cx, double cy, double cz,
            double dx, double dy, double dz) {
        double shearX = dx / dz;
        double shearY = dy / dz;
        double px = ax - shearX * az;
        double py = ay - shearY * az;
        double qx = bx - shearX * bz;
        double qy = by - shearY * bz;
        double rx = cx - shearX * cz;
        double ry = cy - shearY * cz;
        double u = edge(qx, qy, rx, ry);
        double v = edge(rx, ry, px, py);
        double w = edge(px, py, qx, qy);
        if (!(u >= 0 && v >= 0 && w >= 0 || u <= 0 && v <= 0 && w <= 0)) {
            return MISS;
        }
        double t = (u * (az / dz) + v * (bz / dz) + w * (cz / dz)) / (u + v + w);
        return t > THRESHOLD && t < Double.POSITIVE_INFINITY ? t : MISS;
    }

    /**
     * Computes on which side of an edge the ray passes.
     *
     * @return twice the area that edge and ray span; its sign is exact, and opposite for (q, p), as watertightness requires
     */
    static double edge(double px, double py, double qx, double qy) {
        double one = px * qy;
        double other = py * qx;
        if (one != other) {                                   // rounding never swaps the two; at most it makes them equal
            return one - other;
        }
        return Math.fma(px, qy, -one) - Math.fma(py, qx, -other);
    }

    @Override
    public Vector normal(Point p) {
        Vector out = new Vector();
        normal(p, out);
        return out;
    }

    @Override
    public void normal(Point p, Vector out) {
        double scale = scale();
        double ux = b.x * scale - a.x * scale;
        double uy = b.y * scale - a.y * scale;
        double uz = b.z * scale - a.z * scale;
        double vx = c.x * scale - a.x * scale;
        double vy = c.y * scale - a.y * scale;
        double vz = c.z * scale - a.z * scale;
        out.set(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
        out.normalise();
    }

    /** {@return a power of two to scale the vertices by, so that their products neither underflow nor overflow} */
    private double scale() {
        double largest = Math.max(largest(a), Math.max(largest(b), largest(c)));
        return Math.scalb(1.0, -Math.getExponent(largest));
    }

    private static double largest(Point p) {
        return Math.max(Math.abs(p.x), Math.max(Math.abs(p.y), Math.abs(p.z)));
    }

    private static Point scaled(Point p, double scale) {
        return new Point(p.x * scale, p.y * scale, p.z * scale);
    }

    /** {@return whether the vertices are on one line, up to the rounding of their decimals} */
    public boolean isFlat() {
        double scale = scale();
        Point[] v = {scaled(a, scale), scaled(b, scale), scaled(c, scale)};
        return isFlat(v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y)
            && isFlat(v[0].y, v[0].z, v[1].y, v[1].z, v[2].y, v[2].z)
            && isFlat(v[0].z, v[0].x, v[1].z, v[1].x, v[2].z, v[2].x);
    }

    /** {@return whether the area of a triangle in a plane is within rounding error} */
    private static boolean isFlat(double ax, double ay, double bx, double by, double cx, double cy) {
        double ux = bx - ax;
        double uy = by - ay;
        double vx = cx - ax;
        double vy = cy - ay;
        double doubt = sum(ax, bx) * Math.abs(vy) + Math.abs(ux) * sum(ay, cy) + sum(ay, by) * Math.abs(vx) + Math.abs(uy) * sum(ax, cx);
        return Math.abs(ux * vy - uy * vx) <= ROUNDING * doubt;
    }

    private static double sum(double x, double y) {
        return Math.abs(x) + Math.abs(y);
    }

    @Override
    public Bounds bounds() {
        return Bounds.of(a, b, c);
    }

    @Override
    public Object moved(Vector t) {
        Triangle moved = new Triangle(surfaceMaterial, Lengths.moved(a, t), Lengths.moved(b, t), Lengths.moved(c, t));
        if (moved.isFlat()) {
            throw new IllegalArgumentException(NOT_ON_ONE_LINE);
        }
        return moved;
    }

    @Override
    public void print(SceneWriter os) throws IOException {
        os.writeString("Triangle with vertices: ");
        a.print(os);
        os.writeString(", ");
        b.print(os);
        os.writeString(", ");
        c.print(os);
        os.writeNewline();
        surfaceMaterial.print(os);
    }

    @Override
    public void read(SceneReader is) throws IOException {
        is.group();
        a = Lengths.readPoint(is, "first vertex");
        b = Lengths.readPoint(is, "second vertex");
        c = Lengths.readPoint(is, "third vertex");
        if (isFlat()) {
            is.rejectGroup(NOT_ON_ONE_LINE);
        }
        Lengths.check(is, "vertices", a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
        readMaterial(is);
    }

    @Override
    public void write(SceneWriter os) throws IOException {
        a.write(os);
        os.writeString("  ");
        b.write(os);
        os.writeString("  ");
        c.write(os);
        os.writeString("  ");
        surfaceMaterial.write(os);
    }
}
