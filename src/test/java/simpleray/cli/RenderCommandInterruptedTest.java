package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A {@code render} that is told to stop in the middle (SIGTERM). */
class RenderCommandInterruptedTest {
    private static final int SIGTERM = 128 + 15;

    @TempDir
    Path folder;

    @Test
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void theOldPictureStaysAndOnlyACheckpointIsLeft() throws IOException, InterruptedException {
        String mirror = " 0.001 0.001 0.001  0 0 0  1 1 1  1000 ";
        Files.writeString(folder.resolve("slow.scene"), "2  1 0 0 1 -2" + mirror + "1 0 0 1 4" + mirror + "1 1 1  0");
        Files.writeString(folder.resolve("slow.png"), "the old picture");
        Process process = Program.program(folder, List.of(), "render", "slow.scene", "-o", "slow.png", "--depth", "1000", "--threads", "1",
            "--size", "4x4000", "--samples", "2", "--progress", "plain").start();
        assumeTrue(process.supportsNormalTermination(), "no SIGTERM here");
        try (BufferedReader err = process.errorReader()) {
            assertThat(err.readLine()).startsWith(" 10 %, 400 of 4000 rows, ");
            assertThat(files()).as("the picture has been begun").hasSize(4).contains("slow.scene", "slow.png")
                .anyMatch(name -> name.startsWith(".") && name.endsWith(".part"))
                .anyMatch(name -> name.startsWith(".") && name.endsWith(".lock"));
            process.destroy();

            assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
        } finally {
            process.destroyForcibly();
        }
        assertThat(process.exitValue()).isEqualTo(SIGTERM);
        assertThat(files()).containsExactlyInAnyOrder("slow.scene", "slow.png", "slow.png.part");
        assertThat(folder.resolve("slow.png")).hasContent("the old picture");
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).collect(Collectors.toList());
        }
    }
}
