package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StatsTest {
    /** A mirror as floor, seen by each ray of the lower half; and a light above. */
    private static final String MIRROR = """
        1
        1 0 1 0 -1  1 1 1  1 1 1  1 1 1  1
        0 0 0
        1
        0 1 1 1  0 5 0
        """;

    @TempDir
    Path folder;

    @BeforeEach
    void writeScene() throws IOException {
        Files.writeString(folder.resolve("mirror.scene"), MIRROR);
    }

    @Test
    void statsCountTheRaysOfEachKindAndDepth() throws IOException, InterruptedException {
        Program.Result result = Program.run(folder, "render", "mirror.scene", "-o", "m.png", "--size", "4x4", "-q", "--stats", "text");

        // 16 rays from the eye; the 8 of the lower half hit the floor: 8 shadow rays, and 8 mirror rays that see nothing
        assertThat(result.exitCode()).as(result.err()).isZero();
        assertThat(result.err()).isEmpty();
        assertThat(result.text()).containsPattern("(?m)^primary rays +16$").containsPattern("(?m)^reflected rays +8$")
            .containsPattern("(?m)^refracted rays +0$").containsPattern("(?m)^shadow rays +8$")
            .containsPattern("(?m)^rays after 0 reflections +16$").containsPattern("(?m)^rays after 1 reflection +8$")
            .doesNotContain("after 2").containsPattern("(?m)^seconds to render and write +[0-9.]+$");
    }

    @Test
    void statsAsJsonAreOneLine() throws IOException, InterruptedException {
        Program.Result result = Program.run(folder, "render", "mirror.scene", "-o", "m.png", "--size", "4x4", "-q", "--stats", "json");

        Matcher json = Pattern.compile("\\{\"rays\":\\{\"primary\":16,\"reflected\":8,"
            + "\"refracted\":0,\"shadow\":8,\"testsPerRay\":([0-9.]+),"
            + "\"stepsPerRay\":0\\.0},\"raysByDepth\":\\[16,8],\"seconds\":\\{\"read\":[0-9.]+,\"prepare\":[0-9.]+,"
            + "\"renderAndWrite\":[0-9.]+}}\n").matcher(result.text());
        assertThat(json.matches()).as(result.text()).isTrue();
        assertThat(Double.parseDouble(json.group(1))).as("tests of one object by 32 rays").isBetween(0.5, 1.0);
    }

    @Test
    void withThePictureOnStandardOutputTheStatsGoToStandardError() throws IOException, InterruptedException {
        Program.Result result = Program.run(folder, "render", "mirror.scene", "-o", "-", "--size", "4x4", "-q", "--stats", "text");

        assertThat(result.err()).startsWith("primary rays");
        assertThat(result.out()).startsWith(0x89, 'P', 'N', 'G');
    }

    @Test
    void theLoopDoesNotCount() throws IOException, InterruptedException {
        Program.Result result = Program.run(folder, "render", "mirror.scene", "-o", "m.png", "--size", "4x4", "-q", "--stats", "json",
            "--accel", "none");

        assertThat(result.text()).startsWith("{\"rays\":null,\"raysByDepth\":null,\"seconds\":{");
    }

    @Test
    void anotherFormatIsRefused() throws IOException, InterruptedException {
        Program.Result result = Program.run(folder, "render", "mirror.scene", "-o", "m.png", "--stats", "xml");

        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(result.err()).contains("[text, json]").contains("'xml'");
    }
}
