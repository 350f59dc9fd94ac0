package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LongNumberTest {
    private static final int SAMPLES = 2000;
    private static final long SEED = 767;

    @ParameterizedTest
    @CsvSource({"5, 5", "-5, -5", "+5, 5", "0005, 5", "-000, -0", "1.50, 150e-2", "0.0015, 15e-4", "5., 5e0", ".5, 5e-1", "0.000, 0e-3",
        "1e5, 1e5", "1E+5, 1e5", "15.0e-5, 150e-6", "1e99999999999999999999, 1e100000", "1e-99999999999999999999, 1e-100000"})
    void whatIsTheSameIsShorter(String word, String shorter) {
        assertThat(shortened(word)).isEqualTo(shorter);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-", ".", "-.", "e5", "1e", "1e+", "1e+-5", "1e5.", "1.2.3", "1-", "1x", "--1", "x1", "1e5e5", "1ex5", "1ee5", "NaN"})
    void whatIsNoNumberStaysNone(String word) {
        assertThat(NumberParser.parseDouble(shortened(word))).isNaN();
        assertThat(NumberParser.parseInteger(shortened(word), Long.MIN_VALUE, Long.MAX_VALUE)).isNull();
    }

    @Test
    void thatItIsNoNumberIsKnownBeforeItEnds() {
        LongNumber number = new LongNumber();
        number.add('1');
        assertThat(number.isWrong()).isFalse();
        number.add('x');
        number.add('1');
        assertThat(number.isWrong()).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"'', false", "-, false", "9223372036854775807, false", "-00000000000000000000000000009, false", "9999999999999999999, false",
        "10000000000000000000, true", "0000000000000000000010000000000000000000, true", "5., true", ".5, true", "5e, true", "5e0, true", "5x, true"})
    void thatItIsNoLongIsKnownBeforeItEnds(String begin, boolean none) {
        LongNumber number = new LongNumber();
        begin.chars().forEach(c -> number.add((char) c));
        assertThat(number.isNoLong()).isEqualTo(none);
    }

    @ParameterizedTest
    @ValueSource(strings = {"5.0", "5.", "5e0", "99999999999999999999"})
    void whatIsNoIntegerBecomesNone(String word) {
        assertThat(NumberParser.parseInteger(shortened(word), Long.MIN_VALUE, Long.MAX_VALUE)).isNull();
    }

    @Test
    void itIsShortHoweverLongTheWord() {
        assertThat(shortened("7".repeat(100_000) + '.' + "7".repeat(100_000) + "e-100000")).hasSizeLessThan(1100);
    }

    @Test
    void zerosThatCancelAnExponentAreCounted() {
        assertThat(NumberParser.parseDouble(shortened("0." + "0".repeat(200_000) + "15e200001"))).isEqualTo(1.5);
        assertThat(NumberParser.parseDouble(shortened("15" + "0".repeat(200_000) + "e-200001"))).isEqualTo(1.5);
    }

    @Test
    void oneDigitFarBehindAPointHalfWayTipsIt() {
        // between the two smallest doubles: 2^-1074 · 1.5, of 1075 places
        String half = new BigDecimal(Double.MIN_VALUE).multiply(new BigDecimal("1.5")).toPlainString();
        assertThat(NumberParser.parseDouble(shortened(half))).isEqualTo(2 * Double.MIN_VALUE);
        assertThat(NumberParser.parseDouble(shortened(half + "0".repeat(5000) + '1'))).isEqualTo(2 * Double.MIN_VALUE);
        String below = half.substring(0, half.length() - 1) + '4' + "9".repeat(5000);
        assertThat(NumberParser.parseDouble(shortened(below))).isEqualTo(Double.MIN_VALUE);
        // between 1 and the next: the even one of the two, unless a digit says otherwise
        String tie = new BigDecimal(1 + 0x1p-53).toPlainString();
        String exact = "1" + new BigDecimal(0x1p-53).toPlainString().substring(1);
        assertThat(tie).isEqualTo("1");
        assertThat(NumberParser.parseDouble(shortened(exact + "0".repeat(5000)))).isEqualTo(1);
        assertThat(NumberParser.parseDouble(shortened(exact + "0".repeat(5000) + '1'))).isEqualTo(1 + 0x1p-52);
    }

    @Test
    void anyNumberStaysTheSame() {
        Random random = new Random(SEED);
        for (int i = 0; i < SAMPLES; i++) {
            String word = (random.nextBoolean() ? "-" : "") + "0".repeat(random.nextInt(3) * random.nextInt(400)) + digits(random)
                + (random.nextBoolean() ? "." : "") + "0".repeat(random.nextInt(2) * random.nextInt(600)) + digits(random)
                + (random.nextBoolean() ? "e" + (random.nextInt(4000) - 2000) : "");
            assertThat(Double.doubleToRawLongBits(NumberParser.parseDouble(shortened(word)))).as("seed " + SEED + ", sample " + i)
                .isEqualTo(Double.doubleToRawLongBits(NumberParser.parseDouble(word)));
        }
    }

    private static String digits(Random random) {
        return Integer.toString(random.nextInt(1000)).repeat(random.nextInt(random.nextBoolean() ? 700 : 3));
    }

    private static String shortened(String word) {
        LongNumber number = new LongNumber();
        word.chars().forEach(c -> number.add((char) c));
        return number.toString();
    }
}
