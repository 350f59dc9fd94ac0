package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.scene.PerspectiveCamera.Pose;

/** How a camera moves round its pivot; the numbers can be checked by hand. */
class OrbitTest {
    private static final Offset<Double> ROUNDING = within(1e-12);
    /** At (1, 2, 8), looking along -z at (1, 2, 3), and seeing 10 units of height there: tan 45° = 1. */
    private static final Pose FRONT = new Pose(1, 2, 8, 1, 2, 3, 90);

    @Test
    void aCameraInFrontHasNoYawAndNoPitch() {
        assertThat(Orbit.of(FRONT)).isEqualTo(new Orbit(1, 2, 3, 0, 0, 5, 90));
        assertThat(Orbit.of(FRONT).pose()).isEqualTo(FRONT);
    }

    @ParameterizedTest
    @CsvSource({"90, 0, 6, 2, 3", "-90, 0, -4, 2, 3", "180, 0, 1, 2, -2", "0, 30, 1, 4.5, 7.330127018922193",
        "90, 30, 5.330127018922193, 4.5, 3", "0, -30, 1, -0.5, 7.330127018922193"})
    void turningGoesRoundThePivotAtTheSameDistance(double right, double up, double ex, double ey, double ez) {
        assertPose(Orbit.of(FRONT).turned(right, up).pose(), new Pose(ex, ey, ez, 1, 2, 3, 90));
    }

    @Test
    void itLooksAtAnotherPointFromWhereItIsAndAParallelOneMovesThere() {
        assertPose(Orbit.of(FRONT).lookingAt(new Point(4, 2, 8)).pose(), new Pose(1, 2, 8, 4, 2, 8, 90));
        assertPose(new Orbit(1, 2, 3, 0, 0, 5, 0, 2, null).lookingAt(new Point(2, 4, 6)).pose(), new Pose(2, 4, 11, 2, 4, 6, 0));
        assertThat(Orbit.of(FRONT).lookingAt(new Point(1, 2, 8))).as("its own eye").isEqualTo(Orbit.of(FRONT));
    }

    @Test
    void aFullTurnReturnsHoweverManySteps() {
        Orbit slanted = Orbit.of(new Pose(4, 6, 3, 1, 2, -5, 40));
        Orbit turned = slanted;
        for (int i = 0; i < 72; i++) {
            turned = turned.turned(5, 0);
        }

        assertPose(turned.pose(), slanted.pose());
        assertPose(slanted.turned(360, 0).pose(), slanted.pose());
    }

    @ParameterizedTest
    @ValueSource(doubles = {90, 100, 270, 1e9})
    void aPoleIsNeverCrossedSoThatUpStaysUp(double degrees) {
        Pose above = Orbit.of(FRONT).turned(0, degrees).pose();
        Pose below = Orbit.of(FRONT).turned(0, -degrees).pose();

        assertThat(above.ey()).isCloseTo(7, within(1e-4));
        assertThat(below.ey()).isCloseTo(-3, within(1e-4));
        assertThat(above.ez()).as("still in front").isGreaterThan(3).isEqualTo(below.ez());
        assertThat(topOf(above)).as("up in the picture is away from the eye, seen from above").isLessThan(0);
    }

    @Test
    void atThePoleTheWayBackBeginsAtOnce() {
        Orbit atThePole = Orbit.of(FRONT).turned(0, 1000);

        assertThat(atThePole.pitch()).isEqualTo(89.9);
        assertThat(atThePole.turned(0, -9.9).pitch()).isCloseTo(80, ROUNDING);
    }

    /** Its right and its up are those that the scene's camera has. */
    @ParameterizedTest
    @ValueSource(doubles = {3, -3})
    void aCameraAlongYKeepsItsSidesWhenItIsTurnedALittle(double height) {
        Pose along = new Pose(1, 2 + height, 3, 1, 2, 3, 60);
        Orbit orbit = Orbit.of(along);
        Ray before = new PerspectiveCamera(along, 100, 100).through(80, 10);
        Ray after = new PerspectiveCamera(orbit.turned(0, 0).pose(), 100, 100).through(80, 10);

        assertThat(orbit.pose()).isEqualTo(along);
        assertThat(before.direction.dot(after.direction)).isCloseTo(1, within(1e-5));
        assertThat(orbit.dollied(2).pose()).isEqualTo(new Pose(1, 2 + 2 * height, 3, 1, 2, 3, 60));
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 10, 0, 0", "90, 0, 0, 0, -10", "180, 0, -10, 0, 0", "90, 60, 0, 0, -10"})
    void panningToTheRightMovesEyeAndPivotBySoManyHeightsOfThePicture(double yaw, double pitch, double dx, double dy, double dz) {
        Orbit orbit = Orbit.of(FRONT).turned(yaw, pitch);
        assertMoved(orbit, orbit.panned(1, 0), dx, dy, dz);
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 0, 10, 0", "90, 0, 0, 10, 0", "0, 30, 0, 8.660254037844386, -5", "90, 30, -5, 8.660254037844386, 0"})
    void panningUpMovesThemAtRightAnglesToTheView(double yaw, double pitch, double dx, double dy, double dz) {
        Orbit orbit = Orbit.of(FRONT).turned(yaw, pitch);
        assertMoved(orbit, orbit.panned(0, 1), dx, dy, dz);
    }

    @Test
    void dollyingChangesTheDistanceAlone() {
        assertThat(Orbit.of(FRONT).dollied(0.5).pose()).isEqualTo(new Pose(1, 2, 5.5, 1, 2, 3, 90));
        assertThat(Orbit.of(FRONT).dollied(3).pose()).isEqualTo(new Pose(1, 2, 18, 1, 2, 3, 90));
    }

    @Test
    void noDollyReachesThePivot() {
        Orbit orbit = Orbit.of(FRONT);
        for (int i = 0; i < 5000; i++) {
            orbit = orbit.dollied(0.5);
            assertThat(orbit.pose().fault()).isNull();
            assertThat(orbit.pose().ez()).isGreaterThan(3);
        }
        assertThat(orbit.distance()).isEqualTo(1e-6);
        assertThat(orbit.dollied(1e6).distance()).as("the way back").isCloseTo(1, ROUNDING);
    }

    @Test
    void noDollyLeavesTheDoubles() {
        Orbit orbit = Orbit.of(FRONT);
        for (int i = 0; i < 5000; i++) {
            orbit = orbit.dollied(2).panned(1, 1);
        }
        assertThat(orbit.pose().ez()).isFinite();
        assertThat(orbit.pose().fault()).isNull();
    }

    @Test
    void whatTheMiddleShowsBecomesThePivotAndTheEyeStays() {
        Orbit aimed = Orbit.of(FRONT).aimed(withSphere(new Point(1, 2, -2), 1));

        assertThat(aimed).isEqualTo(new Orbit(1, 2, -1, 0, 0, 9, 90));
        assertThat(aimed.pose().ez()).isEqualTo(8);
    }

    @Test
    void theNearestOfWhatTheMiddleShowsBecomesThePivot() {
        Scene scene = withSphere(new Point(1, 2, -2), 1);
        scene.setNumberObjects(2);
        scene.setObject(1, new Sphere(new Material(), new Point(1, 2, 5), 1));

        assertThat(Orbit.of(FRONT).aimed(scene).distance()).isEqualTo(2);
    }

    @Test
    void whereTheMiddleShowsNothingOrWhatIsMuchTooFarThePivotStays() {
        assertThat(Orbit.of(FRONT).aimed(new Scene())).isEqualTo(Orbit.of(FRONT));
        assertThat(Orbit.of(FRONT).aimed(withSphere(new Point(1, 2, -9000), 1))).isEqualTo(Orbit.of(FRONT));
    }

    private static Scene withSphere(Point centre, double radius) {
        Scene scene = new Scene();
        scene.setNumberObjects(1);
        scene.setObject(0, new Sphere(new Material(), centre, radius));
        return scene;
    }

    /** {@return z of the ray through the middle of the picture's top} */
    private static double topOf(Pose pose) {
        return new PerspectiveCamera(pose, 100, 100).through(50, 0).direction.z;
    }

    private static void assertMoved(Orbit before, Orbit after, double dx, double dy, double dz) {
        Pose a = before.pose();
        assertPose(after.pose(), new Pose(a.ex() + dx, a.ey() + dy, a.ez() + dz, a.lx() + dx, a.ly() + dy, a.lz() + dz, a.fov()));
    }

    private static void assertPose(Pose actual, Pose expected) {
        assertThat(new double[] {actual.ex(), actual.ey(), actual.ez(), actual.lx(), actual.ly(), actual.lz(), actual.fov()})
            .containsExactly(new double[] {expected.ex(), expected.ey(), expected.ez(), expected.lx(), expected.ly(), expected.lz(),
                expected.fov()}, ROUNDING);
    }
}
