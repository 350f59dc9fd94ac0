package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Settings put above others, as the command line's above a file's, and the camera that they make. */
class SceneSettingsUnderTest {
    private static final SceneSettings.Window WINDOW = new SceneSettings.Window(-1, 3, -1, 1);
    private static final PerspectiveCamera.Pose POSE = new PerspectiveCamera.Pose(0, 0, 7, 0, 0, 0, 40);
    private static final ParallelCamera.View VIEW = new ParallelCamera.View(3, 4, 7, 0, 0, 0, 5);

    private final SceneSettings file = new SceneSettings();
    private final SceneSettings line = new SceneSettings();

    @Test
    void whatIsNotAskedForAboveStays() {
        fill(file);

        assertThat(SceneBits.of(file.under(line))).isEqualTo(SceneBits.of(file));
    }

    @Test
    void whatIsAskedForAboveWins() {
        fill(file);
        line.background = new Colour(1, 0, 0);
        line.window = new SceneSettings.Window(0, 1, 0, 1);
        line.cop = 9.0;
        line.resolution = new SceneSettings.Resolution(1, 2);
        line.depth = 0;
        line.samples = 1;

        assertThat(SceneBits.of(file.under(line))).isEqualTo(SceneBits.of(line));
    }

    @Test
    void neitherIsChanged() {
        fill(file);
        line.camera = POSE;
        List<java.lang.Object> before = SceneBits.of(file);
        List<java.lang.Object> above = SceneBits.of(line);

        file.under(line);

        assertThat(SceneBits.of(file)).isEqualTo(before);
        assertThat(SceneBits.of(line)).isEqualTo(above);
    }

    @Test
    void aCameraTakesThePlaceOfCopAndWindow() {
        fill(file);
        line.camera = POSE;
        SceneSettings both = file.under(line);

        assertThat(both.camera).isEqualTo(POSE);
        assertThat(both.cop).isNull();
        assertThat(both.window).isNull();
        assertThat(both.depth).isEqualTo(3);
    }

    @Test
    void aCopOrAWindowTakesThePlaceOfACamera() {
        file.camera = POSE;
        line.cop = 3.0;
        SceneSettings cop = file.under(line);
        line.cop = null;
        line.window = WINDOW;
        SceneSettings window = file.under(line);

        assertThat(cop.camera).isNull();
        assertThat(cop.cop).isEqualTo(3);
        assertThat(window.camera).isNull();
        assertThat(window.window).isEqualTo(WINDOW);
    }

    @Test
    void aCopLeavesTheWindowAndAWindowTheCop() {
        fill(file);
        line.cop = 9.0;
        assertThat(file.under(line).window).isEqualTo(WINDOW);
        assertThat(file.under(line).cop).isEqualTo(9);

        line.cop = null;
        line.window = new SceneSettings.Window(0, 1, 0, 1);
        assertThat(file.under(line).cop).isEqualTo(4);
        assertThat(file.under(line).window).isEqualTo(line.window);
    }

    @Test
    void aParallelCameraTakesThePlaceOfEachOtherButLeavesUp() {
        line.parallel = VIEW;
        for (SceneSettings other : List.of(file, filled())) {
            assertThat(other.under(line).parallel).isEqualTo(VIEW);
            assertThat(other.under(line).cop).isNull();
            assertThat(other.under(line).window).isNull();
        }
        file.camera = POSE;
        file.up = new Vector(1, 2, 3);
        assertThat(file.under(line).camera).isNull();
        assertThat(file.under(line).up).isSameAs(file.up);
        line.parallel = null;
        line.cop = 3.0;
        assertThat(file.under(line).up).isNull();
    }

    @Test
    void upNeedsACameraThatItIsNotAlong() {
        file.up = new Vector(0, 0, 3);
        assertThatThrownBy(file::newCamera).isInstanceOf(IllegalArgumentException.class).hasMessage("up needs a camera or parallel");
        line.camera = new PerspectiveCamera.Pose(1, 2, 3, 1, 2, 2, 40);
        assertThatThrownBy(file.under(line)::newCamera).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("up must not be along the view");
        line.camera = null;
        line.parallel = new ParallelCamera.View(1, 2, 3, 1, 2, 2, 40);
        assertThatThrownBy(file.under(line)::newCamera).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("up must not be along the view");
    }

    @Test
    void aViewMakesAParallelCameraAndUpTurnsEither() {
        Vector up = new Vector(1, 0, 1);
        file.parallel = VIEW;
        file.resolution = new SceneSettings.Resolution(30, 10);
        assertSame(file.newCamera(), new ParallelCamera(VIEW, null, 30, 10));

        file.up = up;
        assertSame(file.newCamera(), new ParallelCamera(VIEW, up, 30, 10));
        file.parallel = null;
        file.camera = POSE;
        assertSame(file.newCamera(), new PerspectiveCamera(POSE, up, 30, 10));
    }

    private static SceneSettings filled() {
        SceneSettings settings = new SceneSettings();
        fill(settings);
        return settings;
    }

    @Test
    void withoutSettingsTheCameraIsTheThesiss() {
        Camera camera = new SceneSettings().newCamera();

        assertSame(camera, new SimpleCamera());
        assertThat(camera.width()).isEqualTo(200);
        assertThat(camera.height()).isEqualTo(200);
    }

    @Test
    void resolutionGrowsTheDefaultWindowAndStretchesOneThatIsSet() {
        file.resolution = new SceneSettings.Resolution(30, 10);
        assertSame(file.newCamera(), new SimpleCamera(30, 10));

        file.window = WINDOW;
        SimpleCamera stretched = new SimpleCamera(30, 10);
        stretched.setVPWindow(-1, 3, -1, 1);
        assertSame(file.newCamera(), stretched);

        file.cop = 4.0;
        stretched.setCOP(4);
        assertSame(file.newCamera(), stretched);
    }

    @Test
    void aPoseMakesAPerspectiveCamera() {
        file.camera = POSE;
        assertSame(file.newCamera(), new PerspectiveCamera(POSE, 200, 200));

        file.resolution = new SceneSettings.Resolution(30, 10);
        assertSame(file.newCamera(), new PerspectiveCamera(POSE, 30, 10));
    }

    private static void fill(SceneSettings settings) {
        settings.background = new Colour(0.1, 0.2, 0.3);
        settings.window = WINDOW;
        settings.cop = 4.0;
        settings.resolution = new SceneSettings.Resolution(64, 48);
        settings.depth = 3;
        settings.samples = 2;
    }

    private static void assertSame(Camera camera, Camera expected) {
        assertThat(camera).isInstanceOf(expected.getClass());
        assertThat(camera.width()).isEqualTo(expected.width());
        assertThat(camera.height()).isEqualTo(expected.height());
        Ray ray = camera.through(3.25, 4.5);
        Ray other = expected.through(3.25, 4.5);
        assertThat(ray.origin).hasToString(other.origin.toString());
        assertThat(new Vector(ray.direction)).hasToString(other.direction.toString());
    }
}
