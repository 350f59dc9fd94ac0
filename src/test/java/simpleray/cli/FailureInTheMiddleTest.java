package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A picture is written while it is rendered: a picture that cannot be written any more is not rendered any more either. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class FailureInTheMiddleTest {
    /** A sphere whose picture does not become small. */
    private static final String ROUGH =
        "1  0  0 0 0  1.9  0.9 0.7 0.5  0.5 0.7 0.9  0.3 0.3 0.3  5  0.2 0.3 0.4  1  0 0.9 0.8 0.7  3 2 4\n";

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"1", "2", "7"})
    void standardOutputThatFailsEndsTheRendering(String threads) {
        OutputStream broken = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("no paper");
            }
        };

        // a strip has 65536 / 3001 = 21 rows: the first fails long before the last
        Program.Result result = InProcess.run(new ByteArrayInputStream(ROUGH.getBytes(StandardCharsets.UTF_8)), broken,
            "render", "-", "-o", "-", "--size", "1000x1000", "--threads", threads, "--progress", "plain");

        assertThat(result.err()).doesNotContain("100 %")
            .endsWith("simpleray: the picture cannot be written to standard output: no paper\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
    }

    /** A limit to the size of files stands for a disk that becomes full. */
    @Test
    void aDiskThatBecomesFullLeavesTheOldPictureAndNothingHalf() throws IOException, InterruptedException {
        Path shell = Path.of("/bin/sh");
        assumeTrue(Files.isExecutable(shell), "no " + shell);
        Files.writeString(folder.resolve("rough.scene"), ROUGH);
        Files.writeString(folder.resolve("rough.png"), "the old picture");
        ProcessBuilder program = Program.program(folder, List.of("-XX:-UsePerfData", "-Xshare:auto"),
            "render", "rough.scene", "-o", "rough.png", "--size", "1000x1000", "--progress", "plain");
        program.command().addAll(0, List.of(shell.toString(), "-c", "ulimit -f 32 && exec \"$@\"", "sh"));   // 16 or 32 KiB

        Program.Result result = Program.finish(program.start(), new byte[0]);

        assertThat(result.err()).endsWith("simpleray: rough.png: cannot be written: File too large\n").doesNotContain("100 %");
        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
        assertThat(folder.resolve("rough.png")).hasContent("the old picture");
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files.map(file -> file.getFileName().toString()).collect(Collectors.toList()))
                .containsExactlyInAnyOrder("rough.png", "rough.scene");
        }
    }
}
