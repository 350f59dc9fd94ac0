package simpleray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Properties;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.cli.Program;

/** A picture is the same by another Java, of those that lie beside the running one; without one these tests are skipped. */
class OtherJavaTest {
    private static final int OLDEST = 17;
    private static final Path HOME = Path.of(System.getProperty("java.home"));
    private static Path other;

    @TempDir
    Path folder;

    @BeforeAll
    static void findAnotherJava() throws IOException {
        try (Stream<Path> homes = Files.list(HOME.toRealPath().getParent())) {
            List<Path> others = homes.filter(home -> Files.isExecutable(home.resolve("bin/java")))
                .filter(home -> version(home) >= OLDEST && version(home) != Runtime.version().feature())
                .sorted(Comparator.comparing(OtherJavaTest::version).thenComparing(Path::toString)).collect(Collectors.toList());
            assumeTrue(!others.isEmpty(), "no other Java beside " + HOME);
            other = others.get(others.size() - 1);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"thesis", "shininess", "odd-planes"})
    void thePictureIsTheSameByAnotherJava(String scene) throws IOException, InterruptedException {
        assertThat(Rendered.levels(png(other, scene))).isEqualTo(Rendered.levels(png(HOME, scene)));
    }

    @Test
    void theFileIsTheSameByAnotherJavaWithTheSameZlib() throws Exception {
        Path tests = Path.of(DeflateProbe.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        Program.Result probe = Program.finish(
            Program.java(other, folder, List.of("-cp", tests.toString(), DeflateProbe.class.getName())).start(), new byte[0]);
        assertThat(probe.err()).isEmpty();
        assumeTrue(Arrays.equals(probe.out(), DeflateProbe.compressed()), "the other Java has another zlib");

        assertThat(png(other, "thesis")).isEqualTo(png(HOME, "thesis"));
    }

    @Test
    void theInterpretationIsTheSameByAnotherJava() throws IOException, InterruptedException {
        String scene = Project.scene("sphere-flake").toString();

        assertThat(run(other, "print", scene).text()).isEqualTo(run(HOME, "print", scene).text());
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

    /** {@return the feature version of a Java, as the file beside it says; 0 if it does not} */
    private static int version(Path home) {
        Properties release = new Properties();
        try (var in = Files.newInputStream(home.resolve("release"))) {
            release.load(in);
            return Runtime.Version.parse(release.getProperty("JAVA_VERSION", "0").replace("\"", "")).feature();
        } catch (IOException | IllegalArgumentException e) {
            return 0;
        }
    }
}
