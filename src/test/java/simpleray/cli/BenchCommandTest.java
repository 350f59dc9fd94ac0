package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BenchCommandTest {
    @TempDir
    Path folder;

    @Test
    void benchMeasuresRaysGrowthScenesThreadsAndPictures() throws IOException, InterruptedException {
        Program.Result result = Program.run(folder, "bench", "--quick");

        assertThat(result.exitCode()).as(result.err()).isZero();
        assertThat(result.err()).isEmpty();
        assertThat(result.text()).containsPattern("(?m)^primary +1600 +").containsPattern("(?m)^shadow +\\d+ +")
            .containsPattern("(?m)^ +100 +[0-9.]+ +[0-9.]+ +\\d+ ").containsPattern("(?m)^ +1000 +[0-9.]+ +[0-9.]+ +\\d+ ")
            .containsPattern("grows as the number of spheres to the power of -?[0-9.]+").containsPattern("(?m)^ +1 +[0-9.]+ +1\\.00$")
            .containsPattern("\\d+ pictures a second");
        for (String scene : new String[] {"1000 even spheres", "1000 spheres in heaps", "mesh of about 2000 triangles"}) {
            assertThat(result.text()).containsPattern("(?m)^" + scene + " +[0-9.]+ +[0-9.]+ +\\d+ +\\d+ +[0-9.]+ +\\d+ \\(40 x 40\\)$");
        }
    }
}
