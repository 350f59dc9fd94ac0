package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.ParallelCamera.View;

/** The camera of parallel rays: it looks along -z, and its picture of 4 × 2 pixels is 6 scene units high, and so 12 wide. */
class ParallelCameraTest {
    private static final Offset<Double> ROUNDING = within(1e-15);
    private static final View AHEAD = new View(1, 2, 3, 1, 2, -5, 6);

    @Test
    void raysStartInThePlaneThroughTheEyeAndAreParallel() {
        ParallelCamera camera = new ParallelCamera(AHEAD, null, 4, 2);

        assertRay(camera.through(2, 1), 1, 2, 3, 0, 0, -1);
        assertRay(camera.through(0, 0), 1 - 6, 2 + 3, 3, 0, 0, -1);
        assertRay(camera.through(3.5, 1.5), 1 + 4.5, 2 - 1.5, 3, 0, 0, -1);
        assertThat(camera.eye()).as("none that rays have in common").isNull();
        assertThat(new int[] {camera.width(), camera.height()}).containsExactly(4, 2);
    }

    @Test
    void upTurnsThePictureRoundItsMiddle() {
        ParallelCamera camera = new ParallelCamera(AHEAD, new Vector(7, 0, 0), 4, 2);

        assertRay(camera.through(2, 0), 1 + 3, 2, 3, 0, 0, -1);
        assertRay(camera.through(4, 1), 1, 2 - 6, 3, 0, 0, -1);
    }

    @Test
    void straightDownUpIsAwayFromTheViewerUnlessItIsGiven() {
        View down = new View(0, 9, 0, 0, 1, 0, 2);

        assertRay(new ParallelCamera(down, null, 2, 2).through(1, 0), 0, 9, -1, 0, -1, 0);
        assertRay(new ParallelCamera(down, new Vector(-1, 5, 0), 2, 2).through(1, 0), -1, 9, 0, 0, -1, 0);
    }

    /** From (2, 1, 2) to the origin: right is along (1, 0, -1), and up along (-1, 4, -1), since both are at right angles to (2, 1, 2). */
    @Test
    void pixelsAreSquareInASlantedView() {
        ParallelCamera camera = new ParallelCamera(new View(2, 1, 2, 0, 0, 0, 2), null, 2, 2);
        double r = StrictMath.sqrt(0.5);
        double u = 1 / StrictMath.sqrt(18);

        assertRay(camera.through(2, 1), 2 + r, 1, 2 - r, -2 / 3.0, -1 / 3.0, -2 / 3.0);
        assertRay(camera.through(1, 0), 2 - u, 1 + 4 * u, 2 - u, -2 / 3.0, -1 / 3.0, -2 / 3.0);
    }

    @Test
    void itsAxesSpanThePicture() {
        ParallelCamera camera = new ParallelCamera(AHEAD, null, 4, 2);

        assertNear(camera.forward(), 0, 0, -1);
        assertNear(camera.right(), 12, 0, 0);
        assertNear(camera.up(), 0, 6, 0);
        assertThat(camera.middle()).hasToString("[1.0,2.0,3.0]");
    }

    @Test
    void farAwayAndVeryNearLookAtPointsGiveTheSameRays() {
        assertRay(new ParallelCamera(new View(0, 0, 1e308, 0, 0, -1e308, 2), null, 2, 2).through(2, 1), 1, 0, 1e308, 0, 0, -1);
        assertRay(new ParallelCamera(new View(0, 0, 0, 0, 0, -1e-300, 2), null, 2, 2).through(2, 1), 1, 0, 0, 0, 0, -1);
    }

    private static void assertRay(Ray ray, double x, double y, double z, double dx, double dy, double dz) {
        assertNear(new Vector(ray.origin), x, y, z);
        assertNear(ray.direction, dx, dy, dz);
    }

    private static void assertNear(Vector v, double x, double y, double z) {
        assertThat(v.x).isEqualTo(x, ROUNDING);
        assertThat(v.y).isEqualTo(y, ROUNDING);
        assertThat(v.z).isEqualTo(z, ROUNDING);
    }
}
