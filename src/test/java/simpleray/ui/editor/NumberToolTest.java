package simpleray.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What a drag over some pixels makes of a number. */
class NumberToolTest {
    @ParameterizedTest
    @CsvSource({"0.50,1,0.501", "0.50,10,0.51", "0.50,-50,0.45", "0.535,1,0.536", "1,1,1.01", "1,100,2", "1.0,100,2.0", "35,10,36",
        "200,-1,199", "0,3,0.03", "0.0,-100,-1.0", "-0.6,100,-0.5", "1e-3,1,0.00101", "2E+30,10,2.1E+30", "-1,100,0"})
    void aStepIsAHundredthOfTheFirstDigitAndDigitsStay(String number, int pixels, String expected) {
        BigDecimal first = new BigDecimal(number);
        BigDecimal by = NumberTool.step(first, false).multiply(BigDecimal.valueOf(pixels));

        assertThat(NumberTool.text(first, by)).isEqualTo(expected);
    }

    @ParameterizedTest
    @CsvSource({"9,1,10", "400,-2,398", "1,-1,0"})
    void anIntegerStaysOne(String number, int steps, String expected) {
        BigDecimal first = new BigDecimal(number);

        assertThat(NumberTool.text(first, NumberTool.step(first, true).multiply(BigDecimal.valueOf(steps)))).isEqualTo(expected);
    }
}
