package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simpleray.Project;
import simpleray.scene.SceneBits;
import simpleray.scene.Reach;
import simpleray.scene.SceneFile;

/** {@code convert}: the same scene in canonical form. */
class ConvertCommandTest {
    private static final String GLASS = """
        1  # ball
        0  0 0 0 1  1 1 1  0.1 0.2 0.3  0 0 0  1e1
          transmit 0.5 0.5 1e0 1.50   .25 .5 1
        1  1 1 1 1 0 -1 0
        samples 2   # smooth
        camera 3 2 5  0 0 0  40
        background 0.1 0.2 4e-1
        """;
    private static final String CANONICAL = """
        # number of objects
        1
        0  0.0 0.0 0.0 1.0  1.0 1.0 1.0  0.1 0.2 0.3  0.0 0.0 0.0  10.0  transmit 0.5 0.5 1.0  1.5
        # ambient light
        0.25 0.5 1.0
        # number of lights
        1
        1  1.0 1.0 1.0  0.0 -1.0 0.0
        background 0.1 0.2 0.4
        camera 3.0 2.0 5.0 0.0 0.0 0.0 40.0
        samples 2
        """;

    @TempDir
    Path folder;
    private Path in;
    private Path out;

    @BeforeEach
    void writeScene() throws IOException {
        in = Files.writeString(folder.resolve("in.scene"), GLASS);
        out = folder.resolve("out.scene");
    }

    @Test
    void aSceneIsRewrittenInCanonicalForm() throws IOException {
        assertDone(InProcess.run("convert", in.toString(), out.toString()));

        assertThat(out).hasContent(CANONICAL);
        assertThat(in).hasContent(GLASS);
        assertOnly("in.scene", "out.scene");
    }

    @Test
    void anOldFileIsReplaced() throws IOException {
        Files.writeString(out, "old ".repeat(10000));

        assertDone(InProcess.run("convert", in.toString(), out.toString()));

        assertThat(out).hasContent(CANONICAL);
    }

    @Test
    void inAndOutMayBeOneFile() throws IOException {
        assertDone(InProcess.run("convert", in.toString(), folder.resolve("../" + folder.getFileName() + "/in.scene").toString()));

        assertThat(in).hasContent(CANONICAL);
        assertOnly("in.scene");
    }

    @Test
    void aDashIsStandardInputOrOutput() throws IOException {
        Program.Result both = InProcess.runWithInput(GLASS, "convert", "-", "-");
        assertThat(both.out()).isEqualTo(CANONICAL.getBytes(StandardCharsets.UTF_8));
        assertThat(both.err()).isEmpty();
        assertThat(both.exitCode()).isZero();

        assertThat(InProcess.run("convert", in.toString(), "-").text()).isEqualTo(CANONICAL);

        assertDone(InProcess.runWithInput(GLASS, "convert", "-", out.toString()));
        assertThat(out).hasContent(CANONICAL);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void aSampleSceneStaysTheSame(String name) throws IOException {
        Path again = folder.resolve("again.scene");
        Path scene = Files.copy(Project.scene(name), folder.resolve("scene.scene"));
        for (String mesh : List.of("knot.obj", "house.obj", "house.mtl")) {
            Files.copy(Project.scene(name).resolveSibling(mesh), folder.resolve(mesh));
        }
        assertThat(InProcess.run("convert", scene.toString(), out.toString()).exitCode()).isZero();
        assertDone(InProcess.run("convert", out.toString(), again.toString()));

        assertThat(SceneBits.of(SceneFile.read(out).scene())).isEqualTo(SceneBits.of(SceneFile.read(scene).scene()));
        assertThat(InProcess.run("print", out.toString()).out()).isEqualTo(InProcess.run("print", scene.toString()).out()).isNotEmpty();
        assertThat(again).hasSameBinaryContentAs(out);
    }

    @Test
    void inAnotherFolderAMeshIsStillFound() throws IOException {
        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere")).resolve("out.scene");
        Path mesh = Files.copy(Project.scene("mesh"), folder.resolve("mesh.scene"));
        Files.copy(Project.scene("mesh").resolveSibling("knot.obj"), folder.resolve("knot.obj"));

        Program.Result result = InProcess.run("convert", mesh.toString(), elsewhere.toString());

        assertThat(result.exitCode()).isZero();
        assertThat(result.err()).isEqualTo(elsewhere + ": warning: names OBJ files outside its folder: --allow-outside allows them\n");
        assertThat(elsewhere).content().contains("4  \"../knot.obj\" ");
        assertThat(SceneFile.read(elsewhere, Reach.ANYWHERE).scene().getNumberObjects()).isEqualTo(5);
    }

    @Test
    void warningsAreToldAndHeadingsLost() throws IOException {
        Files.writeString(in, SmallScenes.WITH_HEADING);

        Program.Result result = InProcess.run("convert", in.toString(), out.toString());

        assertThat(result.err()).isEqualTo(String.format(SmallScenes.HEADING_WARNING, in));
        assertThat(result.exitCode()).isZero();
        assertThat(InProcess.run("convert", out.toString(), "-").err()).isEmpty();
    }

    @Test
    void aBadSceneIsReportedAndLeavesTheOutputAlone() throws IOException {
        Files.writeString(in, SmallScenes.BAD);

        assertFails(ExitCode.BAD_SCENE, String.format(SmallScenes.BAD_REPORT, in), in.toString(), in.toString());
        assertFails(ExitCode.BAD_SCENE, String.format(SmallScenes.BAD_REPORT, in), in.toString(), "-");
        assertFails(ExitCode.BAD_SCENE, String.format(SmallScenes.BAD_REPORT, in), in.toString(), out.toString());

        assertThat(in).hasContent(SmallScenes.BAD);
        assertOnly("in.scene");
    }

    @Test
    void aSceneThatCannotBeReadIsNamed() throws IOException {
        assertFails(ExitCode.NO_SCENE, "simpleray: " + out + ": no such file\n", out.toString(), in.toString());
        assertFails(ExitCode.NO_SCENE, "simpleray: " + folder + ": is a folder\n", folder.toString(), "-");

        assertThat(in).hasContent(GLASS);
    }

    @Test
    void anOutputThatCannotBeCreatedIsNamed() throws IOException {
        Path missing = folder.toRealPath().resolve("missing");

        assertFails(ExitCode.NO_OUTPUT, "simpleray: " + folder + ": cannot be created: is a folder\n", in.toString(), folder.toString());
        assertFails(ExitCode.NO_OUTPUT, "simpleray: " + missing.resolve("a.scene") + ": cannot be created: there is no folder " + missing
            + '\n', in.toString(), missing.resolve("a.scene").toString());
        assertOnly("in.scene");
    }

    private static Stream<String> scenes() {
        return Project.scenes().stream();
    }

    private static void assertDone(Program.Result result) {
        assertThat(result.err()).isEmpty();
        assertThat(result.out()).isEmpty();
        assertThat(result.exitCode()).isZero();
    }

    private static void assertFails(int exitCode, String message, String in, String out) {
        Program.Result result = InProcess.run("convert", in, out);

        assertThat(result.err()).isEqualTo(message);
        assertThat(result.out()).isEmpty();
        assertThat(result.exitCode()).isEqualTo(exitCode);
    }

    private void assertOnly(String... names) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files.map(file -> file.getFileName().toString())).containsExactlyInAnyOrder(names);
        }
    }
}
