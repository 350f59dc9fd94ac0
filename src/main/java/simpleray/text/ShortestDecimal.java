package simpleray.text;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.function.Predicate;

/**
 * The shortest decimal that reads back as the same number, in the notation of {@link Double#toString(double)} since JDK 19
 * (Raffaello Giulietti, "The Schubfach way to render doubles", 2020). On older runtimes, whose {@code toString} is at times
 * longer, it is found here by trying one digit after another.
 */
public final class ShortestDecimal {
    private static final boolean PLATFORM_IS_SHORTEST = Runtime.version().feature() >= 19;
    /** No double needs more digits than these to be told from its neighbours. */
    private static final int DOUBLE_DIGITS = 17;
    private static final int FLOAT_DIGITS = 9;

    private ShortestDecimal() {
    }

    /**
     * Writes a number.
     *
     * @param d the number
     * @return the shortest decimal that reads back as the same number
     */
    public static String of(double d) {
        return PLATFORM_IS_SHORTEST ? Double.toString(d) : search(d);
    }

    static String of(float f) {
        return PLATFORM_IS_SHORTEST ? Float.toString(f) : search(f);
    }

    /** {@return what {@link Double#toString(double)} gives since JDK 19} */
    static String search(double d) {
        if (d == 0 || Double.isNaN(d) || Double.isInfinite(d)) {
            return Double.toString(d);
        }
        double size = Math.abs(d);
        String plain = ofFewDigits(size);
        return (d < 0 ? "-" : "")
            + (plain != null ? plain : search(new BigDecimal(size), DOUBLE_DIGITS, c -> Double.parseDouble(c.toString()) == size));
    }

    /**
     * Returns the shortest decimal of at most 15 digits, as nearly all numbers that people write. At most one of them reads back as a
     * given double; n / 10^k is that double, since both are exact and a quotient is rounded correctly (Clinger, "How to Read Floating
     * Point Numbers Accurately", 1990).
     *
     * @param size a positive number
     * @return the decimal; null if it has more digits, or is written with an exponent
     */
    static String ofFewDigits(double size) {
        double power = 1;
        for (int decimals = 0; size >= 1e-3 && size < 1e7 && size * power < 1e15; decimals++) {
            double n = Math.rint(size * power);
            if (n / power == size) {
                long whole = (long) n / (long) power;
                String fraction = Long.toString((long) n % (long) power);
                return whole + "." + "0".repeat(Math.max(0, decimals - fraction.length())) + fraction;
            }
            power *= 10;
        }
        return null;
    }

    /** {@return what {@link Float#toString(float)} gives since JDK 19} */
    static String search(float f) {
        if (f == 0 || Float.isNaN(f) || Float.isInfinite(f)) {
            return Float.toString(f);
        }
        float size = Math.abs(f);
        return (f < 0 ? "-" : "") + search(new BigDecimal(size), FLOAT_DIGITS, c -> Float.parseFloat(c.toString()) == size);
    }

    /** Tries two digits first: Java's notation always shows two, and takes the nearest such number. */
    private static String search(BigDecimal exact, int most, Predicate<BigDecimal> readsBack) {
        for (int digits = 2; digits < most; digits++) {
            BigDecimal nearest = exact.round(new MathContext(digits, RoundingMode.HALF_EVEN));
            if (readsBack.test(nearest)) {
                return notation(nearest);
            }
            // At a power of two the numbers that read back as it reach further up than down: the nearest may miss, and the next above hit.
            BigDecimal above = exact.round(new MathContext(digits, RoundingMode.CEILING));
            if (readsBack.test(above)) {
                return notation(above);
            }
        }
        return notation(exact.round(new MathContext(most, RoundingMode.HALF_EVEN)));
    }

    /** {@return the positive decimal in Java's notation: plain from 1.0E-3 to below 1.0E7, else with an exponent} */
    private static String notation(BigDecimal value) {
        BigDecimal v = value.stripTrailingZeros();
        String digits = v.unscaledValue().toString();
        int point = digits.length() - v.scale();              // value = 0.DIGITS × 10^point
        if (point > -3 && point <= 0) {
            return "0." + "0".repeat(-point) + digits;
        }
        if (point > 0 && point <= 7) {
            String padded = digits + "0".repeat(Math.max(0, point + 1 - digits.length()));
            return padded.substring(0, point) + '.' + padded.substring(point);
        }
        return digits.charAt(0) + "." + (digits.length() > 1 ? digits.substring(1) : "0") + 'E' + (point - 1);
    }
}
