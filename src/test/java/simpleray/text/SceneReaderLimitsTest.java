package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** How long a heading may be, and a word that is no number. */
class SceneReaderLimitsTest {
    private static final int MAX = 1 << 20;
    private static final int FAR = 3 * MAX;

    private static String x(int count) {
        return "x".repeat(count);
    }

    /** {@return a reader of a text without end} */
    private static SceneReader endless(String begin, String repeated) {
        byte[] first = begin.getBytes(StandardCharsets.UTF_8);
        byte[] then = repeated.getBytes(StandardCharsets.UTF_8);
        return new SceneReader(new InputStream() {
            private int count;

            @Override
            public int read() {
                assertThat(count).as("bytes read").isLessThan(FAR);
                int i = count++;
                return (i < first.length ? first[i] : then[(i - first.length) % then.length]) & 0xFF;
            }
        });
    }

    @Test
    void aHeadingMayHaveAMegabyte() throws IOException {
        assertThat(reader(x(MAX) + "\n7").readInt()).isEqualTo(7);
        assertThat(reader("  " + x(MAX) + "\n7").readInt()).isEqualTo(7);
        SceneReader is = reader(x(MAX + 1) + "\n7");
        assertThatThrownBy(is::readInt).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith("<stdin>:1:1: error: expected a heading of at most 1048576 bytes, found a longer one\nxxx");
    }

    @Test
    void whatIsBeforeAHeadingDoesNotCount() throws IOException {
        assertThat(reader('#' + x(700_000) + '\n' + x(500_000) + "\n7").readInt()).isEqualTo(7);
        assertThat(reader(" ".repeat(700_000) + '\n' + x(500_000) + "  \n7").readInt()).isEqualTo(7);
    }

    @Test
    void allHeadingsTogetherHaveAMegabyteAtMost() throws IOException {
        assertThat(reader(x(MAX / 2) + '\n' + x(MAX / 2) + " \n7").readInt()).isEqualTo(7);
        SceneReader is = reader(x(MAX / 2) + '\n' + x(MAX / 2) + "\nx\n7");
        assertThatThrownBy(is::readInt).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith("<stdin>:3:1: error: expected a scene, found more than 1048576 bytes of headings\nx\n^");
    }

    @ParameterizedTest
    @ValueSource(strings = {"x", "x ", "y\n", "heading\r\n"})
    void headingsWithoutEndAreRefused(String repeated) {
        assertThatThrownBy(() -> endless("", repeated).readInt()).isInstanceOf(SceneFormatException.class);
        assertThatThrownBy(() -> endless("# comment\n", repeated).readInt()).isInstanceOf(SceneFormatException.class);
    }

    @ParameterizedTest
    @CsvSource({"*, ****", "9, 9999", "1., 1.1.", "-, ----", "e, eeee"})
    void wordsWithoutEndAreRefused(String repeated, String found) {
        for (String begin : new String[] {"1 ", '#' + x(700_000) + "\n 1 "}) {
            assertThatThrownBy(() -> {
                SceneReader is = endless(begin, repeated);
                is.readInt();
                is.readInt();
            }).isInstanceOf(SceneFormatException.class).hasMessageContaining("found '" + found);
        }
    }

    @Test
    void afterAWordThatWasReadToItsEndReadingGoesOn() throws IOException {
        assertThat(reader("1." + "0".repeat(MAX + 1) + " 7").readDouble()).isEqualTo(1);
        SceneReader is = reader("0.5" + "0".repeat(200_000) + " 7");
        assertThat(is.readDouble()).isEqualTo(0.5);
        assertThat(is.readInt()).isEqualTo(7);
    }
}
