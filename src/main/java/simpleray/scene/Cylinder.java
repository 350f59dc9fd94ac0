package simpleray.scene;

import java.io.IOException;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * A closed cylinder with flat ends: all P within R of a line through two points, and between the planes perpendicular to it
 * there.
 */
public final class Cylinder extends Object {
    private static final String ENDS_DIFFER = "two ends that differ";

    /** The first end of the axis, in the middle of a flat end. */
    public Point start;
    /** The second end of the axis, other than the first. */
    public Point end;
    /** The radius, above 0. */
    public double radius;

    /** Creates a cylinder of radius 1 and height 1 that stands on the origin, of the default material. */
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
     * <p>A closed cylinder is the intersection of an endless one and the slab between two planes. A ray is within each of them from
     * one t to another, and so within both from the later start to the earlier end: there is no seam for it to slip through
     * (Kay and Kajiya, "Ray Tracing Complex Scenes", 1986, on convex bodies).
     */
    @Override
    public double intersect(Ray ray) {
        double ax = end.x - start.x;
        double ay = end.y - start.y;
        double az = end.z - start.z;
        double square = ax * ax + ay * ay + az * az;
        if (Vector.isPlain(square)) {
            double length = Math.sqrt(square);
            return hit(ray, ax / length, ay / length, az / length);
        }
        Vector axis = axis();
        return hit(ray, axis.x, axis.y, axis.z);
    }

    /** {@return t of the hit, or MISS} A is the unit vector from the first end to the second; no vector is allocated. */
    private double hit(Ray ray, double ax, double ay, double az) {
        Point o = ray.origin;
        Vector d = ray.direction;
        double fx = o.x - start.x;
        double fy = o.y - start.y;
        double fz = o.z - start.z;

        // the slab: the distances of the ray's origin beyond the planes, and the ray's speed across them
        double rise = d.x * ax + d.y * ay + d.z * az;
        double low = fx * ax + fy * ay + fz * az;
        double high = (o.x - end.x) * ax + (o.y - end.y) * ay + (o.z - end.z) * az;
        double near = Double.NEGATIVE_INFINITY;
        double far = Double.POSITIVE_INFINITY;
        if (rise != 0) {
            near = Math.min(-low / rise, -high / rise);
            far = Math.max(-low / rise, -high / rise);
        } else if (low < 0 || high > 0) {
            return MISS;
        }

        // the endless cylinder, |(F + D t) × A|² = R², the quadratic of Sphere in the plane across the axis: F × A and D × A are
        double px = fy * az - fz * ay;
        double py = fz * ax - fx * az;
        double pz = fx * ay - fy * ax;
        double sx = d.y * az - d.z * ay;
        double sy = d.z * ax - d.x * az;
        double sz = d.x * ay - d.y * ax;
        double a = sx * sx + sy * sy + sz * sz;
        double e = px * px + py * py + pz * pz - radius * radius;
        if (a >= Double.MIN_NORMAL) {                         // else the ray is parallel to the axis
            double towards = -(px * sx + py * sy + pz * sz);
            double closest = towards / a;                     // t of the point closest to the axis
            double lx = px + closest * sx;
            double ly = py + closest * sy;
            double lz = pz + closest * sz;
            double square = e < 0 ? towards * towards / a - e : radius * radius - (lx * lx + ly * ly + lz * lz);
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

    /** {@return the unit vector from the first end to the second} */
    private Vector axis() {
        Vector axis = Vector.subtract(end, start);
        axis.normalise();
        return axis;
    }

    @Override
    public Vector normal(Point p) {
        Vector out = new Vector();
        normal(p, out);
        return out;
    }

    /** {@inheritDoc} On the rim it is that of the side or of the end, whichever the point is farther beyond. */
    @Override
    public void normal(Point p, Vector out) {
        Vector.subtract(out, end, start);
        out.normalise();
        double ax = out.x;
        double ay = out.y;
        double az = out.z;
        Vector.subtract(out, p, start);
        double low = out.x * ax + out.y * ay + out.z * az;
        double high = (p.x - end.x) * ax + (p.y - end.y) * ay + (p.z - end.z) * az;
        out.set(out.x - ax * low, out.y - ay * low, out.z - az * low);
        double beyondSide = out.norm() - radius;
        double beyondEnd = Math.max(-low, high);
        if (beyondSide >= beyondEnd) {
            out.normalise();
        } else if (high > -low) {
            out.set(ax, ay, az);
        } else {
            out.set(-ax, -ay, -az);
        }
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
    public boolean isSolid() {
        return true;
    }

    @Override
    public Object moved(Vector t) {
        Cylinder moved = new Cylinder(surfaceMaterial, Lengths.moved(start, t), Lengths.moved(end, t), radius);
        if (moved.start.equals(moved.end)) {
            throw new IllegalArgumentException(ENDS_DIFFER);
        }
        return moved;
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
        start = Lengths.readPoint(is, "first end");
        end = Lengths.readPoint(is, "second end");
        if (start.equals(end)) {
            is.rejectGroup(ENDS_DIFFER);
        }
        Lengths.check(is, "ends", start.x, start.y, start.z, end.x, end.y, end.z);
        radius = is.readDouble("radius");
        Lengths.checkRadius(is, radius);
        readMaterial(is);
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
