package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A reader of standard output that takes a few bytes and goes, in a real pipe. */
class EarlyEndTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"render rough.scene -o - --size 1000x1000 -q, the picture cannot be written to standard output",
        "print many.scene, standard output cannot be written", "convert many.scene -, standard output cannot be written",
        "export --pov many.scene -o -, standard output cannot be written"})
    void itIs74WithoutATrace(String line, String message) throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "no shell");
        Files.writeString(folder.resolve("rough.scene"), SmallScenes.ROUGH);
        Files.writeString(folder.resolve("many.scene"), SmallScenes.many(5000));
        ProcessBuilder program = Program.program(folder, List.of(), line.split(" "));
        program.command().addAll(0, List.of("/bin/sh", "-c", "{ \"$@\"; echo \"$?\" >&2; } | head -c 10", "sh"));

        Program.Result result = Program.finish(program.start(), new byte[0]);

        assertThat(result.err()).isEqualTo("simpleray: " + message + ": Broken pipe\n74\n");
        assertThat(result.out()).hasSize(10);
    }
}
