package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import simpleray.Project;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

class SceneFilePrefixesTest {
    private static final int COUNT_OF_LIGHTS = 47;

    @Test
    void everyPrefixOfTheThesisSceneThatLacksANumberIsAnErrorAtItsEnd() throws IOException {
        byte[] text = Files.readAllBytes(Project.scene("thesis"));
        int whole = new String(text, StandardCharsets.US_ASCII).stripTrailing().length();
        int lines = 0;
        for (int length = 0; length <= text.length; length++) {
            SceneFormatException e = (SceneFormatException) SceneFuzzer.outcome(Arrays.copyOf(text, length));

            if (length >= whole) {
                assertThat(e).as(length + " bytes").isNull();
            } else if (e != null) {                           // null where the last number is cut and still is one
                Diagnostic last = e.problems().get(e.problems().size() - 1);
                boolean oneLight = last.message().equals("expected the number of lights to be 1, as many as follow, found '2'");
                assertThat(last.line()).as(length + " bytes").isEqualTo(oneLight ? COUNT_OF_LIGHTS : lines + 1);
            }
            assertThat(e == null && length < whole - 8).as(length + " bytes are no scene").isFalse();
            lines += length < text.length && text[length] == '\n' ? 1 : 0;
        }
    }
}
