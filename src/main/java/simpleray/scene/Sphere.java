package simpleray.scene;

import java.io.IOException;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** A sphere, (P - C)·(P - C) = R² (thesis, chapters 3 and 5). */
public final class Sphere extends Object {
    /** An upper bound of the rounding error of a squared distance, as a share of it. */
    private static final double ROUNDING = 0x1p-46;

    /** The centre. */
    public Point centre;
    /** The radius, above 0. */
    public double radius;

    /** Creates a sphere of radius 1 about the origin, of the default material. */
    public Sphere() {
        this(new Material(), new Point(), 1);
    }

    /**
     * Creates a sphere. The values are referenced, not copied.
     *
     * @param n the material
     * @param p the centre
     * @param r the radius, above 0
     */
    public Sphere(Material n, Point p, double r) {
        super(n);
        centre = p;
        radius = r;
    }

    /**
     * {@inheritDoc} A ray that starts inside hits the far side; one that grazes hits.
     *
     * <p>The thesis's quadratic a t² + b t + e = 0, in the arrangement that keeps its digits for small and far spheres (Haines,
     * Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019).
     */
    @Override
    public double intersect(Ray ray) {
        Vector d = ray.direction;
        Point o = ray.origin;
        return hit(o.x - centre.x, o.y - centre.y, o.z - centre.z, d.x, d.y, d.z, radius);
    }

    /**
     * Returns the nearest hit of a ray on a sphere, like {@link #intersect}, with all numbers as arguments for spheres kept in arrays.
     *
     * @param fx x of the ray's origin, relative to the centre
     * @param fy y of it
     * @param fz z of it
     * @param dx x of the ray's direction
     * @param dy y of it
     * @param dz z of it
     * @param radius the radius
     * @return t of the hit, or {@link #MISS}
     */
    public static double hit(double fx, double fy, double fz, double dx, double dy, double dz, double radius) {
        double a = dx * dx + dy * dy + dz * dz;
        double towards = -(fx * dx + fy * dy + fz * dz);      // -b/2
        double ff = fx * fx + fy * fy + fz * fz;
        double e = ff - radius * radius;
        // Most rays miss clearly: away from the sphere, or so far beside it that no rounding error below makes it a hit.
        if (towards < 0 && e >= 0 || towards * towards < a * (e - ROUNDING * ff)) {
            return MISS;
        }
        double closest = towards / a;                         // t of the point closest to the centre
        double lx = fx + closest * dx;
        double ly = fy + closest * dy;
        double lz = fz + closest * dz;
        double square = radius * radius - (lx * lx + ly * ly + lz * lz);
        if (!(square >= 0)) {
            return MISS;
        }
        double q = towards + Math.copySign(Math.sqrt(a * square), towards);
        double one = e / q;
        double other = q / a;
        double near = other < one ? other : one;              // NaN if one is NaN: no hit
        if (near > THRESHOLD) {
            return near;
        }
        double far = other > one ? other : one;
        return far > THRESHOLD ? far : MISS;
    }

    @Override
    public Vector normal(Point p) {
        Vector out = new Vector();
        normal(p, out);
        return out;
    }

    @Override
    public void normal(Point p, Vector out) {
        Vector.subtract(out, p, centre);
        out.normalise();
    }

    @Override
    public Bounds bounds() {
        return new Bounds(centre.x - radius, centre.y - radius, centre.z - radius,
            centre.x + radius, centre.y + radius, centre.z + radius);
    }

    @Override
    public boolean isSolid() {
        return true;
    }

    @Override
    public Object moved(Vector t) {
        return new Sphere(surfaceMaterial, Lengths.moved(centre, t), radius);
    }

    @Override
    public void print(SceneWriter os) throws IOException {
        os.writeString("Sphere with centre: ");
        centre.print(os);
        os.writeString(" and radius: ");
        os.writeDouble(radius);
        os.writeNewline();
        surfaceMaterial.print(os);
    }

    @Override
    public void read(SceneReader is) throws IOException {
        is.group();
        centre = Lengths.readPoint(is, "centre");
        Lengths.check(is, "centre", centre.x, centre.y, centre.z);
        radius = is.readDouble("radius");
        Lengths.checkRadius(is, radius);
        readMaterial(is);
    }

    @Override
    public void write(SceneWriter os) throws IOException {
        centre.write(os);
        os.writeDouble(radius);
        os.writeString("  ");
        surfaceMaterial.write(os);
    }
}
