package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Ray;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings.Window;
import simpleray.text.SceneFormatException;

/** Scenes that are read, printed and given another view more than once, and views as wide as numbers go. */
class SceneAnewTest {
    private static final String MATERIAL = "  1 1 1  1 1 1  0 0 0  2\n";
    private static final String TWO = "2\n0 0 0 0 1" + MATERIAL + "1 0 1 0 -1" + MATERIAL + "0.5 0.5 0.5\n1\n0 1 1 1  0 5 0\ndepth 3\n";
    private static final String BARE = "0 # objects\n0.1 0.1 0.1 # ambient\n0";

    private static Scene read(String text) throws IOException {
        Scene scene = new Scene();
        scene.read(reader(text));
        return scene;
    }

    @Test
    void aSceneThatIsReadAgainHasNothingOfTheOneBefore() throws IOException {
        Scene scene = read(TWO);
        scene.read(reader("1\n0 0 0 0 3" + MATERIAL + "0 0 0\n2\n0 1 1 1  0 5 0\n1 1 1 1  0 -1 0\n"));

        assertThat(written(scene::write)).isEqualTo("""
            # number of objects
            1
            0  0.0 0.0 0.0 3.0  1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0
            # ambient light
            0.0 0.0 0.0
            # number of lights
            2
            0  1.0 1.0 1.0  0.0 5.0 0.0
            1  1.0 1.0 1.0  0.0 -1.0 0.0
            """);
    }

    @Test
    void whatIsPrintedNamesObjectsLightsAndSettings() throws IOException {
        assertThat(written(read(TWO)::print)).isEqualTo("""
            Scene has 2 objects
            Scene has 1 lights
            Number of objects 2
            Sphere with centre: [0.0,0.0,0.0] and radius: 1.0
            Material: ambient (1.0,1.0,1.0) diffuse (1.0,1.0,1.0) specular (0.0,0.0,0.0) shininess 2.0
            Plane with normal: [0.0,1.0,0.0] and constant: -1.0
            Material: ambient (1.0,1.0,1.0) diffuse (1.0,1.0,1.0) specular (0.0,0.0,0.0) shininess 2.0
            Ambient light is 0.5 0.5 0.5
            Number of lights 1
            Point light with colour: (1.0,1.0,1.0) and origin: [0.0,5.0,0.0]
            depth 3
            """);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1e308 1.7e308 -1 1", "-1 1 -1.7e308 -1e308", "-1e307 1e307 0 1"})
    void aWindowMayLieWhereverItsSidesAreNumbers(String window) throws IOException {
        Window w = read("0 0 0 0 0\nwindow " + window).settings.window;
        SimpleCamera camera = new SimpleCamera(3, 2);
        camera.setVPWindow(w.xmin(), w.xmax(), w.ymin(), w.ymax());

        assertThat(camera.window()).isEqualTo(w);
    }

    @ParameterizedTest
    @ValueSource(strings = {"-1e308 1e308 -1 1", "-1 1 -1e308 1e308"})
    void aWindowThatIsWiderThanANumberIsNone(String window) {
        assertThatThrownBy(() -> read("0 0 0 0 0\nwindow " + window)).isInstanceOf(SceneFormatException.class).hasMessageStartingWith(
            "<stdin>:2:8: error: expected window's xmin below its xmax and ymin below its ymax, found '" + window + "'\n");
    }

    /** It looks along -z, and its sides are as long as those at a distance of 1. */
    @ParameterizedTest
    @CsvSource({"1e-300", "1e-200", "1e-100", "1e-3", "1e3", "1e100", "1e200", "1e300"})
    void aCameraSeesTheSameHoweverFarTheFarPointThatItLooksAt(double distance) {
        Ray near = new PerspectiveCamera(new Pose(0, 0, 0, 0, 0, -1, 70), 30, 20).through(3.5, 4.5);
        Ray far = new PerspectiveCamera(new Pose(0, 0, 0, 0, 0, -distance, 70), 30, 20).through(3.5, 4.5);

        assertThat(far.direction.x).isEqualTo(near.direction.x, within(1e-15));
        assertThat(far.direction.y).isEqualTo(near.direction.y, within(1e-15));
        assertThat(far.direction.z).isEqualTo(near.direction.z, within(1e-15));
    }

    private static String put(String text, SceneSettings view) throws IOException {
        return new String(ViewLines.put(text.getBytes(StandardCharsets.UTF_8), Path.of("room.scene"), view, Reach.FOLDER),
            StandardCharsets.UTF_8);
    }

    @Test
    void numbersChangeWhereverTheirLinesStand() throws IOException {
        SceneSettings view = new SceneSettings();
        view.cop = 3.0;
        view.window = new Window(-1, 1, -2, 2);

        assertThat(put(BARE + "\ncop 5\nwindow -1 1 -1 1\n", view)).isEqualTo(BARE + "\ncop 3\nwindow -1 1 -2 2\n");
    }

    @Test
    void aLineOfWhichOnlyBlanksWouldBeLeftGoesWithThem() throws IOException {
        SceneSettings view = new SceneSettings();
        view.camera = new Pose(1, 2, 3, 0, 0, 0, 40);
        String line = "camera 1 2 3 0 0 0 40";

        assertThat(put(BARE + "\nwindow -1 1 -1 1\ncop 3 \t\nsamples 2\n", view)).isEqualTo(BARE + "\n" + line + "\nsamples 2\n");
        assertThat(put(BARE + "\nwindow -1 1 -1 1\n  cop 3  ", view)).isEqualTo(BARE + "\n" + line + "\n");
        assertThat(put(BARE.replace('\n', '\r') + '\r', view)).isEqualTo(BARE.replace('\n', '\r') + '\r' + line + '\r');
    }

    /** 5 away a field of view of 60 degrees is 10 tan 30° high. */
    @Test
    void aPanIsMeasuredByWhatThePictureShows() {
        Orbit panned = new Orbit(1, 2, 3, 0, 0, 5, 60).panned(0.5, 2);

        assertThat(panned.x()).isEqualTo(1 + 5 / Math.sqrt(3), within(1e-12));
        assertThat(panned.y()).isEqualTo(2 + 20 / Math.sqrt(3), within(1e-12));
    }

    @Test
    void aPictureMayHaveOnePixel() {
        assertThat(new SimpleCamera(1, 1).width()).isEqualTo(1);
        assertThat(new SimpleCamera(1, 1).height()).isEqualTo(1);
    }

    @Test
    void theEyeIsWhereThePoseSays() {
        assertThat(new PerspectiveCamera(new Pose(1, 2, 3, 0, 0, 0, 70), 3, 2).eye()).hasToString("[1.0,2.0,3.0]");
    }

    @Test
    void behindACameraAnyOtherSettingMayFollow() throws IOException {
        assertThat(read("0 0 0 0 0\ncamera 1 2 3 4 5 6 70\ndepth 4\nsamples 2\n").settings.depth).isEqualTo(4);
    }
}
