package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.image.Picture;
import simpleray.image.png.PngWriter;
import simpleray.render.Provenance;
import simpleray.render.RenderRequest;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;

/** {@code --skip-done}: what is there already, whole and the same, is not rendered again; all else is. */
class RenderCommandSkipDoneTest {
    private static final FileTime LONG_AGO = FileTime.fromMillis(1_000_000_000_000L);

    @TempDir
    Path folder;
    private Path scene;
    private Path out;

    @BeforeEach
    void copyScene() throws IOException {
        scene = Files.copy(Project.scene("thesis"), folder.resolve("a.scene"));
        out = folder.resolve("a.png");
    }

    private Program.Result render(String options) {
        return InProcess.run(Stream.concat(Stream.of("render", scene.toString(), "-o", out.toString(), "--size", "23x17"),
            Arrays.stream(options.split(" "))).toArray(String[]::new));
    }

    private byte[] made(String options) throws IOException {
        assertThat(render(options).exitCode()).isZero();
        return Files.readAllBytes(out);
    }

    private void assertSkipped(String options) throws IOException {
        Files.setLastModifiedTime(out, LONG_AGO);

        Program.Result result = render(options);

        assertThat(result.err()).isEqualTo(out + ": is there already, whole and of the same scene and options: it is not rendered again\n");
        assertThat(result.out()).isEmpty();
        assertThat(result.exitCode()).isZero();
        assertThat(Files.getLastModifiedTime(out)).isEqualTo(LONG_AGO);
    }

    private void assertRendered(String options, byte[] expected) throws IOException {
        Program.Result result = render(options);

        assertThat(result.err()).startsWith(out + ": 23x").doesNotContain("already");
        assertThat(result.exitCode()).isZero();
        assertThat(out).hasBinaryContent(expected);
    }

    @ParameterizedTest
    @ValueSource(strings = {"-q", "--samples adaptive", "--region 2,3,4,5", "--band 2/3", "--region 2,3,4,5 --band 2/3", "--depth 2 --stage lighting",
        "--threads 1 --accel none"})
    void whatIsThereAndWholeIsNotRenderedAgain(String options) throws IOException {
        byte[] before = made(options);

        assertSkipped(options.replace("-q", "--skip-done") + (options.equals("-q") ? "" : " --skip-done"));
        assertThat(out).hasBinaryContent(before);
    }

    @Test
    void howItIsMadeDoesNotMatter() throws IOException {
        made("-q");

        assertSkipped("--skip-done --threads 1 --accel none --stats json");
        assertThat(render("--skip-done -q").err()).isEmpty();
        assertThat(render("--skip-done --progress openjd").text()).isEqualTo("openjd_progress: 100.0\nopenjd_status: " + out
            + ": is there already, whole and of the same scene and options: it is not rendered again\n");
        assertThat(render("--skip-done --progress openjd -q").text()).isEmpty();
    }

    @Test
    void whatIsNotThereIsRendered() throws IOException {
        byte[] expected = made("-q");
        Files.delete(out);

        assertRendered("--skip-done", expected);
    }

    @ParameterizedTest
    @ValueSource(strings = {"--depth 3", "--samples 2", "--samples adaptive", "--stage lighting", "--cop 3", "--region 0,0,23,16",
        "--background 1,0,0", "--band 1/1", "--band 1/2"})
    void whatIsOfSomethingElseIsRenderedAgain(String other) throws IOException {
        byte[] expected = made("-q");
        made("-q " + other);
        assertRendered("--skip-done", expected);

        expected = made("-q " + other);
        made("-q");
        assertRendered("--skip-done " + other, expected);
    }

    @Test
    void anotherBandIsAnotherPicture() throws IOException {
        byte[] expected = made("--band 2/3 -q");
        made("--band 1/3 -q");

        assertRendered("--skip-done --band 2/3", expected);
    }

    @Test
    void ofAnotherSceneOrVersionItIsRenderedAgain() throws IOException {
        byte[] before = made("-q");
        Files.write(out, PngSums.renewed(new String(before, StandardCharsets.ISO_8859_1).replace("SimpleRay 0", "SimpleRay 9")
            .getBytes(StandardCharsets.ISO_8859_1)));
        assertRendered("--skip-done", before);

        Files.writeString(scene, Files.readString(scene) + "# a comment\n");
        assertThat(render("--skip-done").err()).startsWith(out + ": 23x17, ");
        assertThat(Files.readAllBytes(out)).isNotEqualTo(before);
    }

    @Test
    void whatIsBrokenIsRenderedAgain() throws IOException {
        for (String options : List.of("-q", "--band 2/3 -q")) {
            byte[] before = made(options);
            for (int at = 0; at < before.length; at += before.length / 20) {
                Files.write(out, Arrays.copyOf(before, at));
                assertRendered(options.replace("-q", "--skip-done"), before);
                byte[] other = before.clone();
                other[at] ^= (byte) (1 << at % 8);
                Files.write(out, other);
                assertRendered(options.replace("-q", "--skip-done"), before);
            }
        }
    }

    @Test
    void aPartWhoseSealIsAnothersIsRenderedAgain() throws IOException {
        byte[] before = made("--band 2/3 -q");
        String text = new String(before, StandardCharsets.ISO_8859_1);
        int seal = text.lastIndexOf("sha256 ") + "sha256 ".length();
        byte[] other = before.clone();
        other[seal] = (byte) (other[seal] == '0' ? '1' : '0');
        Files.write(out, PngSums.renewed(other));

        assertRendered("--band 2/3 --skip-done", before);
    }

    /** A file whose texts and checksums are all right, and that lacks rows. */
    @Test
    void pixelsThatAreMissingAreNoticed() throws IOException {
        byte[] before = made("-q");
        RenderRequest request = new RenderRequest();
        SceneFile read = SceneFile.read(scene);
        for (int[] size : new int[][] {{23, 16}, {22, 17}, {23, 17}}) {
            Picture picture = new Picture(size[0], size[1]);
            for (int y = 0; y < size[1]; y++) {
                picture.setRow(y, new double[3 * size[0]]);
            }
            SceneSettings settings = new SceneSettings();
            settings.resolution = new SceneSettings.Resolution(23, 17);
            picture.tell(Provenance.of(request.with(settings), read));
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            PngWriter.write(picture, png);
            Files.write(out, png.toByteArray());
            if (size[0] == 23 && size[1] == 17) {             // the right size: what it shows is not asked
                assertSkipped("--skip-done");
            } else {
                assertRendered("--skip-done", before);
            }
        }
        byte[] last = {0, 0, 0, 6, 'I', 'D', 'A', 'T'};
        int end = new String(before, StandardCharsets.ISO_8859_1).lastIndexOf(new String(last, StandardCharsets.ISO_8859_1));
        byte[] cut = Arrays.copyOf(before, before.length - 18);
        System.arraycopy(before, before.length - 12, cut, end, 12);
        Files.write(out, cut);                                // without the last chunk of image data
        assertRendered("--skip-done", before);
    }

    @Test
    void aFolderInItsPlaceIsAnErrorAsAlways() throws IOException {
        Files.createDirectory(out);

        Program.Result result = render("--skip-done");
        assertThat(result.err()).isEqualTo("simpleray: " + out + ": cannot be created: is a folder\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
    }

    @Test
    void whatIsNoFileCannotBeSkipped() {
        out = Path.of("-");
        Program.Result result = render("--skip-done");
        assertThat(result.err()).isEqualTo("simpleray render: --skip-done looks for a file, and standard output is none "
            + "(see simpleray render --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(result.out()).isEmpty();
        assumeTrue(Files.exists(Path.of("/dev/null")));
        out = Path.of("/dev/null");
        assertThat(render("--skip-done").err()).startsWith("simpleray render: --skip-done looks for a file, and /dev/null is none ");
    }

    @Test
    void aSceneWithErrorsIsToldEvenIfItsPictureIsThere() throws IOException {
        made("-q");
        Files.writeString(scene, SmallScenes.BAD);

        assertThat(render("--skip-done").exitCode()).isEqualTo(ExitCode.BAD_SCENE);
    }
}
