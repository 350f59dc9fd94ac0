package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** No command writes over what it reads. In a command line @ stands for the folder. */
class OutputNameTest {
    private static final String MESH = "1  4 \"parts/tetra.obj\" 0 0 0 1  1 1 1  0 0 0  0 0 0  1   0.5 0.5 0.5  0\n";
    private static final String TETRA = "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";

    @TempDir
    Path folder;
    private Path scene;
    private Path mesh;
    private Path picture;

    @BeforeEach
    void writeScene() throws IOException {
        scene = Files.writeString(folder.resolve("tetra.scene"), MESH);
        mesh = Files.writeString(Files.createDirectory(folder.resolve("parts")).resolve("tetra.obj"), TETRA);
        picture = folder.resolve("tetra.png");
        assertThat(run("render @tetra.scene -q --size 8x8 -o @tetra.png").exitCode()).isZero();
    }

    private Program.Result run(String line) {
        return InProcess.run(line.replace("@", folder + "/").split(" "));
    }

    private void assertRefused(String line, String output, String why) throws IOException {
        byte[][] before = {Files.readAllBytes(scene), Files.readAllBytes(mesh), Files.readAllBytes(picture)};

        Program.Result result = run(line);

        String command = "simpleray " + line.split(" ")[0];
        assertThat(result.err()).isEqualTo(command + ": the output " + output.replace("@", folder + "/") + ' ' + why
            + " (see " + command + " --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(scene).hasBinaryContent(before[0]);
        assertThat(mesh).hasBinaryContent(before[1]);
        assertThat(picture).hasBinaryContent(before[2]);
    }

    private Path link(String name, Path target, boolean hard) throws IOException {
        Path link = folder.resolve(name);
        return hard ? Files.createLink(link, target) : Files.createSymbolicLink(link, target);
    }

    /** {@return the commands that write something else than a scene; that of a scene may be that scene itself} */
    static List<String> commands() {
        return List.of("render @tetra.scene --progress plain -o", "export --pov @tetra.scene -o", "still @tetra.scene -o");
    }

    @ParameterizedTest
    @MethodSource("commands")
    void theSceneByAnyNameIsRefused(String line) throws IOException {
        link("hard", scene, true);
        link("soft", scene, false);
        link("softer", folder.resolve("soft"), false);
        for (String name : List.of("@parts/../hard", "@hard", "@soft", "@softer", "@tetra.scene")) {
            assertRefused(line + ' ' + name, name, "is the scene itself");
        }
    }

    @ParameterizedTest
    @MethodSource("commands")
    void theSceneIsNotEvenRead(String line) throws IOException {
        Files.writeString(scene, "no scene");
        link("hard", scene, true);

        assertRefused(line + " @hard", "@hard", "is the scene itself");
    }

    static Stream<String> allCommands() {
        return Stream.concat(commands().stream(), Stream.of("convert @tetra.scene"));
    }

    @ParameterizedTest
    @MethodSource("allCommands")
    void aMeshByAnyNameIsRefused(String line) throws IOException {
        link("hard", mesh, true);
        link("soft", mesh, false);
        boolean picture = line.startsWith("render");          // is not called so anyway
        for (String name : picture ? List.of("@hard") : List.of("@hard", "@soft", "@parts/../parts/tetra.obj")) {
            assertRefused(line + ' ' + name, name, "is read by the scene");
        }
    }

    @ParameterizedTest
    @CsvSource({"tetra.png, the scene itself", "tetra-stages.png, the scene itself"})
    void aPictureThatCarriesTheSceneIsRefused(String name, String what) throws IOException {
        if (!Files.exists(folder.resolve(name))) {
            link(name, picture, true);
        }
        assertRefused("render @tetra.png --progress plain -o @" + name, "@" + name, "is " + what);
        assertRefused("export --pov @tetra.png -o @" + name, "@" + name, "is " + what);
        assertRefused("convert @tetra.png @" + name, "@" + name, "is the picture that carries the scene");
        if (name.contains("stages")) {
            assertRefused("figures @tetra.png --progress plain -d @", "@" + name, "is the scene itself");
        }
    }

    @Test
    void aFigureIsNoMesh() throws IOException {
        link("tetra-terms.png", mesh, true);

        assertRefused("figures @tetra.scene --progress plain -d @", "@tetra-terms.png", "is read by the scene");
        assertThat(folder.resolve("tetra-stages.png")).doesNotExist();
    }

    @Test
    void theMeshesOfAPicturesSceneAreRefused() throws IOException {
        link("hard", mesh, true);

        assertRefused("render @tetra.png --progress plain -o @hard", "@hard", "is read by the scene");
        assertRefused("convert @tetra.png @hard", "@hard", "is read by the scene");
    }

    @ParameterizedTest
    @ValueSource(strings = {"a.scene", "A.OBJ", "a.b.mtl", "a.txt", "a.pov", "parts/tetra.obj", ".obj"})
    void aPictureIsNotCalledAsScenesAndMeshesAre(String name) {
        for (String line : List.of("render @tetra.scene -o", "render @none -o", "render - -o", "compare @tetra.png @tetra.png --heatmap")) {
            Program.Result result = run(line + " @" + name);

            String command = "simpleray " + line.split(" ")[0];
            assertThat(result.err()).isEqualTo(command + ": pictures are written as PNG only: call the output " + folder + '/' + name
                + ".png? (see " + command + " --help)\n");
            assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        }
        assertThat(folder.resolve("a.scene")).doesNotExist();
    }

    @Test
    void aLinkIsCalledAsWhatItLeadsTo() throws IOException {
        Path other = Files.writeString(folder.resolve("other.scene"), "not read here");
        link("link.png", other, false);
        link("dangling.png", folder.resolve("none.obj"), false);

        for (String name : List.of("link.png -> other.scene", "dangling.png -> none.obj")) {
            String[] link = name.split(" -> ");
            Program.Result result = run("render @tetra.scene -q -o @" + link[0]);
            assertThat(result.err()).isEqualTo("simpleray render: pictures are written as PNG only, and the output " + folder.resolve(link[0])
                + " is a link to " + folder.toRealPath().resolve(link[1]) + " (see simpleray render --help)\n");
            assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        }
        assertThat(other).hasContent("not read here");
    }

    @Test
    void aCheckpointTouchesNoFileThatIsNone() {
        assertThat(run("render @tetra.scene -q -o @new.png --restart --checkpoint @parts/tetra.obj").err())
            .isEqualTo("simpleray: " + mesh + ": is no checkpoint\n");
        assertThat(mesh).hasContent(TETRA);
    }

    @Test
    void aSceneMayBeConvertedInPlace() {
        assertThat(run("convert @tetra.scene @tetra.scene").exitCode()).isZero();
        assertThat(scene).content().startsWith("# number of objects");
    }

    @Test
    void standardInputIsTheFileThatItComesFrom() throws IOException, InterruptedException {
        assumeTrue(Files.exists(Path.of("/dev/stdin")), "no /dev/stdin");
        Path hard = link("hard", scene, true);
        ProcessBuilder program = Program.program(folder, List.of(), "render", "-", "-o", "hard", "--progress", "plain");

        Program.Result result = Program.finish(program.redirectInput(scene.toFile()).start(), new byte[0]);

        assertThat(result.err()).isEqualTo("simpleray render: the output hard is the scene itself (see simpleray render --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(hard).hasContent(MESH);
    }

    @Test
    void aNameThatBeginsWithADashMeansWhatItSays() throws IOException, InterruptedException {
        Files.copy(scene, folder.resolve("-x.scene"));

        assertThat(Program.run(folder, "render", "tetra.scene", "--output=-o.png", "--size=8x8", "-q", "--window=-1,1,-1,1").err()).isEmpty();
        assertThat(folder.resolve("-o.png")).isNotEmptyFile();
        assertThat(Program.run(folder, "render", "-o", "a.png", "-q", "--size", "8x8", "--", "-x.scene").err()).isEmpty();
        assertThat(Program.run(folder, "render", "tetra.scene", "--output=-", "--size=8x8", "-q").out()).startsWith(0x89, 'P');
        Program.Result hint = Program.run(folder, "render", "-x.scene", "-o", "b.png");
        assertThat(hint.err()).isEqualTo("simpleray render: Missing required parameter: 'SCENE': a file whose name begins with - is named last, "
            + "behind --: -- -x.scene (see simpleray render --help)\n");
        assertThat(hint.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(Program.run(folder, "check", "-x.scene").err()).contains(": -- -x.scene (see simpleray check --help)");
        assertThat(Program.run(folder, "-x.scene").err()).contains(": -- -x.scene (see simpleray view --help)");
    }
}
