package simpleray.text;

import java.math.BigInteger;

/** Finds the double nearest to a decimal of up to 19 digits, mostly. */
final class Decimal {
    /** Powers of ten that are doubles. */
    private static final double[] POWERS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17,
        1e18, 1e19, 1e20, 1e21, 1e22};
    private static final int FRACTION_BITS = 52;
    private static final int BIAS = 1023;

    private Decimal() {
    }

    /**
     * Finds digits · 10^power, rounded to the nearest double, to the even one of two.
     *
     * @param digits an unsigned integer
     * @param power the power of ten
     * @return the double; NaN if this is a case for {@link Double#parseDouble}
     */
    static double toDouble(long digits, int power) {
        if (digits >>> (FRACTION_BITS + 1) == 0 && power >= 1 - POWERS.length && power < POWERS.length) {
            // both are doubles, and so the one rounding is that of the result (Clinger, "How to Read Floating Point Numbers
            // Accurately", 1990)
            return power < 0 ? digits / POWERS[-power] : digits * POWERS[power];
        }
        if (digits == 0) {
            return 0;
        }
        return power < -Fives.MAX || power > Fives.MAX ? Double.NaN : byProduct(digits, power);
    }

    /**
     * Multiplies by 128 bits of the power of five. These are cut off, so that the true product is up to two units of the last bit of
     * hi:lo above it: only where that might tip the rounding is the result in doubt (an idea of Lemire, "Number Parsing at a Gigabyte
     * per Second", 2021).
     */
    private static double byProduct(long digits, int power) {
        int zeros = Long.numberOfLeadingZeros(digits);
        long w = digits << zeros;
        long high = Fives.HIGH[power + Fives.MAX];
        long low = w * high;
        long lo = low + multiplyHigh(w, Fives.LOW[power + Fives.MAX]);
        long hi = multiplyHigh(w, high) + (Long.compareUnsigned(lo, low) < 0 ? 1 : 0);

        int below = Long.SIZE - FRACTION_BITS - 1 - (hi < 0 ? 0 : 1);      // the bits of hi that are to be rounded away
        long half = 1L << (below - 1);
        long rest = hi & ((1L << below) - 1);
        if (rest == half && lo == 0 || rest == half - 1 && lo == -1) {
            return Double.NaN;
        }
        long mantissa = (hi >>> below) + (rest >= half ? 1 : 0);
        long exponent = (long) Fives.EXPONENT[power + Fives.MAX] + power + Long.SIZE - zeros + below + FRACTION_BITS + BIAS;
        return Double.longBitsToDouble((exponent << FRACTION_BITS) + mantissa - (1L << FRACTION_BITS));
    }

    /** {@return the upper half of an unsigned product} */
    private static long multiplyHigh(long a, long b) {
        return Math.multiplyHigh(a, b) + ((a >> (Long.SIZE - 1)) & b) + ((b >> (Long.SIZE - 1)) & a);
    }

    /** The powers of five, 5^k = (HIGH + LOW / 2^64) · 2^EXPONENT at index k + MAX, cut off there; made when first they are needed. */
    private static final class Fives {
        static final int MAX = 64;
        static final long[] HIGH = new long[2 * MAX + 1];
        static final long[] LOW = new long[2 * MAX + 1];
        static final int[] EXPONENT = new int[2 * MAX + 1];

        static {
            for (int k = -MAX; k <= MAX; k++) {
                BigInteger power = BigInteger.valueOf(5).pow(Math.abs(k));
                int exponent = (k < 0 ? 1 - power.bitLength() : power.bitLength()) - Long.SIZE;
                int shift = Long.SIZE - exponent;
                BigInteger bits = k < 0 ? BigInteger.ONE.shiftLeft(shift).divide(power) : power.shiftLeft(shift);
                HIGH[k + MAX] = bits.shiftRight(Long.SIZE).longValue();
                LOW[k + MAX] = bits.longValue();
                EXPONENT[k + MAX] = exponent;
            }
        }
    }
}
