package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.image.Checkpoint;
import simpleray.image.Picture;
import simpleray.image.PictureText;
import simpleray.image.Pictures;
import simpleray.image.png.PngReader;
import simpleray.image.png.PngWriter;
import simpleray.render.PictureIdentity;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.PictureScene;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;

/** Pictures of scenes without a background, in all that a command line makes of them. */
class TransparentPictureTest {
    /** A ball that fills the middle. */
    private static final String BALL = "1\n0 0 0 0 1  1 0 0  0.5 0 0  0.5 0.5 0.5 9\n0.5 0.5 0.5\n1\n0 1 1 1  2 2 2\nresolution 12 8\n"
        + "samples 2\n";
    private static final int WIDTH = 12;
    private static final int HEIGHT = 8;

    @TempDir
    Path folder;

    @BeforeEach
    void writeScenes() throws IOException {
        Files.writeString(folder.resolve("none.scene"), BALL + "background none\n");
        Files.writeString(folder.resolve("ball.scene"), BALL);
        Files.writeString(folder.resolve("film.scene"), BALL + "background none\nframes 2 10\nkey 0 object 1 0 0 0\nkey 1 object 1 1 0 0\n");
    }

    private Program.Result run(String line) {
        return InProcess.run(line.replace("@", folder + "/").split(" "));
    }

    private String good(String line) {
        Program.Result result = run(line);

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        return result.text();
    }

    private byte[] bytes(String name) throws IOException {
        return Files.readAllBytes(folder.resolve(name));
    }

    /** {@return the alpha of a pixel of a file} */
    private int alpha(String name, int x, int y) throws IOException {
        return ImageIO.read(folder.resolve(name).toFile()).getRGB(x, y) >>> 24;
    }

    @Test
    void theFileHasAlphaAndTheOptionIsAsTheKeyword() throws IOException {
        good("render @none.scene -q -o @none.png");
        good("render @ball.scene --background none -q -o @option.png");
        good("render @none.scene --background 0,0,0 -q -o @black.png");

        BufferedImage image = ImageIO.read(folder.resolve("none.png").toFile());
        assertThat(image.getColorModel().hasAlpha()).isTrue();
        assertThat(Pictures.decoded(bytes("option.png"))).isDeepEqualTo(Pictures.decoded(bytes("none.png")));
        assertThat(image.getRGB(0, 0)).isZero();
        assertThat(alpha("none.png", 6, 4)).isEqualTo(255);
        assertThat(ImageIO.read(folder.resolve("black.png").toFile()).getColorModel().hasAlpha()).isFalse();
        assertThat(Stream.of(0, 64, 128, 191, 255)).as("of 2 x 2 samples").containsAll(Arrays.stream(
            image.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH)).mapToObj(argb -> argb >>> 24).distinct().toList());
    }

    @Test
    void bytesDoNotDependOnThreadsOrAcceleration() throws IOException {
        good("render @none.scene -q -o @one.png --threads 1 --samples adaptive");
        good("render @none.scene -q -o @more.png --threads 3 --accel none --samples adaptive");

        assertThat(bytes("more.png")).isEqualTo(bytes("one.png"));
    }

    @Test
    void itIsVerifiedAndAChangeOfAlphaIsFound() throws IOException {
        good("render @none.scene -q -o @none.png");
        assertThat(good("verify @none.png -q")).endsWith(": good: all 96 pixels are the same\n");

        Picture changed = new Picture(WIDTH, HEIGHT, Picture.RGBA);
        try (PngReader rows = PngReader.open(folder.resolve("none.png").toString())) {
            for (int y = 0; y < HEIGHT; y++) {
                changed.setRow(y, Picture.light(rows.next()));
            }
        }
        changed.row(4)[4 * 6 + 3] = 0.5;
        assertDifferent(changed, "1 of 96 pixels, the first in row 5, column 7: ", ",128 in the file, ", ",255 rendered");
    }

    /** {@return what the picture tells} */
    private List<PictureText> told() throws IOException {
        PictureScene told = PictureScene.read(folder.resolve("none.png"));
        return PictureScene.texts(told.software(), String.join("\n", told.others()) + '\n' + told.settings().lines(), told.text());
    }

    private void assertDifferent(Picture changed, String... words) throws IOException {
        changed.tell(told());
        try (var out = Files.newOutputStream(folder.resolve("changed.png"))) {
            PngWriter.write(changed, out);
        }
        Program.Result result = run("verify @changed.png -q");
        assertThat(result.exitCode()).isEqualTo(ExitCode.DIFFERENT);
        assertThat(result.text()).contains(words);
    }

    @Test
    void aPictureThatHasLostItsAlphaIs65() throws IOException {
        good("render @none.scene -q -o @none.png");
        Picture opaque = Pictures.plain(WIDTH, HEIGHT, 0);
        opaque.tell(told());
        try (var out = Files.newOutputStream(folder.resolve("opaque.png"))) {
            PngWriter.write(opaque, out);
        }

        Program.Result result = run("verify @opaque.png -q");

        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(result.err()).isEqualTo("simpleray: " + folder.resolve("opaque.png") + ": has no alpha, and its scene has no background\n");
    }

    @Test
    void bandsAreMergedToTheSameFile() throws IOException {
        good("render @none.scene -q -o @none.png");
        for (int i = 1; i <= 3; i++) {
            good("render @none.scene -q --band " + i + "/3 -o @part" + i + ".png");
        }
        good("merge @part3.png @part1.png @part2.png -q -o @merged.png");

        assertThat(bytes("merged.png")).isEqualTo(bytes("none.png"));
    }

    @Test
    void keptRowsMakeTheSameFile() throws IOException {
        good("render @none.scene -q -o @none.png");
        Scene scene = SceneFile.read(folder.resolve("none.scene")).scene();
        RenderRequest request = new RenderRequest(new SceneSettings(), Stage.FINAL, false, 1);
        try (Checkpoint kept = Checkpoint.create(folder.resolve("again.png.part"), PictureIdentity.of(Main.version(), request, scene),
                4 * WIDTH, HEIGHT);
                PngReader rows = PngReader.open(folder.resolve("none.png").toString())) {
            for (int y = 0; y < 5; y++) {
                kept.put(y, rows.next(), 0);
            }
        }

        Program.Result result = run("render @none.scene -o @again.png --resume");

        assertThat(result.err()).contains("going on with 5 of 8 rows");
        assertThat(bytes("again.png")).isEqualTo(bytes("none.png"));
        Program.Result other = run("render @ball.scene -o @again.png");
        assertThat(other.exitCode()).isZero();
    }

    @Test
    void theRowsOfAnOpaquePictureAreRefused() throws IOException {
        Scene scene = SceneFile.read(folder.resolve("ball.scene")).scene();
        RenderRequest request = new RenderRequest(new SceneSettings(), Stage.FINAL, false, 1);
        Checkpoint.create(folder.resolve("a.png.part"), PictureIdentity.of(Main.version(), request, scene), 3 * WIDTH, HEIGHT).close();

        Program.Result result = run("render @ball.scene --background none -o @a.png --resume");

        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(result.err()).contains("holds rows of another picture: background");
    }

    @Test
    void theSceneIsPrintedAndConvertedWithTheKeyword() throws IOException {
        good("convert @none.scene @copy.scene");
        assertThat(Files.readString(folder.resolve("copy.scene"))).contains("\nbackground none\n");
        assertThat(good("print @none.scene")).contains("background none");
        good("render @none.scene -q -o @none.png");
        good("convert @none.png @carried.scene");
        assertThat(Files.readString(folder.resolve("carried.scene"))).contains("background none");
    }

    @Test
    void filmsAreTransparentWhereTheirFormatCanBe() throws IOException {
        good("animate @film.scene -q -o @f.%d.png");
        good("animate @film.scene -q -o @f.gif");
        good("animate @film.scene -q -o @f.apng");

        assertThat(alpha("f.0.png", 0, 0)).isZero();
        assertThat(alpha("f.gif", 0, 0)).isZero();
        assertThat(alpha("f.gif", 6, 4)).isEqualTo(255);
        assertThat(bytes("f.apng")[25]).as("colour type").isEqualTo((byte) 6);
    }

    @Test
    void aFilmByFfmpegIsBlackThere() throws IOException {
        assumeTrue(Arrays.stream(System.getenv("PATH").split(File.pathSeparator)).anyMatch(path -> new File(path, "ffmpeg").canExecute()),
            "no ffmpeg here");
        String black = BALL + "frames 2 10\nkey 0 object 1 0 0 0\nkey 1 object 1 1 0 0\n";
        Files.writeString(folder.resolve("black.scene"), black);
        good("animate @film.scene -q -o @f.mp4");
        good("animate @black.scene -q -o @black.mp4");

        assertThat(bytes("f.mp4")).isEqualTo(bytes("black.mp4"));
    }

    /** A figure's paper is white, and seen where its pictures are transparent. */
    @Test
    void figuresShowThePaper() throws IOException {
        good("figures @none.scene -q -d " + folder);

        BufferedImage sheet = ImageIO.read(folder.resolve("none-stages.png").toFile());
        assertThat(sheet.getColorModel().hasAlpha()).isFalse();
        int[] above = sheet.getRGB(0, 12, sheet.getWidth(), 1, null, 0, sheet.getWidth());
        int[] ball = sheet.getRGB(0, 12 + 4, sheet.getWidth(), 1, null, 0, sheet.getWidth());
        assertThat(Arrays.stream(above)).as("the pictures' first row").containsOnly(0xFFFFFFFF);
        assertThat(Arrays.stream(ball).filter(rgb -> rgb != 0xFFFFFFFF).count()).as("pixels of three balls").isBetween(9L, 36L);
    }

    @Test
    void thePixelsStorySaysTransparent() {
        assertThat(good("explain @none.scene --pixel 0,0")).contains("levels 0 0 0, transparent\n").doesNotContain("background");
        assertThat(good("explain @none.scene --pixel 0,0 --format json")).contains("\"levels\":[0,0,0],\"alpha\":0.0,\"mean\":true");
        assertThat(good("explain @none.scene --pixel 6,4 --format json")).contains("\"alpha\":1.0,");
        assertThat(good("explain @ball.scene --pixel 0,0 --format json")).doesNotContain("alpha");
    }

    @Test
    void povRayIsToldToMakeAlpha() throws IOException {
        good("export @none.scene --pov -o @none.pov --samples 1");
        good("export @ball.scene --pov -o @ball.pov --samples 1");

        assertThat(Files.readString(folder.resolve("none.pov"))).contains(" File_Gamma=1.0 +UA\n", "background { rgb <0.0,0.0,0.0> transmit 1 }\n");
        assertThat(Files.readString(folder.resolve("ball.pov"))).contains(" File_Gamma=1.0\n", "background { rgb <0.0,0.0,0.0> }\n");
    }
}
