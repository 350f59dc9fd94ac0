package simpleray.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simpleray.cli.Program;

/** Processes that begin a checkpoint while another removes it. */
@Tag("slow")
@Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class CheckpointRaceTest {
    private static final int PROCESSES = 3;

    @TempDir
    Path folder;

    @Test
    void ofManyProcessesOneHasItAtATime() throws Exception {
        Path home = Path.of(System.getProperty("java.home"));
        List<Process> all = new ArrayList<>();
        for (int i = 0; i < PROCESSES; i++) {
            all.add(Program.java(home, folder, List.of("-cp", System.getProperty("java.class.path"), CheckpointOwner.class.getName(),
                "rows", "owned")).start());
        }

        for (Process process : all) {
            Program.Result result = Program.finish(process, new byte[0]);
            assertThat(result.err()).isEmpty();
            assertThat(Integer.parseInt(result.text().strip())).isPositive();
        }
        assertThat(folder).isEmptyDirectory();
    }
}
