package simpleray.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class VectorLengthTest {
    /** A few roundings of numbers near 1. */
    private static final double ROUNDING = 4e-16;

    @Test
    void theNormIsTheLength() {
        // 2² + 3² + 6² = 7²
        assertThat(new Vector(2, -3, 6).norm()).isEqualTo(7);
        assertThat(new Vector(2, -3, 6).squarednorm()).isEqualTo(49);
        assertThat(new Vector().norm()).isZero();
        assertThat(new Vector().squarednorm()).isZero();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-320, 1e-300, 1e-200, 1e-155, 1e-10, 1, 1e10, 1e155, 1e200, 1e300})
    void theNormIsRightForTheSmallestAndTheLargest(double size) {
        assertThat(new Vector(3 * size, 0, -4 * size).norm() / (5 * size)).isEqualTo(1, within(size < 1e-310 ? 1e-3 : ROUNDING));
        assertThat(new Vector(0, size, 0).norm() / size).isEqualTo(1, within(ROUNDING));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-300, 1e-200, 1e-155, 1e-10, 1, 1e10, 1e155, 1e200, 1e300})
    void normaliseGivesTheLengthOneAndKeepsTheDirection(double size) {
        Vector v = new Vector(3 * size, 0, -4 * size);
        v.normalise();

        assertThat(v.x).isEqualTo(0.6, within(ROUNDING));
        assertThat(v.y).isZero();
        assertThat(v.z).isEqualTo(-0.8, within(ROUNDING));
    }

    @Test
    void theSmallestDoubleCanBeNormalised() {
        Vector v = new Vector(0, -Double.MIN_VALUE, 0);
        v.normalise();
        assertThat(v.y).isEqualTo(-1);
    }

    @Test
    void theLargestDoublesCanBeNormalised() {
        // three equal components: 1/√3 each
        Vector v = new Vector(Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE);
        v.normalise();
        assertThat(v.x).isEqualTo(1 / Math.sqrt(3), within(ROUNDING));
        assertThat(v.z).isEqualTo(-1 / Math.sqrt(3), within(ROUNDING));
    }

    @Test
    void aZeroVectorStaysZero() {
        Vector v = new Vector();
        v.normalise();
        assertThat(v).hasToString("[0.0,0.0,0.0]");
        assertThat(v.normalised()).hasToString("[0.0,0.0,0.0]");
    }

    @Test
    void normalisedLeavesTheVectorAsItIs() {
        Vector v = new Vector(0, 0, -5);

        assertThat(v.normalised().z).isEqualTo(-1);
        assertThat(v).hasToString("[0.0,0.0,-5.0]");
    }
}
