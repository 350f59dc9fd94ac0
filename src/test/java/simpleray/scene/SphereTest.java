package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

class SphereTest {
    /** A few roundings of numbers near 1. */
    private static final double ROUNDING = 1e-15;

    private final Sphere unit = new Sphere();

    @Test
    void aNewSphereIsTheUnitSphere() {
        assertThat(unit.centre).hasToString("[0.0,0.0,0.0]");
        assertThat(unit.radius).isEqualTo(1);
        assertThat(unit.surfaceMaterial).isNotNull();
    }

    @Test
    void itsBoundsAreTheRadiusFromTheCentre() {
        assertThat(new Sphere(new Material(), new Point(1, 20, 300), 4).bounds()).isEqualTo(new Bounds(-3, 16, 296, 5, 24, 304));
    }

    @Test
    void aSphereKeepsWhatItIsMadeOfAndCopiesNothing() {
        Material material = new Material();
        Point centre = new Point(1, 2, 3);
        Sphere sphere = new Sphere(material, centre, 4);

        assertThat(sphere.surfaceMaterial).isSameAs(material);
        assertThat(sphere.centre).isSameAs(centre);
        assertThat(sphere.radius).isEqualTo(4);
    }

    @Test
    void rayAtTheCentreHitsTheNearSide() {
        assertThat(unit.intersect(ray(0, 0, 5, 0, 0, -1))).isEqualTo(4);
    }

    @Test
    void rayBesideTheCentreHitsWhereTheCircleIs() {
        // 0.6² + 0.8² = 1: the sphere's front is at z = 0.8 there
        assertThat(unit.intersect(ray(0.6, 0, 5, 0, 0, -1))).isEqualTo(4.2, within(ROUNDING * 5));
    }

    @Test
    void aMovedSphereIsHitWhereItIs() {
        // from (1,2,9) down to the sphere's front at z = 3 + 2
        Sphere sphere = new Sphere(new Material(), new Point(1, 2, 3), 2);
        assertThat(sphere.intersect(ray(1, 2, 9, 0, 0, -1))).isEqualTo(4);
    }

    @Test
    void rayPastTheSphereMisses() {
        assertThat(unit.intersect(ray(1.001, 0, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0, 5, 5, 0, 0, -1))).isEqualTo(Object.MISS);
    }

    @Test
    void tangentRayHits() {
        assertThat(unit.intersect(ray(1, 0, 5, 0, 0, -1))).isEqualTo(5);
        assertThat(unit.intersect(ray(0, -1, 5, 0, 0, -2))).isEqualTo(2.5);
    }

    @Test
    void rayFromInsideHitsTheFarSide() {
        assertThat(unit.intersect(ray(0, 0, 0.5, 0, 0, -1))).isEqualTo(1.5);
        assertThat(unit.intersect(ray(0, 0, 0.5, 0, 0, 1))).isEqualTo(0.5);
    }

    @Test
    void rayFromTheCentreHitsAtTheRadius() {
        assertThat(new Sphere(new Material(), new Point(1, 2, 3), 2).intersect(ray(1, 2, 3, 0.6, 0, -0.8)))
            .isEqualTo(2, within(ROUNDING));
    }

    @Test
    void sphereBehindTheRayIsMissed() {
        assertThat(unit.intersect(ray(0, 0, 5, 0, 0, 1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(1, 0, 5, 0, 0, 1))).isEqualTo(Object.MISS);
    }

    @Test
    void rayFromTheSurfaceInwardsHitsTheOtherSide() {
        assertThat(unit.intersect(ray(0, 0, 1, 0, 0, -1))).isEqualTo(2);
    }

    @Test
    void rayFromTheSurfaceOutwardsMisses() {
        assertThat(unit.intersect(ray(0, 0, 1, 0, 0, 1))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0, 0, 1, 0.6, 0, 0.8))).isEqualTo(Object.MISS);
        assertThat(unit.intersect(ray(0, 0, 1, 1, 0, 0))).as("along the surface").isEqualTo(Object.MISS);
    }

    @Test
    void aHitWithinTheThresholdIsNone() {
        assertThat(unit.intersect(ray(0, 0, 1 + 0.9e-7, 0, 0, -1))).as("the far side").isEqualTo(2, within(1e-6));
        assertThat(unit.intersect(ray(0, 0, 1 + 1.1e-7, 0, 0, -1))).as("the near side").isEqualTo(1.1e-7, within(1e-12));
        assertThat(unit.intersect(ray(0, 0, 1 - 0.9e-7, 0, 0, 1))).isEqualTo(Object.MISS);
    }

    @Test
    void aLongerDirectionCountsFewerOfIts() {
        assertThat(unit.intersect(ray(0, 0, 5, 0, 0, -4))).isEqualTo(1);
        assertThat(unit.intersect(ray(0, 0, 5, 0, 0, -0.5))).isEqualTo(8);
        assertThat(unit.intersect(ray(0, 0, 0.5, 0, 0, -3))).isEqualTo(0.5);
        assertThat(unit.intersect(ray(1.001, 0, 5, 0, 0, -4))).isEqualTo(Object.MISS);
    }

    @Test
    void aSmallSphereFarAwayKeepsItsEdge() {
        // from 10000 away the distance squared, 1e8, has 1e-8 between neighbours: b² - 4ac would lose the radius, 1e-4
        Sphere dot = new Sphere(new Material(), new Point(), 1e-4);
        assertThat(dot.intersect(ray(0.9e-4, 0, 1e4, 0, 0, -1))).isEqualTo(1e4, within(1e-3));
        assertThat(dot.intersect(ray(1.1e-4, 0, 1e4, 0, 0, -1))).isEqualTo(Object.MISS);
    }

    @Test
    void aVastSphereIsHitWhereItsSurfaceIs() {
        // a floor of radius 1e6 whose top is y = 0, seen from a height of 2
        Sphere floor = new Sphere(new Material(), new Point(0, -1e6, 0), 1e6);
        assertThat(floor.intersect(ray(0, 2, 0, 0, -1, 0))).isEqualTo(2, within(1e-9));
    }

    @Test
    void theNormalPointsOutAndHasLengthOne() {
        // (3,2,3) - (1,2,3) = (2,0,0); (1,2,3) + 2 (0,0.6,-0.8)
        Sphere sphere = new Sphere(new Material(), new Point(1, 2, 3), 2);
        assertThat(sphere.normal(new Point(3, 2, 3))).hasToString("[1.0,0.0,0.0]");

        Vector slanted = sphere.normal(new Point(1, 3.2, 1.4));
        assertThat(slanted.y).isEqualTo(0.6, within(ROUNDING));
        assertThat(slanted.z).isEqualTo(-0.8, within(ROUNDING));
    }

    private static Ray ray(double x, double y, double z, double dx, double dy, double dz) {
        return new Ray(new Point(x, y, z), new Vector(dx, dy, dz));
    }
}
