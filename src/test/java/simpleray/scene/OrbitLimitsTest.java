package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;
import simpleray.scene.PerspectiveCamera.Pose;

/** Where a camera takes its pivot from, and where it stops. */
class OrbitLimitsTest {
    private static final Offset<Double> ROUNDING = within(1e-12);
    /** At the origin, looking along -z at what is a unit away. */
    private static final Orbit FROM_ORIGIN = Orbit.of(new Pose(0, 0, 0, 0, 0, -1, 40));

    private static Scene wallAt(double distance) {
        return Scenes.of(new Plane(new Material(), new simpleray.math.Vector(0, 0, 1), -distance));
    }

    @ParameterizedTest
    @CsvSource({"30, 20", "-120, 50", "170, -70", "90, 0"})
    void howeverItLooksTheEyeStaysAndTheWayToWhatItShowsIsThePivots(double yaw, double pitch) {
        Orbit before = new Orbit(1, 2, 3, yaw, pitch, 5, 60);
        Scene scene = Scenes.of(new Sphere(new Material(), new Point(1, 2, 3), 1.5));

        Orbit aimed = before.aimed(scene);

        assertThat(aimed.distance()).as("the ball's near side").isEqualTo(3.5, ROUNDING);
        assertThat(aimed.pose().ex()).isEqualTo(before.pose().ex(), ROUNDING);
        assertThat(aimed.pose().ey()).isEqualTo(before.pose().ey(), ROUNDING);
        assertThat(aimed.pose().ez()).isEqualTo(before.pose().ez(), ROUNDING);
        Point pivot = new Point(aimed.x(), aimed.y(), aimed.z());
        assertThat(simpleray.math.Vector.subtract(pivot, new Point(1, 2, 3)).norm()).isEqualTo(1.5, ROUNDING);
        assertThat(new double[] {aimed.yaw(), aimed.pitch(), aimed.fov()}).containsExactly(yaw, pitch, 60);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0011, 0.5, 2, 999})
    void upToAThousandTimesNearerOrFartherIsAPivot(double distance) {
        assertThat(FROM_ORIGIN.aimed(wallAt(distance)).distance()).isEqualTo(distance, within(1e-9 * distance));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0001, 0.0009, 0.001, 1000, 1001, 1e6})
    void whatIsNearerOrFartherIsNone(double distance) {
        assertThat(FROM_ORIGIN.aimed(wallAt(distance))).isSameAs(FROM_ORIGIN);
    }

    @Test
    void whatLiesBehindTheEyeIsNoPivot() {
        assertThat(FROM_ORIGIN.aimed(wallAt(-3))).isSameAs(FROM_ORIGIN);
    }

    @ParameterizedTest
    @CsvSource({"1e6, 0, 0", "0, -1e6, 0", "5, 7, 1e6"})
    void farFromTheOriginTheEyeKeepsAShareOfThatDistance(double x, double y, double z) {
        assertThat(new Orbit(x, y, z, 0, 0, 10, 40).dollied(1e-9).distance()).isEqualTo(1e-3, within(1e-15));
    }

    @Test
    void whatIsNearerThanThatAlreadyStaysAsItIsAndMayGoAway() {
        Orbit near = new Orbit(0, 0, 0, 0, 0, 1e-8, 40);

        assertThat(near.dollied(0.5).distance()).isEqualTo(1e-8);
        assertThat(near.dollied(3).distance()).isEqualTo(3e-8, within(1e-20));
    }

    @Test
    void noMoveLeadsToWhereNoDoubleIs() {
        Orbit far = new Orbit(1e308, 0, 0, 0, 0, 1e307, 90);

        assertThat(far.dollied(100)).isSameAs(far);
        assertThat(far.panned(1e3, 0)).isSameAs(far);
        assertThat(far.dollied(0.5).distance()).isEqualTo(5e306);
    }

    @Test
    void noMoveBringsTheEyeIntoThePivot() {
        Orbit orbit = new Orbit(0, 0, 0, 45, 0, 1e-6, 90);

        assertThat(orbit.panned(1e16, 0)).as("where the doubles are wider apart than eye and pivot").isSameAs(orbit);
    }

    @Test
    void straightAboveItStandsInFrontOfWhatIsUpAndStraightBelowBehind() {
        assertThat(Orbit.of(new Pose(1, 5, 3, 1, 2, 3, 60))).isEqualTo(new Orbit(1, 2, 3, 0, 90, 3, 60));
        assertThat(Orbit.of(new Pose(1, -1, 3, 1, 2, 3, 60))).isEqualTo(new Orbit(1, 2, 3, 180, -90, 3, 60));
    }
}
