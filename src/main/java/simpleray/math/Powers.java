package simpleray.math;

/** Powers that are equal on every machine. */
public final class Powers {
    /** Up to here repeated products are as good as a general power, and much faster. */
    private static final int MAX_FACTORS = 64;

    private Powers() {
    }

    /**
     * Returns a power. Small whole exponents, as most highlights have, are computed by squaring (Knuth, "The Art of Computer Programming",
     * volume 2, section 4.6.3), all others by {@link StrictMath#pow}.
     *
     * @param base the base, from 0 to 1
     * @param exponent the exponent, 0 or more
     * @return base to the power of exponent, from 0 to 1; 1 if the exponent is 0
     */
    public static double power(double base, double exponent) {
        int factors = (int) exponent;
        if (factors != exponent || factors > MAX_FACTORS) {
            return StrictMath.pow(base, exponent);
        }
        double product = 1;
        double square = base;
        while (factors > 0) {
            if ((factors & 1) != 0) {
                product *= square;
            }
            square *= square;
            factors >>= 1;
        }
        return product;
    }
}
