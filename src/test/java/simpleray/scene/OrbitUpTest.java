package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.ParallelCamera.View;
import simpleray.scene.PerspectiveCamera.Pose;

/** Moves of a camera of parallel rays, and of one that has another direction than y as up. */
class OrbitUpTest {
    private static final Offset<Double> ROUNDING = within(1e-12);
    /** In front of (1, 2, 3), 5 away. */
    private static final View FRONT = new View(1, 2, 8, 1, 2, 3, 4);

    @Test
    void aParallelCameraTurnsAndKeepsItsHeight() {
        assertView(orbit(FRONT, null).turned(90, 0).settings().parallel, 6, 2, 3, 1, 2, 3, 4);
        assertView(orbit(FRONT, null).turned(0, 30).settings().parallel, 1, 4.5, 3 + 5 * StrictMath.cos(Math.PI / 6), 1, 2, 3, 4);
        assertThat(orbit(FRONT, null).settings().parallel).isEqualTo(FRONT);
        assertThat(orbit(FRONT, null).settings().camera).isNull();
    }

    @Test
    void goingNearerWithParallelRaysShowsLessFromTheSamePlace() {
        assertView(orbit(FRONT, null).dollied(0.5).settings().parallel, 1, 2, 8, 1, 2, 3, 2);
        assertView(orbit(FRONT, null).dollied(3).settings().parallel, 1, 2, 8, 1, 2, 3, 12);
    }

    @Test
    void aHeightStaysWithinItsRange() {
        assertThat(orbit(FRONT, null).dollied(1e-300).height()).isEqualTo(1e-6);
        assertThat(orbit(new View(0, 0, 1, 0, 0, 0, 1e-9), null).dollied(0.5).height()).as("smaller in the scene").isEqualTo(1e-9);
        assertThat(orbit(new View(0, 0, 1, 0, 0, 0, 1e100), null).dollied(2).height()).isEqualTo(1e100);
    }

    @Test
    void aParallelCameraIsPannedByHeightsOfItsPicture() {
        assertView(orbit(FRONT, null).panned(0.5, -0.25).settings().parallel, 3, 1, 8, 3, 1, 3, 4);
    }

    /** The ball's surface is at z = -1. */
    @Test
    void thePivotOfAParallelCameraIsWhatTheMiddleShows() {
        Orbit aimed = orbit(FRONT, null).aimed(Scenes.of(new Sphere(null, new Point(1, 2, -2), 1)));

        assertView(aimed.settings().parallel, 1, 2, 8, 1, 2, -1, 4);
    }

    /** With z up, the camera is at the -y side, and to its right is +x. */
    @Test
    void itTurnsRoundUp() {
        Orbit orbit = orbit(new View(1, -3, 3, 1, 2, 3, 4), new Vector(0, 0, 7));

        assertThat(orbit.pitch()).isEqualTo(0, ROUNDING);
        assertView(orbit.turned(90, 0).settings().parallel, 6, 2, 3, 1, 2, 3, 4);
        assertView(orbit.turned(0, 90 - Orbit.NEAREST_POLE).turned(0, -90 + Orbit.NEAREST_POLE).settings().parallel, 1, -3, 3, 1, 2, 3, 4);
        assertView(orbit.turned(0, 30).settings().parallel, 1, 2 - 5 * StrictMath.cos(Math.PI / 6), 5.5, 1, 2, 3, 4);
        assertView(orbit.panned(0.5, 0.25).settings().parallel, 3, -3, 4, 3, 2, 4, 4);
        assertThat(orbit.turned(90, 0).settings().up).hasToString(new Vector(0, 0, 7).toString());
    }

    /** Whatever is up, the camera keeps its distance and its height above the pivot while it goes round, and its picture stays upright. */
    @ParameterizedTest
    @CsvSource({"0, 1, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1", "1, 0, 0", "1, 2, 3", "-0.1, 0.2, 5", "0, 1, 2.0647"})
    void aTurnKeepsDistanceAndHeightAboveThePivot(double x, double y, double z) {
        Vector up = new Vector(x, y, z).normalised();
        Pose pose = new Pose(4, 6, 3, 1, 2, -5, 40);
        SceneSettings settings = new SceneSettings();
        settings.camera = pose;
        settings.up = up;
        Vector before = new Vector(3, 4, 8);
        Orbit orbit = Orbit.of(settings);

        Pose same = orbit.settings().camera;
        assertThat(new double[] {same.ex(), same.ey(), same.ez()}).containsExactly(new double[] {4, 6, 3}, ROUNDING);
        Pose turned = orbit.turned(35, 0).settings().camera;
        Vector after = new Vector(turned.ex() - 1, turned.ey() - 2, turned.ez() + 5);
        assertThat(after.dot(up)).isEqualTo(before.dot(up), ROUNDING);
        assertThat(after.norm()).isEqualTo(before.norm(), ROUNDING);
        Vector right = new PerspectiveCamera(pose, up, 1, 1).right();
        assertThat(Vector.subtract(new Point(after.x, after.y, after.z), new Point(3, 4, 8)).dot(right)).as("to its right").isPositive();
        assertThat(orbit.turned(35, 0).turned(-35, 0).settings().camera.ex()).isEqualTo(4, ROUNDING);
    }

    @Test
    void theThesissCameraBecomesAFreeOneWithoutUp() {
        SceneSettings free = FreeView.alone(new SceneSettings());

        assertThat(free.lines()).isEqualTo("camera 0.0 0.0 2.0 0.0 0.0 0.0 90.0\n");
        assertThat(Orbit.of(free).settings().lines()).isEqualTo(free.lines());
    }

    private static Orbit orbit(View view, Vector up) {
        SceneSettings settings = new SceneSettings();
        settings.parallel = view;
        settings.up = up;
        return Orbit.of(FreeView.alone(settings));
    }

    private static void assertView(View actual, double... n) {
        assertThat(new double[] {actual.ex(), actual.ey(), actual.ez(), actual.lx(), actual.ly(), actual.lz(), actual.height()})
            .containsExactly(n, ROUNDING);
    }
}
