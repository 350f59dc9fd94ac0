package simpleray.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FrameRateTest {
    /** A frame of 24 a second is shown for 4.1666 hundredths: for four, and each sixth for five. */
    @Test
    void hundredthsAreSpreadSoThatTheFilmKeepsItsRate() {
        FrameRate rate = new FrameRate(24);

        assertThat(IntStream.range(0, 12).mapToLong(rate::hundredths).toArray()).containsExactly(4, 4, 5, 4, 4, 4, 4, 4, 5, 4, 4, 4);
        assertThat(IntStream.range(0, 240).mapToLong(rate::hundredths).sum()).isEqualTo(1000);
    }

    @ParameterizedTest
    @CsvSource({"25, 4", "50, 2", "100, 1", "1, 100", "0.5, 200", "1000, 0"})
    void ofAWholeNumberOfHundredthsAllFramesHaveIt(double fps, long hundredths) {
        assertThat(new FrameRate(fps).hundredths(0)).isEqualTo(hundredths);
    }

    @ParameterizedTest
    @CsvSource({"24, 65535, 24/1", "25, 65535, 25/1", "29.97, 65535, 2997/100", "23.976, 65535, 2997/125", "0.5, 65535, 1/2", "1000, 65535, 1000/1",
        "1000, 1000, 1000/1", "29.97002997002997, 65535, 30000/1001", "0.3333333333333333, 65535, 1/3", "0.001, 65535, 1/1000",
        "3.141592653589793, 65535, 355/113", "3.141592653589793, 355, 355/113", "3.141592653589793, 354, 333/106"})
    void asAFraction(double fps, int max, String fraction) {
        assertThat(new FrameRate(fps).fraction(max)).hasToString(fraction);
    }

    @Test
    void aFrameThatIsShownForTooLongIsRefused() {
        assertThat(new FrameRate(1 / 65535.0).fraction(65535)).hasToString("1/65535");
        assertThatThrownBy(() -> new FrameRate(1e-5).fraction(65535)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("a frame is shown for at most 65535 s, and 1.0E-5 frames a second are fewer");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, 1000.1, Double.NaN, Double.POSITIVE_INFINITY})
    void otherRatesAreRefused(double fps) {
        assertThatThrownBy(() -> new FrameRate(fps)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("the frames a second must be above 0 and at most 1000, and are " + fps);
    }
}
