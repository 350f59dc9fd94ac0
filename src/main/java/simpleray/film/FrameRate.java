package simpleray.film;

import simpleray.scene.Film;

/**
 * How many frames a second a film has. <em>Constant.</em>
 *
 * @param fps frames a second, above 0 and up to {@link Film#MAX_RATE}
 */
public record FrameRate(double fps) {
    private static final int HUNDREDTHS = 100;
    /** A fraction that is as near counts as exact: 29.97 is 2997/100. */
    private static final double NEAR = 1e-12;

    /**
     * A fraction. <em>Constant.</em>
     *
     * @param numerator above 0
     * @param denominator above 0
     */
    public record Fraction(int numerator, int denominator) {
        @Override
        public String toString() {
            return numerator + "/" + denominator;
        }
    }

    /**
     * Checks the range.
     *
     * @param fps frames a second
     * @throws IllegalArgumentException if it is out of its range
     */
    public FrameRate {
        if (!(fps > 0 && fps <= Film.MAX_RATE)) {
            throw new IllegalArgumentException("the frames a second must be above 0 and at most 1000, and are " + fps);
        }
    }

    /**
     * Returns how long a frame is shown in a file that counts in hundredths of a second. Each frame ends at the hundredth that is nearest to its
     * end, so that errors do not add up.
     *
     * @param frame the frame, from 0
     * @return hundredths of a second
     */
    public long hundredths(int frame) {
        return end(frame) - end(frame - 1);
    }

    private long end(int frame) {
        return Math.round(HUNDREDTHS * (frame + 1L) / fps);
    }

    /**
     * Returns the rate as a fraction of small numbers: the first convergent of its continued fraction that is as good as exact, or the last
     * one of numbers that are not too large (Khinchin, "Continued Fractions", 1935).
     *
     * @param max the largest numerator and denominator
     * @return frames a second
     * @throws IllegalArgumentException if the rate is less than one frame in so many seconds
     */
    public Fraction fraction(int max) {
        long p = 1;
        long q = 0;
        long before = 0;
        long below = 1;
        double rest = fps;
        while (q == 0 || Math.abs(fps - (double) p / q) > NEAR * fps) {
            double whole = Math.floor(rest);
            double nextP = whole * p + before;
            double nextQ = whole * q + below;
            if (nextP > max || nextQ > max) {
                break;
            }
            before = p;
            below = q;
            p = (long) nextP;
            q = (long) nextQ;
            rest = 1 / (rest - whole);
        }
        if (p == 0) {
            throw new IllegalArgumentException("a frame is shown for at most " + max + " s, and " + fps + " frames a second are fewer");
        }
        return new Fraction((int) p, (int) q);
    }
}
