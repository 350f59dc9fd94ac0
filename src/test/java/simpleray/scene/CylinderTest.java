package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.ray;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Vector;

class CylinderTest {
    /** A few roundings of numbers near 1. */
    private static final double ROUNDING = 1e-15;

    /** From y = 0 to y = 1 about the y axis. */
    private final Cylinder unit = new Cylinder();

    @Test
    void aNewCylinderIsOneHighAndOneInRadius() {
        assertThat(unit.start).hasToString("[0.0,0.0,0.0]");
        assertThat(unit.end).hasToString("[0.0,1.0,0.0]");
        assertThat(unit.radius).isEqualTo(1);
        assertThat(unit.surfaceMaterial).isNotNull();
    }

    @Test
    void aCylinderKeepsWhatItIsMadeOfAndCopiesNothing() {
        Material material = new Material();
        Point start = new Point(1, 2, 3);
        Point end = new Point(4, 5, 6);
        Cylinder cylinder = new Cylinder(material, start, end, 7);

        assertThat(cylinder.surfaceMaterial).isSameAs(material);
        assertThat(cylinder.start).isSameAs(start);
        assertThat(cylinder.end).isSameAs(end);
        assertThat(cylinder.radius).isEqualTo(7);
    }

    @Test
    void rayAtTheAxisHitsTheNearSide() {
        assertThat(unit.intersect(ray(0, 0.5, 5, 0, 0, -1))).isEqualTo(4);
    }

    @Test
    void rayBesideTheAxisHitsWhereTheCircleIs() {
        // 0.6² + 0.8² = 1: the front is at z = 0.8 there
        assertThat(unit.intersect(ray(0.6, 0.5, 5, 0, 0, -1))).isEqualTo(4.2, within(5 * ROUNDING));
    }

    @Test
    void rayAlongTheAxisHitsTheEnd() {
        assertThat(unit.intersect(ray(0, 3, 0, 0, -1, 0))).isEqualTo(2);
        assertThat(unit.intersect(ray(0.3, -3, 0.4, 0, 1, 0))).isEqualTo(3);
    }

    @Test
    void slantedRayHitsTheEndOrTheSideWhicheverItMeets() {
        // from y = 5, 4 down at 0.8 a step; it reaches the end's plane 3 further to the right, at x = 0.5 and at x = -1.5
        assertThat(unit.intersect(ray(-2.5, 5, 0, 0.6, -0.8, 0))).isEqualTo(5, within(5 * ROUNDING));
        // there it is past the plane, and meets the side at x = -1, 0.5 further to the right, 5/6 on
        assertThat(unit.intersect(ray(-4.5, 5, 0, 0.6, -0.8, 0))).isEqualTo(5 + 5.0 / 6, within(5 * ROUNDING));
    }

    @Test
    void aSlantedCylinderIsHitWhereItIs() {
        // axis along (0.6,0.8,0) through (1,1,1), radius 2: at right angles to it, (-0.8,0.6,0), the side is 2 from there
        Cylinder cylinder = new Cylinder(new Material(), new Point(1 - 6, 1 - 8, 1), new Point(1 + 6, 1 + 8, 1), 2);
        assertThat(cylinder.intersect(ray(1 - 4, 1 + 3, 1, 0.8, -0.6, 0))).isEqualTo(3, within(5 * ROUNDING));
        assertThat(cylinder.intersect(ray(1, 1, 9, 0, 0, -1))).isEqualTo(6, within(9 * ROUNDING));
        assertThat(cylinder.intersect(ray(1 + 12, 1 + 16, 1, -0.6, -0.8, 0))).isEqualTo(10, within(20 * ROUNDING));
    }

    @Test
    void theOrderOfTheEndsDoesNotMatter() {
        Cylinder turned = new Cylinder(new Material(), unit.end, unit.start, 1);
        assertThat(turned.intersect(ray(0.6, 0.5, 5, 0, 0, -1))).isEqualTo(4.2, within(5 * ROUNDING));
        assertThat(turned.intersect(ray(0, 3, 0, 0, -1, 0))).isEqualTo(2);
        assertThat(turned.intersect(ray(0, 1.5, 5, 0, 0, -1))).isEqualTo(Object.MISS);
    }

    @Test
    void rayPastTheSideMisses() {
        assertThat(unit.intersect(ray(1.001, 0.5, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(1.001, 5, 0, 0, -1, 0))).as("along the axis").isEqualTo(Object.MISS);
    }

    @Test
    void rayPastAnEndMisses() {
        assertThat(unit.intersect(ray(0, 1.001, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0, -0.001, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(1 - 4, 1.01 + 3, 0, 0.8, -0.6, 0))).as("slanted, over the rim").isEqualTo(Object.MISS);
    }

    @Test
    void tangentRayHits() {
        assertThat(unit.intersect(ray(1, 0.5, 5, 0, 0, -1))).isEqualTo(5);
        assertThat(unit.intersect(ray(-1, 0.5, 5, 0, 0, -2))).isEqualTo(2.5);
        assertThat(unit.intersect(ray(1, 5, 0, 0, -1, 0))).as("along the side").isEqualTo(4);
        assertThat(unit.intersect(ray(0, 1, 5, 0, 0, -1))).as("along an end").isEqualTo(4);
        assertThat(unit.intersect(ray(1, 1, 5, 0, 0, -1))).as("at the rim").isEqualTo(5);
    }

    @Test
    void rayFromInsideHitsTheFarWall() {
        assertThat(unit.intersect(ray(0, 0.5, 0.5, 0, 0, -1))).isEqualTo(1.5);
        assertThat(unit.intersect(ray(0, 0.5, 0.5, 0, 0, 1))).isEqualTo(0.5);
    }

    @Test
    void rayFromInsideHitsTheEnds() {
        assertThat(unit.intersect(ray(0.3, 0.25, 0.5, 0, 1, 0))).isEqualTo(0.75);
        assertThat(unit.intersect(ray(0.3, 0.25, 0.5, 0, -1, 0))).isEqualTo(0.25);
        assertThat(unit.intersect(ray(0, 0.2, 0, 0.6, 0.8, 0))).as("slanted").isEqualTo(1, within(ROUNDING));
    }

    @Test
    void rayFromWithinTheAxisHitsAtTheRadius() {
        assertThat(unit.intersect(ray(0, 0.5, 0, 0.6, 0, -0.8))).isEqualTo(1, within(ROUNDING));
    }

    @Test
    void cylinderBehindTheRayIsMissed() {
        assertThat(unit.intersect(ray(0, 0.5, 5, 0, 0, 1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0, 5, 0, 0, 1, 0))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(1, 0.5, 5, 0, 0, 1))).isEqualTo(Object.MISS);
    }

    @Test
    void rayFromTheSurfaceInwardsHitsTheOtherSide() {
        assertThat(unit.intersect(ray(0, 0.5, 1, 0, 0, -1))).isEqualTo(2);
        assertThat(unit.intersect(ray(0.5, 1, 0.5, 0, -1, 0))).isEqualTo(1);
    }

    @Test
    void rayFromTheSurfaceOutwardsMisses() {
        assertThat(unit.intersect(ray(0, 0.5, 1, 0, 0, 1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0, 0.5, 1, 0.6, 0, 0.8))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0, 0.5, 1, 1, 0, 0))).as("along the surface").isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0.5, 1, 0.5, 0, 1, 0))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0.5, 0, 0.5, 0.6, -0.8, 0))).isEqualTo(Object.MISS);
    }

    @Test
    void aHitWithinTheThresholdIsNone() {
        assertThat(unit.intersect(ray(0, 0.5, 1 + 0.9e-7, 0, 0, -1))).as("the far side").isEqualTo(2, within(1e-6));
        assertThat(unit.intersect(ray(0, 0.5, 1 + 1.1e-7, 0, 0, -1))).as("the near side").isEqualTo(1.1e-7, within(1e-12));
        assertThat(unit.intersect(ray(0, 0.5, 1 - 0.9e-7, 0, 0, 1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0, 1 + 0.9e-7, 0, 0, -1, 0))).as("the far end").isEqualTo(1, within(1e-6));
        assertThat(unit.intersect(ray(0, 1 + 1.1e-7, 0, 0, -1, 0))).as("the near end").isEqualTo(1.1e-7, within(1e-12));
    }

    @Test
    void aLongerDirectionCountsFewerOfIts() {
        assertThat(unit.intersect(ray(0, 0.5, 5, 0, 0, -4))).isEqualTo(1);
        assertThat(unit.intersect(ray(0, 0.5, 5, 0, 0, -0.5))).isEqualTo(8);
        assertThat(unit.intersect(ray(0, 3, 0, 0, -4, 0))).isEqualTo(0.5);
        assertThat(unit.intersect(ray(0, 0.5, 0.5, 0, 0, -3))).isEqualTo(0.5);
        assertThat(unit.intersect(ray(1.001, 0.5, 5, 0, 0, -4))).isEqualTo(Object.MISS);
    }

    @Test
    void aThinCylinderFarAwayKeepsItsEdge() {
        // from 10000 away the distance squared, 1e8, has 1e-8 between neighbours: b² - 4ac would lose the radius, 1e-4
        Cylinder hair = new Cylinder(new Material(), new Point(0, -1, 0), new Point(0, 1, 0), 1e-4);
        assertThat(hair.intersect(ray(0.9e-4, 0, 1e4, 0, 0, -1))).isEqualTo(1e4, within(1e-3));
        assertThat(hair.intersect(ray(1.1e-4, 0, 1e4, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(hair.intersect(ray(0.9e-4, 1e4, 0, 0, -1, 0))).as("along it").isEqualTo(1e4 - 1);
        assertThat(hair.intersect(ray(1.1e-4, 1e4, 0, 0, -1, 0))).isEqualTo(Object.MISS);
    }

    @Test
    void aLongCylinderIsThereAtItsFarEnd() {
        Cylinder wire = new Cylinder(new Material(), new Point(0, 0, 0), new Point(3e5, 4e5, 0), 1e-3);
        assertThat(wire.intersect(ray(3e5 - 3, 4e5 - 4, 1, 0, 0, -1))).isEqualTo(1 - 1e-3, within(1e-9));
        assertThat(wire.intersect(ray(3e5 + 3, 4e5 + 4, 1, 0, 0, -1))).isEqualTo(Object.MISS);
    }

    @Test
    void aVastCylinderIsHitWhereItsSurfaceIs() {
        // a floor of radius 1e6 whose top is y = 0, and one whose end is, seen from a height of 2
        Cylinder lying = new Cylinder(new Material(), new Point(-1e6, -1e6, 0), new Point(1e6, -1e6, 0), 1e6);
        assertThat(lying.intersect(ray(0, 2, 0, 0, -1, 0))).isEqualTo(2, within(1e-9));
        Cylinder standing = new Cylinder(new Material(), new Point(0, -1e6, 0), new Point(), 1e6);
        assertThat(standing.intersect(ray(3, 2, 4, 0, -1, 0))).isEqualTo(2);
    }

    @Test
    void theNormalOfTheSidePointsAwayFromTheAxis() {
        assertThat(unit.normal(new Point(1, 0.25, 0))).hasToString("[1.0,0.0,0.0]");
        Vector slanted = unit.normal(new Point(0.6, 0.75, -0.8));
        assertThat(slanted.x).isEqualTo(0.6, within(ROUNDING));
        assertThat(slanted.y).isEqualTo(0, within(ROUNDING));
        assertThat(slanted.z).isEqualTo(-0.8, within(ROUNDING));
    }

    @Test
    void theNormalOfAnEndPointsAlongTheAxis() {
        assertThat(unit.normal(new Point(0.5, 1, 0.5))).hasToString("[0.0,1.0,0.0]");
        assertThat(unit.normal(new Point(0, 1, 0))).hasToString("[0.0,1.0,0.0]");
        Vector low = unit.normal(new Point(0.5, 0, 0.5));
        assertThat(low.y).isEqualTo(-1);
        low.negate();
        assertThat(unit.normal(new Point(0.5, 1, 0.5))).as("a changed one changes nothing").hasToString("[0.0,1.0,0.0]");
    }

    @Test
    void theNormalNextToTheRimIsThatOfTheSurfaceThere() {
        double close = 1e-14;
        assertThat(unit.normal(new Point(1 - close, 1, 0))).hasToString("[0.0,1.0,0.0]");
        assertThat(unit.normal(new Point(1, 1 - close, 0))).hasToString("[1.0,0.0,0.0]");
        assertThat(unit.normal(new Point(1 - close, 0, 0)).y).isEqualTo(-1);
        assertThat(unit.normal(new Point(1, close, 0))).hasToString("[1.0,0.0,0.0]");
    }

    @Test
    void aCoinsNormalInTheMiddleIsThatOfItsSideUp() {
        Cylinder coin = new Cylinder(new Material(), new Point(), new Point(0, 1e-9, 0), 1);
        assertThat(coin.normal(new Point(0, 1e-9, 0))).hasToString("[0.0,1.0,0.0]");
        assertThat(coin.normal(new Point(0, 0, 0)).y).isEqualTo(-1);
        assertThat(coin.normal(new Point(0, 0.5e-9, 1))).hasToString("[0.0,0.0,1.0]");
    }

    /** The square of the axis is no double there, or one of few digits. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-170, 1e-160, 1e160})
    void theAxisMayBeOfAnyLength(double length) {
        Cylinder cylinder = new Cylinder(new Material(), new Point(), new Point(0, 0, length), 1);
        assertThat(cylinder.intersect(ray(3, 0, length / 2, -1, 0, 0))).isEqualTo(2);
        assertThat(cylinder.normal(new Point(1, 0, length / 2))).hasToString("[1.0,0.0,0.0]");
    }

    @Test
    void theBoundsOfAnUprightCylinder() {
        assertThat(unit.bounds()).isEqualTo(new Bounds(-1, 0, -1, 1, 1, 1));
    }

    @Test
    void theBoundsOfASlantedCylinder() {
        // the ends are circles of radius 5 at right angles to (0.6,0.8,0): they reach 0.8, 0.6 and 1 times 5 along the axes
        Bounds box = new Cylinder(new Material(), new Point(1, 2, 3), new Point(7, 10, 3), 5).bounds();
        assertThat(box.xmin()).isEqualTo(1 - 4, within(9 * ROUNDING));
        assertThat(box.ymin()).isEqualTo(2 - 3, within(9 * ROUNDING));
        assertThat(box.zmin()).isEqualTo(3 - 5, within(9 * ROUNDING));
        assertThat(box.xmax()).isEqualTo(7 + 4, within(20 * ROUNDING));
        assertThat(box.ymax()).isEqualTo(10 + 3, within(20 * ROUNDING));
        assertThat(box.zmax()).isEqualTo(3 + 5, within(9 * ROUNDING));
    }
}
