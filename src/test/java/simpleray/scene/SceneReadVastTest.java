package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneReader;

/** Files that announce or err too much. */
class SceneReadVastTest {
    private static final String MATERIAL = "1 1 1  1 1 1  0 0 0  2";
    private static final String SPHERE = "0  0 0 0 1  " + MATERIAL + '\n';
    private static final String AMBIENT = "0.3 0.3 0.3\n";

    @Test
    void nothingStaysOfAFileThatStopsAtTheTwentiethError() {
        SceneFormatException e = catchThrowableOfType(SceneFormatException.class,
            () -> read("2\n0" + " *".repeat(14) + "\n0" + " *".repeat(14) + '\n' + AMBIENT + "0"));

        assertThat(e.problems()).hasSize(20).first().extracting(Diagnostic::message)
            .isEqualTo("expected object 1's centre x, found '*'");
        // the fifteenth is the first of the second object, so that the twentieth is its sixth
        assertThat(e.problems()).last().extracting(Diagnostic::message).isEqualTo("expected object 2's ambient green, found '*'");
        assertThat(e).hasMessageEndingWith("\n20 errors: reading stopped here");
    }

    @Test
    @Timeout(60)
    void aVastNumberOfObjectsFailsAtTheFirstThatIsMissing() {
        assertThatThrownBy(() -> read("2000000000\n" + SPHERE.strip())).hasMessage("""
            <stdin>:2:35: error: expected object 2's type \
            (%s; 2000000000 objects announced), \
            found the end of the file
            0  0 0 0 1  1 1 1  1 1 1  0 0 0  2
                                              ^""".formatted(Kinds.objects()));
    }

    @Test
    @Timeout(60)
    void soDoesAVastNumberOfLights() {
        assertThatThrownBy(() -> read("0 0 0 0 2000000000")).hasMessage("""
            <stdin>:1:19: error: expected light 1's type (%s; 2000000000 lights announced), \
            found the end of the file
            0 0 0 0 2000000000
                              ^""".formatted(Kinds.lights()));
    }

    private static Scene read(String text) throws IOException {
        Scene scene = new Scene();
        try (SceneReader is = reader(text)) {
            scene.read(is);
        }
        return scene;
    }
}
