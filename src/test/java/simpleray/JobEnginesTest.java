package simpleray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Jobs run on the engines they are written for, and what fails on the way does not show; skipped where an engine cannot be had. */
@Tag("slow")
class JobEnginesTest {
    private static final int UNAVAILABLE = 69;
    private static final long MINUTES = 8;

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"test-slurm", "test-openjd"})
    void aFilmIsMadeAsOneMachineMakesIt(String script) throws IOException, InterruptedException {
        assumeTrue(System.getProperty("os.name").equals("Linux"), "no Slurm elsewhere");
        Path said = folder.resolve("said");
        ProcessBuilder builder = new ProcessBuilder("/bin/sh", Project.root().resolve("jobs").resolve(script).toString())
            .redirectErrorStream(true).redirectOutput(said.toFile());
        builder.environment().remove("SIMPLERAY");
        Process process = builder.start();
        try {
            process.getOutputStream().close();

            assertThat(process.waitFor(MINUTES, TimeUnit.MINUTES)).as(Files.readString(said)).isTrue();
        } finally {
            process.destroy();                                // by SIGTERM, after which it ends what it has started
        }

        String all = Files.readString(said, StandardCharsets.UTF_8);
        assumeTrue(process.exitValue() != UNAVAILABLE, all);
        assertThat(process.exitValue()).as(all).isZero();
        assertThat(all).contains("are as one process makes them, and none was made twice");
    }
}
