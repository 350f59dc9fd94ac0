package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import java.util.function.LongSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Digits and powers of ten against {@link Double#parseDouble}; NaN leaves it to that. */
class NumberParserNearestTest {
    private static final int SAMPLES = 50_000;
    private static final long SEED = 19900620;

    @ParameterizedTest
    @CsvSource({"0, 0, 0.0", "5, -1, 0.5", "123456, -3, 123.456", "9007199254740991, 22, 9.007199254740991E37",
        "9007199254740992, 0, 9.007199254740992E15", "17976931348623157, -17, 0.17976931348623157", "3, 23, 3.0E23", "1, -23, 1.0E-23",
        "1, 64, 1.0E64", "1, -64, 1.0E-64", "0, 9999, 0.0"})
    void aDecimalIsItsNearestDouble(long digits, int power, double value) {
        assertThat(NumberParser.nearest(digits, power)).isEqualTo(value);
    }

    @ParameterizedTest
    @CsvSource({"9007199254740993, 0", "9007199254740995, 0", "18014398509481986, 0", "1, 65", "1, -65", "1, 400", "1, -9999",
        "90071992547409930, -1"})
    void halfWayBetweenTwoDoublesAndFarFromOneItIsLeftToJava(long digits, int power) {
        assertThat(NumberParser.nearest(digits, power)).isNaN();
    }

    @Test
    void anyDigitsAreTheDoubleThatJavaFinds() {
        Random random = new Random(SEED);
        assertThat(disagreeing(random, random::nextLong, 64)).isEmpty();
        assertThat(disagreeing(random, () -> random.nextLong() >>> random.nextInt(Long.SIZE), 30)).isEmpty();
        assertThat(disagreeing(random, () -> random.nextInt(1_000_000), 30)).isEmpty();
    }

    @Tag("slow")
    @Test
    void soAreDigitsNextToAPointHalfWay() {
        Random random = new Random(SEED);
        // 54 bits, the last of them 1: half-way between two doubles; and its neighbours
        assertThat(disagreeing(random, () -> (((random.nextLong() | Long.MIN_VALUE) >>> 10) | 1) * 2 + random.nextInt(3) - 1, 0)).isEmpty();
        // the decimals of points half-way, cut after 19 digits: so near that 128 bits are needed to tell
        for (int i = 0; i < SAMPLES; i++) {
            BigDecimal near = halfWay(random);
            String decimal = near.unscaledValue() + "e" + -near.scale();
            double value = NumberParser.nearest(near.unscaledValue().longValue(), -near.scale());
            assertThat(value).as(decimal + ", seed " + SEED).isIn(Double.parseDouble(decimal), Double.NaN);
        }
    }

    private static BigDecimal halfWay(Random random) {
        long bits = random.nextLong() >>> 11 | 1L << 52;
        return new BigDecimal(2 * bits + 1).multiply(BigDecimal.valueOf(2).pow(random.nextInt(60))).round(new MathContext(19));
    }

    @Test
    void ofTheShortestDecimalsNearlyNoneIsLeftToJava() {
        Random random = new Random(SEED);
        int left = 0;
        for (int i = 0; i < SAMPLES; i++) {
            double d = random.nextGaussian();
            BigDecimal decimal = new BigDecimal(Double.toString(Math.abs(d)));
            double value = NumberParser.nearest(decimal.unscaledValue().longValueExact(), -decimal.scale());
            left += Double.isNaN(value) ? 1 : 0;
            assertThat(value).as("sample " + i + ", seed " + SEED).isIn(Math.abs(d), Double.NaN);
        }
        assertThat(left).isLessThan(SAMPLES / 1000);
    }

    /** {@return the first decimal of which something else is made than by Java; empty if there is none} */
    private static String disagreeing(Random random, LongSupplier someDigits, int mostPower) {
        for (int i = 0; i < SAMPLES; i++) {
            long digits = someDigits.getAsLong();
            int power = random.nextInt(2 * mostPower + 1) - mostPower;
            double value = NumberParser.nearest(digits, power);
            String decimal = Long.toUnsignedString(digits) + 'e' + power;
            if (!Double.isNaN(value) && Double.compare(value, Double.parseDouble(decimal)) != 0) {
                return decimal + " gives " + value + ", seed " + SEED + ", sample " + i;
            }
        }
        return "";
    }
}
