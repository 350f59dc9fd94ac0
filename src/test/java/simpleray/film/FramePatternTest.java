package simpleray.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FramePatternTest {
    @ParameterizedTest
    @CsvSource({"film.%04d.png, 7, film.0007.png", "film.%04d.png, 12345, film.12345.png", "%d.png, 0, 0.png", "a/%02d/b.png, 3, a/03/b.png",
        "100%%-%03d.png, 5, 100%-005.png", "%%%d%%.png, 5, %5%.png", "$1\\%d.png, 5, $1\\5.png", "%01d.png, 10, 10.png"})
    void theNumberTakesItsPlace(String pattern, int frame, String name) {
        assertThat(new FramePattern(pattern).name(frame)).isEqualTo(name);
        assertThat(new FramePattern(pattern)).hasToString(pattern);
    }

    @ParameterizedTest
    @CsvSource({"film.png, has no place for the frame's number", "100%%.png, has no place for the frame's number",
        "%d-%d.png, has 2 places for the frame's number", "%s.png, has a % that stands for no number", "%d%.png, has a % that stands for no number",
        "%4d.png, has a % that stands for no number", "%d%x.png, has a % that stands for no number", "%021d.png, has a % that stands for no number"})
    void anythingElseIsRefused(String pattern, String fault) {
        assertThatThrownBy(() -> new FramePattern(pattern)).isInstanceOf(IllegalArgumentException.class).hasMessage("the output " + pattern + ' '
            + fault + ": expected one such as film.%04d.png (%% is a per cent sign), or a .gif, .apng, .mp4 or .webm");
    }

    @Test
    void twentyDigitsAreTheMost() {
        assertThat(new FramePattern("%020d.png").name(1)).isEqualTo("00000000000000000001.png");
    }
}
