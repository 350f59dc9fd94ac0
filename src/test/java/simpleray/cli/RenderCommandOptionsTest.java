package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.Rendered;
import simpleray.render.RenderSettings;
import simpleray.render.Stage;
import simpleray.scene.SimpleCamera;

/** Options change the picture as the same settings made by the program's classes do. */
class RenderCommandOptionsTest {
    private static final Path THESIS = Project.scene("thesis");
    private static final RenderSettings DEFAULTS = new RenderSettings(Stage.FINAL, 10, 1, 2);

    @TempDir
    Path folder;

    @Test
    void withoutOptionsThePictureHasTheThesisSize() throws IOException {
        assertThat(picture(THESIS)).isEqualTo(Rendered.png(THESIS, new SimpleCamera(200, 200), DEFAULTS));
    }

    @ParameterizedTest
    @ValueSource(strings = {"48x32", "32X48"})
    void sizeIsWidthAndHeight(String size) throws IOException {
        SimpleCamera camera = size.startsWith("48") ? new SimpleCamera(48, 32) : new SimpleCamera(32, 48);

        assertThat(picture(THESIS, "--size", size)).isEqualTo(Rendered.png(THESIS, camera, DEFAULTS));
    }

    @ParameterizedTest
    @EnumSource
    void stageIsOneOfEleven(Stage stage) throws IOException {
        byte[] expected = Rendered.png(THESIS, new SimpleCamera(40, 40), DEFAULTS.with(stage));

        assertThat(picture(THESIS, "--size", "40x40", "--stage", stage.toString())).isEqualTo(expected);
        assertThat(picture(THESIS, "--size", "40x40", "--stage=" + stage.name())).as("in capitals").isEqualTo(expected);
    }

    @Test
    void copMovesTheEye() throws IOException {
        SimpleCamera camera = new SimpleCamera(40, 40);
        byte[] before = Rendered.png(THESIS, camera, DEFAULTS);
        camera.setCOP(3.5);

        assertThat(picture(THESIS, "--size", "40x40", "--cop", "3.5"))
            .isEqualTo(Rendered.png(THESIS, camera, DEFAULTS)).isNotEqualTo(before);
    }

    @Test
    void windowIsStretchedOverThePicture() throws IOException {
        SimpleCamera camera = new SimpleCamera(40, 20);
        byte[] before = Rendered.png(THESIS, camera, DEFAULTS);
        camera.setVPWindow(-1.5, 0.5, -1, 1e0);

        assertThat(picture(THESIS, "--size", "40x20", "--window", "-1.5,0.5,-1,1e0"))
            .isEqualTo(Rendered.png(THESIS, camera, DEFAULTS)).isNotEqualTo(before);
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "10, 3", "100, 26", "1000, 255"})
    void depthIsTheMostReflections(String depth, int level) throws IOException {
        assertThat(Rendered.levels(picture(mirrors(), "--size", "3x3", "--depth", depth))).containsOnly(level);
    }

    @Test
    void withoutTheOptionTheDepthIsTen() throws IOException {
        assertThat(picture(mirrors(), "--size", "3x3")).isEqualTo(picture(mirrors(), "--size", "3x3", "--depth", "10"))
            .isNotEqualTo(picture(mirrors(), "--size", "3x3", "--depth", "13"));
    }

    /** {@return a scene of two mirrors that face each other; each adds 0.001 to the light: 255 · 0.001 · (1 + depth) is the level} */
    private Path mirrors() throws IOException {
        String mirror = " 0.001 0.001 0.001  0 0 0  1 1 1  1000 ";
        return Files.writeString(folder.resolve("mirrors.scene"), "2  1 0 0 1 -2" + mirror + "1 0 0 1 4" + mirror + "1 1 1  0");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "3", "1024"})
    void threadsChangeNothing(String threads) throws IOException {
        assertThat(picture(THESIS, "--size", "40x40", "--threads", threads))
            .isEqualTo(Rendered.png(THESIS, new SimpleCamera(40, 40), DEFAULTS));
    }

    private static byte[] picture(Path scene, String... options) {
        List<String> args = new ArrayList<>(List.of("render", scene.toString(), "-o", "-", "-q"));
        args.addAll(Arrays.asList(options));

        Program.Result result = InProcess.run(args.toArray(new String[0]));

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        return Rendered.untold(result.out());
    }
}
