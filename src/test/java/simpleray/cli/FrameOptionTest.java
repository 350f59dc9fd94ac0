package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Rendered;
import simpleray.scene.PictureScene;

/** {@code --frame} and {@code still}: one frame of a film. */
class FrameOptionTest {
    private static final String HEAD = "# a ball and a floor\n2\n0 0 0 0 0.5  1 0 0  0.5 0 0  0 0 0 0\n1 0 1 0 -1  0 0 1  0 0 0.5  0 0 0 0\n0.5 0.5 0.5\n1\n"
        + "0 1 1 1  2 2 2\nresolution 12 8\n";
    /** The ball goes to the right; at frame 2.5, between two frames, the camera looks at itself. */
    private static final String FILM = HEAD + "frames 5 25\ncurve linear\nkey 0 object 1 0 0 0\nkey 4 object 1 1 0 0\n"
        + "key 2 camera 0 0 3 0 0 0 50\nkey 3 camera 0 0 0 0 0 3 50\n";

    @TempDir
    private Path folder;
    private String film;

    @BeforeEach
    void writeFilm() throws IOException {
        film = Files.writeString(folder.resolve("film.scene"), FILM).toString();
        Files.writeString(folder.resolve("scene"), HEAD);
    }

    private Program.Result run(String line) {
        return InProcess.run(line.replace("FILM", film).replace("@", folder + "/").split(" "));
    }

    private byte[] done(String line, String output) throws IOException {
        Program.Result result = run(line);
        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        return output == null ? result.out() : Files.readAllBytes(folder.resolve(output));
    }

    private void assertUsage(String line, String message) {
        Program.Result result = run(line);

        assertThat(result.err()).isEqualTo("simpleray " + line.split(" ")[0] + ": " + message + " (see simpleray " + line.split(" ")[0] + " --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(result.out()).isEmpty();
    }

    @Test
    void aFramesStillIsTheSceneWithItsValues() throws IOException {
        assertThat(new String(done("still FILM --frame 1 -o @a.scene", "a.scene"), StandardCharsets.UTF_8)).isEqualTo("""
            # number of objects
            2
            0  0.25 0.0 0.0 0.5  1.0 0.0 0.0  0.5 0.0 0.0  0.0 0.0 0.0  0.0
            1  0.0 1.0 0.0 -1.0  0.0 0.0 1.0  0.0 0.0 0.5  0.0 0.0 0.0  0.0
            # ambient light
            0.5 0.5 0.5
            # number of lights
            1
            0  1.0 1.0 1.0  2.0 2.0 2.0
            camera 0.0 0.0 3.0 0.0 0.0 0.0 50.0
            resolution 12 8
            """);
        assertThat(done("still FILM --frame 1 -o -", null)).isEqualTo(Files.readAllBytes(folder.resolve("a.scene")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "1", "2.25", "4", "4.0", "0.1e1"})
    void theStillsPictureIsTheFramesToTheLastByteOfItsPixels(String frame) throws IOException {
        done("still FILM --frame " + frame + " -o @a.scene", "a.scene");
        byte[] still = done("render @a.scene -q -o @a.png", "a.png");
        byte[] picture = done("render FILM --frame " + frame + " -q -o @b.png", "b.png");

        assertThat(Rendered.untold(picture)).isEqualTo(Rendered.untold(still));
        assertThat(PictureScene.read(folder.resolve("b.png")).text().bytes()).isEqualTo(Files.readAllBytes(folder.resolve("a.scene")));
        assertThat(PictureScene.read(folder.resolve("b.png")).text().name()).isEqualTo("film.scene");
        assertThat(new String(done("verify @b.png", null), StandardCharsets.UTF_8)).endsWith(": good: all 96 pixels are the same\n");
        assertThat(new String(done("convert @b.png -", null), StandardCharsets.UTF_8))
            .isEqualTo(Files.readString(folder.resolve("a.scene")) + "depth 10\nsamples 1\n");
    }

    @Test
    void framesDifferAndWithoutTheOptionItIsTheFirst() throws IOException {
        byte[] first = done("render FILM -q -o @a.png", "a.png");

        assertThat(done("render FILM -q --frame 0 -o @a.png", "a.png")).isEqualTo(first);
        assertThat(done("render FILM -q --frame=0 -o @a.png", "a.png")).as("by picocli").isEqualTo(first);
        assertThat(done("render FILM -q --frame -0.0 -o @a.png", "a.png")).isEqualTo(first);
        assertThat(done("render FILM -q --frame 1 -o @a.png", "a.png")).isNotEqualTo(first);
        assertThat(done("still FILM -o -", null)).isEqualTo(done("still FILM -o - --frame 0", null)).isNotEqualTo(done("still FILM -o - --frame 1", null));
    }

    @Test
    void aFilmIsConvertedAndPrintedAsItIs() throws IOException {
        String film = FILM.substring(FILM.indexOf("resolution")).replace("key 0 object 1 0 0 0", "key 0.0 object 1 0.0 0.0 0.0")
            .replace("key 4 object 1 1 0 0", "key 4.0 object 1 1.0 0.0 0.0").replace("key 2 camera 0 0 3 0 0 0 50", "key 2.0 camera 0.0 0.0 3.0 0.0 0.0 0.0 50.0")
            .replace("key 3 camera 0 0 0 0 0 3 50", "key 3.0 camera 0.0 0.0 0.0 0.0 0.0 3.0 50.0").replace("frames 5 25", "frames 5 25.0");

        assertThat(new String(done("convert FILM -", null), StandardCharsets.UTF_8)).endsWith("2.0 2.0 2.0\n" + film);
        assertThat(new String(done("print FILM", null), StandardCharsets.UTF_8)).endsWith("[2.0,2.0,2.0]\n" + film);
    }

    @Test
    void allThatTakesAScenesPictureTakesAFrame() throws IOException {
        for (String line : List.of("explain FILM -q --pixel 6,4", "export FILM --pov -o -", "render FILM -q -o -", "still FILM -o -")) {
            List<String> made = new ArrayList<>();
            for (String frame : List.of("", " --frame 0", " --frame 1", " --frame 4")) {
                made.add(new String(done(line + frame, null), StandardCharsets.ISO_8859_1));
            }
            assertThat(made.get(1)).isEqualTo(made.get(0));
            assertThat(made.get(2)).as(line).isNotEqualTo(made.get(0));
            assertThat(made.get(3)).isNotEqualTo(made.get(2));
        }
        byte[] first = done("figures FILM -q -d @.", "film-stages.png");
        assertThat(done("figures FILM -q -d @. --frame 1", "film-stages.png")).isNotEqualTo(first);
        assertThat(done("figures FILM -q -d @. --frame 0", "film-stages.png")).isEqualTo(first);
    }

    @ParameterizedTest
    @CsvSource({"5", "4.0000001", "-1", "1e9"})
    void aFrameThatTheFilmDoesNotHaveIsAUsageErrorWithTheRange(String frame) {
        for (String line : List.of("render FILM -o @x.png", "still FILM -o @x.scene", "explain FILM --pixel 0,0", "figures FILM -d @.", "check FILM",
                "check FILM --errors json", "export FILM --pov -o @x.pov")) {
            assertUsage(line + " --frame " + frame, "--frame must be 0 to 4, the frames of " + film);
        }
        assertThat(folder.toFile().list()).containsExactlyInAnyOrder("film.scene", "scene");
    }

    @Test
    void aSceneThatIsNoFilmHasFrame0() throws IOException {
        assertThat(done("render @scene -q -o - --frame 0", null)).isEqualTo(done("render @scene -q -o -", null));
        assertThat(done("still @scene -o - --frame 0", null)).isEqualTo(done("convert @scene -", null)).isEqualTo(done("still @scene -o -", null));
        assertUsage("render @scene -o @x.png --frame 1", "--frame must be 0, the only frame of " + folder + "/scene");
        assertThat(InProcess.runWithInput(HEAD, "still", "-", "-o", "-", "--frame", "1").err())
            .isEqualTo("simpleray still: --frame must be 0, the only frame of <stdin> (see simpleray still --help)\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"first", "1,5", "NaN", "Infinity", "0x1"})
    void whatIsNoNumberIsAUsageError(String frame) {
        assertUsage("render FILM -o @x.png --frame " + frame, "Invalid value for option '--frame': expected a number such as 12 or 12.5, found '"
            + frame + "'");
    }

    @Test
    void aFrameBetweenTwoWholeOnesMayBeOneThatNoSceneMayHave() {
        String message = "simpleray: " + film + ": expected frame 2.5's camera with a look-at point other than the eye, found 0.0 0.0 1.5 0.0 0.0 1.5 50.0\n";
        for (String line : List.of("render FILM -o @x.png --frame 2.5", "still FILM --frame 2.5 -o @x.png", "check FILM --frame 2.5")) {
            Program.Result result = run(line);

            assertThat(result.err()).isEqualTo(message);
            assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        }
        assertThat(folder.resolve("x.png")).doesNotExist();
    }

    @Test
    void anOptionForTheCameraWinsOverItsKeys() throws IOException {
        byte[] asked = done("render FILM -q -o @a.png --cop 4 --frame 2", "a.png");

        assertThat(asked).isNotEqualTo(done("render FILM -q -o @a.png --frame 2", "a.png"));
        done("still FILM --frame 2 -o @a.scene", "a.scene");
        assertThat(Rendered.untold(done("render @a.scene -q -o @a.png --cop 4", "a.png"))).isEqualTo(Rendered.untold(asked));
    }

    @Test
    void aPictureIsVerifiedByItsFilmAndFrame() throws IOException {
        done("render FILM -q -o @a.png --frame 3", "a.png");

        assertThat(new String(done("verify @a.png --scene FILM --frame 3", null), StandardCharsets.UTF_8)).contains(": good: all 96 pixels");
        Program.Result other = run("verify @a.png --scene FILM --frame 1");
        assertThat(other.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(other.err()).startsWith("simpleray: " + film + ": is not the scene that " + folder + "/a.png was made of: its SHA-256 is ");
        assertUsage("verify @a.png --frame 3", "--frame must be 0, the only frame of " + folder + "/a.png");
    }

    @Test
    void whatIsKeptOfOneFrameIsNotTakenForAnother() throws IOException {
        byte[] first = done("render FILM -q -o @a.png --frame 1", "a.png");
        byte[] other = done("render FILM -q -o @a.png --frame 2.25", "a.png");

        assertThat(other).isNotEqualTo(first);
        assertThat(done("render FILM -q -o @a.png --frame 1", "a.png")).isEqualTo(first);
    }

    @Test
    void aStillInAnotherFolderNamesTheSameMeshes() throws IOException {
        Files.writeString(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Files.writeString(folder.resolve("mesh.scene"), "2\n4 \"a.obj\" 0 0 0 1  1 1 1 0 0 0 0 0 0 0\n4 \"a.obj\" 0 0 -1 1  1 1 1 0 0 0 0 0 0 0\n1 1 1\n0\n"
            + "resolution 8 8\nframes 2 25\nkey 1 object 1 -1 -1 0\n");
        Files.createDirectory(folder.resolve("sub"));
        Program.Result result = run("still @mesh.scene --frame 1 -o @sub/a.scene");

        assertThat(result.exitCode()).isZero();
        assertThat(result.err()).isEqualTo(folder + "/sub/a.scene: warning: names OBJ files outside its folder: --allow-outside allows them\n");
        assertThat(folder.resolve("sub/a.scene")).content().contains("4  \"../a.obj\" -1.0 -1.0 0.0 1.0", "4  \"../a.obj\" 0.0 0.0 -1.0 1.0");
        assertThat(Rendered.untold(done("render @sub/a.scene -q --allow-outside -o -", null))).isEqualTo(Rendered.untold(done("render @mesh.scene --frame 1 -q -o -",
            null)));
    }

    @Test
    void aStillIsNotWrittenOverItsFilm() {
        assertUsage("still FILM --frame 1 -o FILM", "the output " + film + " is the scene itself");
        assertThat(folder.resolve("film.scene")).hasContent(FILM);
    }

    @Test
    void checkTellsTheFramesAndLooksAtOneOrAll() throws IOException {
        assertThat(new String(run("check FILM").out(), StandardCharsets.UTF_8)).isEqualTo(film + ": good: 2 objects, 1 light, 5 frames\n");
        assertThat(new String(run("check @scene").out(), StandardCharsets.UTF_8)).isEqualTo(folder + "/scene: good: 2 objects, 1 light\n");
        Files.writeString(folder.resolve("b.scene"), HEAD + "frames 3 25\nkey 0 object 1 0 0 50\nkey 1 object 1 0 0 50\nkey 2 object 1 0 0 0\n");

        assertThat(run("check @b.scene").err()).isEmpty();
        assertThat(run("check @b.scene --frame 2").err()).isEmpty();
        assertThat(run("check @b.scene --frame 0").err()).isEqualTo(folder + "/b.scene:3:1: warning: object 1 was not seen by any of 18496 rays\n");
        assertThat(run("check @b.scene --frame 0 --errors json").text()).contains("object 1 was not seen by any of 18496 rays");
        assertThat(run("check @b.scene --errors json").text()).isEqualTo("[]\n");
    }
}
