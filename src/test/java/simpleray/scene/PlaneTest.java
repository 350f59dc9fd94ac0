package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

class PlaneTest {
    private static final double ROUNDING = 1e-15;

    /** The floor y = -2, as in the thesis's scene: 0 1 0 and -2. */
    private final Plane floor = new Plane(new Material(), new Vector(0, 1, 0), -2);

    @Test
    void aNewPlaneIsTheFloorThroughTheOrigin() {
        Plane plane = new Plane();
        assertThat(plane.normal).hasToString("[0.0,1.0,0.0]");
        assertThat(plane.constant).isZero();
        assertThat(plane.surfaceMaterial).isNotNull();
    }

    @Test
    void aPlaneKeepsWhatItIsMadeOfAndCopiesNothing() {
        Material material = new Material();
        Vector normal = new Vector(0, 3, 0);
        Plane plane = new Plane(material, normal, 4);

        assertThat(plane.surfaceMaterial).isSameAs(material);
        assertThat(plane.normal).isSameAs(normal);
        assertThat(plane.constant).isEqualTo(4);
    }

    @Test
    void rayFromAboveHits() {
        // from y = 1 down to y = -2
        assertThat(floor.intersect(ray(5, 1, 7, 0, -1, 0))).isEqualTo(3);
    }

    @Test
    void rayFromBelowHitsToo() {
        assertThat(floor.intersect(ray(5, -6, 7, 0, 1, 0))).isEqualTo(4);
    }

    @Test
    void slantedRayHitsFurtherAway() {
        // 4 down at 0.8 a step
        assertThat(floor.intersect(ray(0, 2, 0, 0.6, -0.8, 0))).isEqualTo(5, within(5 * ROUNDING));
    }

    @Test
    void rayAlongThePlaneMisses() {
        assertThat(floor.intersect(ray(0, 1, 0, 1, 0, 0))).isEqualTo(Object.MISS);
        assertThat(floor.intersect(ray(0, -2, 0, 1, 0, 0))).as("within it").isEqualTo(Object.MISS);
    }

    @Test
    void rayAwayFromThePlaneMisses() {
        assertThat(floor.intersect(ray(0, 1, 0, 0, 1, 0))).isEqualTo(Object.MISS);
        assertThat(floor.intersect(ray(0, -3, 0, 0.6, -0.8, 0))).isEqualTo(Object.MISS);
    }

    @Test
    void rayFromThePlaneDoesNotHitIt() {
        assertThat(floor.intersect(ray(0, -2, 0, 0, -1, 0))).isEqualTo(Object.MISS);
        assertThat(floor.intersect(ray(0, -2 + 0.9e-7, 0, 0, -1, 0))).isEqualTo(Object.MISS);
        assertThat(floor.intersect(ray(0, -2 + 1.1e-7, 0, 0, -1, 0))).isEqualTo(1.1e-7, within(ROUNDING));
    }

    @Test
    void aLongerDirectionCountsFewerOfIts() {
        assertThat(floor.intersect(ray(0, 1, 0, 0, -6, 0))).isEqualTo(0.5);
        assertThat(floor.intersect(ray(0, 1, 0, 0, -0.25, 0))).isEqualTo(12);
    }

    @Test
    void aRayThatNeedsInfinitelyLongMisses() {
        assertThat(floor.intersect(ray(0, 1, 0, 1, -Double.MIN_VALUE, 0))).isEqualTo(Object.MISS);
    }

    @Test
    void theConstantIsOfTheNormalAsItIsGiven() {
        // 2 y = -2: the floor y = -1, whatever a unit normal would make of the constant
        Plane plane = new Plane(new Material(), new Vector(0, 2, 0), -2);
        assertThat(plane.intersect(ray(0, 1, 0, 0, -1, 0))).isEqualTo(2);
    }

    @Test
    void aSlantedPlaneIsWhereItsEquationSays() {
        // x + 2 y + 3 z = 14 holds at (1,2,3); from there 5 units back along (0.6,0,0.8)
        Plane plane = new Plane(new Material(), new Vector(1, 2, 3), 14);
        assertThat(plane.intersect(ray(1 - 3, 2, 3 - 4, 0.6, 0, 0.8))).isEqualTo(5, within(5 * ROUNDING));
    }

    @Test
    void theNormalHasLengthOneAndThePlaneKeepsItsOwn() {
        Plane plane = new Plane(new Material(), new Vector(0, -4, 0), 8);

        Vector normal = plane.normal(new Point(1, -2, 3));
        assertThat(normal).hasToString("[0.0,-1.0,0.0]");

        normal.negate();
        assertThat(plane.normal).hasToString("[0.0,-4.0,0.0]");
        assertThat(plane.normal(new Point(1, -2, 3))).hasToString("[0.0,-1.0,0.0]");
    }

    private static Ray ray(double x, double y, double z, double dx, double dy, double dz) {
        return new Ray(new Point(x, y, z), new Vector(dx, dy, dz));
    }
}
