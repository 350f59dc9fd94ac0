package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import simpleray.text.SceneReader;

/** Materials of scene files, for tests. */
final class MaterialText {
    private MaterialText() {
    }

    /** {@return the material that a text holds, and nothing else} */
    static Material read(String text) throws IOException {
        Material material = new Material();
        SceneReader is = reader(text);
        material.read(is);
        assertThat(is.eof()).isTrue();
        assertThat(is.warnings()).isEmpty();
        return material;
    }

    /** Asserts that a line behind a sphere's material is wrong at a column, and how the message goes on behind "object 1's". */
    static void assertWrong(String material, String line, int column, String message) {
        assertError(material, line, "\n0 0 0\n0\n", column, message);
    }

    /** Asserts that a file that ends with a line behind a sphere's material misses something there. */
    static void assertMissing(String material, String line, String expected) {
        assertError(material, line, "", line.length() + 1, expected + ", found the end of the file");
    }

    private static void assertError(String material, String line, String rest, int column, String message) {
        assertThatThrownBy(() -> new Scene().read(reader("1\n0 0 0 0 1 " + material + '\n' + line + rest))).hasMessage(
            "<stdin>:3:" + column + ": error: expected object 1's " + message + '\n' + line + '\n' + " ".repeat(column - 1) + '^');
    }
}
