package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Progress on a standard error that is no terminal, as it is for these processes. */
class ProgressPrinterTest {
    private static final String REPORT = "wall.png: 3x%d, 0.0 s";

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

    /** {@return the lines on standard error, every time as 0.0 s} */
    private List<String> lines(String rows, String style) throws IOException, InterruptedException {
        Program.Result result = Program.run(folder, "render", "wall.scene", "-o", "wall.png", "--size", "3x" + rows, "--progress", style);

        assertThat(result.exitCode()).as(result.err()).isZero();
        assertThat(result.err()).doesNotContain("\r", "\u001B").endsWith("\n");
        return result.err().replaceAll("\\d+\\.\\d s|\\d+ s", "0.0 s").lines().collect(Collectors.toList());
    }
}
