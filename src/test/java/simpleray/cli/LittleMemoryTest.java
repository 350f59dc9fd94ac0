package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A Java with 32 MiB of memory, and demands that are greater. */
@Timeout(value = 30, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class LittleMemoryTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"check boast.scene", "print boast.scene", "render boast.scene -o boast.png"})
    void aSceneThatAnnouncesMoreObjectsThanThereAreIsRefused(String line) throws IOException, InterruptedException {
        Files.writeString(folder.resolve("boast.scene"), "2000000000\n0  0 0 0  1  1 1 1  0 0 0  0 0 0  1\n");

        Program.Result result = run(line.split(" "));

        assertThat(result.err()).isEqualTo("boast.scene:3:1: error: "
            + "expected object 2's type (0 sphere, 1 plane, 2 triangle, 3 cylinder, 4 mesh; 2000000000 objects announced), "
            + "found the end of the file\n\n^\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
    }

    @Test
    void aPictureThatDoesNotFitIsRefusedBeforeTheFirstRay() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("wall.scene"), SmallScenes.GREY);

        // 1000 rows of 1000 × 24 + 24 bytes are 22.9 MiB, and 16 MiB are for all else
        Program.Result result = run("render", "wall.scene", "-o", "wall.png", "--size", "1000x1000");

        assertThat(result.err()).matches("simpleray: a picture of 1000x1000 needs 38 MiB of memory, and Java has [12]\\d MiB left: "
            + "make it smaller, or give java more by -Xmx\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_MEMORY);
        assertThat(folder.resolve("wall.png")).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(strings = {"check crowd.scene", "render crowd.scene -o crowd.png"})
    void aSceneThatDoesNotFitIsRefused(String line) throws IOException, InterruptedException {
        int n = 200_000;
        Files.writeString(folder.resolve("crowd.scene"), n + "\n" + "0  0 0 0  1  1 1 1  0 0 0  0 0 0  1\n".repeat(n) + "0 0 0\n0\n");

        Program.Result result = run(line.split(" "));

        assertThat(result.err()).isEqualTo(
            "simpleray: the scene or the picture is too large for the memory: make it smaller, or give java more by -Xmx\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_MEMORY);
        assertThat(folder.resolve("crowd.png")).doesNotExist();
    }

    @Test
    void aPictureThatFitsIsMade() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("wall.scene"), SmallScenes.GREY);

        Program.Result result = run("render", "wall.scene", "-o", "wall.png", "-q", "--size", "300x200");

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        assertThat(folder.resolve("wall.png")).exists();
    }

    private Program.Result run(String... args) throws IOException, InterruptedException {
        return Program.finish(Program.program(folder, List.of("-Xmx32m"), args).start(), new byte[0]);
    }
}
