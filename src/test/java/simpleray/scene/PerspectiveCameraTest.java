package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.PerspectiveCamera.Pose;

/** The camera that stands anywhere. With a field of view of 90 degrees the upper edge lies as far up as the picture plane lies ahead. */
class PerspectiveCameraTest {
    private static final Offset<Double> ROUNDING = within(1e-15);
    private static final Offset<Double> CLOSE = within(1e-12);
    private static final Pose AHEAD = new Pose(1, 2, 3, 1, 2, -5, 90);

    @Test
    void aRayStartsAtTheEye() {
        assertThat(new PerspectiveCamera(AHEAD, 100, 50).through(17, 4).origin).hasToString("[1.0,2.0,3.0]");
    }

    @Test
    void thePictureHasTheSizeAskedFor() {
        PerspectiveCamera camera = new PerspectiveCamera(AHEAD, 100, 50);

        assertThat(camera.width()).isEqualTo(100);
        assertThat(camera.height()).isEqualTo(50);
    }

    /** The field of view of 90 degrees is that of the height: there the picture is 2 high, and as wide as its ratio says. */
    @Test
    void itsAxesSpanThePicture() {
        PerspectiveCamera camera = new PerspectiveCamera(AHEAD, 100, 50);
        Vector forward = camera.forward();
        Vector right = camera.right();
        Vector up = camera.up();

        assertThat(forward.dot(new Vector(0, 0, -1))).isEqualTo(1, ROUNDING);
        assertThat(forward.norm()).isEqualTo(1, ROUNDING);
        assertThat(right.y).isZero();
        assertThat(right.z).isZero();
        assertThat(up.x).isZero();
        assertThat(up.z).isZero();
        assertThat(right.x / up.y).isEqualTo(2, CLOSE);
        Vector corner = new PerspectiveCamera(AHEAD, 100, 50).through(100, 0).direction;
        assertThat(corner.x / -corner.z).isEqualTo(right.x / 2, CLOSE);
        assertThat(corner.y / -corner.z).isEqualTo(up.y / 2, CLOSE);
    }

    /** Looking along -z with +x up: what was up in the picture is at its left. */
    @Test
    void upTurnsThePictureRoundItsMiddle() {
        PerspectiveCamera camera = new PerspectiveCamera(AHEAD, new Vector(1e200, 0, 0), 100, 50);

        assertDirection(camera.through(50, 25), 0, 0, -1);
        assertDirection(camera.through(50, 0), StrictMath.sqrt(0.5), 0, -StrictMath.sqrt(0.5));
        assertDirection(camera.through(100, 25), 0, -2 / StrictMath.sqrt(5), -1 / StrictMath.sqrt(5));
    }

    @Test
    void upNeedNotBeAtARightAngleToTheView() {
        Pose down = new Pose(0, 3, 4, 0, 0, 0, 40);

        assertSame(new PerspectiveCamera(down, new Vector(0, 1, 0), 30, 20), new PerspectiveCamera(down, 30, 20));
        assertSame(new PerspectiveCamera(down, new Vector(0, 0, -2), 30, 20), new PerspectiveCamera(down, 30, 20));
    }

    @Test
    void straightDownUpMayBeAnywhereAcross() {
        PerspectiveCamera camera = new PerspectiveCamera(new Pose(0, 5, 0, 0, 0, 0, 90), new Vector(1, 0, 0), 2, 2);

        assertDirection(camera.through(1, 0), StrictMath.sqrt(0.5), -StrictMath.sqrt(0.5), 0);
    }

    private static void assertSame(PerspectiveCamera camera, PerspectiveCamera expected) {
        Vector d = expected.through(3.25, 4.5).direction;
        assertDirection(camera.through(3.25, 4.5), d.x, d.y, d.z);
    }

    @Test
    void theCentreRayGoesToTheLookAtPoint() {
        assertDirection(new PerspectiveCamera(AHEAD, 100, 100).through(50, 50), 0, 0, -1);
        assertDirection(new PerspectiveCamera(new Pose(1, 2, 3, 4, 2, -1, 20), 7, 3).through(3.5, 1.5), 0.6, 0, -0.8);
        assertDirection(new PerspectiveCamera(new Pose(0, 0, 0, 2, 3, 6, 150), 3, 8).through(1.5, 4), 2 / 7.0, 3 / 7.0, 6 / 7.0);
    }

    @Test
    void theCornersOfASquareOf90DegreesLieOneAsideAndOneUp() {
        PerspectiveCamera camera = new PerspectiveCamera(AHEAD, 100, 100);

        assertDirection(camera.through(0, 0), -1, 1, -1);
        assertDirection(camera.through(100, 0), 1, 1, -1);
        assertDirection(camera.through(0, 100), -1, -1, -1);
        assertDirection(camera.through(100, 100), 1, -1, -1);
    }

    @ParameterizedTest
    @CsvSource({"200, 100, 2", "100, 200, 0.5", "300, 100, 3", "1, 4, 0.25"})
    void theWidthFollowsFromTheHeight(int width, int height, double right) {
        PerspectiveCamera camera = new PerspectiveCamera(AHEAD, width, height);

        assertDirection(camera.through(width, height / 2.0), right, 0, -1);
        assertDirection(camera.through(0, height / 2.0), -right, 0, -1);
        assertDirection(camera.through(width / 2.0, 0), 0, 1, -1);
        assertDirection(camera.through(width / 2.0, height), 0, -1, -1);
    }

    @Test
    void aFieldOfView60DegreesWideEnds30DegreesUp() {
        assertDirection(new PerspectiveCamera(new Pose(0, 0, 0, 0, 0, -1, 60), 10, 10).through(5, 0), 0, 0.5, -Math.sqrt(3) / 2);
    }

    @Test
    void pixelsAreSquareWhereverTheCameraLooks() {
        // one pixel aside and one pixel down, on the plane at distance 1 of the eye
        Vector forward = Vector.scale(new Vector(3, -4, 12), 1 / 13.0);
        PerspectiveCamera camera = new PerspectiveCamera(new Pose(5, 6, 7, 8, 2, 19, 50), 64, 20);
        Vector middle = onPlane(camera, 32, 10, forward);
        Vector aside = difference(onPlane(camera, 33, 10, forward), middle);
        Vector below = difference(onPlane(camera, 32, 11, forward), middle);

        double pixel = 2 * Math.tan(Math.toRadians(25)) / 20;
        assertThat(aside.norm()).isEqualTo(pixel, CLOSE);
        assertThat(below.norm()).isEqualTo(pixel, CLOSE);
        assertThat(aside.dot(below)).isEqualTo(0, CLOSE);
        assertThat(aside.y).as("the horizon is level").isEqualTo(0, CLOSE);
        assertThat(below.y).as("up is +y").isNegative();
    }

    @Test
    void lookingStraightDownMinusZIsUp() {
        PerspectiveCamera camera = new PerspectiveCamera(new Pose(1, 9, 2, 1, 0, 2, 90), 10, 10);

        assertDirection(camera.through(5, 5), 0, -1, 0);
        assertDirection(camera.through(5, 0), 0, -1, -1);
        assertDirection(camera.through(10, 5), 1, -1, 0);
    }

    @Test
    void lookingStraightUpMinusZIsUpAndXIsAtTheLeft() {
        PerspectiveCamera camera = new PerspectiveCamera(new Pose(1, 0, 2, 1, 9, 2, 90), 10, 10);

        assertDirection(camera.through(5, 5), 0, 1, 0);
        assertDirection(camera.through(5, 0), 0, 1, -1);
        assertDirection(camera.through(0, 5), 1, 1, 0);
    }

    @ParameterizedTest
    @CsvSource({"2, 200, 200", "2, 37, 11", "2, 11, 37", "0.5, 64, 48", "10, 5, 7"})
    void itSeesWhatASimpleCameraSees(double cop, int width, int height) {
        SimpleCamera simple = new SimpleCamera(width, height);
        simple.setCOP(cop);
        double top = height > width ? 2.0 * height / width : 2;
        double fov = 2 * Math.toDegrees(Math.atan(top / cop));
        PerspectiveCamera camera = new PerspectiveCamera(new Pose(0, 0, cop, 0, 0, -3, fov), width, height);

        for (double px = 0; px <= width; px += width / 4.0) {
            for (double py = 0; py <= height; py += height / 4.0) {
                Ray expected = simple.through(px, py);
                Ray ray = camera.through(px, py);
                assertThat(ray.origin).hasToString(expected.origin.toString());
                assertThat(difference(ray.direction, expected.direction).norm()).isEqualTo(0, CLOSE);
            }
        }
    }

    @Test
    void aRayIsTheCallersOwn() {
        PerspectiveCamera camera = new PerspectiveCamera(AHEAD, 10, 10);
        camera.through(5, 5).origin.x = 77;

        assertThat(camera.through(5, 5).origin.x).isEqualTo(1);
    }

    private static Vector difference(Vector one, Vector other) {
        return Vector.add(one, Vector.negate(other));
    }

    private static Vector onPlane(PerspectiveCamera camera, double px, double py, Vector forward) {
        Vector direction = camera.through(px, py).direction;
        return Vector.scale(direction, 1 / direction.dot(forward));
    }

    /** The ray goes along this vector, of any length, and is of unit length. */
    private static void assertDirection(Ray ray, double x, double y, double z) {
        Vector unit = new Vector(x, y, z).normalised();
        assertThat(ray.direction.norm()).isEqualTo(1, ROUNDING);
        assertThat(difference(ray.direction, unit).norm()).as(ray.direction + " is " + unit).isEqualTo(0, ROUNDING);
    }
}
