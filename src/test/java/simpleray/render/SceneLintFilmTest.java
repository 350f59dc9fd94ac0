package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.scene.SceneFile;
import simpleray.text.Diagnostic;

/** Warnings about a film: keys that do nothing, and what no frame shows. */
class SceneLintFilmTest {
    private static final String MATT = "  0.3 0.3 0.3  0.2 0.2 0.2  0 0 0  1\n";
    /** A wall, and a ball behind the eye on line 3; a lamp on line 6, and a directional light. */
    private static final String SCENE = "2\n1  0 0 1  -3" + MATT + "0  0 0 50  0.5" + MATT + "0.5 0.5 0.5\n2\n0  0.5 0.5 0.5  1 1 2\n1  0.2 0.2 0.2  0 -1 -1\n";
    private static final String IN = "key 0 object 2 0 0 -50\n";

    private static List<String> warnings(String lines) throws IOException {
        return SceneLint.all(SceneFile.parse(SCENE + lines), "a").stream().map(Diagnostic::toString).toList();
    }

    @Test
    void anObjectThatComesIntoThePictureIsSeen() throws IOException {
        assertThat(warnings("")).containsExactly("a:3:1: warning: object 2 was not seen by any of 18496 rays");
        assertThat(warnings("frames 9 25\nkey 0 object 2 0 0 0\nkey 8 object 2 0 0 -50")).isEmpty();
        assertThat(warnings("frames 2 25\nkey 0 object 2 0 0 0\nkey 1 object 2 0 0 -50")).isEmpty();
        assertThat(warnings("frames 1 25\nkey 0 object 2 0 0 -50")).isEmpty();
    }

    @Test
    void anObjectThatNoFrameShowsIsNamedWithTheFrames() throws IOException {
        String keys = "key 0 object 2 0 0 0\nkey 1 object 2 0 0 5\n";

        assertThat(warnings("frames 2 25\n" + keys)).containsExactly("a:3:1: warning: object 2 was not seen by any of 22592 rays in all 2 frames");
        assertThat(warnings("frames 40 25\n" + keys)).containsExactly("a:3:1: warning: object 2 was not seen by any of 178240 rays in all 40 frames");
        assertThat(warnings("frames 41 25\n" + keys)).containsExactly("a:3:1: warning: object 2 was not seen by any of 178240 rays in 40 of 41 frames");
        assertThat(warnings("frames 1000000 25\n" + keys))
            .containsExactly("a:3:1: warning: object 2 was not seen by any of 182336 rays in 41 of 1000000 frames");
    }

    @Test
    void unaskedFewerFramesAreTracedAndKeysAreNotLookedAt() throws IOException {
        SceneFile film = SceneFile.parse(SCENE + "frames 9 25\nkey 0 object 2 0 0 0\nkey 1 object 2 0 0 0\nkey 3 object 1 0 0 0\n");

        assertThat(SceneLint.striking(film, "a").stream().map(Diagnostic::toString))
            .containsExactly("a:3:1: warning: object 2 was not seen by any of 38976 rays in 6 of 9 frames");
        assertThat(SceneLint.all(film, "a")).hasSize(3);
    }

    /** Of 1001 frames 487 and 513 are among the 40; the ball flies through the picture between, and comes at 501 nearest to the middle. */
    @Test
    void theFramesAtAnObjectsKeysAndHalfWayBetweenThemAreLookedAt() throws IOException {
        String film = "frames 1001 25\ncurve linear\n";

        assertThat(warnings(film + "key 500 object 2 0 0 0\nkey 501 object 2 0 0 -50\nkey 502 object 2 0 0 0")).isEmpty();
        assertThat(warnings(film + "key 490 object 2 -40 0 -50\nkey 512 object 2 40 0 -50")).isEmpty();
        assertThat(warnings(film + "key 490 object 2 -40 0 -50\nkey 491 object 2 -40 0 -50\nkey 511 object 2 -40 0 -50")).contains(
            "a:3:1: warning: object 2 was not seen by any of 194624 rays in 44 of 1001 frames");
    }

    /** In a long film the first frame, the last one and 38 between are looked at. */
    @Test
    void theEndOfALongFilmIsLookedAt() throws IOException {
        assertThat(warnings("frames 1000000 25\ncurve linear\nkey 999998 object 2 0 0 0\nkey 999999 object 2 0 0 -50")).isEmpty();
    }

    @Test
    void aLightThatReachesSomethingLaterIsNotNamed() throws IOException {
        String behind = SCENE.replace("1 1 2", "1 1 -9");
        SceneFile film = SceneFile.parse(behind + "frames 3 25\n" + IN + "key 0 light 1 0 0 0\nkey 2 light 1 0 0 11");
        SceneFile dark = SceneFile.parse(SCENE.replace("0.5 0.5 0.5  1 1 2", "0 0 0  1 1 2") + "frames 3 25\n" + IN
            + "key 0 colour 1 0 0 0\nkey 2 colour 1 0.5 0.5 0.5");
        SceneFile black = SceneFile.parse(SCENE.replace("0.5 0.5 0.5  1 1 2", "0 0 0  1 1 2") + "frames 3 25\n" + IN);

        assertThat(SceneLint.all(film, "a")).isEmpty();
        assertThat(SceneLint.all(dark, "a")).isEmpty();
        assertThat(SceneLint.all(black, "a").stream().map(Diagnostic::toString))
            .containsExactly("a:6:1: warning: light 1 (line 6) lights nothing that is seen in all 3 frames");
    }

    @Test
    void theOtherWarningsAreAboutTheFirstFrame() throws IOException {
        String bright = SCENE.replace("0.5 0.5 0.5  1 1 2", "0.5 0.5 0.5  1 1 2");

        assertThat(SceneLint.all(SceneFile.parse(bright + "frames 2 25\nkey 0 object 2 0 0 0\nkey 1 object 2 0 0 -50\nkey 0 colour 1 9 9 9\n"
            + "key 1 colour 1 0 0 0"), "a").stream().map(Diagnostic::message)).singleElement().asString()
            .startsWith("the picture is clipped where it is brighter than 1: ").contains(" of 18496 rays saw");
        assertThat(SceneLint.all(SceneFile.parse(bright + "frames 2 25\nkey 0 object 2 0 0 0\nkey 1 object 2 0 0 -50\nkey 0 colour 1 0 0 0\n"
            + "key 1 colour 1 9 9 9"), "a")).isEmpty();
        assertThat(SceneLint.all(SceneFile.parse(bright + "frames 2 25\nkey 0 object 2 0 0 -48\nkey 1 object 2 0 0 -50"), "a").stream()
            .map(Diagnostic::message)).contains("object 2 is around the eye, which sees it from inside");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"key 3 object 1 0 0 0 | the key of object 1 does nothing: it stays where the file puts it",
        "key 3 object 1 0 0 0, key 0 object 1 0 -0.0 0 | the 2 keys of object 1 do nothing: it stays where the file puts it",
        "key 1 light 1 0 0 0 | the key of light 1 does nothing: it stays where the file puts it",
        "key 1 colour 1 0.5 0.5 0.5, key 4 colour 1 0.5 0.5 0.5 | the 2 keys of colour 1 do nothing: it is the light's own",
        "key 1 camera 0 0 2 0 0 0 90, key 4 camera 0 0 2 0 0 0 90 | the 2 keys of camera do nothing: it is the file's camera",
        "key 3 light 1 0 1 0, key 4 light 1 0 1 0 | ", "key 3 object 1 0 0 0.1 | ", "key 1 colour 1 0.5 0.5 0.4 | ", "key 1 camera 0 0 2 0 0 0 80 | "})
    void keysThatLeaveAThingAsInTheFileDoNothing(String keys, String message) throws IOException {
        String camera = "camera 0 0 2 0 0 0 90\nframes 5 25\n" + IN;
        List<String> told = warnings(camera + keys.replace(", ", "\n"));

        if (message != null) {
            assertThat(told).containsExactly("a:11:1: warning: " + message);
        } else {
            assertThat(told).noneMatch(text -> text.contains("do nothing") || text.contains("does nothing: it"));
        }
    }

    @Test
    void withoutACameraInTheFileItsKeysDoSomething() throws IOException {
        assertThat(warnings("frames 5 25\n" + IN + "key 1 camera 0 0 2 0 0 0 90")).isEmpty();
    }

    @Test
    void aKeyThatIsWhereItsNeighboursPutItDoesNothing() throws IOException {
        assertThat(warnings("frames 9 25\ncurve linear\n" + IN + "key 8 object 2 4 0 -50\nkey 4 object 2 2 0 -50\n"))
            .containsExactly("a:12:1: warning: the key of object 2 for frame 4 does nothing: without it the film is the same");
        assertThat(warnings("frames 9 25\n" + IN + "key 8 object 2 4 0 -50\nkey 4.5 object 2 2 0 -50\n")).isEmpty();
        assertThat(warnings("frames 9 25\n" + IN + "key 4.5 object 2 0 0 -50\n"))
            .containsExactly("a:10:1: warning: the key of object 2 for frame 4.5 does nothing: without it the film is the same");
    }

    @Test
    void ofManyKeysThatDoNothingTheFirstTenAreTold() throws IOException {
        String ten = IntStream.range(0, 10).mapToObj(i -> "key " + (i + 1) + " object 2 0 0 -50\n").collect(Collectors.joining());
        String told = "key of object 2 for frame ";

        assertThat(warnings("frames 20 25\n" + IN + ten)).hasSize(10).last().asString().contains(told + "10 does nothing");
        assertThat(warnings("frames 20 25\n" + IN + ten + "key 11 object 2 0 0 -50\nkey 12.5 object 2 0 0 -50")).hasSize(11).last()
            .isEqualTo("a:20:1: warning: 2 more keys do nothing");
    }
}
