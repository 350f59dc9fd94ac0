package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.scene.SceneFile;
import simpleray.text.Diagnostic;

/** Warnings about a scene, each with the line of the object or light that causes it. */
class SceneLintTest {
    private static final String MATT = "  0.5 0.5 0.5  0.4 0.4 0.4  0 0 0  1\n";
    private static final String WALL = "1  0 0 1  -3" + MATT;
    private static final String BALL = "0  0 0 -1  0.5" + MATT;

    /** {@return the warnings about objects, each with a line, from line 2 on, and lights, each with a line} */
    private static List<String> warnings(List<String> objects, String ambient, String... lights) throws IOException {
        String text = objects.size() + "\n" + String.join("", objects) + ambient + "\n" + lights.length + "\n" + String.join("\n", lights);
        return warnings(text);
    }

    private static List<String> warnings(String text) throws IOException {
        SceneFile file = SceneFile.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
        return SceneLint.all(file, "a").stream().map(Diagnostic::toString).toList();
    }

    @Test
    void ofSeveralObjectsInTheWayTheOneThatBlocksMostIsNamed() throws IOException {
        String roof = "1  0 1 0  1.5  0 0 0  0 0 0  0 0 0  1\n";
        String ball = "0  0 8 1  0.5  0 0 0  0 0 0  0 0 0  1\n";

        assertThat(warnings(List.of(WALL, roof, ball), "0.5 0.5 0.5", "0  0.5 0.5 0.5  0 9 2")).anyMatch(
            text -> text.endsWith("light 1 (line 7) lights nothing that is seen: object 2 (plane, line 3) is in the way"));
    }

    @Test
    void aSceneWithoutMistakesHasNoWarning() throws IOException {
        assertThat(warnings(List.of(WALL, BALL), "0.5 0.5 0.5", "0  0.5 0.5 0.5  1 1 2", "1  0.2 0.2 0.2  0 -1 -1")).isEmpty();
    }

    @Test
    void theThesissSecondLightReachesNothing() throws IOException {
        SceneFile thesis = SceneFile.read(Project.scene("thesis"));

        assertThat(SceneLint.all(thesis, "thesis.scene")).extracting(Diagnostic::toString)
            .containsExactly("thesis.scene:55:1: warning: "
                + "light 2 (line 55) lights nothing that is seen: object 4 (plane, line 19) is in the way");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"1  1 1 1  0 0 1 | light 2 (line 6) lights nothing that is seen: all of that is turned away from it",
        "0  1 1 1  0 0 -4 | light 2 (line 6) lights nothing that is seen: all of that is turned away from it",
        "2  1 1 1  -1 0 -4  2 0 0  0 1 -3  2 | light 2 (line 6) lights nothing that is seen: all of that is turned away from it",
        "2  0 0 0  0 0 2  1 0 0  0 1 0  2 | light 2 is black",
        "0  0 0 0  1 1 2 | light 2 is black"})
    void aLightBehindTheWallReachesNothing(String light, String message) throws IOException {
        assertThat(warnings(List.of(WALL), "0.5 0.5 0.5", "0  0.5 0.5 0.5  1 1 2", light)).containsExactly("a:6:1: warning: " + message);
    }

    @Test
    void aLightBehindGlassReachesWhatItColours() throws IOException {
        String glass = "1  0 1 0  1.5  0 0 0  0 0 0  0 0 0  1  transmit 0.5 0 0  1\n";
        String wood = "1  0 1 0  1.5  0 0 0  0 0 0  0 0 0  1\n";

        assertThat(warnings(List.of(WALL, glass), "0.5 0.5 0.5", "0  0.5 0.5 0.5  0 9 2")).isEmpty();
        assertThat(warnings(List.of(WALL, wood), "0.5 0.5 0.5", "0  0.5 0.5 0.5  0 9 2"))
            .containsExactly("a:6:1: warning: light 1 (line 6) lights nothing that is seen: object 2 (plane, line 3) is in the way");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1  0 1 0  1.9", "1  1 2 0  4.1", "3  0.3 1.9 -1  0.3 9 -1  0.5", "0  0.3 2.9 -1  1"})
    void aLightInASurfaceReachesWhatItShinesOn(String shape) throws IOException {
        assertThat(warnings(List.of(WALL, shape + MATT), "0.5 0.5 0.5", "0  0.5 0.5 0.5  0.3 1.9 -1")).noneMatch(text -> text.contains("lights nothing"));
    }

    @Test
    void aLightMayReachWhatIsSeenInAMirrorAlone() throws IOException {
        String mirror = "1  0 0 1  -3  0 0 0  0 0 0  0.9 0.9 0.9  5\n";
        String behind = "1  0 0 -1  -9  0.5 0.5 0.5  0.4 0.4 0.4  0 0 0  1\n";

        assertThat(warnings(List.of(mirror, behind), "0.5 0.5 0.5", "0  0.5 0.5 0.5  0 0 3")).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"0  0 0 9  1", "0  90 0 -1  0.5", "0  0 0 -9  1", "0  0 0 -1  0.1", "1  0 0 1  20", "2  0 0 -5  1 0 -5  0 1 -5",
        "3  0 0 -5  1 0 -5  0.2"})
    void anObjectThatNoRayHitsIsNotSeen(String object) throws IOException {
        assertThat(warnings(List.of(WALL, object + MATT, BALL), "0.5 0.5 0.5"))
            .containsExactly("a:3:1: warning: object 2 was not seen by any of 18496 rays");
    }

    @Test
    void ofManyUnseenObjectsOnlyTheFirstIsNamed() throws IOException {
        List<String> objects = new ArrayList<>(Collections.nCopies(12, "0  0 0 -9  1" + MATT));
        objects.set(0, WALL);

        assertThat(warnings(objects, "0.5 0.5 0.5"))
            .containsExactly("a:3:1: warning: object 2 and 10 others were not seen by any of 18496 rays");
    }

    @ParameterizedTest
    @ValueSource(strings = {"0  0 0 2  0.5", "0  0.4 0 2  0.5", "3  0 -1 2  0 1 2  0.3"})
    void anObjectAroundTheEyeHasAWarning(String object) throws IOException {
        assertThat(warnings(List.of(object + MATT), "0.5 0.5 0.5"))
            .containsExactly("a:2:1: warning: object 1 is around the eye, which sees it from inside");
    }

    @ParameterizedTest
    @ValueSource(strings = {"0  0.6 0 2  0.5", "3  0 -1 1.6  0 1 1.6  0.3", "1  0 0 1  -3", "0  0 0 0  1.999"})
    void anObjectBesideTheEyeHasNoWarning(String object) throws IOException {
        assertThat(warnings(List.of(WALL, object + MATT), "0.5 0.5 0.5")).noneMatch(warning -> warning.contains("around"));
    }

    @Test
    void parallelRaysStartRoundTheEye() throws IOException {
        assertThat(warnings("1\n" + BALL + "1 1 1\n0\nparallel 0 0 -1.2  0 0 0  0.1"))
            .containsExactly("a:2:1: warning: object 1 is around the eye, which sees it from inside");
        assertThat(warnings("1\n" + BALL + "1 1 1\n0\nparallel 0 0 5  0 0 0  4")).isEmpty();
    }

    @Test
    void theCameraOfTheFileIsUsed() throws IOException {
        assertThat(warnings("1\n" + BALL + "1 1 1\n0\ncop 0.25\nwindow -9 9 -9 9")).isEmpty();
        assertThat(warnings("1\n" + BALL + "1 1 1\n0\ncamera 0 0 -1.2  0 0 0  40"))
            .containsExactly("a:2:1: warning: object 1 is around the eye, which sees it from inside");
    }

    @Test
    void coloursAboveWhiteAreClipped() throws IOException {
        String bright = "1  0 0 1  -3  1 0.5 0  0 0 0  0 0 0  1\n";

        assertThat(warnings(List.of(BALL, bright), "1 1 1")).isEmpty();
        assertThat(warnings(List.of(BALL, bright), "1.0019 1 1")).as("still level 255").isEmpty();
        assertThat(warnings(List.of(bright), "1.5 1 1")).containsExactly(
            "a:2:1: warning: the picture is clipped where it is brighter than 1: "
            + "4096 of 4096 rays saw such colours, the brightest 1.50 0.50 0.00 on object 1 (column 2, row 2)");
    }

    @Test
    void unaskedWarningsNameBrightColoursOnlyIfThereAreMany() throws IOException {
        String spot = "2\n" + WALL + "0  0 0 -2  0.05  2 2 2  0 0 0  0 0 0  1\n0.5 0.5 0.5\n0\nresolution 100 100\n";
        SceneFile little = SceneFile.read(new ByteArrayInputStream(spot.replace("2 2 2", "3 3 3").getBytes(StandardCharsets.UTF_8)));
        SceneFile much = SceneFile.read(new ByteArrayInputStream(spot.replace("2 2 2", "3 3 3").replace("0.05", "1")
            .getBytes(StandardCharsets.UTF_8)));

        assertThat(SceneLint.all(little, "a")).singleElement().extracting(Diagnostic::line).isEqualTo(3);
        assertThat(SceneLint.striking(little, "a")).isEmpty();
        assertThat(SceneLint.striking(much, "a")).singleElement().extracting(Diagnostic::line).isEqualTo(3);
    }

    @Test
    void anEmptySceneHasNoWarning() throws IOException {
        assertThat(warnings("0\n1 1 1\n1\n0  1 1 1  0 0 0")).isEmpty();
    }
}
