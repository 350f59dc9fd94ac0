package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.Sample;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Many random points and rays at cones that are stout, long, flat, sharp, small and large, in any direction. */
class ConeSurfaceTest {
    private static final long SEED = 19860818;
    private static final int CONES = Sample.size(100, 20);
    /** How far from the surface a hit may be, in sizes of what the ray crosses. */
    private static final double NEAR = 1e-14;
    /** Between these many places along a ray the independent test looks for the surface. */
    private static final int STEPS = 1500;

    private final Random random = new Random(SEED);

    /** Two unit vectors at right angles to the axis and each other, and the axis. */
    private Vector across;
    private Vector other;
    private Vector along;

    /** The nearest change of sign of the distance to the side, looked for step by step along the ray and then by halving, is the hit. */
    @ParameterizedTest
    @CsvSource({"1, 1, 0", "1, 0, 1", "2, 1, 0.4", "0.5, 1, 1", "4, 0.2, 0.3", "0.2, 0.3, 1"})
    void aHitIsWhereTheRayComesThroughTheSide(double length, double first, double second) {
        int hits = 0;
        for (int i = 0; i < CONES; i++) {
            Cone cone = random(length, first, second);
            for (int k = 0; k < 20; k++) {
                Point from = Point.add(at(cone, random.nextDouble(), 0, 0), Vector.scale(direction(), 4 * random.nextDouble()));
                Point to = at(cone, 1.4 * random.nextDouble() - 0.2, 1.1 * random.nextDouble(), 2 * Math.PI * random.nextDouble());
                Vector d = Vector.subtract(to, from);
                d.scale((0.3 + random.nextDouble()) / d.norm());
                Ray ray = new Ray(from, d);
                double expected = found(cone, ray, 12 / d.norm());
                double t = cone.intersect(ray);
                if (!isDoubtful(cone, ray, t) && !isDoubtful(cone, ray, expected)) {
                    hits += t >= 0 ? 1 : 0;
                    assertThat(t).as("cone %d, ray %d, seed %d", i, k, SEED).isCloseTo(expected, within(1e-9));
                }
            }
        }
        assertThat(hits).isGreaterThan(5 * CONES);
    }

    /** {@return t of the first place where the ray passes the side between the ends, -1 if there is none} */
    private static double found(Cone cone, Ray ray, double reach) {
        double step = reach / STEPS;
        for (int i = 0; i < STEPS; i++) {
            double a = i * step;
            double b = a + step;
            double before = beyond(cone, ray.getPointAt(a));
            double after = beyond(cone, ray.getPointAt(b));
            if (before > 0 == after > 0) {
                continue;
            }
            for (int k = 0; k < 60; k++) {
                double middle = (a + b) / 2;
                if (beyond(cone, ray.getPointAt(middle)) > 0 == before > 0) {
                    a = middle;
                } else {
                    b = middle;
                }
            }
            if (isBetween(cone, ray.getPointAt(a), 0)) {
                return a;
            }
        }
        return -1;
    }

    /** {@return whether the hit is so near a rim or apex, or at so low an angle, that both sides may lie within a step} */
    private static boolean isDoubtful(Cone cone, Ray ray, double t) {
        return t >= 0 && (!isBetween(cone, ray.getPointAt(t), -0.03)
            || Math.abs(cone.normal(ray.getPointAt(t)).dot(ray.direction)) < 0.03 * ray.direction.norm());
    }

    /** {@return how far a point is beyond the side, across the axis; below 0 inside} */
    private static double beyond(Cone cone, Point p) {
        Vector axis = Vector.subtract(cone.end, cone.start);
        double share = Vector.subtract(p, cone.start).dot(axis) / axis.squarednorm();
        Point foot = Point.add(cone.start, Vector.scale(axis, share));
        return Vector.subtract(p, foot).norm() - (cone.startRadius + share * (cone.endRadius - cone.startRadius));
    }

    private static boolean isBetween(Cone cone, Point p, double more) {
        Vector axis = Vector.subtract(cone.end, cone.start);
        double share = Vector.subtract(p, cone.start).dot(axis) / axis.squarednorm();
        return share >= -more && share <= 1 + more;
    }

    /** A cone on a cylinder of the same rim, the cylinder closed there; and another cone on its other rim. */
    @ParameterizedTest
    @CsvSource({"1, 1, 0.5", "1, 1, 0", "0.1, 1, 0.2", "0.001, 1, 0.5", "5, 0.01, 0.02", "1e4, 1e4, 1", "1e-2, 1e-2, 3e-2", "1, 1, 1"})
    void noRaySlipsBetweenAConeAndWhatEndsAtItsRim(double length, double rim, double far) {
        int slipped = 0;
        double size = length + rim + far;
        for (int i = 0; i < CONES; i++) {
            Cone cone = random(length, rim, far);
            Point below = Point.add(cone.start, Vector.scale(along, -1.3 * size));
            Cylinder cylinder = new Cylinder(new Material(), cone.start, below, rim);
            Cone second = new Cone(new Material(), below, 0, cone.start, rim);
            for (int k = 0; k < 100; k++) {
                Point at = at(cone, 0, 1, random.nextDouble() * 2 * Math.PI);
                double low = 0.8 * random.nextDouble();          // the target lies in the cone or below it
                Point target = k % 4 < 2 ? at(cone, 0.05 + low, 0.8 * random.nextDouble(), random.nextDouble() * 7)
                    : at(second, 0.15 + low, 0.8 * random.nextDouble(), random.nextDouble() * 7);
                Vector d = Vector.subtract(target, at);
                d.scale(k % 2 == 0 ? 1 / d.norm() : 1);
                Point from = Point.add(at, Vector.scale(d, -(0.1 + 20 * random.nextDouble()) * size / d.norm()));
                Ray ray = new Ray(from, d);
                double t = Vector.subtract(at, from).norm() / d.norm();
                slipped += isHitNear(t, cone.intersect(ray), cylinder.intersect(ray)) ? 0 : 1;
                slipped += isHitNear(t, cone.intersect(ray), second.intersect(ray)) ? 0 : 1;
            }
        }
        assertThat(slipped).as("rays that slip through the rim, seed " + SEED).isZero();
    }

    private static boolean isHitNear(double t, double... hits) {
        for (double hit : hits) {
            if (hit >= 0 && hit < t * (1 + 1e-6)) {
                return true;
            }
        }
        return false;
    }

    /** A double cone is closed. */
    @ParameterizedTest
    @CsvSource({"1, 1", "1000, 0.01", "0.01, 1", "1e-2, 1e-2", "1e4, 1e4"})
    void noRayEscapesFromInside(double length, double radius) {
        int escaped = 0;
        for (int i = 0; i < CONES; i++) {
            Cone up = random(length, radius, 0);
            Point tip = Point.add(up.start, Vector.scale(along, -0.7 * length));
            Cone down = new Cone(new Material(), tip, 0, up.start, radius);
            for (int k = 0; k < 200; k++) {
                Point inside = at(up, 0.9 * random.nextDouble(), 0.99 * random.nextDouble(), 7 * random.nextDouble());
                Vector d = switch (k % 8) {
                    case 0 -> new Vector(along);
                    case 1 -> out(random.nextDouble() * 7);
                    case 2 -> Vector.subtract(up.end, inside);
                    case 3 -> Vector.subtract(tip, inside);
                    case 4 -> Vector.subtract(at(up, 0, 1, 7 * random.nextDouble()), inside);
                    default -> direction();
                };
                d.scale(0.1 + random.nextDouble());
                Ray ray = new Ray(inside, d);
                double t = Math.max(up.intersect(ray), down.intersect(ray));
                Cone hit = up.intersect(ray) >= 0 ? up : down;
                double off = Math.abs(beyond(hit, ray.getPointAt(hit.intersect(ray))));
                escaped += t > Object.THRESHOLD && off < NEAR * (length + radius + 10) * steep(up) ? 0 : 1;
            }
        }
        assertThat(escaped).as("rays that escape, seed " + SEED).isZero();
    }

    /** {@return how much a distance across the axis may exceed that to the side} */
    private static double steep(Cone cone) {
        double length = Vector.subtract(cone.end, cone.start).norm();
        return Math.hypot(length, cone.startRadius - cone.endRadius) / length;
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 0.5", "1000, 0.01, 0", "0.01, 1, 0.3", "1, 0.2, 1"})
    void theNormalIsAtRightAnglesToTheSideAndOutward(double length, double first, double second) {
        for (int i = 0; i < CONES; i++) {
            Cone cone = random(length, first, second);
            double turn = random.nextDouble() * 2 * Math.PI;
            double share = 0.05 + 0.9 * random.nextDouble();
            Vector normal = cone.normal(at(cone, share, 1, turn));
            Vector side = Vector.subtract(at(cone, 1, 1, turn), at(cone, 0, 1, turn)).normalised();
            Vector round = Vector.cross(along, out(turn));
            assertThat(Math.abs(normal.dot(side))).as("seed " + SEED).isLessThan(1e-9);
            assertThat(Math.abs(normal.dot(round))).as("seed " + SEED).isLessThan(1e-9);
            assertThat(normal.dot(out(turn))).as("seed " + SEED).isPositive();
            assertThat(Math.abs(normal.norm() - 1)).isLessThan(1e-14);
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 0", "1000, 0.01, 0.02", "0.001, 0.5, 1"})
    void theBoundsHoldTheSurfaceAndNoMore(double length, double first, double second) {
        double rounding = 1e-15 * (length + first + second + 10);
        for (int i = 0; i < 5; i++) {
            Cone cone = random(length, first, second);
            Bounds box = cone.bounds();
            Bounds reached = Bounds.of(cone.start, cone.end);
            for (int k = 0; k < 1000; k++) {
                double turn = k * 2 * Math.PI / 1000;
                reached = reached.with(Bounds.of(at(cone, 0, 1, turn), at(cone, 1, 1, turn), at(cone, random.nextDouble(), 1, turn)));
            }
            double[] actual = new double[6];
            double[] found = new double[6];
            box.get(actual);
            reached.get(found);
            for (int side = 0; side < 6; side++) {            // of 1000 points of a circle one is within 2π/2000 of the outermost
                double more = (side < 3 ? 1 : -1) * (found[side] - actual[side]);
                assertThat(more).as("seed " + SEED).isBetween(-rounding, 1e-5 * (first + second));
            }
        }
    }

    private Vector direction() {
        return new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalised();
    }

    /** {@return a cone in a random direction, at times along an axis, within a few units of the origin} */
    private Cone random(double length, double first, double second) {
        along = switch (random.nextInt(6)) {
            case 0 -> new Vector(1, 0, 0);
            case 1 -> new Vector(0, -1, 0);
            case 2 -> new Vector(0, 0, 1);
            default -> direction();
        };
        across = Vector.cross(along, Math.abs(along.x) < 0.6 ? new Vector(1, 0, 0) : new Vector(0, 1, 0)).normalised();
        other = Vector.cross(along, across);
        Point start = new Point(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
        return new Cone(new Material(), start, first, Point.add(start, Vector.scale(along, length)), second);
    }

    /** {@return the point at this share of the length and of the radius there} */
    private Point at(Cone cone, double height, double out, double turn) {
        Vector to = Vector.scale(Vector.subtract(cone.end, cone.start), height);
        to.add(Vector.scale(out(turn), out * (cone.startRadius + height * (cone.endRadius - cone.startRadius))));
        return Point.add(cone.start, to);
    }

    private Vector out(double turn) {
        return Vector.add(Vector.scale(across, Math.cos(turn)), Vector.scale(other, Math.sin(turn)));
    }
}
