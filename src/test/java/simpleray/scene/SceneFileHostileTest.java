package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is said of each hostile file is what lies beside it. */
class SceneFileHostileTest {
    private static final int MIN = 500;
    private static final Locale DEFAULT = Locale.getDefault();

    @AfterEach
    void theLocaleIsAsItWas() {
        Locale.setDefault(DEFAULT);
    }

    static List<Path> files() {
        return HostileFiles.all();
    }

    @ParameterizedTest
    @MethodSource("files")
    void whatIsSaidOfItIsWhatAUserIsToRead(Path file) throws IOException {
        assertThat(HostileFiles.outcome(file)).isEqualTo(HostileFiles.told(file));
    }

    @Test
    void thereAreFiveHundredAndTheirNamesSayWhichAreAccepted() throws IOException {
        assertThat(files()).hasSizeGreaterThanOrEqualTo(MIN);
        for (Path file : files()) {
            String expected = HostileFiles.told(file);
            String first = expected.lines().findFirst().orElse("");
            if (file.getFileName().toString().contains("accepted")) {
                assertThat(first).as(file.toString()).startsWith("accepted: ");
            } else if (file.endsWith("png-file.scene")) {     // a picture is no text, and has no lines
                assertThat(expected).isEqualTo("png-file.scene: is cut off in the chunk IHDR\n");
            } else if (!first.startsWith("accepted: ")) {
                assertThat(first).matches("[\\w.-]+:\\d+:\\d+: error: expected .+, found .+");
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"de-DE", "tr-TR", "ar-EG-u-nu-arab"})
    void nothingDependsOnTheLocale(String tag) throws IOException {
        Locale.setDefault(Locale.forLanguageTag(tag));

        for (Path file : files()) {
            assertThat(HostileFiles.outcome(file)).isEqualTo(HostileFiles.told(file));
        }
    }
}
