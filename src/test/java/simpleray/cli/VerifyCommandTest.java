package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.image.Picture;
import simpleray.image.png.PngReader;
import simpleray.image.png.PngWriter;
import simpleray.scene.PictureScene;

/** Pictures that prove how they were made. */
class VerifyCommandTest {
    private static final String MESH = "1  4 \"tetra.obj\" 0 0 0 1  1 1 1  0 0 0  0 0 0  1   0.5 0.5 0.5  0\n";
    private static final String TETRA = "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";

    @TempDir
    Path folder;
    private Path scene;
    private Path picture;

    @BeforeEach
    void render() throws IOException {
        scene = Files.copy(Project.scene("thesis"), folder.resolve("thesis.scene"));
        picture = folder.resolve("thesis.png");
        run("render", scene, "-o", picture, "--size", "40x30", "-q");
    }

    private static void run(Object... args) {
        Program.Result result = InProcess.run(words(args));
        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
    }

    private static String[] words(Object... args) {
        return Arrays.stream(args).map(Object::toString).toArray(String[]::new);
    }

    private static void assertEnds(int exitCode, String out, String err, Object... args) {
        Program.Result result = InProcess.run(words(args));

        assertThat(result.err()).isEqualTo(err);
        assertThat(result.text()).isEqualTo(out);
        assertThat(result.exitCode()).isEqualTo(exitCode);
    }

    private void assertGood(Path png, int pixels) {
        assertEnds(0, png + ": good: all " + pixels + " pixels are the same\n", "", "verify", png);
    }

    /** Changes a picture's pixels and leaves what it tells. */
    private static void rewrite(Path png, Picture changed) throws IOException {
        rewrite(png, changed, PictureScene.read(png).others());
    }

    /** Changes a picture's pixels and what it tells of stage, region and adaptive sampling. */
    private static void rewrite(Path png, Picture changed, List<String> others) throws IOException {
        PictureScene told = PictureScene.read(png);
        StringBuilder options = new StringBuilder();
        others.forEach(line -> options.append(line).append('\n'));
        changed.tell(PictureScene.texts(told.software(), options + told.settings().lines(), told.text()));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PngWriter.write(changed, bytes);
        Files.write(png, bytes.toByteArray());
    }

    private static Picture pixels(Path png) throws IOException {
        try (PngReader rows = PngReader.open(png.toString())) {
            Picture picture = new Picture(rows.width(), rows.height());
            for (int y = 0; y < rows.height(); y++) {
                byte[] levels = rows.next();
                double[] light = new double[levels.length];
                for (int i = 0; i < light.length; i++) {
                    light[i] = (levels[i] & 0xFF) / 255.0;
                }
                picture.setRow(y, light);
            }
            return picture;
        }
    }

    @Test
    void aPictureAsItWasMadeIsGoodWithoutItsScene() throws IOException {
        Files.delete(scene);

        assertGood(picture, 1200);
    }

    @ParameterizedTest
    @ValueSource(strings = {"--stage lighting", "--stage specular --depth 2", "--samples 2", "--samples adaptive", "--cop 3.3",
        "--window -1,1,-0.7,0.7", "--camera 1,0.5,3,0,-0.2,0,50 --background 0.1,0.2,0.3", "--depth 0 --accel none", "--threads 3"})
    void everyOptionThatDecidesAboutPixelsIsCarried(String options) throws IOException {
        Path other = folder.resolve("other.png");
        List<String> line = new ArrayList<>(List.of("render", scene.toString(), "-o", other.toString(), "--size", "40x30", "-q"));
        line.addAll(List.of(options.split(" ")));
        run(line.toArray());
        Files.delete(scene);

        assertGood(other, 1200);
    }

    @ParameterizedTest
    @ValueSource(strings = {"--region 5,3,20,10", "--region 39,29,1,1 --samples adaptive", "--region 0,0,40,30"})
    void aRegionIsThatOfItsWholePicture(String options) throws IOException {
        Path piece = folder.resolve("piece.png");
        List<String> line = new ArrayList<>(List.of("render", scene.toString(), "-o", piece.toString(), "--size", "40x30", "-q"));
        line.addAll(List.of(options.split(" ")));
        run(line.toArray());
        Files.delete(scene);
        Picture pixels = pixels(piece);

        assertGood(piece, pixels.width() * pixels.height());
        run("render", piece, "-o", folder.resolve("whole.png"), "-q");
        assertThat(pixels(folder.resolve("whole.png"))).extracting(Picture::width, Picture::height).containsExactly(40, 30);
    }

    @Test
    void aPictureOfAnotherRegionIsDifferent() throws IOException {
        run("render", scene, "-o", picture, "--size", "40x30", "-q", "--region", "5,3,20,10");
        rewrite(picture, pixels(picture), List.of("stage final", "region 5,4,20,10"));

        Program.Result result = InProcess.run("verify", picture.toString());

        assertThat(result.text()).startsWith(picture + ": different: ").contains(" of 200 pixels, the first in row ");
        assertThat(result.exitCode()).isEqualTo(ExitCode.DIFFERENT);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"5,3,20 | was made of a region that is none: '5,3,20'",
        "5,3,20,0 | was made of a region that is none: '5,3,20,0'",
        "30,3,20,10 | was made with options that do not fit: the region 30,3,20,10 is not inside the picture of 40x30",
        "5,3,20,11 | is 20x10, and its options say 20x11"})
    void aRegionThatCannotBeIs65(String region, String message) throws IOException {
        run("render", scene, "-o", picture, "--size", "40x30", "-q", "--region", "5,3,20,10");
        rewrite(picture, pixels(picture), List.of("stage final", "region " + region));

        assertEnds(ExitCode.BAD_SCENE, "", "simpleray: " + picture + ": " + message + '\n', "verify", picture);
    }

    @Test
    void theSceneAndTheOptionsAloneDecideAboutTheFile() throws IOException {
        Path again = folder.resolve("again.png");
        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere")).resolve("thesis.scene");
        Files.copy(scene, elsewhere);
        run("render", elsewhere, "-o", again, "--size", "40x30", "-q", "--threads", "3", "--accel", "none");

        assertThat(again).hasSameBinaryContentAs(picture);
        assertThat(new String(Files.readAllBytes(picture), StandardCharsets.ISO_8859_1)).doesNotContain(folder.toString());
    }

    @Test
    void aPictureIsASceneAndMakesItselfAgain() throws IOException {
        Path again = folder.resolve("again.png");
        Files.delete(scene);

        run("render", picture, "-o", again, "-q");
        assertThat(again).hasSameBinaryContentAs(picture);
        assertEnds(0, picture + ": good: 9 objects, 2 lights, 1 warning\n",
            picture + ":55:1: warning: light 2 (line 55) lights nothing that is seen: object 4 (plane, line 19) is in the way\n",
            "check", picture);
        assertThat(InProcess.run("explain", picture.toString(), "--pixel", "20,15").text())
            .startsWith("pixel 20,15 of 40x30, stage final: ").contains("\n  Red back wall (line 23), ");
        assertThat(InProcess.run("print", picture.toString()).text()).startsWith("Scene has 9 objects\n")
            .endsWith("resolution 40 30\ndepth 10\nsamples 1\n");
    }

    @Test
    void aPixelThatWasChangedIsFound() throws IOException {
        Picture pixels = pixels(picture);
        double[] row = pixels.row(7).clone();
        row[3 * 5 + 1] = row[3 * 5 + 1] > 0.5 ? 0 : 1;
        row[3 * 9] = row[3 * 9] > 0.5 ? 0 : 1;
        pixels.setRow(7, row);
        rewrite(picture, pixels);

        Program.Result result = InProcess.run("verify", picture.toString());

        assertThat(result.text()).matches("\\Q" + picture
            + "\\E: different: 2 of 1200 pixels, the first in row 8, column 6: \\d+,(0|255),\\d+ in the file, \\d+,\\d+,\\d+ rendered\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.DIFFERENT);
        assertThat(result.err()).isEmpty();
    }

    @Test
    void aPictureOfAnotherVersionIsToldAsSuch() throws IOException {
        Picture pixels = pixels(picture);
        PictureScene told = PictureScene.read(picture);
        pixels.tell(PictureScene.texts("SimpleRay 0.0.1", "stage final\n" + told.settings().lines(), told.text()));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PngWriter.write(pixels, bytes);
        Files.write(picture, bytes.toByteArray());

        assertEnds(0, picture + ": good: all 1200 pixels are the same (made by SimpleRay 0.0.1, rendered again by SimpleRay 0.1.0)\n", "",
            "verify", picture);
    }

    @Test
    void aPictureOfAnotherSizeThanItTellsIs65() throws IOException {
        rewrite(picture, black(41, 30));

        assertEnds(ExitCode.BAD_SCENE, "", "simpleray: " + picture + ": is 41x30, and its options say 40x30\n", "verify", picture);
    }

    @Test
    void aPictureThatTellsNothingIs65() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PngWriter.write(black(2, 2), bytes);
        Files.write(picture, bytes.toByteArray());
        String message = "simpleray: " + picture + ": carries no scene: it is not of SimpleRay, or another program has written it anew\n";

        assertEnds(ExitCode.BAD_SCENE, "", message, "verify", picture);
        assertEnds(ExitCode.BAD_SCENE, "", message, "check", picture);
        assertEnds(ExitCode.BAD_SCENE, "", message, "render", picture, "-o", folder.resolve("b.png"));
        assertEnds(ExitCode.BAD_SCENE, "", "simpleray: " + scene + ": is no PNG\n", "verify", scene);
        assertEnds(ExitCode.NO_SCENE, "", "simpleray: " + folder + ": is a folder\n", "verify", folder);
        assertEnds(ExitCode.NO_SCENE, "", "simpleray: " + folder + "/none: no such file\n", "verify", folder.resolve("none"));
    }

    @Test
    void aDamagedPictureIs65() throws IOException {
        byte[] file = Files.readAllBytes(picture);
        Files.write(picture, Arrays.copyOf(file, file.length - 20));
        assertEnds(ExitCode.BAD_SCENE, "", "simpleray: " + picture + ": is cut off in the chunk IDAT\n", "verify", picture);
        assertEnds(ExitCode.BAD_SCENE, "[{\"file\":\"" + picture + "\",\"line\":1,\"column\":1,\"severity\":\"error\",\"message\":"
            + "\"is cut off in the chunk IDAT\"}]\n", "", "check", "--errors", "json", picture);
        file[file.length / 2]++;
        Files.write(picture, file);
        assertThat(InProcess.run("verify", picture.toString()).err())
            .matches("\\Qsimpleray: " + picture + "\\E: is damaged in the chunk \\w{4}: its checksum is wrong\n");
    }

    @Test
    void ofALongSceneThePictureCarriesTheDigestAndTheFileMustBeGiven() throws IOException {
        Path large = folder.resolve("large.scene");
        Files.writeString(large, SmallScenes.GREY + ("#" + "-".repeat(1023)).repeat(16 * 1024) + '\n');   // 16 MiB and a little
        run("render", large, "-o", picture, "--size", "3x2", "-q");
        assertThat(Files.size(picture)).isLessThan(1000);
        String message = "simpleray: " + picture + ": carries only the digest of its scene, which is too long: open large.scene\n";

        assertEnds(ExitCode.BAD_SCENE, "", message, "verify", picture);
        assertEnds(0, picture + ": good: all 6 pixels are the same\n", "", "verify", picture, "--scene", large);
        Program.Result other = InProcess.run("verify", picture.toString(), "--scene", scene.toString());
        assertThat(other.err()).matches("\\Qsimpleray: " + scene + ": is not the scene that " + picture
            + " was made of: its SHA-256 is \\E[0-9a-f]{64}, and was [0-9a-f]{64}\n");
        assertThat(other.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
    }

    @Test
    void aSceneOfSomeMegabytesIsCarriedPlainAndComesBack() throws IOException {
        Path large = folder.resolve("large.scene");
        Files.writeString(large, SmallScenes.GREY + ("#" + "-".repeat(1023) + '\n').repeat(2 * 1024));
        run("render", large, "-o", picture, "--size", "3x2", "-q");
        // compressed, it could not be opened by programs that unpack no more than 1 MiB
        assertThat(new String(Files.readAllBytes(picture), StandardCharsets.ISO_8859_1)).contains(Files.readString(large));
        Files.delete(large);

        assertGood(picture, 6);
    }

    @Test
    void aMeshIsNamedByItsDigestAndAnotherOneIsNoticed() throws IOException {
        Files.writeString(folder.resolve("tetra.obj"), TETRA);
        Files.writeString(scene, MESH);
        run("render", scene, "-o", picture, "--size", "20x20", "-q");
        assertGood(picture, 400);

        Files.writeString(folder.resolve("tetra.obj"), TETRA + "# more\n");

        assertEnds(ExitCode.BAD_SCENE, "", "simpleray: " + picture + ": was made of other meshes: tetra.obj\n", "verify", picture);
        assertThat(InProcess.run("check", picture.toString()).err()).startsWith(picture
            + ":1:1: warning: the mesh 'tetra.obj' is not the one that the picture was made of\n");
        Path moved = Files.createDirectory(folder.resolve("moved"));
        Files.writeString(moved.resolve("tetra.obj"), TETRA);
        Files.copy(scene, moved.resolve("thesis.scene"));
        assertEnds(0, picture + ": good: all 400 pixels are the same\n", "", "verify", picture, "--scene", moved.resolve("thesis.scene"));
    }

    @Test
    void anMtlFileIsNamedByItsDigestToo() throws IOException {
        Files.writeString(folder.resolve("tetra.obj"), "mtllib tetra.mtl\nusemtl red\n" + TETRA);
        Path mtl = Files.writeString(folder.resolve("tetra.mtl"), "newmtl red\nKa 1 0 0\n");
        Files.writeString(scene, MESH.replace("1   0.5", "1 mtl 0.5"));
        run("render", scene, "-o", picture, "--size", "20x20", "-q");
        assertGood(picture, 400);

        Files.writeString(mtl, "newmtl red\nKa 1 0 0.5\n");

        assertEnds(ExitCode.BAD_SCENE, "", "simpleray: " + picture + ": was made of other meshes: tetra.mtl\n", "verify", picture);
        assertThat(InProcess.run("check", picture.toString()).err()).startsWith(picture
            + ":1:1: warning: the MTL file 'tetra.mtl' is not the one that the picture was made of\n");
    }

    @Test
    void aPictureMayComeFromStandardInput() throws IOException {
        Program.Result result = InProcess.run(Files.newInputStream(picture), new ByteArrayOutputStream(), "render", "-", "-o",
            folder.resolve("again.png").toString(), "-q");

        assertThat(result.err()).isEmpty();
        assertThat(folder.resolve("again.png")).hasSameBinaryContentAs(picture);
    }

    private static Picture black(int width, int height) {
        Picture picture = new Picture(width, height);
        for (int y = 0; y < height; y++) {
            picture.setRow(y, new double[3 * width]);
        }
        return picture;
    }

    @Test
    void whatNeverEndsIsReadNoFurtherThanNeeded() throws IOException {
        InputStream zeros = new InputStream() {
            @Override
            public int read() {
                return 0;
            }
        };
        Program.Result no = InProcess.run(zeros, new ByteArrayOutputStream(), "verify", "-");
        Program.Result more = InProcess.run(new SequenceInputStream(Files.newInputStream(picture), zeros), new ByteArrayOutputStream(), "verify", "-", "-q");

        assertThat(no.err()).isEqualTo("simpleray: <stdin>: is no PNG\n");
        assertThat(no.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(more.err()).isEmpty();
        assertThat(more.exitCode()).isZero();
    }

    @Test
    void aPictureMayComeByStandardInputOrByAPipe() throws IOException, InterruptedException {
        Program.Result piped = Program.runWithInput(folder, Files.readAllBytes(picture), "verify", "-", "-q");
        Program.Result named = Program.runWithInput(folder, Files.readAllBytes(picture), "verify", "/dev/stdin", "-q");
        Program.Result withScene = Program.runWithInput(folder, Files.readAllBytes(picture), "verify", "-", "-q", "--scene", "thesis.scene");
        Program.Result no = Program.runWithInput(folder, Files.readAllBytes(scene), "verify", "-", "-q");

        assertThat(piped.err() + named.err() + withScene.err()).isEmpty();
        assertThat(piped.text()).isEqualTo("-: good: all 1200 pixels are the same\n").isEqualTo(withScene.text());
        assertThat(named.text()).isEqualTo("/dev/stdin: good: all 1200 pixels are the same\n");
        assertThat(no.err()).isEqualTo("simpleray: <stdin>: is no PNG\n");
        assertThat(no.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
    }

    @Test
    void standardInputIsReadOnce() {
        assertEnds(ExitCode.USAGE, "", "simpleray verify: picture and scene cannot both be standard input (see simpleray verify --help)\n",
            "verify", "-", "--scene", "-");
    }
}
