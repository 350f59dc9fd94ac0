package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;

/** What {@code check} warns of, and how editors get it. */
class CheckCommandWarningsTest {
    private static final String MATT = "  1 1 1  0 0 0  0 0 0  1\n";

    @TempDir
    Path folder;

    private Program.Result check(String text, String... options) throws IOException {
        Path scene = Files.writeString(folder.resolve("a.scene"), text);
        String[] line = new String[options.length + 2];
        line[0] = "check";
        System.arraycopy(options, 0, line, 1, options.length);
        line[line.length - 1] = scene.toString();
        Program.Result result = InProcess.run(line);
        return new Program.Result(result.exitCode(), result.out(), result.err().replace(scene.toString(), "a.scene"));
    }

    @Test
    void theThesissSecondLightIsTold() {
        Path thesis = Project.scene("thesis");

        Program.Result result = InProcess.run("check", thesis.toString());

        assertThat(result.err()).isEqualTo(thesis
            + ":55:1: warning: light 2 (line 55) lights nothing that is seen: object 4 (plane, line 19) is in the way\n");
        assertThat(result.text()).isEqualTo(thesis + ": good: 9 objects, 2 lights, 1 warning\n");
        assertThat(result.exitCode()).isZero();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1e-400", "-0.001e-330", "1E-9999999999"})
    void aNumberTooSmallIsTold(String number) throws IOException {
        Program.Result result = check("1\n1  0 0 1 -2" + MATT + "0.5 0.5 " + number.replace("-0", "0") + "\n0\n");

        assertThat(result.err()).isEqualTo("a.scene:3:9: warning: the scene's ambient blue '" + number.replace("-0", "0")
            + "' is too small for a number, and read as 0\n0.5 0.5 " + number.replace("-0", "0") + "\n        ^\n");
        assertThat(result.exitCode()).isZero();
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "0.000", "0e5", "0e-400", "0.0e-999", "1e-300", "-0"})
    void aZeroIsNoNumberTooSmall(String number) throws IOException {
        assertThat(check("1\n1  0 " + number + " 1 -2" + MATT + "0.5 0.5 0.5\n0\n").err()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"0.577 0.577 0.577, 0.9994", "0.7 0.7 0, 0.9899", "0 0 1.04, 1.0400", "0 0.5 0.87, 1.0034"})
    void aNormalThatIsNearlyOfUnitLengthIsTold(String normal, String length) throws IOException {
        assertThat(check("1\n1  " + normal + " -2" + MATT + "0.5 0.5 0.5\n0\n").err().lines()).contains("a.scene:2:1: warning: "
            + "object 1's normal has length " + length + ", nearly 1: the plane lies constant / " + length + " along it");
    }

    @ParameterizedTest
    @ValueSource(strings = {"0 0 1", "0.5774 0.5774 0.5774", "0 -0.7071 0.7071", "0 1 1", "0 0 2", "0 0 1.06"})
    void aNormalOfUnitLengthOrAnyOtherIsNot(String normal) throws IOException {
        assertThat(check("1\n1  " + normal + " -2" + MATT + "0.5 0.5 0.5\n0\n").err()).isEmpty();
    }

    @Test
    void editorsGetJson() throws IOException {
        String thesis = Project.scene("thesis").toString();
        Path bad = Files.writeString(folder.resolve("a \"bad\".scene"), SmallScenes.BAD);
        Path missing = folder.resolve("missing.scene");

        Program.Result result = InProcess.run("check", "--errors", "json", thesis, bad.toString(), missing.toString());

        String quoted = bad.toString().replace("\"", "\\\"");
        assertThat(result.text()).isEqualTo("[{\"file\":\"" + thesis + "\",\"line\":55,\"column\":1,\"severity\":\"warning\","
            + "\"message\":\"light 2 (line 55) lights nothing that is seen: object 4 (plane, line 19) is in the way\"},\n"
            + "{\"file\":\"" + quoted + "\",\"line\":2,\"column\":11,\"severity\":\"error\","
            + "\"message\":\"expected object 1's radius above 0, found '0'\"},\n"
            + "{\"file\":\"" + quoted + "\",\"line\":2,\"column\":32,\"severity\":\"error\","
            + "\"message\":\"expected object 1's specular blue, found 'abc'\"},\n"
            + "{\"file\":\"" + missing + "\",\"line\":1,\"column\":1,\"severity\":\"error\",\"message\":\"no such file\"}]\n");
        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_SCENE);
    }

    @Test
    void withoutProblemsTheJsonIsAnEmptyArray() throws IOException {
        Program.Result result = check(SmallScenes.GREY, "--errors=json");

        assertThat(result.text()).isEqualTo("[]\n");
        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
    }

    @Test
    void theJsonOfStandardInputHasItsWarnings() {
        String heading = "heading \\ \"1\" \t\uD83D\uDE00\n";

        Program.Result result = InProcess.runWithInput(heading + SmallScenes.GREY, "check", "--errors", "json", "-");

        assertThat(result.text()).isEqualTo("[{\"file\":\"<stdin>\",\"line\":1,\"column\":1,\"severity\":\"warning\",\"message\":"
            + "\"expected a value or a comment, found the heading 'heading \\\\ \\\"1\\\" \\u0009\\ud83d\\ude00', which is skipped\"}]\n");
        assertThat(result.exitCode()).isZero();
    }

    @Test
    void anotherFormatIsRefused() {
        Program.Result result = InProcess.run("check", "--errors", "xml", "a.scene");

        assertThat(result.err()).isEqualTo("simpleray check: Invalid value for option '--errors': expected one of [text, json], "
            + "found 'xml' (see simpleray check --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
    }
}
