package simpleray.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FrameListTest {
    @Test
    void numbersAndRangesAreTheFramesInOrder() {
        assertThat(FrameList.parse("0-3,7", "frames").stream()).containsExactly(0, 1, 2, 3, 7);
        assertThat(FrameList.parse("9,2-3,3-4,2", "frames").stream()).containsExactly(2, 3, 4, 9);
        assertThat(FrameList.parse("5-5", "frames").stream()).containsExactly(5);
        assertThat(FrameList.parse("999999", "frames").stream()).containsExactly(999999);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", ",", "1,", "3-2", "-1", "1-", "1--2", "a", "1.5", "0-1000000", "1 -2"})
    void anythingElseIsRefused(String text) {
        assertThatThrownBy(() -> FrameList.parse(text, "numbers of frames")).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("expected numbers of frames such as 0-99,120, found '" + text + "'");
    }
}
