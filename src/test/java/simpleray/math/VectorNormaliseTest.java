package simpleray.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The length that {@link Vector#normalise} returns. */
class VectorNormaliseTest {
    /** A few roundings of numbers near 1. */
    private static final double ROUNDING = 4e-16;

    @ParameterizedTest
    @ValueSource(doubles = {1e-300, 1e-200, 1e-155, 1e-10, 1, 1e10, 1e155, 1e200, 1e300})
    void normaliseReturnsTheLengthBefore(double size) {
        Vector v = new Vector(2 * size, -3 * size, 6 * size);     // 2² + 3² + 6² = 7²

        assertThat(v.measureAndNormalise() / (7 * size)).isEqualTo(1, within(ROUNDING));
        assertThat(v.x).isEqualTo(2.0 / 7, within(ROUNDING));
        assertThat(v.y).isEqualTo(-3.0 / 7, within(ROUNDING));
        assertThat(v.z).isEqualTo(6.0 / 7, within(ROUNDING));
    }

    @Test
    void aZeroVectorHasTheLengthZeroAndStaysZero() {
        Vector v = new Vector();

        assertThat(v.measureAndNormalise()).isZero();
        assertThat(v).hasToString("[0.0,0.0,0.0]");
    }

    @Test
    void anInfiniteVectorHasAnInfiniteLengthAndStaysAsItIs() {
        Vector v = new Vector(1, Double.NEGATIVE_INFINITY, 0);

        assertThat(v.measureAndNormalise()).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(v.norm()).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(v).hasToString("[1.0,-Infinity,0.0]");
    }
}
