package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/** A file that announces other numbers of objects or lights than follow is told the right ones. */
class RecountTest {
    private static final String SPHERE = "0  0 0 -3 1  1 1 1  1 1 1  0 0 0  2\n";
    private static final String LIGHT = "0  1 1 1  0 5 0\n";

    private static SceneFormatException refusal(String text) {
        return catchThrowableOfType(SceneFormatException.class,
            () -> SceneFile.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))));
    }

    private static String scene(int objects, String objectsThere, int lights, String lightsThere) {
        return objects + "\n" + objectsThere + "0.3 0.3 0.3\n" + lights + "\n" + lightsThere;
    }

    @ParameterizedTest
    @CsvSource({"1, 2", "2, 1", "3, 1", "1, 3", "5, 2", "2, 5"})
    void theRightNumberOfLightsIsTold(int announced, int there) {
        SceneFormatException e = refusal(scene(1, SPHERE, announced, LIGHT.repeat(there)));

        assertThat(e.problems()).extracting(Diagnostic::message)
            .containsExactly("expected the number of lights to be " + there + ", as many as follow, found '" + announced + "'");
        assertThat(e.problems().get(0).line()).isEqualTo(4);
    }

    @ParameterizedTest
    @CsvSource({"1, 2", "2, 1", "3, 1", "1, 3", "5, 2", "2, 5", "1, 0"})
    void theRightNumberOfObjectsIsTold(int announced, int there) {
        SceneFormatException e = refusal(scene(announced, SPHERE.repeat(there), 1, LIGHT));

        assertThat(e.problems()).extracting(Diagnostic::message)
            .containsExactly("expected the number of objects to be " + there + ", as many as follow, found '" + announced + "'");
        assertThat(e.problems().get(0).line()).isEqualTo(1);
    }

    @Test
    void bothMayBeWrong() {
        assertThat(refusal(scene(3, SPHERE, 2, LIGHT)).problems()).extracting(Diagnostic::message).containsExactly(
            "expected the number of objects to be 1, as many as follow, found '3'",
            "expected the number of lights to be 1, as many as follow, found '2'");
    }

    /** An ambient light of 0 0 0, the number of lights and a light read as a sphere that is cut off. */
    @Test
    void anAmbientLightThatLooksLikeASphereIsNotTakenForOne() {
        assertThat(refusal("2\n" + SPHERE + "0 0 0\n1\n" + LIGHT).problems()).extracting(Diagnostic::message)
            .containsExactly("expected the number of objects to be 1, as many as follow, found '2'");
    }

    @Test
    void settingsBehindTheLightsStayWhatTheyAre() {
        assertThat(refusal(scene(2, SPHERE, 1, LIGHT + "depth 3\n")).problems()).extracting(Diagnostic::message)
            .containsExactly("expected the number of objects to be 1, as many as follow, found '2'");
    }

    @Test
    void whatWouldBeWrongWithAnyNumbersIsToldAsItWasFound() {
        SceneFormatException e = refusal(scene(2, SPHERE, 1, "0  1 x 1  0 5 0\n"));

        assertThat(e.problems()).extracting(Diagnostic::message).containsExactly("expected object 2's type (" + Kinds.objects()
            + "; 2 objects announced), found '0.3' (an integer has only digits)");
    }

    @Test
    void aFileThatIsCutOffIsNotTakenForOneWithoutLights() {
        SceneFormatException e = refusal("2\n" + SPHERE + "0 0 0 -3");

        assertThat(e.problems()).extracting(Diagnostic::message).containsExactly("expected object 2's radius, found the end of the file");
    }
}
