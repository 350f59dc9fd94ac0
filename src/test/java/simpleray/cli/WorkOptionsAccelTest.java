package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simpleray.Project;
import simpleray.Sample;

/** The engine changes no byte of a picture, however many threads work. */
class WorkOptionsAccelTest {
    @TempDir
    Path folder;

    static List<String> scenes() {
        return Sample.of(List.of("thesis", "many-spheres", "glass", "mesh", "cylinders", "light-ring", "free-camera", "odd-planes"), 3);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void theLoopAndTheEngineMakeTheSameFile(String name) throws IOException {
        byte[] loop = render(name, "--accel", "none");

        for (String threads : List.of("1", "2", "3", "7")) {
            assertThat(render(name, "--threads", threads)).as(threads + " threads").isEqualTo(loop);
        }
        assertThat(render(name, "--accel", "AUTO", "--samples", "2")).isEqualTo(render(name, "--accel", "none", "--samples", "2"));
    }

    private byte[] render(String name, String... options) throws IOException {
        Path scene = Project.scene(name);
        List<String> line = new ArrayList<>(List.of("render", scene.toString(), "-o",
            folder.resolve("a.png").toString(), "--size", "60x50", "-q"));
        line.addAll(List.of(options));
        Program.Result result = InProcess.run(line.toArray(new String[0]));
        assertThat(result.exitCode()).as(result.err()).isZero();
        return Files.readAllBytes(folder.resolve("a.png"));
    }

    @Test
    void anotherWayIsRefused() throws IOException, InterruptedException {
        Program.Result result = Program.run(folder, "render", "a.scene", "-o", "a.png", "--accel", "magic");

        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(result.err()).contains("[auto, none]").contains("'magic'");
    }
}
