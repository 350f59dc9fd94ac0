package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.text.SceneFormatException;

/** What is wrong with a keyword or its values is told with its place. */
class SceneSettingsErrorsTest {
    private static final String EITHER = "expected either camera, or parallel, or window and cop (up goes with the first two), found ";

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
        "background 0 -1 0 | 14 | expected background's green of 0 or more, found '-1'",
        "background 0 0 NaN | 16 | expected background's blue, found 'NaN' (numbers must be finite)",
        "window 2 -2 -2 2 | 8 | expected window's xmin below its xmax and ymin below its ymax, found '2 -2 -2 2'",
        "window -2 2 1 1 | 8 | expected window's xmin below its xmax and ymin below its ymax, found '-2 2 1 1'",
        "window -2 2 -2 Infinity | 16 | expected window's ymax, found 'Infinity' (numbers must be finite)",
        "cop 0 | 5 | expected cop's z above 0, found '0'",
        "cop -2 | 5 | expected cop's z above 0, found '-2'",
        "cop NaN | 5 | expected cop's z, found 'NaN' (numbers must be finite)",
        "camera 1 2 3 1 2 3 90 | 8 | expected camera's look-at point other than the eye, found '1 2 3 1 2 3 90'",
        "camera 0 0 0 0 0 1 0 | 20 | expected camera's field of view above 0 and below 180 degrees, found '0'",
        "camera 0 0 0 0 0 1 180 | 20 | expected camera's field of view above 0 and below 180 degrees, found '180'",
        "camera 0 0 0 0 0 1 -40 | 20 | expected camera's field of view above 0 and below 180 degrees, found '-40'",
        "camera 0 0 0 0 0 1 NaN | 20 | expected camera's field of view, found 'NaN' (numbers must be finite)",
        "up 0 1 0 | 1 | expected a camera or parallel, which up needs, found up alone",
        "parallel 1 2 3 1 2 3 9 | 10 | expected parallel's look-at point other than the eye, found '1 2 3 1 2 3 9'",
        "parallel 0 0 0 0 0 1 0 | 22 | expected parallel's height above 0 and up to 1e100, found '0'",
        "parallel 0 0 0 0 0 1 -4 | 22 | expected parallel's height above 0 and up to 1e100, found '-4'",
        "parallel 0 0 0 0 0 1 1e101 | 22 | expected parallel's height above 0 and up to 1e100, found '1e101'",
        "parallel 0 0 0 0 0 1 NaN | 22 | expected parallel's height, found 'NaN' (numbers must be finite)",
        "camera 0 x 0 0 0 1 40 | 10 | expected camera's eye y, found 'x'"})
    void aValueThatMakesNoSenseIsNamed(String line, int column, String message) {
        assertRejected(line, report(2, column, message, line));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
        "resolution 0 5 | 12 | resolution's width |", "resolution 5 0 | 14 | resolution's height |",
        "resolution 65536 5 | 12 | resolution's width |", "resolution 5 65536 | 14 | resolution's height |",
        "resolution 5.5 5 | 12 | resolution's width |  (an integer has only digits)",
        "resolution NaN 5 | 12 | resolution's width |  (numbers must be finite)",
        "depth -1 | 7 | depth's number |", "depth 1001 | 7 | depth's number |", "depth 1.0 | 7 | depth's number |  (an integer has only digits)",
        "samples 0 | 9 | samples's number |", "samples 17 | 9 | samples's number |", "samples adaptive | 9 | samples's number |"})
    void anIntegerOutOfItsRangeIsNamed(String line, int column, String field, String why) {
        String found = line.substring(column - 1).split(" ")[0];

        assertThatThrownBy(() -> new Scene().read(reader("0 0 0 0 0\n" + line))).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith("<stdin>:2:" + column + ": error: expected " + field)
            .hasMessageEndingWith(", found '" + found + "'" + (why == null ? "" : ' ' + why) + '\n' + line + '\n' + " ".repeat(column - 1) + '^');
    }

    @ParameterizedTest
    @CsvSource({"background, 'red, or none'", "background 1, green", "background 1 1, blue", "window, xmin",
        "window 1, xmax", "window 1 2, ymin",
        "window 1 2 3, ymax", "cop, z", "camera, eye x", "camera 1, eye y", "camera 1 1, eye z", "camera 1 1 1, look-at x",
        "camera 1 1 1 1, look-at y",
        "camera 1 1 1 1 1, look-at z", "camera 1 1 1 1 1 2, field of view", "parallel 1 1 1 1 1 2, height", "up, direction x",
        "up 0, direction y", "up 0 1, direction z", "resolution, width from 1 to 65535",
        "resolution 5, height from 1 to 65535", "depth, number from 0 to 1000", "samples, number from 1 to 16"})
    void aMissingValueIsNamed(String line, String field) {
        String keyword = line.split(" ")[0];

        assertRejected(line, report(2, line.length() + 1, "expected " + keyword + "'s " + field + ", found the end of the file", line));
    }

    @ParameterizedTest
    @CsvSource({"background 1 1 1", "window -1 1 -1 1", "cop 2", "camera 0 0 0 0 0 1 40", "parallel 0 0 0 0 0 1 4", "resolution 5 5", "depth 3",
        "samples 2"})
    void aKeywordComesOnlyOnce(String line) {
        String keyword = line.split(" ")[0];

        assertRejected(line + "\n" + line, report(3, 1, "expected keyword " + keyword + " only once, found '" + keyword + "'", line));
    }

    @ParameterizedTest
    @CsvSource({"cop 2", "window -1 1 -1 1"})
    void aCameraExcludesCopAndWindow(String line) {
        String camera = "camera 0 0 0 0 0 1 40";

        assertRejected(camera + '\n' + line, report(3, 1, EITHER + '\'' + line.split(" ")[0] + '\'', line));
        assertRejected(line + '\n' + camera, report(3, 1, EITHER + "'camera'", camera));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {"up 0 -0 0 | 4 | expected up's direction other than zero, found '0 -0 0'",
        "up 0 1 NaN | 8 | expected up's direction z, found 'NaN' (numbers must be finite)"})
    void aDirectionThatIsNoneIsNamed(String up, int column, String message) {
        assertRejected("camera 0 0 0 0 0 1 40\n" + up, report(3, column, message, up));
    }

    @Test
    void upComesOnlyOnce() {
        assertRejected("up 0 1 0\ncamera 0 0 0 0 0 1 40\nup 0 1 0",
            report(4, 1, "expected keyword up only once, found 'up'", "up 0 1 0"));
    }

    @ParameterizedTest
    @CsvSource({"0 0 1", "0 0 -1", "0 0 1e300", "1e-300 0 1"})
    void upIsNotAlongTheView(String up) {
        assertRejected("camera 1 2 3 1 2 -5 40\nup " + up,
            report(3, 4, "expected up's direction that is not along the view, found '" + up + "'", "up " + up));
        assertRejected("up " + up + "\ncamera 1 2 3 1 2 -5 40",
            report(3, 8, "expected camera's view that is not along up, found '1 2 3 1 2 -5 40'", "camera 1 2 3 1 2 -5 40"));
        assertRejected("up " + up + "\nparallel 1 2 3 1 2 -5 4",
            report(3, 10, "expected parallel's view that is not along up, found '1 2 3 1 2 -5 4'", "parallel 1 2 3 1 2 -5 4"));
    }

    @ParameterizedTest
    @CsvSource({"cop 2", "window -1 1 -1 1"})
    void upExcludesCopAndWindow(String line) {
        assertRejected(line + "\nup 0 1 0", report(3, 1, EITHER + "'up'", "up 0 1 0") + '\n'
            + report(3, 1, "expected a camera or parallel, which up needs, found up alone", "up 0 1 0"));
    }

    @ParameterizedTest
    @CsvSource({"cop 2", "window -1 1 -1 1", "camera 0 0 0 0 0 1 40"})
    void parallelExcludesAllOthers(String line) {
        String parallel = "parallel 0 0 0 0 0 1 4";

        assertRejected(parallel + '\n' + line, report(3, 1, EITHER + '\'' + line.split(" ")[0] + '\'', line));
        assertRejected(line + '\n' + parallel, report(3, 1, EITHER + "'parallel'", parallel));
    }

    @Test
    void allBadValuesAreReportedTogether() {
        assertRejected("cop 0\nbackground 1 x -1\ncamera 0 0 0 0 0 0 90", report(2, 5, "expected cop's z above 0, found '0'", "cop 0")
            + '\n' + report(3, 14, "expected background's green, found 'x'", "background 1 x -1")
            + '\n' + report(3, 16, "expected background's blue of 0 or more, found '-1'", "background 1 x -1")
            + '\n' + report(4, 1, EITHER + "'camera'", "camera 0 0 0 0 0 0 90")
            + '\n' + report(4, 8, "expected camera's look-at point other than the eye, found '0 0 0 0 0 0 90'", "camera 0 0 0 0 0 0 90"));
    }

    @Test
    void aValueTooManyIsNoneOfTheScenes() {
        assertRejected("depth 3 4", report(2, 9, "expected the end of the scene (after 0 objects and 0 lights), found '4'", "depth 3 4"));
        assertRejected("depth 3\n7",
            report(3, 1, "expected the end of the scene (after 0 objects and 0 lights), found '7'", "7"));
    }

    @Test
    void aSceneWithABadKeywordLeavesTheOldOne() {
        Scene scene = Scenes.of(new Sphere());
        scene.settings.depth = 5;

        assertThatThrownBy(() -> scene.read(reader("0 0 0 0 0\nsamples 2\ncop 0"))).isInstanceOf(SceneFormatException.class);

        assertThat(scene.getNumberObjects()).isEqualTo(1);
        assertThat(scene.settings.depth).isEqualTo(5);
        assertThat(scene.settings.samples).isNull();
    }

    private static void assertRejected(String keywords, String message) {
        assertThatThrownBy(() -> new Scene().read(reader("0 0 0 0 0\n" + keywords))).isInstanceOf(SceneFormatException.class)
            .hasMessage(message);
    }

    private static String report(int line, int column, String message, String source) {
        return "<stdin>:" + line + ':' + column + ": error: " + message + '\n' + source + '\n' + " ".repeat(column - 1) + '^';
    }
}
