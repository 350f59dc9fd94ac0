package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Rendered;
import simpleray.scene.Kinds;

/** A Java with 32 MiB of memory, or as much as a test says, and demands that are greater. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class LittleMemoryTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"check boast.scene", "print boast.scene", "render boast.scene -o boast.png"})
    void aSceneThatAnnouncesMoreObjectsThanThereAreIsRefused(String line) throws IOException, InterruptedException {
        Files.writeString(folder.resolve("boast.scene"), "2000000000\n0  0 0 0  1  1 1 1  0 0 0  0 0 0  1\n");

        Program.Result result = run(line.split(" "));

        assertThat(result.err()).isEqualTo("boast.scene:3:1: error: "
            + "expected object 2's type (" + Kinds.objects() + "; 2000000000 objects announced), "
            + "found the end of the file\n\n^\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
    }

    @Test
    void aPictureThatDoesNotFitIsRefusedBeforeTheFirstRay() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("wall.scene"), SmallScenes.GREY);

        // each of 2 threads has a row of 65535 × 24 + 24 bytes, 3 MiB; twice 256 rows and 32 of 65535 × 3 + 1 bytes wait to be written,
        // 108 MiB; and 16 MiB are for all else
        Program.Result result = run("render", "wall.scene", "-o", "wall.png", "--size", "65535x65535", "--threads", "2");

        assertThat(result.err()).matches("simpleray: a picture of 65535x65535 needs 126 MiB of memory, and Java has [123]\\d MiB left: "
            + "make it smaller, or give java more by -Xmx\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_MEMORY);
        assertThat(folder.resolve("wall.png")).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "adaptive"})
    void aPictureFarLargerThanTheMemoryIsMadeRowByRow(String samples) throws IOException, InterruptedException {
        Files.writeString(folder.resolve("empty.scene"), "0  0.5 0.5 0.5  0\n");

        // as linear light 2000 × 2500 pixels of 24 bytes are 114 MiB
        Program.Result result = run("render", "empty.scene", "-o", "empty.png", "-q", "--size", "2000x2500", "--samples", samples,
            "--threads", "2");

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        int[] levels = Rendered.levels(Files.readAllBytes(folder.resolve("empty.png")));
        assertThat(Arrays.equals(levels, new int[3 * 2000 * 2500])).as("all is black").isTrue();
    }

    @Test
    void figuresThatDoNotFitAreRefused() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("wall.scene"), SmallScenes.GREY);

        Program.Result result = run("figures", "wall.scene", "-d", ".", "--size", "1000x1000");

        assertThat(result.err()).matches("simpleray: a sheet of 3\\d{3}x1\\d{3} "
            + "needs \\d{3} MiB of memory, and Java has [123]\\d MiB left: "
            + "make it smaller, or give java more by -Xmx\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_MEMORY);
    }

    @ParameterizedTest
    @ValueSource(strings = {"check crowd.scene", "render crowd.scene -o crowd.png"})
    void aSceneThatDoesNotFitIsRefused(String line) throws IOException, InterruptedException {
        int n = 250_000;
        Files.writeString(folder.resolve("crowd.scene"),
            n + "\n" + "2  0 0 0  1 0 0  0 1 0  1 1 1  0 0 0  0 0 0  1\n".repeat(n) + "0 0 0\n0\n");

        Program.Result result = run(line.split(" "));

        assertThat(result.err()).isEqualTo(
            "simpleray: the scene or the picture is too large for the memory: make it smaller, or give java more by -Xmx\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_MEMORY);
        assertThat(folder.resolve("crowd.png")).doesNotExist();
    }

    /** It ends on a thread that reads or makes the scene ready, now on this one and now on that. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"350000, 2", "350000, 8", "350000, 8", "1000000, 2"})
    void manySpheresThatDoNotFitAreRefused(int n, String threads) throws IOException, InterruptedException {
        spheres(n);

        assertIsTooLarge(run("-Xmx64m", "render", "crowd.scene", "-o", "crowd.png", "-q", "--size", "40x40", "--threads", threads));
    }

    @Test
    void aMeshThatDoesNotFitIsRefused() throws IOException, InterruptedException {
        int side = 550;
        StringBuilder obj = new StringBuilder();
        for (int i = 0; i < side * side; i++) {
            obj.append("v ").append(i % side).append(' ').append(i / side).append(" 0\n");
        }
        for (int i = 1; i < side * (side - 1); i++) {
            obj.append("f ").append(i).append(' ').append(i + 1).append(' ').append(i + side + 1).append(' ').append(i + side).append('\n');
        }
        Files.writeString(folder.resolve("net.obj"), obj);
        Files.writeString(folder.resolve("crowd.scene"), "1\n4 \"net.obj\"  0 0 -2  0.001  1 1 1  0 0 0  0 0 0  1\n0 0 0\n0\n");

        assertIsTooLarge(run("-Xmx64m", "render", "crowd.scene", "-o", "crowd.png"));
    }

    private void spheres(int n) throws IOException {
        StringBuilder text = new StringBuilder().append(n).append('\n');
        Random random = new Random(1);
        for (int i = 0; i < n; i++) {
            text.append(String.format(Locale.ROOT, "0  %.3f %.3f %.3f  0.01  1 1 1  0 0 0  0 0 0  1%n", random.nextDouble(-5, 5),
                random.nextDouble(-5, 5), random.nextDouble(-10, -1)));
        }
        Files.writeString(folder.resolve("crowd.scene"), text.append("0 0 0\n1\n0  1 1 1  0 0 0\n"));
    }

    private void assertIsTooLarge(Program.Result result) {
        assertThat(result.err()).isEqualTo(
            "simpleray: the scene or the picture is too large for the memory: make it smaller, or give java more by -Xmx\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_MEMORY);
        assertThat(folder.resolve("crowd.png")).doesNotExist();
        assertThat(folder).isDirectoryNotContaining("glob:**/.simpleray*");
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
        boolean more = args[0].startsWith("-X");
        return Program.finish(Program.program(folder, List.of(more ? args[0] : "-Xmx32m"),
            Arrays.copyOfRange(args, more ? 1 : 0, args.length)).start(), new byte[0]);
    }
}
