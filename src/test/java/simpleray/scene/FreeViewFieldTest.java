package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.SceneSettings.Window;

/** How wide the free camera looks, from a centre of projection 2 away unless said otherwise. */
class FreeViewFieldTest {
    private final SceneSettings settings = new SceneSettings();

    /** The half height that is to be seen is 2 tan(fov / 2): the window's own, or what its width needs in this picture. */
    @ParameterizedTest
    @CsvSource({"-2, 2, -1, 1, 100, 100, 2", "-2, 2, -1, 1, 100, 25, 1", "-2, 2, -1, 1, 100, 200, 4", "-1, 1, -2, 2, 100, 300, 3",
        "-3, 3, -1, 1, 300, 100, 1", "-3, 3, -1, 1, 100, 100, 3"})
    void theWholeWindowIsSeen(double xmin, double xmax, double ymin, double ymax, int width, int height, double half) {
        settings.window = new Window(xmin, xmax, ymin, ymax);
        settings.resolution = new Resolution(width, height);

        assertThat(FreeView.of(settings).fov()).isEqualTo(Math.toDegrees(2 * Math.atan(half / 2)), within(1e-10));
    }

    @ParameterizedTest
    @CsvSource({"-2, 2, -2, 2, true", "-2, 3, -2.5, 2.5, false", "-2.5, 2.5, -2, 3, false", "-2, 2, -2.001, 2.001, false",
        "-2.001, 2.001, -2, 2, false", "-2, 2, -2.0000000000000004, 2.0000000000000004, true"})
    void onlyAWindowAboutTheAxisWithSquarePixelsIsShownExactly(double xmin, double xmax, double ymin, double ymax, boolean exact) {
        settings.window = new Window(xmin, xmax, ymin, ymax);

        assertThat(FreeView.isExact(settings)).isEqualTo(exact);
    }

    @Test
    void noFieldOfViewIsHalfATurn() {
        settings.window = new Window(-1e9, 1e9, -1e9, 1e9);

        assertThat(FreeView.of(settings).fov()).isEqualTo(179.9);
    }

    @Test
    void itLooksAtTheMiddleOfAWindowThatIsStretchedToo() {
        settings.cop = 12.0;
        settings.window = new Window(-1, 7, 1, 7);

        assertThat(FreeView.of(settings)).isEqualTo(
            new PerspectiveCamera.Pose(0, 0, 12, 3, 4, 0, FreeView.of(settings).fov()));
        assertThat(FreeView.of(settings).fov()).as("4 at a distance of 13").isEqualTo(Math.toDegrees(2 * Math.atan(4.0 / 13)), within(1e-10));
    }

    /** Of the doubles about it no other gives the half height better. */
    @ParameterizedTest
    @CsvSource({"1, 3", "0.7, 2", "2, 0.3", "1, 1e-3", "5, 7"})
    void theHalfHeightIsMetAsWellAsADoubleCan(double half, double cop) {
        settings.cop = cop;
        settings.window = new Window(-half, half, -half, half);
        double fov = FreeView.of(settings).fov();

        double off = Math.abs(PerspectiveCamera.halfHeight(cop, fov) - half);
        assertThat(off).isLessThanOrEqualTo(Math.abs(PerspectiveCamera.halfHeight(cop, Math.nextUp(fov)) - half));
        assertThat(off).isLessThanOrEqualTo(Math.abs(PerspectiveCamera.halfHeight(cop, Math.nextDown(fov)) - half));
    }
}
