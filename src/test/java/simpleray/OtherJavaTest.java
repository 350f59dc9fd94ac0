package simpleray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.cli.Program;

/** A picture is the same by another Java, of those that lie beside the running one; without one these tests are skipped. */
class OtherJavaTest {
    private static Path other;

    @TempDir
    Path folder;

    @BeforeAll
    static void findAnotherJava() throws IOException {
        other = OtherJava.home();
    }

    @ParameterizedTest
    @ValueSource(strings = {"thesis", "shininess", "odd-planes"})
    void thePictureIsTheSameByAnotherJava(String scene) throws IOException, InterruptedException {
        assertThat(Rendered.levels(png(other, scene))).isEqualTo(Rendered.levels(png(OtherJava.HOME, scene)));
    }

    @Test
    void theFileIsTheSameByAnotherJavaWithTheSameZlib() throws Exception {
        Path tests = Path.of(DeflateProbe.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        Program.Result probe = Program.finish(
            Program.java(other, folder, List.of("-cp", tests.toString(), DeflateProbe.class.getName())).start(), new byte[0]);
        assertThat(probe.err()).isEmpty();
        assumeTrue(Arrays.equals(probe.out(), DeflateProbe.compressed()), "the other Java has another zlib");

        assertThat(png(other, "thesis")).isEqualTo(png(OtherJava.HOME, "thesis"));
    }

    @Test
    void theInterpretationIsTheSameByAnotherJava() throws IOException, InterruptedException {
        String scene = Project.scene("sphere-flake").toString();

        assertThat(run(other, "print", scene).text()).isEqualTo(run(OtherJava.HOME, "print", scene).text());
    }

    private byte[] png(Path home, String scene) throws IOException, InterruptedException {
        return run(home, "render", "-q", Project.scene(scene).toString(), "-o", "-", "--size", "120x90").out();
    }

    private Program.Result run(Path home, String... args) throws IOException, InterruptedException {
        Program.Result result = Program.finish(Program.program(home, folder, List.of(), args).start(), new byte[0]);
        assertThat(result.exitCode()).as(result.err()).isZero();
        assertThat(result.out()).isNotEmpty();
        return result;
    }
}
