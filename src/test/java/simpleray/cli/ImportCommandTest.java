package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code import}: scenes of other programs. */
class ImportCommandTest {
    private static final String RT = "A 0.2 255,255,255\nC 0,0,5 0,0,-1 70\nL -3,4,2 0.7 255,255,255\nsp 0,0,0 2 255,0,0 shiny\n";
    private static final String NFF = "v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 hither 0 resolution 8 8\nl 0 0 9\nf 1 0 0 1 0 1 0 0\n"
        + "pp 3  -2 -2 0 0 0 1  2 -2 0 0 0 1  0 2 0 0 0 1\nf 0 0 1 1 0 1 0 0\np 3  -2 -2 -1  2 -2 -1  0 2 -1\n";

    @TempDir
    Path folder;

    private Program.Result run(String line) {
        return InProcess.run(line.replace("@", folder + "/").split(" "));
    }

    private void write(String name, String text) throws IOException {
        Files.writeString(folder.resolve(name), text);
    }

    private void assertDone(String line) {
        Program.Result result = run(line);

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
    }

    private void assertRefused(int exitCode, String line, String message) {
        Program.Result result = run(line);

        assertThat(result.err()).isEqualTo(message.replace("@", folder + "/") + '\n');
        assertThat(result.exitCode()).isEqualTo(exitCode);
        assertThat(result.out()).isEmpty();
    }

    @Test
    void aSceneIsWrittenAndItsWarningsAreTold() throws IOException {
        write("a.rt", RT);

        Program.Result result = run("import @a.rt -o @a.scene");

        assertThat(result.err()).isEqualTo(folder.resolve("a.rt") + ":4:20: warning: left out: what stands here is not in miniRT, and programs that have it "
            + "differ\nsp 0,0,0 2 255,0,0 shiny\n" + " ".repeat(19) + "^\n");
        assertThat(result.exitCode()).isZero();
        assertDone("check @a.scene");
    }

    @Test
    void standardInputAndOutputWorkIfTheFormatIsNamed() {
        Program.Result result = InProcess.runWithInput(RT, "import", "-", "--from", "rt", "-o", "-");

        assertThat(result.text()).startsWith("# imported by SimpleRay from <stdin>\n# number of objects\n1\n0  0.0 0.0 0.0 1.0 ");
        assertThat(result.err()).startsWith("<stdin>:4:20: warning: ");
        assertThat(result.exitCode()).isZero();
    }

    /** The front triangle is red, and hides most of the blue one. */
    @Test
    void polygonsGoToAnObjWhosePictureIsRight() throws IOException {
        write("a.nff", NFF);

        assertDone("import @a.nff -o @b.scene");

        assertThat(folder.resolve("b.scene")).content().contains("\n4  \"b.obj\" 0.0 0.0 0.0 1.0 ", "  mtl\n");
        assertThat(folder.resolve("b.obj")).content().contains("\nmtllib b.mtl\n");
        assertDone("render @b.scene -o @b.png -q");
        assertThat(run("explain @b.scene --pixel 4,4 -q").text()).contains("m1");
        assertDone("import @a.nff -o @b.scene");             // over files of its own
    }

    @Test
    void aFolderIsNoOBJ() throws IOException {
        write("a.nff", NFF);
        Files.createDirectory(folder.resolve("b.obj"));

        assertRefused(ExitCode.NO_OUTPUT, "import @a.nff -o @b.scene", "simpleray: @b.obj: is a folder: give the scene another name");
    }

    @ParameterizedTest
    @CsvSource({"b.obj", "b.mtl"})
    void aFileOfNoImportIsNotOverwritten(String name) throws IOException {
        write("a.nff", NFF);
        write(name, "# mine\n");
        write("b.scene", "the old one");

        assertRefused(ExitCode.NO_OUTPUT, "import @a.nff -o @b.scene",
            "simpleray: @" + name + ": is there, and from no import: give the scene another name, or this file");
        assertThat(folder.resolve(name)).hasContent("# mine");
        assertThat(folder.resolve("b.scene")).hasContent("the old one");
        assertThat(folder.toFile().list()).hasSize(3);
    }

    @Test
    void whatIsReadIsNotOverwritten() throws IOException {
        write("a.obj", NFF);
        Files.createLink(folder.resolve("hard"), folder.resolve("a.obj"));

        assertRefused(ExitCode.USAGE, "import @hard --from nff -o @a.obj", "simpleray import: the output @a.obj is the file to read (see simpleray import --help)");
        assertRefused(ExitCode.USAGE, "import @hard --from nff -o @a.scene", "simpleray import: the output @a.obj is the file to read (see simpleray import --help)");
        write("a.nff", NFF);
        assertRefused(ExitCode.USAGE, "import @a.nff -o @c.obj", "simpleray import: the output @c.obj leaves no name for an OBJ beside it "
            + "(see simpleray import --help)");
        assertThat(folder.resolve("a.obj")).hasContent(NFF);
    }

    @Test
    void anObjNeedsAPlaceAndAName() throws IOException {
        write("a.nff", NFF);

        assertRefused(ExitCode.USAGE, "import @a.nff -o -", "simpleray import: polygons go to an OBJ beside the scene, which - has no place for "
            + "(see simpleray import --help)");
        assertRefused(ExitCode.USAGE, "import @a.nff -o @.scene", "simpleray import: the output @.scene leaves no name for an OBJ beside it "
            + "(see simpleray import --help)");
        assertRefused(ExitCode.USAGE, "import @a.nff -o @\".scene", "simpleray import: the output @\".scene leaves no name for an OBJ beside it "
            + "(see simpleray import --help)");
        assertRefused(ExitCode.NO_OUTPUT, "import @a.nff -o @none/b.scene", "simpleray: @none/b.obj: cannot be created: there is no folder " + folder.resolve("none"));
    }

    @Test
    void anErrorIsOneLineWithItsPlace() throws IOException {
        write("a.rt", "C 0,0,5 0,0,-1 70\nsp 0,0,0 two 255,0,0\n");

        assertRefused(ExitCode.BAD_SCENE, "import @a.rt -o @a.scene", "@a.rt:2:10: error: expected the sphere's diameter, found 'two'\nsp 0,0,0 two 255,0,0\n"
            + "         ^");
        assertThat(folder.resolve("a.scene")).doesNotExist();
    }

    @Test
    void aNameThatTellsNothingAndAFileThatIsNotThereAreErrors() throws IOException {
        write("a.txt", RT);

        assertRefused(ExitCode.USAGE, "import @a.txt -o @a.scene",
            "simpleray import: the name of @a.txt tells no format: --from rt or --from nff does (see simpleray import --help)");
        assertRefused(ExitCode.USAGE, "import @a.txt --from dxf -o @a.scene",
            "simpleray import: Invalid value for option '--from': expected one of [rt, nff], found 'dxf' (see simpleray import --help)");
        assertRefused(ExitCode.NO_SCENE, "import @b.rt -o @a.scene", "simpleray: @b.rt: no such file");
        assertRefused(ExitCode.NO_SCENE, "import @ --from rt -o @a.scene", "simpleray: @: is a folder");
    }
}
