package simpleray.text;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Numbers for people: rounded, the same on every Java. */
public final class RoundedDecimal {
    private static final int LARGE = 9;
    private static final int SMALL = -6;

    private RoundedDecimal() {
    }

    /**
     * Writes a number. No digit before the decimal point is rounded away: of three digits 1234.5 is 1235, and 0.12345 is 0.123.
     *
     * @param d the number
     * @param digits how many significant digits it is rounded to, 1 or more
     * @return its digits; with a power of ten if it is 1E10 or more, or below 1E-6
     */
    public static String of(double d, int digits) {
        if (d == 0 || Double.isNaN(d) || Double.isInfinite(d)) {
            return d == 0 ? "0" : Double.toString(d);
        }
        BigDecimal exact = new BigDecimal(d);
        int before = exact.precision() - exact.scale();
        BigDecimal rounded = exact.round(new MathContext(before > LARGE + 1 ? digits : Math.max(digits, before), RoundingMode.HALF_UP))
            .stripTrailingZeros();
        int exponent = rounded.precision() - rounded.scale() - 1;
        return exponent > LARGE || exponent < SMALL ? rounded.toString() : rounded.toPlainString();
    }

    /**
     * Writes three numbers, such as a colour or a point.
     *
     * @param a the first
     * @param b the second
     * @param c the third
     * @param digits how many significant digits each is rounded to, 1 or more
     * @return the three, with spaces between
     */
    public static String of(double a, double b, double c, int digits) {
        return of(a, digits) + ' ' + of(b, digits) + ' ' + of(c, digits);
    }
}
