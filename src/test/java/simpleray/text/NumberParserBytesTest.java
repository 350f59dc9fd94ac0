package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Numbers in the bytes of a text, and where they end. */
class NumberParserBytesTest {
    private static final String[] BEHIND = {" ", "\n", "\r\n", "\t", "#", " 12"};

    private final NumberParser parser = new NumberParser();

    /** {@return a text as bytes, with a 0 behind them} */
    private static byte[] bytes(String text) {
        return (text + '\0').getBytes(StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-0", "7", "-7", "0123456789", "1234567890123456789", "-9876543210987654321", "1.5", "-2.25", ".5", "5.",
        "-.5", "0.001", "123.456", "0.1234567890123456789", "1e3", "1E3", "1e+3", "1e-3", "2.5e-10", "-2.5E+10",
        ".5e1", "5.e1", "1e0", "9e09", "1e-64",
        "0000000000000000000000125", "000000000000000000012.5", "0.0000000000000000000125", "00000000000000000000.5e2", "0e9", "0e9999",
        "0.00000000000000000000000000000000",
        "+1", "+0.5e3", "12345678901234567890", "1.2345678901234567891", "-10000000000000000000.5", "1e400", "-1e400", "1e-400", "-1e-400", "0e99999",
        "0e-100000", "1e99999999999999999999", "1e-99999999999999999999", "0e99999999999999999999", "9007199254740993", "-9007199254740993.0"})
    void aDecimalIsTheDoubleThatJavaFinds(String word) {
        for (String behind : BEHIND) {
            assertThat(parser.parseDouble(bytes(word + behind), 0)).as("before '" + behind + "'").isEqualTo(Double.parseDouble(word));
            assertThat(parser.end()).as("before '" + behind + "'").isEqualTo(word.length());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-", "+", ".", "-.", "+-1", "--1", "1x", "1.5x", "1.2.3", "1,5", "e5", ".e5", "1e", "1e+", "1e-", "1e+-1",
        "1e5x", "1e5.", "1e5e5", "12345678901234567890x", "1.2345678901234567891e", "1e400f", "nan", "Infinity", "0x10", "1d"})
    void anyOtherWordIsNoNumber(String word) {
        assertThat(parser.parseDouble(bytes(word + " "), 0)).isNaN();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "-1.5", "1e5"})
    void aNumberMayGoOnBehindTheBytes(String word) {
        assertThat(parser.parseDouble(bytes(word), 0)).isNaN();
        assertThat(parser.parseInteger(bytes(word), 0)).isEqualTo(NumberParser.NO_INTEGER);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "7", "-7", "007", "1234567890", "999999999999999999", "-999999999999999999"})
    void anIntegerOfUpToEighteenDigitsIsRead(String word) {
        for (String behind : BEHIND) {
            assertThat(parser.parseInteger(bytes(word + behind), 0)).isEqualTo(Long.parseLong(word));
            assertThat(parser.end()).isEqualTo(word.length());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-", "+1", "--1", "1000000000000000000", "1.0", "1e3", "1x", "/1", ":1", "x"})
    void anyOtherIntegerIsLeftToTheParserOfWords(String word) {
        assertThat(parser.parseInteger(bytes(word + " "), 0)).isEqualTo(NumberParser.NO_INTEGER);
    }
}
