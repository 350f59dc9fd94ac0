package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which numbers are read without making a text of them, and where they end. */
class NumeralsTest {
    private static final String[] BEHIND = {" ", "\n", "\r\n", "\t", "#", " 12"};

    private final Numerals numerals = new Numerals();

    /** {@return a text as bytes, with a 0 behind them} */
    private static byte[] bytes(String text) {
        return (text + '\0').getBytes(StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-0", "7", "-7", "0123456789", "1234567890123456789", "-9876543210987654321", "1.5", "-2.25", ".5", "5.",
        "-.5", "0.001", "123.456", "0.1234567890123456789", "1e3", "1E3", "1e+3", "1e-3", "2.5e-10", "-2.5E+10",
        ".5e1", "5.e1", "1e0", "9e09", "1e-64",
        "0000000000000000000000125", "000000000000000000012.5", "0.0000000000000000000125", "00000000000000000000.5e2", "0e9", "0e9999",
        "0.00000000000000000000000000000000"})
    void aUsualDecimalIsTheDoubleThatJavaFinds(String word) {
        for (String behind : BEHIND) {
            assertThat(numerals.readDouble(bytes(word + behind), 0)).as("before '" + behind + "'").isEqualTo(Double.parseDouble(word));
            assertThat(numerals.end()).as("before '" + behind + "'").isEqualTo(word.length());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-", ".", "-.", "+1", "--1", "1x", "1.5x", "1.2.3", "1,5", "e5", ".e5", "1e", "1e+", "1e-", "1e+-1",
        "1e5x", "1e5.", "1e5e5", "12345678901234567890", "1.2345678901234567891", "10000000000000000000.5", "1e400", "0e99999",
        "0e-100000", "nan"})
    void anyOtherIsLeftToTheRulesOfNumbers(String word) {
        assertThat(numerals.readDouble(bytes(word + " "), 0)).isNaN();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "-1.5", "1e5"})
    void aNumberMayGoOnBehindTheBytes(String word) {
        assertThat(numerals.readDouble(bytes(word), 0)).isNaN();
        assertThat(numerals.readInteger(bytes(word), 0)).isEqualTo(Numerals.NO_INTEGER);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "7", "-7", "007", "1234567890", "999999999999999999", "-999999999999999999"})
    void anIntegerOfUpToEighteenDigitsIsRead(String word) {
        for (String behind : BEHIND) {
            assertThat(numerals.readInteger(bytes(word + behind), 0)).isEqualTo(Long.parseLong(word));
            assertThat(numerals.end()).isEqualTo(word.length());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-", "+1", "--1", "1000000000000000000", "1.0", "1e3", "1x", "/1", ":1", "x"})
    void anyOtherIntegerIsLeftToTheRulesOfNumbers(String word) {
        assertThat(numerals.readInteger(bytes(word + " "), 0)).isEqualTo(Numerals.NO_INTEGER);
    }
}
