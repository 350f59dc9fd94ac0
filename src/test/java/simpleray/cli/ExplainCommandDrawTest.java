package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code explain --draw}: a pixel's rays in the scene. */
class ExplainCommandDrawTest {
    private static final String BALL = "1\n0 0 0 -2 1  0.5 1 0.25  1 1 1  0 0 0  1\n1 1 1\n1\n0  1 1 1  4 4 4\n";

    @TempDir
    Path folder;
    private String scene;
    private String drawing;

    @BeforeEach
    void write() throws IOException {
        scene = Files.writeString(folder.resolve("ball.scene"), BALL).toString();
        drawing = folder.resolve("rays.png").toString();
    }

    @Test
    void theDrawingIsWrittenBesideTheStory() throws IOException {
        Program.Result result = InProcess.run("explain", scene, "--pixel", "100,100", "--draw", drawing, "--draw-size", "120x90");

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        assertThat(result.text()).startsWith("pixel 100,100 of 200x200");
        assertThat(ImageIO.read(Path.of(drawing).toFile()).getWidth()).isEqualTo(120);
        assertThat(ImageIO.read(Path.of(drawing).toFile()).getHeight()).isEqualTo(90);
        assertThat(InProcess.run("verify", drawing).err()).contains("is a sheet of several pictures, 'rays'");
    }

    @Test
    void itIsTheSameEachTimeAndAnotherFromAnotherEye() throws IOException {
        byte[] first = draw();
        assertThat(draw()).isEqualTo(first);
        assertThat(draw("--from", "9,1,-2")).isNotEqualTo(first);
        assertThat(draw("--vectors")).isNotEqualTo(first);
    }

    private byte[] draw(String... more) throws IOException {
        String[] args = {"explain", scene, "--pixel", "100,100", "--draw", drawing, "--draw-size", "120x90", "-q"};
        String[] all = Stream.of(args, more).flatMap(Arrays::stream).toArray(String[]::new);
        assertThat(InProcess.run(all).exitCode()).isZero();
        return Files.readAllBytes(Path.of(drawing));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--from 1,2,3                                     | --from, --draw-size and --vectors belong to --draw OUT.png",
        "--vectors                                        | --from, --draw-size and --vectors belong to --draw OUT.png",
        "--draw rays.gif                                  | pictures are written as PNG only: call the output rays.gif.png?",
        "--draw -                                         | the drawing and the story cannot both go to standard output",
        "--draw /dev/stdout                               | the drawing and the story cannot both go to standard output",
        "--draw rays.png --from 1,2                       | expected three numbers such as 4,2.5,-1, found '1,2'",
        "--draw rays.png --from 1,2,1e101                 | expected three numbers such as 4,2.5,-1, found '1,2,1e101'",
        "--draw rays.png --draw-size 0x9                  | expected WxH such as 640x480, 1 to 65535 each, found '0x9'"})
    void wrongUsageIsTold(String options, String message) {
        String[] words = ("explain|" + scene + "|--pixel|1,1|" + options.trim().replace(' ', '|')).split("\\|");
        Program.Result result = InProcess.run(words);

        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(result.err()).contains(message);
        assertThat(folder.resolve("rays.png")).doesNotExist();
    }

    @Test
    void theSceneIsNotWrittenOver() throws IOException {
        assertThat(InProcess.run("explain", scene, "--pixel", "1,1", "--draw", scene).exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(Files.readString(Path.of(scene))).isEqualTo(BALL);
    }
}
