package simpleray.scene;

import java.io.IOException;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * A cylinder with flat ends, closed: all P not farther than R from a line through two points, and between the planes at right angles
 * to it there.
 */
public final class Cylinder extends Object {
    /** The first end of the axis, in the middle of a flat end. */
    public Point start;
    /** The second end of the axis, other than the first. */
    public Point end;
    /** The radius, above 0. */
    public double radius;

    /** Creates a cylinder of radius 1 that stands on the origin, 1 high, of the default material. */
    public Cylinder() {
        this(new Material(), new Point(), new Point(0, 1, 0), 1);
    }

    /**
     * Creates a cylinder. The values are referenced, not copied.
     *
     * @param n the material
     * @param p the first end of the axis
     * @param q the second end of the axis, other than the first
     * @param r the radius, above 0
     */
    public Cylinder(Material n, Point p, Point q, double r) {
        super(n);
        start = p;
        end = q;
        radius = r;
    }

    /**
     * {@inheritDoc} A ray that starts inside hits the far wall or end; one that grazes hits.
     *
     * <p>A closed cylinder is what an endless one and the slab between two planes have in common. A ray is within each of them from
     * one t to another, and so within both from the later beginning to the earlier end: there is no seam for it to slip through
     * (Kay and Kajiya, "Ray Tracing Complex Scenes", 1986, on convex bodies).
     */
    @Override
    public double intersect(Ray ray) {
        Vector axis = axis();
        Vector from = Vector.subtract(ray.origin, start);

        // the slab: how far the ray's origin is beyond either plane, and how fast it gets farther
        double rise = ray.direction.dot(axis);
        double low = from.dot(axis);
        double high = Vector.subtract(ray.origin, end).dot(axis);
        double near = Double.NEGATIVE_INFINITY;
        double far = Double.POSITIVE_INFINITY;
        if (rise != 0) {
            near = Math.min(-low / rise, -high / rise);
            far = Math.max(-low / rise, -high / rise);
        } else if (low < 0 || high > 0) {
            return MISS;
        }

        // the endless cylinder, |(F + D t) × A|² = R², the quadratic of Sphere in the plane across the axis
        from.cross(axis);
        Vector step = Vector.cross(ray.direction, axis);
        double a = step.squarednorm();
        double e = from.squarednorm() - radius * radius;
        if (a >= Double.MIN_NORMAL) {                         // else the ray runs along the axis
            double towards = -from.dot(step);
            double square = e < 0 ? towards * towards / a - e : radius * radius - closest(from, step, towards / a);
            if (!(square >= 0)) {
                return MISS;
            }
            double q = towards + Math.copySign(Math.sqrt(a * square), towards);
            near = Math.max(near, Math.min(e / q, q / a));
            far = Math.min(far, Math.max(e / q, q / a));
        } else if (e > 0) {
            return MISS;
        }

        if (!(near <= far)) {
            return MISS;
        }
        if (near > THRESHOLD) {
            return near;
        }
        return far > THRESHOLD ? far : MISS;
    }

    /** {@return the squared distance from the axis of a ray's point at t, the closest one} */
    private static double closest(Vector from, Vector step, double t) {
        double x = from.x + t * step.x;
        double y = from.y + t * step.y;
        double z = from.z + t * step.z;
        return x * x + y * y + z * z;
    }

    /** {@return the unit vector from the first end to the second} */
    private Vector axis() {
        Vector axis = Vector.subtract(end, start);
        axis.normalise();
        return axis;
    }

    /** {@inheritDoc} On the rim it is the one of the side or of the end, whichever the point is farther beyond. */
    @Override
    public Vector normal(Point p) {
        Vector axis = axis();
        Vector out = Vector.subtract(p, start);
        double low = out.dot(axis);
        double high = Vector.subtract(p, end).dot(axis);
        out.subtract(Vector.scale(axis, low));
        double beyondSide = out.norm() - radius;
        double beyondEnd = Math.max(-low, high);
        if (beyondSide >= beyondEnd) {
            out.normalise();
            return out;
        }
        return high > -low ? axis : Vector.negate(axis);
    }

    @Override
    public Bounds bounds() {
        Vector axis = axis();
        double x = radius * Math.hypot(axis.y, axis.z);       // √(1 - a²) of each component a of the axis
        double y = radius * Math.hypot(axis.z, axis.x);
        double z = radius * Math.hypot(axis.x, axis.y);
        return Bounds.of(new Point(start.x - x, start.y - y, start.z - z), new Point(start.x + x, start.y + y, start.z + z),
            new Point(end.x - x, end.y - y, end.z - z), new Point(end.x + x, end.y + y, end.z + z));
    }

    @Override
    public void writePov(SceneWriter os) throws IOException {
        os.writeString("cylinder { ");
        Pov.vector(os, start.x, start.y, start.z);
        os.writeString(", ");
        Pov.vector(os, end.x, end.y, end.z);
        os.writeString(", ");
        os.writeDouble(radius);
    }

    @Override
    public boolean isSolid() {
        return true;
    }

    @Override
    public void print(SceneWriter os) throws IOException {
        os.writeString("Cylinder with ends: ");
        start.print(os);
        os.writeString(" and ");
        end.print(os);
        os.writeString(" and radius: ");
        os.writeDouble(radius);
        os.writeNewline();
        surfaceMaterial.print(os);
    }

    @Override
    public void read(SceneReader is) throws IOException {
        is.group();
        start = readEnd(is, "first end");
        end = readEnd(is, "second end");
        if (start.equals(end)) {
            is.rejectGroup("two ends that differ");
        }
        Lengths.check(is, "ends", start.x, start.y, start.z, end.x, end.y, end.z);
        radius = is.readDouble("radius");
        Lengths.checkRadius(is, radius);
        readMaterial(is);
    }

    private static Point readEnd(SceneReader is, String name) throws IOException {
        Point point = new Point();
        is.enter(name);
        point.read(is);
        is.leave();
        return point;
    }

    @Override
    public void write(SceneWriter os) throws IOException {
        start.write(os);
        os.writeString("  ");
        end.write(os);
        os.writeString("  ");
        os.writeDouble(radius);
        os.writeString("  ");
        surfaceMaterial.write(os);
    }
}
