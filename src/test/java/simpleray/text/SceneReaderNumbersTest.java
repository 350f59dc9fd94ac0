package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SceneReaderNumbersTest {
    @ParameterizedTest
    @CsvSource({"1, 1.0", "1., 1.0", ".5, 0.5", "+3, 3.0", "-2.5, -2.5", "1e3, 1000.0", "1E-2, 0.01", "2.5e+1, 25.0",
        "1.e1, 10.0", "0001.50, 1.5", "1e-400, 0.0", "1.7976931348623157e308, 1.7976931348623157E308", "4.9E-324, 4.9E-324"})
    void plainAndExponentFormsAreNumbers(String word, double value) throws IOException {
        assertThat(reader(word).readDouble()).isEqualTo(value);
    }

    @ParameterizedTest
    @CsvSource({"1, 1.0", ".5, 0.5", "+3, 3.0", "1e3, 1000.0", "3.4028235e38, 3.4028235E38"})
    void floatsTakeTheSameForms(String word, float value) throws IOException {
        assertThat(reader(word).readFloat()).isEqualTo(value);
    }

    @Test
    void minusZeroKeepsItsSign() throws IOException {
        SceneReader is = reader("-0.0 -0 0");

        assertThat(1 / is.readDouble()).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(1 / is.readFloat()).isEqualTo(Float.NEGATIVE_INFINITY);
        assertThat(1 / is.readDouble()).isEqualTo(Double.POSITIVE_INFINITY);
    }

    @ParameterizedTest
    @ValueSource(strings = {"NaN", "nan", "-NaN", "Infinity", "-Infinity", "+infinity", "0x10", "0x1p3", "0X1.8P1", "1f",
        "2d", "1.0F", "1e3D", "1,5", "1e400", "-1e400", "1e", "1e+", "1e-", "e5", ".e5", ".", "+", "-", "+.", "--1", "+-1",
        "1.2.3", "1e2.5", "1_000", "\u0661", "1\u0662", "\u2212" + "1", "\uFF11", "abc", "1e5x", "\"1\""})
    void everythingElseIsNoNumber(String word) {
        assertThatThrownBy(() -> afterZero(word).readDouble()).isInstanceOf(SceneFormatException.class)
            .hasMessage("<stdin>:1:3: error: expected a number, found " + BadNumber.describe(word) + "\n0 " + word + "\n  ^");
    }

    @ParameterizedTest
    @ValueSource(strings = {"nan", "1f", "0x10", "1e39", "1,5", "."})
    void norIsItAFloat(String word) {
        assertThatThrownBy(() -> afterZero(word).readFloat()).isInstanceOf(SceneFormatException.class)
            .hasMessage("<stdin>:1:3: error: expected a number, found " + BadNumber.describe(word) + "\n0 " + word + "\n  ^");
    }

    @ParameterizedTest
    @ValueSource(strings = {"9.0", "1e3", "2147483648", "-2147483649", "99999999999999999999", "0x1", "1L", "+", "-", "9.",
        "\u0661", "1,000", "nine"})
    void anIntegerHasNothingButDigitsAndFits(String word) {
        assertThatThrownBy(() -> afterZero(word).readInt()).isInstanceOf(SceneFormatException.class).hasMessage("<stdin>:1:3: error: expected an integer, found "
                + BadNumber.describeInteger(word, Integer.MIN_VALUE, Integer.MAX_VALUE) + "\n0 " + word + "\n  ^");
    }

    @ParameterizedTest
    @ValueSource(strings = {"9.0", "9223372036854775808", "-9223372036854775809", "1L"})
    void soDoesALongOne(String word) {
        assertThatThrownBy(() -> afterZero(word).readLong()).isInstanceOf(SceneFormatException.class)
            .hasMessage("<stdin>:1:3: error: expected an integer, found " + BadNumber.describeInteger(word, Long.MIN_VALUE, Long.MAX_VALUE) + "\n0 " + word + "\n  ^");
    }

    @ParameterizedTest
    @ValueSource(strings = {"-1", "9.0", "2147483648"})
    void aCountIsAnIntegerOfZeroOrMore(String word) {
        assertThatThrownBy(() -> reader(word).readInt("the number of objects", 0, Integer.MAX_VALUE))
            .isInstanceOf(SceneFormatException.class)
            .hasMessage("<stdin>:1:1: error: expected the number of objects, found " + BadNumber.describeInteger(word, 0, Integer.MAX_VALUE) + '\n' + word + "\n^");
    }

    @Test
    void aCountMayBeZero() throws IOException {
        assertThat(reader("0").readInt("the number of objects", 0, Integer.MAX_VALUE)).isZero();
    }

    /** A word that stands at column 3, for at the start of a line a letter would begin a heading. */
    private static SceneReader afterZero(String word) throws IOException {
        SceneReader is = reader("0 " + word);
        is.readInt();
        return is;
    }
}
