package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Both {@code of}, which programs call, and {@code search}, which it uses on old runtimes only. */
class ShortestDecimalTest {
    private static final int SHORTEST_SINCE = 19;
    private static final int SAMPLES = 100_000;
    private static final long SEED = 20100504;

    @ParameterizedTest
    @CsvSource({"2.0E-3, 0.002", "1.0E-3, 0.001", "9.99E-4, 9.99E-4", "9999999.0, 9999999.0", "1.0E7, 1.0E7",
        "12345678, 1.2345678E7", "1, 1.0", "-2.5, -2.5", "100, 100.0", "0.1, 0.1", "-1234.5, -1234.5", "2.0E-44, 2.0E-44",
        "2.2250738585072014E-308, 2.2250738585072014E-308", "1.7976931348623157E308, 1.7976931348623157E308",
        "4.9E-324, 4.9E-324", "5.0E-324, 4.9E-324", "9007199254740993, 9.007199254740992E15",
        "0, 0.0", "-0.0, -0.0", "NaN, NaN", "Infinity, Infinity", "-Infinity, -Infinity"})
    void aDoubleIsWrittenInJavasNotation(double d, String decimal) {
        assertThat(ShortestDecimal.of(d)).isEqualTo(decimal);
        assertThat(ShortestDecimal.search(d)).isEqualTo(decimal);
    }

    /** Java 17 writes 1.0E23 as 9.999999999999999E22, the next three alike, the last as 1.0E-323. */
    @ParameterizedTest
    @CsvSource({"1.0E23", "2.0E23", "4.0E23", "8.41E21", "9.9E-324"})
    void whereOlderJavaIsLongerTheShortOneIsFound(String decimal) {
        assertThat(ShortestDecimal.of(Double.parseDouble(decimal))).isEqualTo(decimal);
        assertThat(ShortestDecimal.search(Double.parseDouble(decimal))).isEqualTo(decimal);
    }

    @ParameterizedTest
    @CsvSource({"2.0E-3, 0.002", "2.0E-44, 2.0E-44", "1.4E-45, 1.4E-45", "1.17549435E-38, 1.1754944E-38",
        "3.4028235E38, 3.4028235E38", "9.0E9, 9.0E9", "9999999, 9999999.0", "1.0E7, 1.0E7", "-0.1, -0.1", "16777217, 1.6777216E7",
        "0, 0.0", "-0.0, -0.0", "NaN, NaN", "Infinity, Infinity", "-Infinity, -Infinity"})
    void soIsAFloat(float f, String decimal) {
        assertThat(ShortestDecimal.of(f)).isEqualTo(decimal);
        assertThat(ShortestDecimal.search(f)).isEqualTo(decimal);
    }

    @Test
    void everyPowerOfTwoReadsBack() {
        for (int k = Double.MIN_EXPONENT - 52; k <= Double.MAX_EXPONENT; k++) {
            double d = Math.scalb(1.0, k);
            assertThat(Double.parseDouble(ShortestDecimal.search(d))).as("2^" + k).isEqualTo(d);
            assertThat(Double.parseDouble(ShortestDecimal.of(-d))).as("-2^" + k).isEqualTo(-d);
            assertThat(shorterReadsBack(d, ShortestDecimal.search(d))).as("2^" + k).isFalse();
        }
    }

    @Test
    void everyPowerOfTwoReadsBackAsAFloat() {
        for (int k = Float.MIN_EXPONENT - 23; k <= Float.MAX_EXPONENT; k++) {
            float f = Math.scalb(1f, k);
            assertThat(Float.parseFloat(ShortestDecimal.search(f))).as("2^" + k).isEqualTo(f);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"0.001", "0.5", "4.0", "0.3", "9999999.0", "1234567.12345678", "0.00123456789012345", "100.25"})
    void fewDigitsNeedNoSearch(String decimal) {
        assertThat(ShortestDecimal.ofFewDigits(Double.parseDouble(decimal))).isEqualTo(decimal);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.000999, 1e7, 0.1234567890123456, 1.0 / 3, Double.MIN_VALUE, Double.MAX_VALUE, 1e15})
    void allOtherNumbersDo(double d) {
        assertThat(ShortestDecimal.ofFewDigits(d)).isNull();
    }

    @Test
    void decimalsOfUpTo15DigitsAreWrittenAsTheyAre() {
        Random random = new Random(SEED);
        for (int i = 0; i < 10_000; i++) {
            long digits = random.nextLong(1, (long) Math.pow(10, 1 + random.nextInt(15)));
            BigDecimal decimal = BigDecimal.valueOf(digits, random.nextInt(18)).stripTrailingZeros();
            if (decimal.compareTo(new BigDecimal("0.001")) >= 0 && decimal.compareTo(new BigDecimal(10_000_000)) < 0) {
                String text = decimal.scale() > 0 ? decimal.toPlainString() : decimal.toPlainString() + ".0";
                assertThat(ShortestDecimal.search(decimal.doubleValue())).isEqualTo(text);
                assertThat(ShortestDecimal.search(-decimal.doubleValue())).isEqualTo('-' + text);
            }
        }
    }

    @Tag("slow")
    @Test
    void anyDoubleReadsBackAndNothingShorterDoes() {
        Random random = new Random(SEED);
        for (int i = 0; i < SAMPLES; i++) {
            double d = Double.longBitsToDouble(random.nextLong());
            if (Double.isFinite(d)) {
                String decimal = ShortestDecimal.of(d);
                if (Double.parseDouble(decimal) != d || shorterReadsBack(Math.abs(d), decimal)) {
                    throw new AssertionError(decimal + " for " + Double.toHexString(d) + ", seed " + SEED + ", sample " + i);
                }
            }
        }
    }

    @Tag("slow")
    @Test
    void anyFloatReadsBack() {
        Random random = new Random(SEED);
        for (int i = 0; i < SAMPLES; i++) {
            float f = Float.intBitsToFloat(random.nextInt());
            if (Float.isFinite(f) && Float.parseFloat(ShortestDecimal.of(f)) != f) {
                throw new AssertionError(ShortestDecimal.of(f) + " for " + Float.toHexString(f) + ", seed " + SEED);
            }
        }
    }

    @Test
    void theSearchAgreesWithJava19AndLater() {
        assumeTrue(Runtime.version().feature() >= SHORTEST_SINCE, "Double.toString of this runtime is not the shortest");
        Random random = new Random(SEED);
        for (int i = 0; i < SAMPLES; i++) {
            double d = Double.longBitsToDouble(random.nextLong());
            float f = Float.intBitsToFloat(random.nextInt());
            double plain = Math.scalb(random.nextInt(), -random.nextInt(32));
            if (!ShortestDecimal.search(d).equals(Double.toString(d))
                || !ShortestDecimal.search(plain).equals(Double.toString(plain))
                || !ShortestDecimal.search(f).equals(Float.toString(f))) {
                throw new AssertionError(d + " or " + plain + " or " + f + ", seed " + SEED + ", sample " + i);
            }
        }
        for (int k = Double.MIN_EXPONENT - 52; k <= Double.MAX_EXPONENT; k++) {
            double d = Math.scalb(1.0, k);
            assertThat(ShortestDecimal.search(d)).isEqualTo(Double.toString(d));
            assertThat(ShortestDecimal.search(Math.nextDown(d))).isEqualTo(Double.toString(Math.nextDown(d)));
        }
    }

    /**
     * Tells whether one digit less would do. The decimals that read back as d lie in an interval about d; if one with fewer digits
     * is among them, so is d rounded to that many digits, up or down. (With two digits Java's notation is at its shortest.)
     */
    private static boolean shorterReadsBack(double d, String decimal) {
        int digits = new BigDecimal(decimal).stripTrailingZeros().precision();
        if (digits <= 2) {
            return false;
        }
        BigDecimal exact = new BigDecimal(d);
        BigDecimal down = exact.round(new MathContext(digits - 1, RoundingMode.FLOOR));
        BigDecimal up = exact.round(new MathContext(digits - 1, RoundingMode.CEILING));
        return Double.parseDouble(down.toString()) == d || Double.parseDouble(up.toString()) == d;
    }
}
