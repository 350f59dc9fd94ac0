package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Many random points and rays at cylinders that are stout, long, flat, small and large, in any direction. */
class CylinderSurfaceTest {
    private static final long SEED = 19860818;
    private static final int CYLINDERS = 100;
    /** How far from the surface a hit may be, in sizes of what the ray crosses. */
    private static final double NEAR = 1e-14;

    private final Random random = new Random(SEED);

    /** Two unit vectors at right angles to the axis and each other. */
    private Vector across;
    private Vector other;

    @ParameterizedTest
    @CsvSource({"1, 1", "1000, 0.01", "0.001, 1", "1e5, 1e-4", "1e-3, 1e-3", "1e4, 1e4"})
    void noRaySlipsBetweenTheSideAndAnEnd(double length, double radius) {
        int slipped = 0;
        for (int i = 0; i < CYLINDERS; i++) {
            Cylinder cylinder = random(length, radius);
            for (int k = 0; k < 200; k++) {
                Point rim = at(cylinder, random.nextInt(2), 1);
                Vector direction = Vector.subtract(at(cylinder, 0.2 + 0.6 * random.nextDouble(), 0.8 * random.nextDouble()), rim);
                direction.scale(k % 2 == 0 ? 1 : 1 / direction.norm());
                double back = (0.1 + 20 * random.nextDouble()) * (length + radius) / direction.norm();
                Ray ray = new Ray(Point.add(rim, Vector.scale(direction, -back)), direction);
                double t = cylinder.intersect(ray);
                slipped += isHitOf(cylinder, ray, t, 20 * (length + radius)) && cylinder.intersect(through(ray, t)) >= 0 ? 0 : 1;
            }
        }
        assertThat(slipped).as("rays that slip through the rim, seed " + SEED).isZero();
    }

    /** {@return the ray from a little behind the hit, where the way through the inside goes on} */
    private static Ray through(Ray ray, double t) {
        return new Ray(ray.getPointAt(t * (1 - 1e-9)), ray.direction);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1000, 0.01", "0.01, 1", "1e5, 1e-2", "1e-2, 1e-2", "1e4, 1e4"})
    void noRayEscapesFromInside(double length, double radius) {
        int escaped = 0;
        for (int i = 0; i < CYLINDERS; i++) {
            Cylinder cylinder = random(length, radius);
            for (int k = 0; k < 200; k++) {
                Vector direction = k % 10 == 0 ? Vector.subtract(cylinder.end, cylinder.start)
                    : k % 10 == 1 ? new Vector(across) : new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
                direction.normalise();
                direction.scale(0.1 + random.nextDouble());
                Point inside = at(cylinder, 0.001 + 0.998 * random.nextDouble(), 0.999 * random.nextDouble());
                Ray ray = new Ray(inside, direction);
                escaped += isHitOf(cylinder, ray, cylinder.intersect(ray), length + radius) ? 0 : 1;
            }
        }
        assertThat(escaped).as("rays that escape, seed " + SEED).isZero();
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1000, 0.01", "0.001, 1"})
    void theNormalIsThatOfTheSurfaceEverywhere(double length, double radius) {
        for (int i = 0; i < CYLINDERS; i++) {
            Cylinder cylinder = random(length, radius);
            double turn = random.nextDouble() * 2 * Math.PI;
            double share = i % 2 == 0 ? random.nextDouble() : 1 - 1e-7;      // half of them next to the rim
            Vector out = out(turn);
            Vector axis = Vector.subtract(cylinder.end, cylinder.start).normalised();
            assertClose(cylinder.normal(at(cylinder, share, 1, turn)), out);
            assertClose(cylinder.normal(at(cylinder, 1 - share, 1, turn)), out);
            assertClose(cylinder.normal(at(cylinder, 1, share, turn)), axis);
            assertClose(cylinder.normal(at(cylinder, 0, share, turn)), Vector.negate(axis));
        }
    }

    private static void assertClose(Vector actual, Vector expected) {
        Vector difference = new Vector(actual);
        difference.subtract(expected);
        assertThat(difference.norm()).as(actual + " is not " + expected + ", seed " + SEED).isLessThan(1e-9);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1000, 0.01", "0.001, 1"})
    void theBoundsHoldTheSurfaceAndNoMore(double length, double radius) {
        double rounding = 1e-15 * (length + radius + 10);
        for (int i = 0; i < 10; i++) {
            Cylinder cylinder = random(length, radius);
            Bounds box = cylinder.bounds();
            Bounds reached = null;
            for (int k = 0; k < 1000; k++) {
                Point p = at(cylinder, random.nextInt(2), 1, k * 2 * Math.PI / 1000);
                Point q = at(cylinder, random.nextDouble(), random.nextDouble());
                for (Point each : new Point[] {p, q}) {
                    assertThat(box.xmin() - each.x).isLessThan(rounding);
                    assertThat(box.ymin() - each.y).isLessThan(rounding);
                    assertThat(box.zmin() - each.z).isLessThan(rounding);
                    assertThat(each.x - box.xmax()).isLessThan(rounding);
                    assertThat(each.y - box.ymax()).isLessThan(rounding);
                    assertThat(each.z - box.zmax()).isLessThan(rounding);
                }
                Bounds both = Bounds.of(at(cylinder, 0, 1, k * 2 * Math.PI / 1000), at(cylinder, 1, 1, k * 2 * Math.PI / 1000));
                reached = reached == null ? both : reached.with(both);
            }
            // of 1000 points of a circle one is within 2π/2000 of the outermost: 1 - cos of that is 5e-6
            double tight = 1e-5 * radius;
            assertThat(reached.xmin() - box.xmin()).isLessThan(tight);
            assertThat(reached.ymin() - box.ymin()).isLessThan(tight);
            assertThat(reached.zmin() - box.zmin()).isLessThan(tight);
            assertThat(box.xmax() - reached.xmax()).isLessThan(tight);
            assertThat(box.ymax() - reached.ymax()).isLessThan(tight);
            assertThat(box.zmax() - reached.zmax()).isLessThan(tight);
        }
    }

    /** Tells whether the ray's point at t is on the surface, as measured from scratch. */
    private static boolean isHitOf(Cylinder cylinder, Ray ray, double t, double size) {
        Point p = ray.getPointAt(t);
        Vector axis = Vector.subtract(cylinder.end, cylinder.start).normalised();
        Vector start = Vector.subtract(p, cylinder.start);
        double beyondEnd = Math.max(-start.dot(axis), Vector.subtract(p, cylinder.end).dot(axis));
        double beyondSide = Vector.cross(start, axis).norm() - cylinder.radius;
        return t > Object.THRESHOLD && Math.abs(Math.max(beyondEnd, beyondSide)) < NEAR * (size + 10);
    }

    /** {@return a cylinder in a random direction, at times along an axis, within a few units of the origin} */
    private Cylinder random(double length, double radius) {
        Vector axis = switch (random.nextInt(6)) {
            case 0 -> new Vector(1, 0, 0);
            case 1 -> new Vector(0, -1, 0);
            case 2 -> new Vector(0, 0, 1);
            default -> new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalised();
        };
        across = Vector.cross(axis, Math.abs(axis.x) < 0.6 ? new Vector(1, 0, 0) : new Vector(0, 1, 0)).normalised();
        other = Vector.cross(axis, across);
        Point start = new Point(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
        return new Cylinder(new Material(), start, Point.add(start, Vector.scale(axis, length)), radius);
    }

    private Point at(Cylinder cylinder, double height, double out) {
        return at(cylinder, height, out, random.nextDouble() * 2 * Math.PI);
    }

    /** {@return the point at this share of the length and of the radius} */
    private Point at(Cylinder cylinder, double height, double out, double turn) {
        Vector along = Vector.subtract(cylinder.end, cylinder.start);
        along.scale(height);
        along.add(Vector.scale(out(turn), out * cylinder.radius));
        return Point.add(cylinder.start, along);
    }

    private Vector out(double turn) {
        return Vector.add(Vector.scale(across, Math.cos(turn)), Vector.scale(other, Math.sin(turn)));
    }
}
