package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Numbers for people. */
class RoundedDecimalTest {
    @ParameterizedTest
    @CsvSource({"0,0", "-0.0,0", "1,1", "0.5,0.5", "0.12345,0.123", "0.0625,0.0625", "0.9996,1", "-2.345,-2.35", "100,100", "999.6,1000",
        "1234.5,1235",
        "123456.7,123457", "12345678901,1.23E+10", "0.00000012345,1.23E-7", "0.00012345,0.000123", "NaN,NaN", "-Infinity,-Infinity"})
    void threeDigitsAreLeftOrAllBeforeThePoint(double d, String text) {
        assertThat(RoundedDecimal.of(d, 3)).isEqualTo(text);
    }

    @Test
    void threeNumbersHaveSpacesBetween() {
        assertThat(RoundedDecimal.of(1.0 / 3, 2.0 / 3, 5, 6)).isEqualTo("0.333333 0.666667 5");
    }
}
