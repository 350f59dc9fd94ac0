package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simpleray.io.AtomicFile;

/** Two that write to one name at the same time. */
@Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class BusyOutputTest {
    private static final String BUSY = "simpleray: %s: is being written by another run of SimpleRay: "
        + "wait until it has ended, or choose another name\n";

    @TempDir
    Path folder;

    @BeforeEach
    void writeScenes() throws IOException {
        String mirror = " 0.001 0.001 0.001  0 0 0  1 1 1  1000 ";
        Files.writeString(folder.resolve("slow.scene"), "2  1 0 0 1 -2" + mirror + "1 0 0 1 4" + mirror + "1 1 1  0");
        Files.writeString(folder.resolve("grey.scene"), SmallScenes.GREY);
    }

    /** {@return a run that has begun its picture a.png and has long to go} */
    private Process begun() throws IOException {
        Process process = Program.program(folder, List.of(), "render", "slow.scene", "-o", "a.png", "--depth", "1000", "--threads", "1",
            "--size", "10x60000", "-q").start();
        while (files().stream().noneMatch(name -> name.endsWith(".part"))) {
            assertThat(process.isAlive()).isTrue();
            Thread.yield();
        }
        return process;
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).collect(Collectors.toList());
        }
    }

    @Test
    void theSecondProcessIsRefusedAndTheFirstGoesOn() throws IOException, InterruptedException {
        Process first = begun();
        try {
            Program.Result second = Program.run(folder, "render", "grey.scene", "-o", "a.png");

            assertThat(second.err()).isEqualTo(String.format(BUSY, "a.png"));
            assertThat(second.exitCode()).isEqualTo(ExitCode.BUSY);
            assertThat(Program.run(folder, "convert", "grey.scene", "a.png").exitCode()).isEqualTo(ExitCode.BUSY);
            assertThat(Program.run(folder, "render", "grey.scene", "-o", "b.png", "-q").err()).isEmpty();
            assertThat(first.isAlive()).isTrue();
        } finally {
            first.destroyForcibly();
        }
    }

    @Test
    void whatAKilledProcessHeldIsFreeAndItsLeftoversGoWithTheNextPicture() throws IOException, InterruptedException {
        Process first = begun();
        first.destroyForcibly();
        assertThat(first.waitFor(60, TimeUnit.SECONDS)).isTrue();

        Program.Result second = Program.run(folder, "render", "grey.scene", "-o", "a.png", "-q");

        assertThat(second.err()).isEmpty();
        assertThat(second.exitCode()).isZero();
        assertThat(files()).containsExactlyInAnyOrder("a.png", "slow.scene", "grey.scene");
    }

    @Test
    void aSecondInTheSameProcessIsRefusedToo() throws IOException {
        Path target = folder.resolve("a.png");
        try (AtomicFile first = new AtomicFile(target)) {
            Program.Result second = InProcess.run("render", folder.resolve("grey.scene").toString(), "-o", target.toString());

            assertThat(second.err()).isEqualTo(String.format(BUSY, target));
            assertThat(second.exitCode()).isEqualTo(ExitCode.BUSY);
            first.commit();
        }
        assertThat(InProcess.run("render", folder.resolve("grey.scene").toString(), "-o", target.toString(), "-q").exitCode()).isZero();
    }
}
