package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.ray;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

class ConeTest {
    /** A few roundings of numbers near 1. */
    private static final double ROUNDING = 4e-15;

    /** Its base is the circle of radius 1 about the origin at y = 0, its apex at y = 1. */
    private final Cone unit = new Cone();
    /** From radius 2 at y = 0 to radius 1 at y = 2. */
    private final Cone bucket = new Cone(new Material(), new Point(), 2, new Point(0, 2, 0), 1);
    /** An open cylinder, from y = 0 to y = 2. */
    private final Cone pipe = new Cone(new Material(), new Point(), 1, new Point(0, 2, 0), 1);

    @Test
    void aNewConeStandsOnTheOriginItsApexUp() {
        assertThat(unit.start).hasToString("[0.0,0.0,0.0]");
        assertThat(unit.startRadius).isEqualTo(1);
        assertThat(unit.end).hasToString("[0.0,1.0,0.0]");
        assertThat(unit.endRadius).isZero();
        assertThat(unit.surfaceMaterial).isNotNull();
    }

    @Test
    void aConeKeepsWhatItIsMadeOfAndCopiesNothing() {
        Material material = new Material();
        Point start = new Point(1, 2, 3);
        Point end = new Point(4, 5, 6);
        Cone cone = new Cone(material, start, 7, end, 8);

        assertThat(cone.surfaceMaterial).isSameAs(material);
        assertThat(cone.start).isSameAs(start);
        assertThat(cone.startRadius).isEqualTo(7);
        assertThat(cone.end).isSameAs(end);
        assertThat(cone.endRadius).isEqualTo(8);
    }

    @Test
    void rayAtTheAxisHitsTheNearSide() {
        assertThat(unit.intersect(ray(0, 0.5, 5, 0, 0, -1))).isEqualTo(4.5, within(ROUNDING));
        assertThat(bucket.intersect(ray(0, 1, 5, 0, 0, -1))).isEqualTo(3.5, within(ROUNDING));
        assertThat(pipe.intersect(ray(0, 1, 5, 0, 0, -1))).isEqualTo(4, within(ROUNDING));
    }

    @Test
    void rayBesideTheAxisHitsWhereTheCircleIs() {
        // 0.3² + 0.4² = 0.5²: halfway up the front is at z = 0.4 there
        assertThat(unit.intersect(ray(0.3, 0.5, 5, 0, 0, -1))).isEqualTo(4.6, within(ROUNDING));
    }

    @Test
    void rayAlongTheAxisHitsTheApexFromBothSides() {
        assertThat(unit.intersect(ray(0, 3, 0, 0, -1, 0))).isEqualTo(2, within(ROUNDING));
        assertThat(unit.intersect(ray(0, -3, 0, 0, 1, 0))).isEqualTo(4, within(ROUNDING));
        assertThat(unit.intersect(ray(0, 0.25, 0, 0, 1, 0))).isEqualTo(0.75, within(ROUNDING));
        assertThat(unit.intersect(ray(0, 0.25, 0, 0, -1, 0))).as("out at the open base").isEqualTo(Object.MISS);
    }

    @Test
    void rayAcrossTheApexHitsIt() {
        assertThat(unit.intersect(ray(0, 1, 5, 0, 0, -1))).isEqualTo(5, within(ROUNDING));
        assertThat(unit.intersect(ray(-3, 4, 0, 1, -1, 0))).as("and then along in a side").isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(-1, 3, 0, 1, -2, 0))).as("from above, into the inside").isEqualTo(1, within(ROUNDING));
        assertThat(unit.intersect(ray(0, 1.001, 5, 0, 0, -1))).as("just above").isEqualTo(Object.MISS);
    }

    @Test
    void rayParallelToTheAxisHitsTheSideOnce() {
        assertThat(unit.intersect(ray(0.25, 3, 0, 0, -1, 0))).isEqualTo(2.25, within(ROUNDING));
        assertThat(unit.intersect(ray(0.25, -1, 0, 0, 1, 0))).as("from below, on the inside").isEqualTo(1.75, within(ROUNDING));
        assertThat(unit.intersect(ray(0, 3, -1.001, 0, -1, 0))).as("past the base").isEqualTo(Object.MISS);
        assertThat(bucket.intersect(ray(1.5, 5, 0, 0, -1, 0))).isEqualTo(4, within(ROUNDING));
    }

    @Test
    void rayThroughBothOpenEndsMisses() {
        assertThat(bucket.intersect(ray(0.5, 5, 0, 0, -1, 0))).isEqualTo(Object.MISS);
        assertThat(bucket.intersect(ray(0, -5, 0, 0, 1, 0))).isEqualTo(Object.MISS);
        assertThat(pipe.intersect(ray(0, 5, 0, 0, -1, 0))).isEqualTo(Object.MISS);
        assertThat(pipe.intersect(ray(0.3, 5, 0.4, 0, -1, 0))).isEqualTo(Object.MISS);
    }

    @Test
    void rayInAtAnOpenEndHitsTheInside() {
        // 0.6 to the right and 0.8 down a step: at the pipe's upper end at x = 0.75, at its wall 5/3 steps from the start
        assertThat(pipe.intersect(ray(0, 3, 0, 0.6, -0.8, 0))).isEqualTo(5.0 / 3, within(ROUNDING));
        assertThat(pipe.intersect(ray(-2, 3, 0, 0.6, -0.8, 0))).as("the outside, steeply").isEqualTo(5.0 / 3, within(ROUNDING));
        assertThat(pipe.intersect(ray(-2.5, 3, 0, 0.6, -0.4, 0))).as("the outside").isEqualTo(2.5, within(ROUNDING));
    }

    @Test
    void rayFromInsideHitsTheFarWall() {
        assertThat(unit.intersect(ray(0, 0.5, 0.25, 0, 0, -1))).isEqualTo(0.75, within(ROUNDING));
        assertThat(pipe.intersect(ray(0, 0.5, 0.25, 0, 0, 1))).isEqualTo(0.75, within(ROUNDING));
    }

    @Test
    void rayBehindItMisses() {
        assertThat(unit.intersect(ray(0, 0.5, 5, 0, 0, 1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0, 0.5, -0.5, 0, 0, -1))).as("from the very surface, outward").isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0, 0.5, 0.5, 0, 0, -1))).as("from the very surface, inward").isEqualTo(1, within(ROUNDING));
    }

    @Test
    void hitsCloserThanTheThresholdDoNotCount() {
        assertThat(pipe.intersect(ray(0, 0.5, 1 + 0.9e-7, 0, 0, -1))).isEqualTo(2, within(1e-6));
        assertThat(pipe.intersect(ray(0, 0.5, 1 + 1.1e-7, 0, 0, -1))).isEqualTo(1.1e-7, within(1e-15));
    }

    @Test
    void rayPastARimMisses() {
        assertThat(unit.intersect(ray(0, -0.001, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(bucket.intersect(ray(0, 2.001, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(bucket.intersect(ray(0, -0.001, 5, 0, 0, -1))).isEqualTo(Object.MISS);
    }

    @Test
    void rayAtARimHits() {
        assertThat(bucket.intersect(ray(0, 2, 5, 0, 0, -1))).isEqualTo(4, within(ROUNDING));
        assertThat(bucket.intersect(ray(0, 0, 5, 0, 0, -1))).isEqualTo(3, within(ROUNDING));
    }

    @Test
    void rayAtTheOtherConeOfTheEquationMisses() {
        // the equation of the sharp cone goes on above its apex, where there is no cone
        assertThat(unit.intersect(ray(0, 1.5, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0.2, 9, 0, 0, -1, 0.2))).isEqualTo(Object.MISS);
        Cone flat = new Cone(new Material(), new Point(), 4, new Point(0, 1, 0), 0);
        assertThat(flat.intersect(ray(0, 1.0625, 5, 0, 0, -1))).isEqualTo(Object.MISS);
    }

    @Test
    void tangentRayHits() {
        assertThat(pipe.intersect(ray(1, 0.5, 5, 0, 0, -1))).isEqualTo(5);
        assertThat(unit.intersect(ray(0.5, 0.5, 5, 0, 0, -1))).isEqualTo(5, within(1e-7));
        assertThat(unit.intersect(ray(0.501, 0.5, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0.499, 0.5, 5, 0, 0, -1))).isEqualTo(5 - Math.sqrt(0.25 - 0.499 * 0.499), within(1e-13));
    }

    @Test
    void rayParallelToASideHitsTheOtherSideOnce() {
        // the side runs from (1,0,0) to (0,1,0); the ray half a unit within it comes to x = -0.25, y = 0.75 on the other side
        assertThat(unit.intersect(ray(0.5, 0, 0, -1, 1, 0))).isEqualTo(0.75, within(ROUNDING));
        assertThat(unit.intersect(ray(1.5, -1, 0, -1, 1, 0))).isEqualTo(1.75, within(ROUNDING));
        assertThat(unit.intersect(ray(2, -1, 0, -1, 1, 0))).as("in the side itself").isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(2.1, -1, 0, -1, 1, 0))).as("outside").isEqualTo(Object.MISS);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-50, 0.5, 3, 1e6})
    void theDirectionMayBeOfAnyLength(double length) {
        assertThat(unit.intersect(ray(0, 0.5, 5, 0, 0, -length)) * length).isEqualTo(4.5, within(ROUNDING));
        assertThat(unit.intersect(ray(0.25, -1, 0, 0, length, 0)) * length).isEqualTo(1.75, within(ROUNDING));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1, 1e6, 1e50, 1e100})
    void aConeMayBeOfAnySize(double size) {
        Cone cone = new Cone(new Material(), new Point(size, 0, 0), 2 * size, new Point(size, 0, 4 * size), size);
        assertThat(cone.intersect(ray(9 * size, 0, 2 * size, -1, 0, 0))).isEqualTo(6.5 * size, within(1e-14 * size));
        assertThat(cone.intersect(ray(2.5 * size, 0, -size, 0, 0, 1))).as("its radius is 1.5 halfway").isEqualTo(3 * size, within(1e-14 * size));
    }

    @Test
    void theOrderOfTheEndsDoesNotMatter() {
        Cone turned = new Cone(new Material(), unit.end, 0, unit.start, 1);
        assertThat(turned.intersect(ray(0.3, 0.5, 5, 0, 0, -1))).isEqualTo(4.6, within(ROUNDING));
        assertThat(turned.intersect(ray(0, 3, 0, 0, -1, 0))).isEqualTo(2, within(ROUNDING));
        assertThat(turned.intersect(ray(0, 1.5, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(turned.intersect(ray(0.25, -1, 0, 0, 1, 0))).isEqualTo(1.75, within(ROUNDING));
    }

    @Test
    void aSlantedConeIsHitWhereItIs() {
        // axis along (0.6,0.8,0), 10 long, radius 4 to 2: in its middle, 3 from the axis along (-0.8,0.6,0)
        Cone cone = new Cone(new Material(), new Point(1 - 3, 1 - 4, 1), 4, new Point(1 + 3, 1 + 4, 1), 2);
        assertThat(cone.intersect(ray(1 - 8, 1 + 6, 1, 0.8, -0.6, 0))).isEqualTo(7, within(5 * ROUNDING));
        assertThat(cone.intersect(ray(1, 1, 9, 0, 0, -1))).isBetween(4.9, 5.1);
        assertThat(cone.intersect(ray(1 + 12, 1 + 16, 1, -0.6, -0.8, 0))).as("along the axis").isEqualTo(Object.MISS);
    }

    /** A cone of next to no height is a disc, or a ring. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e-9, 1e-18, 1e-170})
    void aFlatConeIsADiscOrARing(double height) {
        Cone disc = new Cone(new Material(), new Point(), 1, new Point(0, height, 0), 0);
        assertThat(disc.intersect(ray(0.5, 3, 0, 0, -1, 0))).isEqualTo(3, within(height));
        assertThat(disc.intersect(ray(0.3, -2, 0.4, 0, 1, 0))).isEqualTo(2, within(height));
        assertThat(disc.intersect(ray(1.001, 3, 0, 0, -1, 0))).isEqualTo(Object.MISS);
        Cone ring = new Cone(new Material(), new Point(), 1, new Point(0, height, 0), 0.5);
        assertThat(ring.intersect(ray(0.75, 3, 0, 0, -1, 0))).isEqualTo(3, within(height));
        assertThat(ring.intersect(ray(0, 3, -0.499, 0, -1, 0))).isEqualTo(Object.MISS);
        assertThat(ring.intersect(ray(0, 3, -1.001, 0, -1, 0))).isEqualTo(Object.MISS);
    }

    @Test
    void theNormalPointsAwayFromTheAxisAndTowardsTheThinEnd() {
        double half = Math.sqrt(0.5);
        assertNormal(unit, new Point(0.5, 0.5, 0), half, half, 0);
        assertNormal(unit, new Point(0, 0.25, -0.75), 0, half, -half);
        // the bucket narrows by 1 over 2: its normal rises by 1 over 2
        assertNormal(bucket, new Point(-1.5, 1, 0), -2 / Math.sqrt(5), 1 / Math.sqrt(5), 0);
        assertNormal(pipe, new Point(0.6, 0.3, 0.8), 0.6, 0, 0.8);
        Cone turned = new Cone(new Material(), new Point(0, 2, 0), 1, new Point(), 2);
        assertNormal(turned, new Point(-1.5, 1, 0), -2 / Math.sqrt(5), 1 / Math.sqrt(5), 0);
    }

    @Test
    void theNormalOfAnApexIsTheDirectionOfTheAxisTowardsIt() {
        assertThat(unit.normal(new Point(0, 1, 0))).hasToString("[0.0,1.0,0.0]");
        assertThat(new Cone(new Material(), new Point(3, 0, 0), 0, new Point(1, 0, 0), 5).normal(new Point(3, 0, 0)).x).isEqualTo(1);
        assertNormal(unit, new Point(1e-9, 1 - 1e-9, 0), Math.sqrt(0.5), Math.sqrt(0.5), 0);
        Cone slanted = new Cone(new Material(), new Point(1, 2, 3), 1, new Point(1.3, 2.7, 3.1), 0);
        Vector axis = Vector.subtract(slanted.end, slanted.start).normalised();
        Vector down = Vector.negate(axis);
        Ray ray = new Ray(Point.add(slanted.end, Vector.scale(axis, 4)), down);
        assertNormal(slanted, ray.getPointAt(slanted.intersect(ray)), axis.x, axis.y, axis.z);
    }

    private static void assertNormal(Cone cone, Point p, double x, double y, double z) {
        Vector n = cone.normal(p);
        assertThat(n.x).isEqualTo(x, within(1e-6));
        assertThat(n.y).isEqualTo(y, within(1e-6));
        assertThat(n.z).isEqualTo(z, within(1e-6));
        assertThat(n.norm()).isEqualTo(1, within(ROUNDING));
    }

    /** A ray that comes to the outside enters; the inside is the side of the axis. */
    @Test
    void aRayEntersFromOutsideAndLeavesFromInside() {
        assertThat(at(0, 0.5, 5, -1).enters).isTrue();
        Interaction leaving = at(0, 0.5, 0.25, -1);
        assertThat(leaving.enters).isFalse();
        assertThat(leaving.normal.z).as("the normal is turned to the ray's side").isPositive();
        assertThat(leaving.outward.z).isNegative();
    }

    private Interaction at(double x, double y, double z, double dz) {
        Hit hit = new Hit();
        unit.intersect(ray(x, y, z, 0, 0, dz), 0, hit);
        Interaction at = new Interaction();
        at.set(ray(x, y, z, 0, 0, dz), hit, unit);
        return at;
    }

    /** The square of the axis is no double there, or one of few digits. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-170, 1e-160, 1e160})
    void theAxisMayBeOfAnyLength(double length) {
        Cone cone = new Cone(new Material(), new Point(), 1, new Point(0, 0, length), 1);
        assertThat(cone.intersect(ray(3, 0, length / 2, -1, 0, 0))).isEqualTo(2);
        assertThat(cone.normal(new Point(1, 0, length / 2))).hasToString("[1.0,0.0,0.0]");
    }

    @Test
    void theBoundsOfAnUprightCone() {
        assertThat(unit.bounds()).isEqualTo(new Bounds(-1, 0, -1, 1, 1, 1));
        Cone low = new Cone(new Material(), new Point(0, 5, 0), 1, new Point(0, 3, 0), 2);
        assertThat(low.bounds()).isEqualTo(new Bounds(-2, 3, -2, 2, 5, 2));
    }

    @Test
    void theBoundsOfASlantedCone() {
        // circles at right angles to (0.6,0.8,0) reach 0.8, 0.6 and 1 times their radius, 5 and 10, along the axes
        Bounds box = new Cone(new Material(), new Point(1, 2, 3), 5, new Point(7, 10, 3), 10).bounds();
        assertThat(box.xmin()).isEqualTo(1 - 4, within(1e-14));
        assertThat(box.ymin()).isEqualTo(2 - 3, within(1e-14));
        assertThat(box.zmin()).isEqualTo(3 - 10, within(1e-14));
        assertThat(box.xmax()).isEqualTo(7 + 8, within(1e-14));
        assertThat(box.ymax()).isEqualTo(10 + 6, within(1e-14));
        assertThat(box.zmax()).isEqualTo(3 + 10, within(1e-14));
    }
}
