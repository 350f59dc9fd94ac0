package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Supplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Each number that is read is to the bit what {@link Double#parseDouble} makes of its word. */
class SceneReaderDecimalsTest {
    private static final int SAMPLES = 40_000;
    private static final long SEED = 2021;

    @Tag("slow")
    @Test
    void anyFormOfDigits() throws IOException {
        Random random = new Random(SEED);
        assertSame(words(() -> sign(random) + digits(random, 1, 25) + '.' + digits(random, 0, 25) + exponent(random)));
        assertSame(words(() -> sign(random) + digits(random, 0, 3) + '.' + digits(random, 1, 8)));
        assertSame(words(() -> sign(random) + "0." + "0".repeat(random.nextInt(30)) + digits(random, 1, 20)));
        assertSame(words(() -> sign(random) + "0".repeat(random.nextInt(30)) + digits(random, 1, 20) + exponent(random)));
    }

    @Tag("slow")
    @Test
    void anyDoubleAsJavaWritesIt() throws IOException {
        Random random = new Random(SEED);
        assertSame(words(() -> {
            double d = Double.longBitsToDouble(random.nextLong());
            return Double.isFinite(d) ? Double.toString(d) : "0";
        }));
        assertSame(words(() -> Double.toString(random.nextGaussian())));
        assertSame(words(() -> Float.toString((float) random.nextGaussian())));
    }

    @Test
    void pointsHalfWayBetweenTwoDoublesAndTheirNeighbours() throws IOException {
        Random random = new Random(SEED);
        List<String> words = new ArrayList<>();
        for (int i = 0; i < SAMPLES / 20; i++) {
            double d = Math.scalb(1 + random.nextDouble(), random.nextInt(100) - 50);
            words.add(half(d).toPlainString());
            words.add(half(d).toString() + '1');
            words.add(half(d).subtract(new BigDecimal(Math.ulp(d)).movePointLeft(30)).toString());
        }
        assertSame(words);
    }

    @Test
    void theEndsOfTheRange() throws IOException {
        List<String> words = new ArrayList<>(List.of("0", "-0", "0.0", "-0.0", "-.0e5", "1.7976931348623157e308", "1.7976931348623158e308",
            "2.2250738585072014e-308", "2.2250738585072012e-308", "2.2250738585072011e-308", "4.9e-324", "2.5e-324", "2.4e-324",
            "2.4703282292062327e-324", "2.4703282292062328e-324", "1e-400", "0e400", "0.0e99999999999",
            "9007199254740993", "9007199254740992.5", "18446744073709551615", "18446744073709551616",
            "9999999999999999999", "0.1e1", "1e22", "1e23", "-1e-22", "8.41E21"));
        for (int k = -330; k <= 308; k++) {
            words.add("1e" + k);
            words.add("9e" + (k - 1));
            words.add("1.2345678901234567e" + (k - 1));
        }
        for (int k = Double.MIN_EXPONENT - 52; k <= Double.MAX_EXPONENT; k++) {
            words.add(Double.toString(Math.scalb(1.0, k)));
            words.add(Double.toString(Math.nextDown(Math.scalb(1.0, k))));
        }
        assertSame(words);
    }

    private static BigDecimal half(double d) {
        return new BigDecimal(d).add(new BigDecimal(Math.ulp(d)).divide(BigDecimal.valueOf(2)));
    }

    private static List<String> words(Supplier<String> some) {
        List<String> words = new ArrayList<>();
        for (int i = 0; i < SAMPLES; i++) {
            words.add(some.get());
        }
        return words;
    }

    /** Reads the words, one to a line, and looks for one that is read otherwise; those too large for a double are left out. */
    private static void assertSame(List<String> words) throws IOException {
        List<String> finite = words.stream().filter(word -> !Double.isInfinite(Double.parseDouble(word))).toList();
        assertThat(finite).isNotEmpty();
        SceneReader is = reader(String.join("\n", finite));
        for (String word : finite) {
            double value = is.readDouble();
            if (Double.doubleToRawLongBits(value) != Double.doubleToRawLongBits(Double.parseDouble(word))) {
                throw new AssertionError(word + " is read as " + value + ", seed " + SEED);
            }
        }
        assertThat(is.eof()).isTrue();
    }

    private static String sign(Random random) {
        return List.of("", "-", "+").get(random.nextInt(3));
    }

    private static String exponent(Random random) {
        return random.nextBoolean() ? "" : (random.nextBoolean() ? "e" : "E") + (random.nextBoolean() ? "+" : "-") + digits(random, 1, 3);
    }

    private static String digits(Random random, int least, int most) {
        StringBuilder digits = new StringBuilder();
        for (int n = least + random.nextInt(most - least + 1); n > 0; n--) {
            digits.append((char) ('0' + random.nextInt(10)));
        }
        return digits.toString();
    }
}
