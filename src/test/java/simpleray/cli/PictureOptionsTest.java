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
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Rendered;
import simpleray.SettingSamples;
import simpleray.scene.Setting;

/** An option makes the same picture as the keyword of its name in the scene file, over which it wins. */
class PictureOptionsTest {
    /** A ball before a mirror, an open sky. */
    private static final String BALL = """
        2  0  0.3 0.2 0 1  1 1 1  0.2 0.4 0.8  0.4 0.4 0.4  5
           1  0 1 0.2 -1.5  1 1 1  0.1 0.2 0.1  0.6 0.6 0.6  5
        0.2 0.2 0.2
        1  0  1 1 1  3 4 5
        """;
    private static final String SMALL = "resolution 24 18\n";

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"background 0.1 0.2 0.4 | --background 0.1,0.2,0.4", "window -1 1 -1 0.5 | --window -1,1,-1,0.5",
        "cop 3.5 | --cop 3.5", "camera 3 2 5 0 0.5 0 40 | --camera 3,2,5,0,0.5,0,40", "parallel 3 2 5 0 0.5 0 4 | --parallel 3,2,5,0,0.5,0,4",
        "resolution 16 12 | --size 16x12",
        "depth 0 | --depth 0", "samples 3 | --samples 3", "samples 16 | --samples 16"})
    void anOptionIsTheKeywordOfTheFile(String keyword, String option) throws IOException {
        String small = keyword.startsWith("resolution") ? "" : SMALL;
        byte[] expected = picture(BALL + small + keyword);

        assertThat(picture(BALL + small, option.split(" "))).isEqualTo(expected);
        assertThat(picture(BALL + SMALL)).as("without it").isNotEqualTo(expected);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"background 1 0 0 | --background 0.1,0.2,0.4", "window -3 3 -3 3 | --window -1,1,-1,0.5",
        "cop 9 | --cop 3.5", "camera 0 0 9 0 0 0 70 | --camera 3,2,5,0,0.5,0,40", "camera 0 0 9 0 0 0 70 | --parallel 3,2,5,0,0.5,0,4",
        "parallel 0 0 9 0 0 0 4 | --parallel 3,2,5,0,0.5,0,4", "parallel 0 0 9 0 0 0 4 | --camera 3,2,5,0,0.5,0,40",
        "parallel 0 0 9 0 0 0 4 | --cop 3.5", "resolution 16 12 | --size 24x18", "depth 0 | --depth 3",
        "samples 4 | --samples 1", "samples 1 | --samples adaptive", "samples 16 | --samples adaptive"})
    void anOptionWinsOverTheFile(String keyword, String option) throws IOException {
        String small = keyword.startsWith("resolution") ? "" : SMALL;
        byte[] expected = picture(BALL + SMALL, option.split(" "));

        assertThat(picture(BALL + small + keyword, option.split(" "))).isEqualTo(expected);
        assertThat(picture(BALL + small + keyword)).as("without the option").isNotEqualTo(expected);
    }

    @ParameterizedTest
    @ValueSource(strings = {"--cop 3", "--window -1,1,-1,1", "--cop 3 --window -1,1,-1,1"})
    void copAndWindowReplaceAFilesCamera(String options) throws IOException {
        assertThat(picture(BALL + SMALL + "camera 3 2 5 0 0.5 0 40", options.split(" ")))
            .isEqualTo(picture(BALL + SMALL, options.split(" ")));
    }

    @Test
    void aCameraReplacesAFilesCopAndWindow() throws IOException {
        String[] camera = {"--camera", "3,2,5,0,0.5,0,40"};

        assertThat(picture(BALL + SMALL + "cop 3\nwindow -1 1 -1 1", camera)).isEqualTo(picture(BALL + SMALL, camera));
    }

    @Test
    void copLeavesAFilesWindow() throws IOException {
        assertThat(picture(BALL + SMALL + "window -1 1 -1 0.5", "--cop", "3.5"))
            .isEqualTo(picture(BALL + SMALL + "cop 3.5\nwindow -1 1 -1 0.5"));
    }

    @Test
    void upTurnsAFilesCameraAndLeavesItWhereItIs() throws IOException {
        assertThat(picture(BALL + SMALL + "camera 3 2 5 0 0.5 0 40\nup 1 0 0", "--up", "0,1,0"))
            .isEqualTo(picture(BALL + SMALL + "camera 3 2 5 0 0.5 0 40"));
        assertThat(picture(BALL + SMALL + "camera 0 0 9 0 0 0 40\nup 0 1 1", "--parallel", "3,2,5,0,0.5,0,4"))
            .isEqualTo(picture(BALL + SMALL + "parallel 3 2 5 0 0.5 0 4\nup 0 1 1"));
        assertThat(picture(BALL + SMALL, "--parallel", "3,2,5,0,0.5,0,4", "--up", "0,1,1"))
            .isEqualTo(picture(BALL + SMALL + "parallel 3 2 5 0 0.5 0 4\nup 0 1 1"));
        assertThat(picture(BALL + SMALL + "camera 0 0 9 0 0 0 40\nup 0 1 1", "--cop", "3")).isEqualTo(picture(BALL + SMALL + "cop 3"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--up 0,0,0 | Invalid value for option '--up': expected a direction other than zero, found '0,0,0'",
        "--up 0,1 | Invalid value for option '--up': expected three numbers such as 0,0,1, found '0,1'",
        "--up 0,1,0 | up needs a camera or parallel", "--up 0,1,0 --camera 0,5,0,0,0,0,40 | up must not be along the view",
        "--up 0,1,0 --cop 3 | --up goes with --camera or --parallel, not with --cop and --window",
        "--up 0,1,0 --window -1,1,-1,1 | --up goes with --camera or --parallel, not with --cop and --window",
        "--parallel 0,5,0,0,0,0,4 --cop 3 | --parallel takes the place of --camera, --cop and --window: give one or the other",
        "--parallel 0,5,0,0,0,0,4 --camera 0,5,0,0,0,0,40 | --parallel takes the place of --camera, --cop and --window: give one or the other",
        "--parallel 0,5,0,0,0,0,-4 | Invalid value for option '--parallel': expected a height above 0 and up to 1e100, found '0,5,0,0,0,0,-4'",
        "--parallel 0,5,0,0,5,0,4 | Invalid value for option '--parallel': expected a look-at point other than the eye, found '0,5,0,0,5,0,4'"})
    void whatMakesNoCameraIsAnError(String options, String message) throws IOException {
        Path scene = Files.writeString(folder.resolve("ball.scene"), BALL);
        List<String> args = new ArrayList<>(List.of("render", scene.toString(), "-o", "-", "-q"));
        args.addAll(Arrays.asList(options.split(" ")));

        Program.Result result = InProcess.run(args.toArray(new String[0]));

        assertThat(result.exitCode()).isEqualTo(2);
        assertThat(result.err()).startsWith("simpleray render: " + message + " (see simpleray render --help)").hasLineCount(1);
    }

    @ParameterizedTest
    @CsvSource({"1, 0", "2, 128", "4, 64", "16, 96"})
    void samplesAreTheMeanOfTheirLight(String samples, int expected) throws IOException {
        // one pixel, [-2,2] wide, white from 0.6 on: of its columns that is 0 of 1, 1 of 2, 1 of 4, 6 of 16
        String right = "1  2  0.6 -900 0  0.6 900 0  900 0 0  1 1 1  0 0 0  0 0 0  0  9 9 9  0\n";

        assertThat(Rendered.levels(picture(right, "--size", "1x1", "--samples", samples))).containsOnly(expected);
    }

    @ParameterizedTest
    @ValueSource(strings = {"adaptive", "ADAPTIVE", "Adaptive"})
    void adaptiveSamplesAreTakenWhereTheyAreNeeded(String samples) throws IOException {
        byte[] adaptive = picture(BALL + SMALL, "--samples", samples);

        assertThat(adaptive).isEqualTo(picture(BALL + SMALL, "--samples", "adaptive")).isNotEqualTo(picture(BALL + SMALL));
    }

    @ParameterizedTest
    @MethodSource("settings")
    void everySettingOfTheTableIsAnOptionOfEachCommandThatRenders(Setting<?> setting) throws IOException {
        for (String command : List.of("view", "render", "figures", "explain")) {
            assertThat(InProcess.run(command, "--help").text()).contains("  " + setting.option() + '=' + setting.label());
        }
        String line = SettingSamples.only(setting).lines();
        String small = (setting == Setting.RESOLUTION ? "" : SMALL) + (setting == Setting.UP ? "camera 0 0 9 0 0 0 70\n" : "");

        assertThat(picture(BALL + small, setting.option(), SettingSamples.value(setting))).isEqualTo(picture(BALL + small + line))
            .isEqualTo(picture(BALL + small, setting.option() + '=' + SettingSamples.value(setting))).isNotEqualTo(picture(BALL + small))
            .isNotEqualTo(picture(BALL + SMALL));
    }

    static List<Setting<?>> settings() {
        return SettingSamples.withOption();
    }

    @Test
    void aBackgroundOfALevelFillsAnEmptyScene() throws IOException {
        assertThat(Rendered.levels(picture("0 0 0 0 0", "--background", "0.2,0.4,7", "--size", "1x1"))).containsExactly(51, 102, 255);
    }

    private byte[] picture(String text, String... options) throws IOException {
        Path scene = Files.writeString(folder.resolve("ball.scene"), text);
        List<String> args = new ArrayList<>(List.of("render", scene.toString(), "-o", "-", "-q"));
        args.addAll(Arrays.asList(options));

        Program.Result result = InProcess.run(args.toArray(new String[0]));

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        return Rendered.untold(result.out());
    }
}
