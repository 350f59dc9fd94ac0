package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code --progress openjd}: what a scheduler reads on standard output. */
class OpenJobLinesTest {
    @TempDir
    Path folder;
    private String scene;
    private String out;

    @BeforeEach
    void writeScene() throws IOException {
        scene = Files.writeString(folder.resolve("wall.scene"), SmallScenes.GREY).toString();
        out = folder.resolve("wall.png").toString();
    }

    private Program.Result render(String... options) {
        return InProcess.run(Stream.concat(Stream.of("render", scene, "-o", out, "--progress", "openjd"),
            Stream.of(options)).toArray(String[]::new));
    }

    private static List<String> lines(Program.Result result) {
        return result.text().replaceAll("\\d+\\.\\d s|\\d+ s", "0.0 s").lines().collect(Collectors.toList());
    }

    @ParameterizedTest
    @CsvSource({"render x --progress openjd, true", "render --progress=openjd x, true", "render --progress OpenJD x, true",
        "render --progress plain x, false", "render x --progress, false", "render x openjd, false", "render -- --progress openjd, false",
        "render --progress=open, false", "--progressopenjd, false", "'', false"})
    void theyAreAskedForByTheirOption(String line, boolean expected) {
        assertThat(OpenJobLines.areAskedFor(line.split(" "))).isEqualTo(expected);
    }

    @Test
    void eachIsALineOfItsOwn() {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        OpenJobLines lines = new OpenJobLines(all);

        lines.progress(0);
        lines.progress(42);
        lines.progress(99.96);
        lines.status("  7 of 9 rows ");
        lines.fail("a.scene:2:11: error: ü\n0 1 2\n^");
        lines.fail("");

        assertThat(all.toString(StandardCharsets.UTF_8)).isEqualTo("openjd_progress: 0.0\nopenjd_progress: 42.0\nopenjd_progress: 100.0\n"
            + "openjd_status: 7 of 9 rows\nopenjd_fail: a.scene:2:11: error: ü\nopenjd_fail: \n");
    }

    @Test
    void thatNobodyReadsEndsNoRendering() {
        OutputStream gone = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("nobody reads");
            }
        };

        Program.Result result = InProcess.run(InputStream.nullInputStream(), gone, "render", scene, "-o", out, "--progress", "openjd");
        assertThat(result.exitCode()).isZero();
        assertThat(Path.of(out)).isNotEmptyFile();
    }

    @Test
    void everyHundredthIsProgressAndEveryTenthIsAStatus() {
        List<String> expected = IntStream.rangeClosed(1, 40).boxed().flatMap(row -> (row % 4 == 0
            ? List.of("openjd_status: " + row * 5 / 2 + " %, " + row + " of 40 rows, 0.0 s left", "openjd_progress: " + row * 5 / 2 + ".0")
            : List.of("openjd_progress: " + row * 5 / 2 + ".0")).stream()).collect(Collectors.toList());
        expected.add("openjd_status: " + out + ": 3x40, 0.0 s");

        Program.Result result = render("--size", "3x40");

        assertThat(lines(result)).isEqualTo(expected);
        assertThat(result.err()).startsWith(out + ": 3x40, ").hasLineCount(1);
    }

    @Test
    void aLineIsNotRepeatedWhereRowsAreFewerOrMore() {
        assertThat(lines(render("--size", "1x3"))).containsExactly("openjd_status: 33 %, 1 of 3 rows, 0.0 s left", "openjd_progress: 33.0",
            "openjd_status: 66 %, 2 of 3 rows, 0.0 s left", "openjd_progress: 66.0", "openjd_status: 100 %, 3 of 3 rows, 0.0 s left",
            "openjd_progress: 100.0", "openjd_status: " + out + ": 1x3, 0.0 s");
        assertThat(lines(render("--size", "1x1000"))).hasSize(100 + 10 + 1).doesNotHaveDuplicates();
        assertThat(lines(render("--size", "1x99", "--band", "1/9"))).contains("openjd_status: 100 %, 11 of 11 rows, 0.0 s left");
    }

    @Test
    void aFailureIsToldWhateverItIs() throws IOException {
        assertThat(lines(render("--size", "0x4"))).singleElement().asString().startsWith("openjd_fail: simpleray render: Invalid value");
        assertThat(lines(render("--nonsense"))).containsExactly("openjd_fail: simpleray render: Unknown option: '--nonsense' (see simpleray "
            + "render --help)");
        Files.writeString(Path.of(scene), SmallScenes.BAD);
        Program.Result bad = render();
        assertThat(lines(bad)).containsExactly("openjd_fail: " + scene + ":2:11: error: expected object 1's radius above 0, found '0'");
        assertThat(bad.err()).isEqualTo(String.format(SmallScenes.BAD_REPORT, scene));
        assertThat(bad.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        scene = folder.resolve("none").toString();
        assertThat(lines(render())).containsExactly("openjd_fail: simpleray: " + scene + ": no such file");
        assertThat(lines(render("-q"))).containsExactly("openjd_fail: simpleray: " + scene + ": no such file");
    }

    @Test
    void quietIsButFailures() {
        assertThat(render("-q").text()).isEmpty();
    }

    @Test
    void thePictureCannotGoThereToo() {
        String message = "simpleray render: --progress openjd and the picture cannot both go to standard output (see simpleray render --help)\n";
        for (String name : List.of("-", "/dev/stdout")) {
            out = name;
            Program.Result result = render();

            assertThat(result.err()).isEqualTo(message);
            assertThat(result.text()).isEqualTo("openjd_fail: " + message);
            assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        }
    }

    @Test
    void otherCommandsHaveThemToo() {
        assertThat(render("--size", "3x2", "-q").exitCode()).isZero();

        assertThat(InProcess.run("verify", out, "--progress=openjd").text()).startsWith("openjd_status: 50 %, 1 of 2 rows, ")
            .endsWith("openjd_progress: 100.0\n" + out + ": good: all 6 pixels are the same\n");
    }
}
