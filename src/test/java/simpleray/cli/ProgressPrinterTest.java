package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.render.Progress;

/** Progress on a standard error that is no terminal, as it is for these processes; {@link TerminalTest} has those with one. */
class ProgressPrinterTest {
    private static final String REPORT = "wall.png: 3x%d, 0.0 s";

    private static final long LATER = 3723_000_000_000L;      // nanoseconds: an hour, two minutes and three seconds

    @TempDir
    Path folder;

    @BeforeEach
    void writeScene() throws IOException {
        Files.writeString(folder.resolve("wall.scene"), SmallScenes.GREY);
    }

    @ParameterizedTest
    @ValueSource(strings = {"plain", "bar"})
    void everyTenthIsALine(String style) throws IOException, InterruptedException {
        List<String> expected = IntStream.rangeClosed(1, 10)
            .mapToObj(tenth -> String.format("%3d %%, %d of 40 rows, 0.0 s left", 10 * tenth, 4 * tenth)).collect(Collectors.toList());
        expected.add(String.format(REPORT, 40));

        assertThat(lines("40", style)).isEqualTo(expected);
    }

    @Test
    void aLineIsNotRepeatedWhereARowIsMoreThanATenth() throws IOException, InterruptedException {
        assertThat(lines("3", "plain")).containsExactly(" 33 %, 1 of 3 rows, 0.0 s left", " 66 %, 2 of 3 rows, 0.0 s left",
            "100 %, 3 of 3 rows, 0.0 s left", String.format(REPORT, 3));
    }

    @ParameterizedTest
    @CsvSource({"auto", "none"})
    void noBarIsDrawnUnasked(String style) throws IOException, InterruptedException {
        assertThat(lines("40", style)).containsExactly(String.format(REPORT, 40));
    }

    @ParameterizedTest
    @CsvSource({"auto, xterm, '', bar", "auto, dumb, '', plain", "auto, none, '', plain", "auto, unknown, '', plain", "auto, '', '', plain",
        "auto, xterm, 1, plain", "bar, screen-256color, '', bar", "bar, dumb, '', plain", "bar, xterm, 0, plain", "plain, xterm, '', plain",
        "none, xterm, '', none", "none, dumb, 1, none"})
    void aTerminalThatMovesNoCursorOrIsToBePlainHasLines(String style, String term, String noColor, String expected) {
        assertThat(Values.constant(ProgressPrinter.Style.values(), style).shown(true, Map.of("TERM", term, "NO_COLOR", noColor)))
            .hasToString(expected);
    }

    @Test
    void aTerminalWithoutNameHasLines() {
        assertThat(ProgressPrinter.Style.AUTO.shown(true, Map.of())).isEqualTo(ProgressPrinter.Style.PLAIN);
        assertThat(ProgressPrinter.Style.AUTO.shown(false, Map.of())).isEqualTo(ProgressPrinter.Style.NONE);
    }

    @ParameterizedTest
    @CsvSource({"200, '[###############---------------]  50 %, 2000 of 4000 rows, 1:02:03 h left'",
        "73, '[###############---------------]  50 %, 2000 of 4000 rows, 1:02:03 h left'",
        "72, '[##############---------------]  50 %, 2000 of 4000 rows, 1:02:03 h left'",
        "51, '[####----]  50 %, 2000 of 4000 rows, 1:02:03 h left'", "50, '[#############-------------]  50 %, 1:02:03 h left'",
        "32, '[####----]  50 %, 1:02:03 h left'", "31, '[###########------------]  50 %'", "16, '[####----]  50 %'", "15, ' 50 %'",
        "5, ' 50 %'", "4, '50%'", "3, '50%'", "2, ''", "1, ''", "0, ''"})
    void theBarTakesTheRoomThatThereIs(int room, String expected) {
        assertThat(half().bar(room, LATER)).isEqualTo(expected);
    }

    @Test
    void theBarIsNeverLongerThanItsRoom() {
        for (int room = 0; room < 100; room++) {
            assertThat(half().bar(room, LATER)).hasSizeLessThanOrEqualTo(room);
        }
    }

    @ParameterizedTest
    @CsvSource({"24 80, '', 80", "'24 80\n', '', 80", "24 80, 40, 40", "24 30, 40, 30", "0 0, 40, 40",
        "0 0, '', 80", "'', '', 80", "'', 1, 1", "24 1, wide, 1", "24 9999999999, 0, 80", "24 80, -5, 80", "nonsense, 99999999999, 80"})
    void theWidthIsTheSmallerOfWhatIsKnownOfIt(String stty, String variable, int expected) {
        assertThat(TerminalWidth.columns(stty, variable)).isEqualTo(expected);
    }

    /** {@return what shows half of a rendering of two hours} */
    private static ProgressPrinter half() {
        Progress progress = new Progress(4000, 0);
        for (int i = 0; i < 2000; i++) {
            progress.rowFinished();
        }
        return new ProgressPrinter(progress, System.err, null, ProgressPrinter.Style.NONE);
    }

    /** {@return the lines on standard error, every time as 0.0 s} */
    private List<String> lines(String rows, String style) throws IOException, InterruptedException {
        Program.Result result = Program.run(folder, "render", "wall.scene", "-o", "wall.png", "--size", "3x" + rows, "--progress", style);

        assertThat(result.exitCode()).as(result.err()).isZero();
        assertThat(result.err()).doesNotContain("\r", "\u001B").endsWith("\n");
        return result.err().replaceAll("\\d+\\.\\d s|\\d+ s", "0.0 s").lines().collect(Collectors.toList());
    }
}
