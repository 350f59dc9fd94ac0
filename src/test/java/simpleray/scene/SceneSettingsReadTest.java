package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Colour;
import simpleray.math.Vector;
import simpleray.text.Diagnostic;
import simpleray.text.SceneReader;

/** What a scene file may say after its last light. */
class SceneSettingsReadTest {
    private static final String SCENE = "0  0 0 0  1  0 1 1 1 0 5 0\n";
    private static final SceneSettings.Window WINDOW = new SceneSettings.Window(-1, 2.5, -0.5, 1e1);
    private static final PerspectiveCamera.Pose POSE = new PerspectiveCamera.Pose(3, 2, 5, 0, -1, 0.5, 40);

    @Test
    void aFileWithoutKeywordsAsksForNothing() throws IOException {
        assertThat(SceneBits.of(read(""))).isEqualTo(SceneBits.of(new SceneSettings())).containsOnlyNulls();
    }

    @Test
    void eachKeywordAsksForItsOwnThing() throws IOException {
        SceneSettings background = new SceneSettings();
        background.background = new Colour(0.1, 0.2, 4);
        assertReads("background 0.1 0.2 4", background);
        SceneSettings window = new SceneSettings();
        window.window = WINDOW;
        assertReads("window -1 2.5 -0.5 1e1", window);
        SceneSettings cop = new SceneSettings();
        cop.cop = 3.5;
        assertReads("cop 3.5", cop);
        SceneSettings camera = new SceneSettings();
        camera.camera = POSE;
        assertReads("camera 3 2 5  0 -1 0.5  40", camera);
        camera.up = new Vector(0.5, -2, 0);
        assertReads("up 0.5 -2 0\ncamera 3 2 5  0 -1 0.5  40", camera);
        SceneSettings parallel = new SceneSettings();
        parallel.parallel = new ParallelCamera.View(3, 2, 5, 0, -1, 0.5, 4);
        assertReads("parallel 3 2 5  0 -1 0.5  4", parallel);
        parallel.up = new Vector(0, 0, -1e9);
        assertReads("parallel 3 2 5  0 -1 0.5  4\nup 0 0 -1e9", parallel);
        SceneSettings resolution = new SceneSettings();
        resolution.resolution = new SceneSettings.Resolution(640, 480);
        assertReads("resolution 640 480", resolution);
        SceneSettings depth = new SceneSettings();
        depth.depth = 3;
        assertReads("depth 3", depth);
        SceneSettings samples = new SceneSettings();
        samples.samples = 4;
        assertReads("samples 4", samples);
    }

    @Test
    void aBackgroundMayBeNone() throws IOException {
        SceneSettings none = read("background none # to be cut out\ndepth 2");

        assertThat(none.isTransparent()).isTrue();
        assertThat(none.depth).isEqualTo(2);
        assertThat(none.lines()).isEqualTo("background none\ndepth 2\n");
        assertThat(read("background\nnone").isTransparent()).isTrue();
        assertThat(SceneSettings.of("background none\n", "options").isTransparent()).isTrue();
        assertThat(read("background 0 0 0").isTransparent()).isFalse();
        assertThat(new SceneSettings().isTransparent()).isFalse();
        assertThat(Setting.BACKGROUND.identity(none)).isEqualTo("none");
        assertThat(Setting.BACKGROUND.text(none)).isEqualTo("none");
        assertThat(Setting.BACKGROUND.parse("none")).isSameAs(SceneSettings.TRANSPARENT);
        assertThat(SceneSettings.isSetting("background none")).isTrue();
    }

    @Test
    void anotherWordIsNoBackground() {
        assertThatThrownBy(() -> read("background nothing")).hasMessageStartingWith(
            "<stdin>:2:12: error: expected background's red, or none, found 'nothing'");
        assertThatThrownBy(() -> read("background none 0")).hasMessageContaining("<stdin>:2:17: error: expected");
        assertThatThrownBy(() -> Setting.BACKGROUND.parse("None")).hasMessage(
            "expected none, or three numbers such as 0.1,0.2,0.4, found 'None'");
    }

    @Test
    void theOptionWinsOverTheFile() throws IOException {
        SceneSettings none = read("background none");
        SceneSettings red = read("background 1 0 0");

        assertThat(none.under(red).isTransparent()).isFalse();
        assertThat(red.under(none).isTransparent()).isTrue();
        assertThat(none.under(new SceneSettings()).isTransparent()).isTrue();
    }

    @Test
    void theEndsOfEachRangeAreGood() throws IOException {
        assertThat(read("depth 0").depth).isZero();
        assertThat(read("depth 1000").depth).isEqualTo(1000);
        assertThat(read("samples 1").samples).isEqualTo(1);
        assertThat(read("samples 16").samples).isEqualTo(16);
        assertThat(read("resolution 1 65535").resolution).isEqualTo(new SceneSettings.Resolution(1, 65535));
        assertThat(read("resolution 65535 1").resolution).isEqualTo(new SceneSettings.Resolution(65535, 1));
        assertThat(read("cop 4.9e-324").cop).isEqualTo(Double.MIN_VALUE);
        assertThat(read("camera 0 0 0 0 0 1 179.99999").camera.fov()).isEqualTo(179.99999);
        assertThat(read("camera 0 0 0 0 0 1e-300 1e-9").camera.lz()).isEqualTo(1e-300);
        assertThat(read("background 0 0 0").background).hasToString("(0.0,0.0,0.0)");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void keywordsComeInAnyOrder(long seed) throws IOException {
        List<String> lines = new ArrayList<>(List.of("background 0.1 0.2 4", "window -1 2.5 -0.5 1e1", "cop 3.5", "resolution 640 480",
            "depth 3", "samples 4"));
        List<java.lang.Object> expected = SceneBits.of(read(String.join("\n", lines)));
        Collections.shuffle(lines, new Random(seed));

        assertThat(SceneBits.of(read(String.join("\n", lines)))).isEqualTo(expected);
    }

    @Test
    void headingsAndCommentsMayStandBetweenThem() throws IOException {
        SceneReader is = reader(SCENE + "# the eye\ncop 3 # far\nSize of the picture\n\n\tresolution 4\n5\ndeptth 7\n samples 2\nThe end");
        Scene scene = new Scene();
        scene.read(is);

        assertThat(scene.settings.cop).isEqualTo(3);
        assertThat(scene.settings.resolution).isEqualTo(new SceneSettings.Resolution(4, 5));
        assertThat(scene.settings.samples).isEqualTo(2);
        assertThat(scene.settings.depth).as("a misspelt keyword is skipped").isNull();
        assertThat(is.warnings()).extracting(Diagnostic::toString).containsExactly("""
            <stdin>:4:1: warning: expected a value or a comment, found the heading 'Size of the picture', which is skipped
            Size of the picture
            ^""", """
            <stdin>:8:1: warning: unknown setting 'deptth': did you mean depth? The line is skipped
            deptth 7
            ^""", """
            <stdin>:10:1: warning: expected a value or a comment, found the heading 'The end', which is skipped
            The end
            ^""");
    }

    @Test
    void aKeywordBeforeItsPlaceIsAHeading() throws IOException {
        SceneReader is = reader("depth 3\n0\nsamples 2\n0 0 0\ncop 1\n0\n");
        Scene scene = new Scene();
        scene.read(is);

        assertThat(SceneBits.of(scene.settings)).containsOnlyNulls();
        assertThat(is.warnings()).extracting(Diagnostic::line).containsExactly(1, 3, 5);
    }

    @Test
    void readingTakesThePlaceOfTheSettingsThatWereThere() throws IOException {
        Scene scene = new Scene();
        scene.settings.depth = 5;
        scene.settings.camera = POSE;
        scene.read(reader(SCENE + "samples 2"));

        assertThat(scene.settings.depth).isNull();
        assertThat(scene.settings.camera).isNull();
        assertThat(scene.settings.samples).isEqualTo(2);
    }

    /** Reads it with other white space too, and as it is written. */
    private static void assertReads(String line, SceneSettings expected) throws IOException {
        assertThat(SceneBits.of(read(line))).isEqualTo(SceneBits.of(expected));
        assertThat(SceneBits.of(read(line.replaceAll(" +", "\n\t")))).as("over lines").isEqualTo(SceneBits.of(expected));
        assertThat(SceneBits.of(read(written(expected::write)))).as("written").isEqualTo(SceneBits.of(expected));
    }

    private static SceneSettings read(String keywords) throws IOException {
        Scene scene = new Scene();
        SceneReader is = reader(SCENE + keywords);
        scene.read(is);
        assertThat(is.warnings()).isEmpty();
        return scene.settings;
    }
}
