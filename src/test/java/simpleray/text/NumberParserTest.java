package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What the reader never asks for; the rest is in {@link SceneReaderNumbersTest}. */
class NumberParserTest {
    @Test
    void nothingIsNoNumber() {
        assertThat(NumberParser.parseDouble("")).isNaN();
        assertThat(NumberParser.parseFloat("")).isNaN();
        assertThat(NumberParser.parseInteger("", 0, 9)).isNull();
    }

    @Test
    void blanksAreNoPartOfANumber() {
        assertThat(NumberParser.parseDouble(" 1")).isNaN();
        assertThat(NumberParser.parseDouble("1 ")).isNaN();
        assertThat(NumberParser.parseInteger(" 1", 0, 9)).isNull();
        assertThat(NumberParser.parseInteger("1\n", 0, 9)).isNull();
    }

    @Test
    void anIntegerLiesBetweenTheLeastAndTheMost() {
        assertThat(NumberParser.parseInteger("1", 1, 3)).isEqualTo(1);
        assertThat(NumberParser.parseInteger("3", 1, 3)).isEqualTo(3);
        assertThat(NumberParser.parseInteger("0", 1, 3)).isNull();
        assertThat(NumberParser.parseInteger("4", 1, 3)).isNull();
    }

    @Test
    void onlyTheDigitsOfAsciiMakeANumber() {
        assertThat(NumberParser.parseInteger("\u0661", 0, 9)).isNull();
        assertThat(NumberParser.parseInteger("\uFF11", 0, 9)).isNull();
        assertThat(NumberParser.parseDouble("\u0661")).isNaN();
    }

    @Test
    void whatEndsANumberInAFileEndsNoneInAWord() {
        assertThat(NumberParser.parseDouble("1#")).isNaN();
        assertThat(NumberParser.parseDouble("1 2")).isNaN();
        assertThat(NumberParser.parseDouble("1\0")).isNaN();
    }

    @Test
    void aNumberTooLargeForADoubleIsToldFromAWordThatIsNone() {
        assertThat(NumberParser.parse("-1e400")).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(NumberParser.parseDouble("-1e400")).isNaN();
        assertThat(NumberParser.parse("1e400x")).isNaN();
        assertThat(NumberParser.parse("-1e-400")).isEqualTo(-0.0);
    }

    @Test
    void aNumberTooSmallForADoubleIsNotZero() {
        assertThat(NumberParser.isTiny("1e-400")).isTrue();
        assertThat(NumberParser.isTiny("0.000e9")).isFalse();
        assertThat(NumberParser.isTiny("-0E-9")).isFalse();
    }
}
