package simpleray.scene;

import java.io.IOException;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * The side of a truncated cone, open at both ends: all P between the planes perpendicular to an axis at its ends, at a distance from the
 * axis that goes evenly from one radius to the other. Equal radii make an open cylinder, a radius of 0 an apex.
 */
public final class Cone extends Object {
    /** An upper bound of the rounding errors of a hit's place, as a share of the numbers it is computed from. */
    private static final double ROUNDINGS = 0x1p-48;
    /** The most by which the side goes on beyond its rims, as a share of its size; far less than the padding of a tree's box. */
    private static final double MAX_SLACK = 0x1p-24;
    private static final String ENDS_DIFFER = "second end that differs from the first";

    /** The first end of the axis. */
    public Point start;
    /** The second end of the axis, other than the first. */
    public Point end;
    /** The radius at the first end, 0 or more. */
    public double startRadius;
    /** The radius at the second end, 0 or more; not both are 0. */
    public double endRadius;

    /** Creates a cone of radius 1 and height 1 that stands on the origin, its apex up, of the default material. */
    public Cone() {
        this(new Material(), new Point(), 1, new Point(0, 1, 0), 0);
    }

    /**
     * Creates a cone. The values are referenced, not copied.
     *
     * @param n the material
     * @param p the first end of the axis
     * @param atP the radius there, 0 or more
     * @param q the second end of the axis, other than the first
     * @param atQ the radius there, 0 or more; not both are 0
     */
    public Cone(Material n, Point p, double atP, Point q, double atQ) {
        super(n);
        start = p;
        startRadius = atP;
        end = q;
        endRadius = atQ;
    }

    /**
     * {@inheritDoc} A ray that starts inside hits the far side; one that grazes hits; one that runs along the side, in it, misses.
     *
     * <p>The side goes on beyond its rims by more than all rounding errors, so that no ray slips between a cone and a shape that ends at
     * its rim.
     */
    @Override
    public double intersect(Ray ray) {
        double ax = end.x - start.x;
        double ay = end.y - start.y;
        double az = end.z - start.z;
        double square = ax * ax + ay * ay + az * az;
        if (Vector.isPlain(square)) {
            double length = Math.sqrt(square);
            return hit(ray, ax / length, ay / length, az / length, length);
        }
        Vector axis = Vector.subtract(end, start);
        double length = axis.measureAndNormalise();
        return hit(ray, axis.x, axis.y, axis.z, length);
    }

    /**
     * {@return t of the hit, or MISS} A is the unit vector from the first end to the second; no vector is allocated.
     *
     * <p>With h the height along the axis, r the first radius, and cos and sin of the angle between axis and side, the cone is
     * |P × A| cos = r cos + h sin; squared, a quadratic in t. So that no digits are lost, t counts from where the ray comes closest to the
     * axis between the ends, and Lagrange's identity makes the discriminant a difference of two squares: seen from inside, there is no
     * gap at the apex.
     */
    private double hit(Ray ray, double ax, double ay, double az, double length) {
        double slant = slant(length);
        double cos = length / slant;
        double sin = (endRadius - startRadius) / slant;
        Point o = ray.origin;
        Vector d = ray.direction;
        double fx = o.x - start.x;
        double fy = o.y - start.y;
        double fz = o.z - start.z;
        double rise = d.x * ax + d.y * ay + d.z * az;
        double height = fx * ax + fy * ay + fz * az;

        // across the axis: F × A and D × A
        double px = fy * az - fz * ay;
        double py = fz * ax - fx * az;
        double pz = fx * ay - fy * ax;
        double sx = d.y * az - d.z * ay;
        double sy = d.z * ax - d.x * az;
        double sz = d.x * ay - d.y * ax;
        double ss = sx * sx + sy * sy + sz * sz;
        double from = -(px * sx + py * sy + pz * sz) / ss;    // NaN or infinite for a ray parallel to the axis
        if (rise != 0) {
            double low = -height / rise;
            double high = ((end.x - o.x) * ax + (end.y - o.y) * ay + (end.z - o.z) * az) / rise;
            double near = Math.min(low, high);
            from = from > near ? Math.min(from, Math.max(low, high)) : near;
        }
        px += from * sx;
        py += from * sy;
        pz += from * sz;
        height += from * rise;

        double square = cos * cos;
        double radius = startRadius * cos + height * sin;
        double growth = rise * sin;
        double a = square * ss - growth * growth;
        double b = square * (px * sx + py * sy + pz * sz) - radius * growth;
        double e = square * (px * px + py * py + pz * pz) - radius * radius;
        double wx = radius * sx - growth * px;
        double wy = radius * sy - growth * py;
        double wz = radius * sz - growth * pz;
        double cx = py * sz - pz * sy;
        double cy = pz * sx - px * sz;
        double cz = px * sy - py * sx;
        double discriminant = wx * wx + wy * wy + wz * wz - square * (cx * cx + cy * cy + cz * cz);
        if (!(discriminant >= 0)) {
            return MISS;
        }
        double root = Math.sqrt(discriminant);
        double q = -(b + Math.copySign(cos * root, b));
        double largest = Math.max(startRadius, endRadius);
        // the lower the ray's angle and the flatter the cone, the farther along the side does a rounding move the hit and the rim
        double times = Math.max(1, largest * Math.sqrt(ss + rise * rise) / root) * Math.max(1, largest / length);
        double rounding = ROUNDINGS * (Math.abs(fx) + Math.abs(fy) + Math.abs(fz) + length + largest);
        double slack = Math.min(rounding * times, MAX_SLACK * (length + largest));
        double hit = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 2; i++) {
            double t = i == 0 ? q / a : e / q;                // infinite or NaN if there is none
            double h = height + t * rise;
            double x = px + t * sx;
            double y = py + t * sy;
            double z = pz + t * sz;
            double along = h * cos + (Math.sqrt(x * x + y * y + z * z) - startRadius) * sin;
            boolean onSide = along >= -slack && along <= slant + slack && startRadius * cos + h * sin >= -rounding;
            if (onSide && from + t > THRESHOLD) {
                hit = Math.min(hit, from + t);
            }
        }
        return hit < Double.POSITIVE_INFINITY ? hit : MISS;
    }

    /** {@return the length of the side from rim to rim} */
    private double slant(double length) {
        double widening = endRadius - startRadius;
        double square = length * length + widening * widening;
        return Vector.isPlain(square) ? Math.sqrt(square) : Math.hypot(length, widening);
    }

    @Override
    public Vector normal(Point p) {
        Vector out = new Vector();
        normal(p, out);
        return out;
    }

    /** {@inheritDoc} Away from the axis; at an apex it is the direction of the axis towards it. */
    @Override
    public void normal(Point p, Vector out) {
        Vector.subtract(out, end, start);
        double length = out.measureAndNormalise();
        double ax = out.x;
        double ay = out.y;
        double az = out.z;
        double slant = slant(length);
        double cos = length / slant;
        double sin = (endRadius - startRadius) / slant;
        Vector.subtract(out, p, start);
        double height = out.x * ax + out.y * ay + out.z * az;
        out.set(out.x - ax * height, out.y - ay * height, out.z - az * height);
        double size = Math.max(Math.abs(p.x), Math.max(Math.abs(p.y), Math.abs(p.z))) + length + Math.max(startRadius, endRadius);
        if (sin != 0 && out.norm() <= ROUNDINGS * size) {
            double towards = -Math.signum(sin);
            out.set(towards * ax, towards * ay, towards * az);
        } else {
            out.normalise();
            out.set(out.x * cos - ax * sin, out.y * cos - ay * sin, out.z * cos - az * sin);
        }
    }

    @Override
    public Bounds bounds() {
        Vector axis = Vector.subtract(end, start);
        axis.normalise();
        double x = Math.hypot(axis.y, axis.z);                // √(1 - a²) of each component a of the axis
        double y = Math.hypot(axis.z, axis.x);
        double z = Math.hypot(axis.x, axis.y);
        return disc(start, startRadius, x, y, z).with(disc(end, endRadius, x, y, z));
    }

    private static Bounds disc(Point middle, double radius, double x, double y, double z) {
        return new Bounds(middle.x - radius * x, middle.y - radius * y, middle.z - radius * z,
            middle.x + radius * x, middle.y + radius * y, middle.z + radius * z);
    }

    @Override
    public Object moved(Vector t) {
        Cone moved = new Cone(surfaceMaterial, Lengths.moved(start, t), startRadius, Lengths.moved(end, t), endRadius);
        if (moved.start.equals(moved.end)) {
            throw new IllegalArgumentException(ENDS_DIFFER);
        }
        return moved;
    }

    @Override
    public void print(SceneWriter os) throws IOException {
        os.writeString("Cone with ends: ");
        start.print(os);
        os.writeString(" and ");
        end.print(os);
        os.writeString(" and radii: ");
        os.writeDouble(startRadius);
        os.writeString(" and ");
        os.writeDouble(endRadius);
        os.writeNewline();
        surfaceMaterial.print(os);
    }

    @Override
    public void read(SceneReader is) throws IOException {
        start = readEnd(is, "first end");
        startRadius = readRadius(is, "first radius");
        end = readEnd(is, "second end");
        if (start.equals(end)) {
            is.rejectGroup(ENDS_DIFFER);
        }
        endRadius = readRadius(is, "second radius");
        if (startRadius == 0 && endRadius == 0) {
            is.reject("second radius above 0, since the first is 0");
        }
        readMaterial(is);
    }

    private static Point readEnd(SceneReader is, String name) throws IOException {
        is.group();
        Point point = Lengths.readPoint(is, name);
        Lengths.check(is, name, point.x, point.y, point.z);
        return point;
    }

    private static double readRadius(SceneReader is, String name) throws IOException {
        double radius = is.readDouble(name);
        if (radius < 0) {
            is.reject(name + " of 0 or more");
        } else if (radius > Lengths.MAX) {
            is.reject(name + " of 1e100 or less");
        }
        return radius;
    }

    @Override
    public void write(SceneWriter os) throws IOException {
        start.write(os);
        os.writeDouble(startRadius);
        os.writeString("  ");
        end.write(os);
        os.writeDouble(endRadius);
        os.writeString("  ");
        surfaceMaterial.write(os);
    }
}
