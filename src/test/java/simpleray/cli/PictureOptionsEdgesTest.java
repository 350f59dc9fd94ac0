package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Rendered;

/** Settings at the edge of what a file may say. */
class PictureOptionsEdgesTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"0 0 0 0 0\ndepth 3 samples 2\n", "0 0 0 0 0 depth 3\n"})
    void aKeywordStandsOnALineOfItsOwn(String text) {
        assertThat(InProcess.runWithInput(text, "check", "-").exitCode()).isEqualTo(ExitCode.BAD_SCENE);
    }

    @Test
    void aWindowThatIsTooWideIsAnErrorOfTheScene() {
        Program.Result result = InProcess.runWithInput("0 0 0 0 0\nwindow -1e308 1e308 -1 1\n", "render", "-", "-o", "-", "-q");

        assertThat(result.err()).doesNotContain("internal error");
        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
    }

    @Test
    void aNegativeZeroOfTransmissionIsWritten() {
        String scene = "1 0 0 0 0 1  1 1 1 0 0 0 0 0 0 1 transmit -0 0 0 1\n0 0 0 0\n";

        assertThat(InProcess.runWithInput(scene, "convert", "-", "-").text()).contains("transmit -0.0 0.0 0.0  1.0");
    }

    @Test
    void aCameraSeesHoweverFarItLooks() throws IOException {
        // a white floor below, seen from (-1e308,5,0) along +x: the lower half of the picture
        Path scene = Files.writeString(folder.resolve("far.scene"), "1  1 0 1 0 -1  1 1 1  0 0 0  0 0 0  1   1 1 1  0\n"
            + "camera -1e308 5 0  1e308 5 0  40\nresolution 2 2\n");

        byte[] png = InProcess.run("render", scene.toString(), "-o", "-", "-q").out();

        assertThat(Rendered.levels(png)).containsExactly(0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255);
    }
}
