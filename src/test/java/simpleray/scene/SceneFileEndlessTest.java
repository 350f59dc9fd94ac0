package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.text.SceneFormatException;

/** A file that is no scene is refused by its first few megabytes, even if it never ends; what may be long in a scene may be any length. */
class SceneFileEndlessTest {
    private static final int MAX_READ = 4 << 20;
    private static final int MAX_HEADING = 1 << 20;
    private static final int LONG = 3 << 20;
    private static final String REST = " 0.1 0.1 0.1 0 ";
    /** More than the first bytes, by which many kinds of files are known. */
    private static final String COMMENT = "#" + " ".repeat(600) + "\n";

    /** A stream of a beginning and a pattern without end; fails a test that reads too much of it. */
    private static InputStream endless(String begin, String pattern) {
        byte[] repeated = pattern.replace("NUL", "\0").getBytes(StandardCharsets.ISO_8859_1);
        return new SequenceInputStream(bytes(begin), new InputStream() {
            private int count;

            @Override
            public int read() {
                assertThat(count).as("bytes read").isLessThan(MAX_READ);
                return repeated[count++ % repeated.length] & 0xFF;
            }
        });
    }

    private static InputStream bytes(String text) {
        return new ByteArrayInputStream(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', value = {
        "x | expected a heading of at most 1048576 bytes, found a longer one",
        "~y\n~ | expected a scene, found more than 1048576 bytes of headings",
        "~ab cd ~ | expected a heading of at most 1048576 bytes, found a longer one",
        "9 | expected the number of objects, found '999999999999999999999999999999999999999999999999999999999999...' (beyond 1.8e308, the largest number)",
        "1. | expected the number of objects, found '1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1.1....' (an integer has only digits)",
        "* | expected the number of objects, found '************************************************************...'",
        "~\"x~ | expected the number of objects, found '\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x...'",
        "\u00E9 | expected the number of objects, found bytes that are no text in UTF-8",
        "NUL | expected a scene, as text in UTF-8, found NUL bytes",
        "\u00FF\u00D8\u00FF\u00E0 | expected a scene, as text in UTF-8, found a JPEG image",
        "2NUL | expected a scene, as text in UTF-8, found UTF-16",
        "NUL\u00C2\u0080\u00FE\u007F | expected a scene, as text in UTF-8, found binary data"})
    void whatIsNoSceneIsRefused(String pattern, String message) {
        assertThatThrownBy(() -> SceneFile.read(endless("", pattern))).isInstanceOf(SceneFormatException.class)
            .message().matches("(?s)<stdin>:(1|1048577):1: error: .*").satisfies(m -> assertThat(m.lines().findFirst().orElseThrow()).endsWith(": " + message));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', value = {
        "1 0 0 0 0 | x | :11: error: expected object 1's radius, found 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...'",
        "1 0 0 0 0 | -1- | :11: error: expected object 1's radius, found '-1--1--1--1--1--1--1--1--1--1--1--1--1--1--1--1--1--1--1--1-...'",
        "1 0 0 0 0 | NUL | :11: error: expected object 1's radius, found NUL bytes",
        "1 0 x 0 0 | \u00E9 | :11: error: expected object 1's radius, found bytes that are no text in UTF-8",
        "1 4 | ~\"x~ | :5: error: expected object 1's OBJ file between double quotes, found '\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x\"x...'",
        "0 0 0 0 0 | ~9 ~ | :11: error: expected the end of the scene (after 0 objects and 0 lights), found '9'"})
    void noMatterWhereItBegins(String begin, String pattern, String message) {
        assertThatThrownBy(() -> SceneFile.read(endless(COMMENT + begin + ' ', pattern))).isInstanceOf(SceneFormatException.class)
            .hasMessageContaining("<stdin>:2" + message);
    }

    @Test
    void norAfterTheScene() {
        assertThatThrownBy(() -> SceneFile.read(endless("0 0 0 0 0\n", "x")))
            .hasMessageStartingWith("<stdin>:2:1: error: expected a heading of at most 1048576 bytes, found a longer one\nxxx");
    }

    @Test
    void theErrorsBeforeItAreTold() {
        assertThatThrownBy(() -> SceneFile.read(endless("1 0 a 0 0 ", "x")))
            .hasMessageContainingAll("<stdin>:1:5: error: expected object 1's centre x, found 'a'", "<stdin>:1:11: error: expected object 1's radius, found 'xx");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', value = {
        "NUL | expected text in UTF-8, found NUL bytes", "NUL\u00C2\u0080\u00FE\u007F | expected text in UTF-8, found binary data",
        "\u00FF\u00D8\u00FF\u00E0 | expected text in UTF-8, found a JPEG image", "NULv | expected text in UTF-8, found UTF-16",
        "\u00E9 | expected a line of at most 1048576 characters, found a longer one",
        "x | expected a line of at most 1048576 characters, found a longer one",
        "9 | expected a line of at most 1048576 characters, found a longer one",
        "# | expected a line of at most 1048576 characters, found a longer one"})
    void anObjLikewise(String pattern, String message) {
        assertThatThrownBy(() -> ObjReader.read(endless("", pattern), "a.obj", warning -> { })).isInstanceOf(SceneFormatException.class)
            .message().satisfies(m -> assertThat(m.lines().findFirst().orElseThrow()).isEqualTo("a.obj:1:1: error: " + message));
    }

    @ParameterizedTest
    @ValueSource(strings = {" ", "\n", "\t", "\r\n", "\u00C2\u00A0", "#", "# x\n"})
    void blanksAndCommentsMayBeOfAnyLength(String pattern) throws IOException {
        String filler = pattern.repeat(LONG / pattern.length());
        assertThat(SceneFile.read(bytes(filler + "\n0" + filler + "\n" + REST + filler)).warnings()).isEmpty();
    }

    @Test
    void soMayNumbers() throws IOException {
        String zeros = "0".repeat(LONG);
        Scene scene = SceneFile.read(bytes(zeros + "0 0.25" + zeros + " 1" + zeros + "e-" + LONG + " -0." + zeros + "1 0" + zeros)).scene();
        assertThat(scene.ambient.r).isEqualTo(0.25);
        assertThat(scene.ambient.g).isEqualTo(1);
    }

    @Test
    void aHeadingMayHaveAMegabyte() throws IOException {
        assertThat(SceneFile.read(bytes("x".repeat(MAX_HEADING) + "\n0" + REST)).warnings()).hasSize(1);
        assertThatThrownBy(() -> SceneFile.read(bytes("x".repeat(MAX_HEADING + 1) + "\n0" + REST)))
            .hasMessageStartingWith("<stdin>:1:1: error: expected a heading of at most 1048576 bytes, found a longer one\nxxx");
    }
}
