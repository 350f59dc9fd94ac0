package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import simpleray.math.Ray;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.SceneSettings.Window;

/** Free cameras in place of simple ones. */
class FreeViewTest {
    private final SceneSettings settings = new SceneSettings();

    @Test
    void theThesissCameraIsAFreeOneOf90DegreesAtItsCentreOfProjection() {
        assertThat(FreeView.of(settings)).isEqualTo(new Pose(0, 0, 2, 0, 0, 0, 90));
        assertThat(FreeView.isExact(settings)).isTrue();
    }

    @Test
    void itsRaysAreThoseOfTheThesissCameraToTheLastBit() {
        settings.resolution = new Resolution(120, 90);
        Camera simple = settings.newCamera();
        Camera free = new PerspectiveCamera(FreeView.of(settings), 120, 90);
        for (int y = 0; y < 90; y++) {
            for (int x = 0; x < 120; x++) {
                Ray expected = simple.through(x + 0.5, y + 0.5);
                Ray actual = free.through(x + 0.5, y + 0.5);
                assertThat(actual.direction.x).isEqualTo(expected.direction.x);
                assertThat(actual.direction.y).isEqualTo(expected.direction.y);
                assertThat(actual.direction.z).isEqualTo(expected.direction.z);
            }
        }
    }

    @Test
    void aFreeCameraIsItself() {
        settings.camera = new Pose(1, 2, 3, 4, 5, 6, 7);

        assertThat(FreeView.of(settings)).isSameAs(settings.camera);
        assertThat(FreeView.isExact(settings)).isTrue();
    }

    @Test
    void raysAreTheSameWhateverTheSizeAndTheCentreOfProjection() {
        settings.cop = 3.5;
        for (Resolution size : new Resolution[] {new Resolution(37, 37), new Resolution(60, 40), new Resolution(40, 60)}) {
            settings.resolution = size;
            settings.window = null;
            assertSameRays(size);
            double half = 1.25 / size.width();
            settings.window = new Window(-half * size.width(), half * size.width(), -half * size.height(), half * size.height());
            assertSameRays(size);
        }
    }

    /** The window's middle is at (3, 4, 0), twelve units from the eye's height: 13 away. */
    @Test
    void aWindowBesideTheAxisIsLookedAt() {
        settings.cop = 12.0;
        settings.window = new Window(-10, 16, -9, 17);

        Pose pose = FreeView.of(settings);
        assertThat(pose).isEqualTo(new Pose(0, 0, 12, 3, 4, 0, pose.fov()));
        assertThat(pose.fov()).isCloseTo(90, within(1e-12));
        assertThat(FreeView.isExact(settings)).isFalse();
    }

    @Test
    void ofAStretchedWindowAllIsSeen() {
        settings.window = new Window(-2, 2, -1, 1);
        assertThat(FreeView.of(settings).fov()).as("wide, in a square picture").isCloseTo(90, within(1e-12));
        assertThat(FreeView.isExact(settings)).isFalse();

        settings.window = new Window(-1, 1, -2, 2);
        assertThat(FreeView.of(settings).fov()).as("high").isCloseTo(90, within(1e-12));
        assertThat(FreeView.isExact(settings)).isFalse();
    }

    @Test
    void aWindowOfAnySizeGivesAGoodCamera() {
        settings.window = new Window(-1e300, 1e300, -1e300, 1e300);
        assertThat(FreeView.of(settings).fault()).isNull();
    }

    private void assertSameRays(Resolution size) {
        Camera simple = settings.newCamera();
        Camera free = new PerspectiveCamera(FreeView.of(settings), size.width(), size.height());
        assertThat(FreeView.isExact(settings)).isTrue();
        for (int y = 0; y <= size.height(); y++) {
            for (int x = 0; x <= size.width(); x++) {
                Ray expected = simple.through(x, y);
                Ray actual = free.through(x, y);
                assertThat(actual.origin.z).isEqualTo(expected.origin.z);
                assertThat(actual.direction.dot(expected.direction)).isCloseTo(1, within(1e-15));
                assertThat(actual.direction.x).isCloseTo(expected.direction.x, within(1e-15));
                assertThat(actual.direction.y).isCloseTo(expected.direction.y, within(1e-15));
            }
        }
    }
}
