package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Wrong usage is one line that says what was expected, and exit code 2. */
class CommandsUsageTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"rendr, render", "exprot, export", "veiw, view", "verfy, verify"})
    void aMisspeltCommandIsTold(String word, String meant) {
        Program.Result result = InProcess.run(word, "a.scene");

        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(result.err()).isEqualTo("simpleray: unknown command '" + word + "': did you mean " + meant + "? (see simpleray --help)\n");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--size 0x5 | Invalid value for option '--size': expected WxH such as 640x480, 1 to 65535 each, found '0x5'",
        "--size 640 | Invalid value for option '--size': expected WxH such as 640x480, 1 to 65535 each, found '640'",
        "--size 5x65536 | Invalid value for option '--size': expected WxH such as 640x480, 1 to 65535 each, found '5x65536'",
        "--size 5x5x5 | Invalid value for option '--size': expected WxH such as 640x480, 1 to 65535 each, found '5x5x5'",
        "--stage first | Invalid value for option '--stage': "
            + "expected one of [original, lighting, final, ambient, diffuse, specular, normals, depth, objects, bounces, "
            + "shadows], found 'first'",
        "--depth many | Invalid value for option '--depth': 'many' is not an int",
        "--depth -1 | the depth must be 0 to 1000, and is -1",
        "--depth 1001 | the depth must be 0 to 1000, and is 1001",
        "--cop 0 | the centre of projection must be above 0, and is 0.0",
        "--cop NaN | Invalid value for option '--cop': expected a number, found 'NaN'",
        "--window 1,2,3 | Invalid value for option '--window': expected four numbers such as -2,2,-2,2, found '1,2,3'",
        "--window 1,2,3,x | Invalid value for option '--window': expected four numbers such as -2,2,-2,2, found '1,2,3,x'",
        "--window 2,-2,-2,2 | the window must have xmin < xmax and ymin < ymax, and is 2.0,-2.0,-2.0,2.0",
        "--samples 0 | --samples must be 1 to 16 or adaptive, and is '0'",
        "--samples 17 | --samples must be 1 to 16 or adaptive, and is '17'",
        "--samples 2.5 | --samples must be 1 to 16 or adaptive, and is '2.5'",
        "--samples many | --samples must be 1 to 16 or adaptive, and is 'many'",
        "--camera 1,2,3 | Invalid value for option '--camera': expected seven numbers such as 3,2,5,0,0,0,40, found '1,2,3'",
        "--camera 1,2,3,0,0,NaN,40 | Invalid value for option '--camera': "
            + "expected seven numbers such as 3,2,5,0,0,0,40, found '1,2,3,0,0,NaN,40'",
        "--camera 1,2,3,0,0,0,180 | Invalid value for option '--camera': "
            + "expected a field of view above 0 and below 180 degrees, found '1,2,3,0,0,0,180'",
        "--camera 1,2,3,1,2,3,40 | Invalid value for option '--camera': "
            + "expected a look-at point other than the eye, found '1,2,3,1,2,3,40'",
        "--camera 1,2,3,0,0,0,40 --cop 2 | --camera takes the place of --cop and --window: give one or the other",
        "--window -1,1,-1,1 --camera 1,2,3,0,0,0,40 | --camera takes the place of --cop and --window: give one or the other",
        "--background 1,1 | Invalid value for option '--background': expected none, or three numbers such as 0.1,0.2,0.4, found '1,1'",
        "--background 1,x,1 | Invalid value for option '--background': expected none, or three numbers such as 0.1,0.2,0.4, found '1,x,1'",
        "--background 1,-1,1 | Invalid value for option '--background': expected numbers of 0 or more, found '1,-1,1'",
        "--threads 0 | --threads must be 1 to 1024, and is 0",
        "--threads 1025 | --threads must be 1 to 1024, and is 1025",
        "--progress much | Invalid value for option '--progress': expected one of [auto, bar, plain, openjd, none], found 'much'",
        "--colour red | Unknown options: '--colour', 'red'"})
    void anOptionThatMakesNoSenseIsNamed(String options, String message) throws IOException {
        Path scene = Files.writeString(folder.resolve("grey.scene"), SmallScenes.GREY);
        Path out = folder.resolve("grey.png");
        List<String> args = new ArrayList<>(List.of("render", scene.toString(), "-o", out.toString()));
        args.addAll(Arrays.asList(options.split(" ")));

        assertUsage("render", message, args.toArray(new String[0]));

        assertThat(out).doesNotExist();
    }

    @Test
    void aCommandThatLacksSomethingSaysWhat() {
        assertUsage("render", "Missing required options and parameters: '--output=OUT.png', 'SCENE'", "render");
        assertUsage("render", "Missing required option: '--output=OUT.png'", "render", "a.scene");
        assertUsage("print", "Missing required parameter: 'SCENE'", "print");
        assertUsage("check", "Missing required parameter: 'SCENE'", "check");
        assertUsage("convert", "Missing required parameters: 'IN', 'OUT'", "convert");
        assertUsage("convert", "Missing required parameter: 'OUT'", "convert", "a.scene");
    }

    @Test
    void oneSceneAtATimeIsRendered() {
        assertUsage("render", "Unmatched argument at index 2: 'b.scene'", "render", "a.scene", "b.scene", "-o", "a.png");
    }

    @Test
    void theSceneItselfIsNotOverwritten() throws IOException {
        Path scene = Files.writeString(folder.resolve("grey.png"), SmallScenes.GREY);
        Path same = folder.resolve("../" + folder.getFileName() + "/grey.png");

        assertUsage("render", "the output " + same + " is the scene itself", "render", scene.toString(), "-o", same.toString());

        assertThat(scene).hasContent(SmallScenes.GREY);
    }

    @ParameterizedTest
    @CsvSource({"jpg", "JPEG", "gif", "bmp", "ppm", "webp", "tiff"})
    void anOutputThatIsCalledLikeAnotherFormatIsRefused(String ending) throws IOException {
        Path scene = Files.writeString(folder.resolve("grey.scene"), SmallScenes.GREY);
        String out = folder.resolve("grey." + ending).toString();

        assertUsage("render", "pictures are written as PNG only: call the output " + out + ".png?", "render", scene.toString(), "-o", out);

        assertThat(Path.of(out)).doesNotExist();
    }

    @Test
    void whatIsNoCommandIsTakenForASceneToView() {
        assertUsage("view", "Unknown option: '--colour'", "a.scene", "--colour");
    }

    private static void assertUsage(String command, String message, String... args) {
        Program.Result result = InProcess.run(args);

        assertThat(result.err()).isEqualTo("simpleray " + command + ": " + message + " (see simpleray " + command + " --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(result.out()).isEmpty();
    }
}
