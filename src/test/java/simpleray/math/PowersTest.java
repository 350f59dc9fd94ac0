package simpleray.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PowersTest {
    @ParameterizedTest
    @ValueSource(doubles = {0, 1, 2, 5, 63, 64, 65, 1000, 0.5, 2.5, 63.999, 1e300})
    void powersEqualThoseOfTheJdkUpToRounding(double exponent) {
        for (double base : new double[] {0, 1e-300, 0.1, 0.5, 0.99, 1}) {
            double expected = StrictMath.pow(base, exponent);
            assertThat(Powers.power(base, exponent)).as(base + " to the " + exponent).isCloseTo(expected, within(expected * 0x1p-46));
        }
    }

    @Test
    void aPowerOfHalvesIsExact() {
        assertThat(Powers.power(0.5, 10)).isEqualTo(1.0 / 1024);
    }

    @Test
    void zeroToThePowerOfZeroIsOne() {
        assertThat(Powers.power(0, 0)).isEqualTo(1);
    }
}
