package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class BadNumberTest {
    @ParameterizedTest
    @CsvSource(delimiter = ';', quoteCharacter = '`', value = {"NaN; numbers must be finite", "-inf; numbers must be finite", "+Infinity; numbers must be finite",
        "0x10; numbers are decimal", "-0X1P3; numbers are decimal", "1,5; a decimal point is a '.'", "-,5e3; a decimal point is a '.'",
        "1,2,3; values are separated by blanks", "1f; a number ends with a digit", "2.5D; a number ends with a digit",
        "1e400; beyond 1.8e308, the largest number", "\u0661; numbers are written with 0 to 9, + and -",
        "\u22121; numbers are written with 0 to 9, + and -", "1\uFFFD; not UTF-8", "\uFFFD\uFFFD2; `not UTF-8; is the file UTF-16, or no text?`"})
    void whyAWordIsNoNumberIsTold(String word, String why) {
        assertThat(BadNumber.describe(word)).isEqualTo("'" + word + "' (" + why + ')');
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '"', value = {"200B", "00AD", "202E", "FEFF", "0008", "007F", "001B"})
    void whatCannotBeSeenIsTold(String code) {
        assertThat(BadNumber.describe("1" + (char) Integer.parseInt(code, 16))).isEqualTo("'1\uFFFD' (with the invisible character U+" + code + ')');
    }

    @ParameterizedTest
    @ValueSource(strings = {"abc", "9x", "--1", "1e", ".", "", "1.2.3", "\u00BD", "5", "1e-400"})
    void ofOthersNothingIs(String word) {
        assertThat(BadNumber.describe(word)).isEqualTo("'" + word + "'");
    }

    @ParameterizedTest
    @CsvSource({"-1, less than 0", "2147483648, more than 2147483647", "-99999999999999999999, less than 0", "9.0, an integer has only digits",
        "1e9, an integer has only digits", "'2,', an integer has only digits", "NaN, numbers must be finite"})
    void whyAWordIsNoCountIsTold(String word, String why) {
        assertThat(BadNumber.describeInteger(word, 0, Integer.MAX_VALUE)).isEqualTo("'" + word + "' (" + why + ')');
    }

    @ParameterizedTest
    @CsvSource({"-2147483649, less than -2147483648", "2147483648, more than 2147483647"})
    void whyAWordIsNoIntegerIsTold(String word, String why) {
        assertThat(BadNumber.describeInteger(word, Integer.MIN_VALUE, Integer.MAX_VALUE)).isEqualTo("'" + word + "' (" + why + ')');
    }

    @ParameterizedTest
    @ValueSource(strings = {"\0001", "1\0000"})
    void aTextOfTwoBytesACharacterIsSuspected(String word) {
        assertThat(BadNumber.describe(word)).isEqualTo("'" + word.replace('\0', '\uFFFD') + "' (with NUL bytes; is the file UTF-16, or no text?)");
    }

    @Test
    void ofManyBytesThatAreNoTextTheNameIsTold() {
        assertThat(BadNumber.describe("\0".repeat(8))).isEqualTo("NUL bytes");
        assertThat(BadNumber.describe("\uFFFD".repeat(8))).isEqualTo("bytes that are no text in UTF-8");
        assertThat(BadNumber.describeInteger("\1\uFFFD".repeat(4) + "1", 0, 9)).isEqualTo("bytes that are no text in UTF-8");
        assertThat(BadNumber.describe("\uFFFD".repeat(7))).startsWith("'\uFFFD");
        assertThat(BadNumber.describe("\uFFFD".repeat(7) + "1")).startsWith("'\uFFFD");
    }

    @ParameterizedTest
    @ValueSource(strings = {"-1", "1001"})
    void aNarrowRangeIsToldByWhoReads(String word) {
        assertThat(BadNumber.describeInteger(word, 0, 1000)).isEqualTo("'" + word + "'");
    }
}
