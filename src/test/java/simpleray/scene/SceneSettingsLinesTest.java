package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.text.SceneFormatException;

/** Settings that stand alone, as a picture carries them. */
class SceneSettingsLinesTest {
    private static final String LINES = """
        background 0.1 0.2 0.3
        window -1.0 2.0 -3.0 4.0
        cop 2.5
        resolution 30 20
        depth 7
        samples 3
        """;

    @ParameterizedTest
    @ValueSource(strings = {LINES, "camera 1.0 2.0 3.0 4.0 5.0 6.0 70.0\n", "depth 0\n", ""})
    void theyReadBackAsTheyAreWritten(String lines) throws IOException {
        assertThat(SceneSettings.of(lines, "a.png").lines()).isEqualTo(lines);
    }

    @Test
    void anythingElseAmongThemIsAnError() {
        assertThatThrownBy(() -> SceneSettings.of("depth 3\n5\n", "a.png")).isInstanceOf(SceneFormatException.class)
            .hasMessage("a.png:2:1: error: expected the end of the settings, found '5'\n5\n^");
    }

    @ParameterizedTest
    @ValueSource(strings = {"depth 3", "background 1 1 1", "window -1 1 -1 1", "cop 2", "camera 1 2 3 4 5 6 70", "resolution 2 2", "samples 4"})
    void aKeywordAndValuesAreASetting(String line) {
        assertThat(SceneSettings.isSetting(line)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"samples adaptive", "depth", "", " depth 3", "depths 3", "stage final"})
    void otherOptionsAreNone(String line) {
        assertThat(SceneSettings.isSetting(line)).isFalse();
    }

    @Test
    void aKeywordNeedsALineOfItsOwn() {
        assertThatThrownBy(() -> SceneSettings.of("depth 3 samples 2\n", "a.png")).isInstanceOf(SceneFormatException.class).hasMessage(
            "a.png:1:9: error: expected keyword samples on a line of its own, found 'samples'\ndepth 3 samples 2\n        ^");
    }
}
