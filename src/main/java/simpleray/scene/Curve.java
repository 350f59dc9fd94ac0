package simpleray.scene;

import java.util.Locale;

/** The way in which a channel of a film goes from one key to the next. */
public enum Curve {
    /** At the same pace all the way. */
    LINEAR {
        @Override
        double between(double u, double length, double v0, double m0, double v1, double m1) {
            return v0 + u * (v1 - v0);
        }
    },
    /** Without a bend at a key, and at rest at the first and the last one: a cubic Hermite spline. */
    SMOOTH {
        /** {@inheritDoc} The cubic's (2u³ - 3u² + 1) v0 is 1 - (3u² - 2u³) of it here, so that equal values stay the same to the last bit. */
        @Override
        double between(double u, double length, double v0, double m0, double v1, double m1) {
            double share = u * u * (3 - 2 * u);
            double bend = u * (1 - u) * ((1 - u) * m0 - u * m1);
            return v0 + share * (v1 - v0) + length * bend;
        }
    };

    private final String word = name().toLowerCase(Locale.ROOT);

    /**
     * Computes a value between two keys.
     *
     * @param u the share of the way from one key to the other, above 0 and below 1
     * @param length the frames from one key to the other
     * @param v0 the value at the first key
     * @param m0 the tangent there, in values a frame
     * @param v1 the value at the second key
     * @param m1 the tangent there
     * @return the value
     */
    abstract double between(double u, double length, double v0, double m0, double v1, double m1);

    /** {@return its word in a scene file} */
    @Override
    public String toString() {
        return word;
    }
}
