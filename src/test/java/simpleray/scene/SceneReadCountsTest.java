package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.text.Diagnostic;
import simpleray.text.SceneReader;

/** Counts and codes that do not fit what follows, and what may stand around a scene. */
class SceneReadCountsTest {
    private static final String SPHERE = "0 0 0 0 1 1 1 1 1 1 1 0 0 0 2\n";
    private static final String AMBIENT = "0.3 0.3 0.3\n";
    private static final String LIGHT = "0 1 1 1 0 5 0\n";

    @Test
    void tooFewObjectsAreNoticedWhereATypeShouldStand() {
        // the ambient light's first number is taken for the type of the missing object
        assertThatThrownBy(() -> read("2\n" + SPHERE + AMBIENT + "0")).hasMessage("""
            <stdin>:3:1: error: expected object 2's type (%s; 2 objects announced), found '0.3' (an integer has only digits)
            0.3 0.3 0.3
            ^""".formatted(Kinds.objects()));
    }

    @Test
    void tooManyObjectsAreNoticedAfterTheAmbientLight() {
        // the second object begins 0 0 0, which passes for the ambient light; 0 lights; and then its radius is too much
        assertThatThrownBy(() -> read("1\n" + SPHERE + SPHERE + AMBIENT + "0")).hasMessage("""
            <stdin>:3:9: error: expected the end of the scene (after 1 object and 0 lights), found '1'
            0 0 0 0 1 1 1 1 1 1 1 0 0 0 2
                    ^""");
    }

    @Test
    void anAmbientLightThatIsLongerIsNoticedAtTheNumberOfLights() {
        assertThatThrownBy(() -> read("1\n" + SPHERE + "0 0 0 0.5\n0")).hasMessage("""
            <stdin>:3:7: error: expected the number of lights (after 1 object and the ambient light), found '0.5' (an integer has only digits)
            0 0 0 0.5
                  ^""");
    }

    @Test
    void tooFewLightsAreNoticedAtTheEnd() {
        assertThatThrownBy(() -> read("0\n" + AMBIENT + "2\n" + LIGHT)).hasMessage("""
            <stdin>:5:1: error: expected light 2's type (%s; 2 lights announced), \
            found the end of the file

            ^""".formatted(Kinds.lights()));
    }

    @Test
    void whatFollowsTheLastLightIsAnError() {
        assertThatThrownBy(() -> read("0\n" + AMBIENT + "1\n" + LIGHT + LIGHT)).hasMessage("""
            <stdin>:5:1: error: expected the end of the scene (after 0 objects and 1 light), found '0'
            0 1 1 1 0 5 0
            ^""");
    }

    @ParameterizedTest
    @CsvSource({"-1, ''", "98, ''", "0.0, (an integer has only digits)", "1e0, (an integer has only digits)",
        "2147483648, (more than 2147483647)"})
    void anUnknownTypeOfObjectIsAnError(String type, String why) {
        assertThatThrownBy(() -> read("1\n" + type + " 0 0 0 1")).hasMessage(
            "<stdin>:2:1: error: expected object 1's type (" + Kinds.objects() + "; 1 object announced), found '"
                + type + "'" + (why.isEmpty() ? "" : ' ' + why) + '\n' + type + " 0 0 0 1\n^");
    }

    @Test
    void anUnknownTypeOfLightIsAnError() {
        assertThatThrownBy(() -> read("0\n" + AMBIENT + "1\n98 1 1 1 0 0 0")).hasMessage("""
            <stdin>:4:1: error: expected light 1's type (%s; 1 light announced), found '98'
            98 1 1 1 0 0 0
            ^""".formatted(Kinds.lights()));
    }

    @ParameterizedTest
    @CsvSource({"-1, less than 0", "9.0, an integer has only digits", "2147483648, more than 2147483647", "NaN, numbers must be finite"})
    void aBadNumberOfObjectsIsAnError(String number, String why) {
        assertThatThrownBy(() -> read(number)).hasMessage(
            "<stdin>:1:1: error: expected the number of objects, found '" + number + "' (" + why + ")\n" + number + "\n^");
    }

    @Test
    void errorsBeforeABadCodeAreReportedWithIt() {
        assertThatThrownBy(() -> read("2\n0 0 0 x 1 1 1 1 1 1 1 0 0 0 2\n97")).hasMessage("""
            <stdin>:2:7: error: expected object 1's centre z, found 'x'
            0 0 0 x 1 1 1 1 1 1 1 0 0 0 2
                  ^
            <stdin>:3:1: error: expected object 2's type (%s; 2 objects announced), found '97'
            97
            ^""".formatted(Kinds.objects()));
    }

    @Test
    void aTransmitLineBelongsToTheMaterialBeforeIt() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("1\n" + SPHERE + "# glass\n  transmit 0.25 0.5 1 1.5\n" + AMBIENT + "0"));

        Material glass = scene.getObject(0).surfaceMaterial;
        assertThat(glass.transmission).hasToString("(0.25,0.5,1.0)");
        assertThat(glass.index).isEqualTo(1.5);
    }

    @Test
    void elsewhereTheseWordsAreHeadings() throws IOException {
        SceneReader is = reader("background\n1\n" + SPHERE + "depth of it\n" + AMBIENT + "transmit\n1\nwindow\n" + LIGHT
            + "Background\ntransmit 1 1 1 1\n# the end");
        new Scene().read(is);

        assertThat(is.warnings()).extracting(Diagnostic::line).containsExactly(1, 4, 6, 8, 10, 11);
    }

    private static void read(String text) throws IOException {
        try (SceneReader is = reader(text)) {
            new Scene().read(is);
        }
    }
}
