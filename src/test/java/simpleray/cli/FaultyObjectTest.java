package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.scene.FaultyKind;

/** A fault of the program while it renders. */
class FaultyObjectTest {
    @TempDir
    Path folder;

    @Test
    void itEndsTheRenderingWithItsExitCodeAndLeavesTheOldFileAndNoOther() throws IOException, InterruptedException {
        for (Program.Result result : rendered("-Dmemory=false")) {
            assertThat(result.err()).contains("simpleray: internal error, which should not happen whatever the input: "
                + "java.lang.IllegalStateException: a fault of this object\n");
            assertThat(result.exitCode()).isEqualTo(ExitCode.INTERNAL);
        }
    }

    /** The memory may end on any thread: here it does on those that render. */
    @ParameterizedTest
    @ValueSource(strings = {"--threads 1", "--threads 4", "--threads 4 --samples adaptive", "--threads 4 --accel none", "--checkpoint rows"})
    void memoryThatEndsWhileItRendersIsOneLineAndItsExitCode(String options) throws IOException, InterruptedException {
        for (Program.Result result : rendered("-Dmemory=true", options.split(" "))) {
            assertThat(result.err()).isEqualTo(
                "simpleray: the scene or the picture is too large for the memory: make it smaller, or give java more by -Xmx\n");
            assertThat(result.exitCode()).isEqualTo(ExitCode.NO_MEMORY);
        }
    }

    private List<Program.Result> rendered(String property, String... options) throws IOException, InterruptedException {
        Files.writeString(folder.resolve("faulty.scene"), "1\n99\n0 0 0\n0\n");
        Files.writeString(folder.resolve("old.png"), "the old picture");
        List<Program.Result> results = new ArrayList<>();
        for (String output : List.of("new.png", "old.png")) {
            List<String> args = new ArrayList<>(List.of("-cp", System.getProperty("java.class.path"), property, FaultyKind.class.getName(),
                "render", "faulty.scene", "-o", output));
            args.addAll(List.of(options));
            results.add(Program.finish(Program.java(Path.of(System.getProperty("java.home")), folder, args).start(), new byte[0]));
        }
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files.map(file -> file.getFileName().toString())).containsExactlyInAnyOrder("faulty.scene", "old.png");
        }
        assertThat(folder.resolve("old.png")).hasContent("the old picture");
        return results;
    }
}
