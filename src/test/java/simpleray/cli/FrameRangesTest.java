package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FrameRangesTest {
    @ParameterizedTest
    @CsvSource({"'7', '7-7', 1", "'0-99,120', '0-99,120-120', 101", "'5,3', '3-3,5-5', 2", "'3,4', '3-4', 2", "'0-5,3-9', '0-9', 10",
        "'0-9,3-5', '0-9', 10", "'3-3,1-2', '1-3', 3", "'0-999999', '0-999999', 1000000"})
    void rangesAreSortedAndJoined(String text, String ranges, int count) {
        FrameRanges frames = FrameRanges.parse(text);

        assertThat(frames).hasToString(ranges);
        assertThat(frames.count()).isEqualTo(count);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", ",", "1,", "a", "-1", "1-", "5-3", "1-2-3", "1.5", " 1", "1000000", "1 2", "0x1", "99999999999"})
    void whatIsNoListIsRefused(String text) {
        assertThatIllegalArgumentException().isThrownBy(() -> FrameRanges.parse(text)).withMessageEndingWith(", found '" + text + "'");
    }

    @ParameterizedTest
    @CsvSource({"0, 2", "1, 3", "2, 8", "3, 9"})
    void framesAreCountedOverAllRanges(int before, int frame) {
        assertThat(FrameRanges.parse("2-3,8-9").frame(before)).isEqualTo(frame);
        assertThatThrownBy(() -> FrameRanges.parse("2-3,8-9").frame(4)).isInstanceOf(IndexOutOfBoundsException.class);
    }

    @Test
    void allFramesBeginWithTheFirst() {
        assertThat(FrameRanges.all(24)).hasToString("0-23");
        assertThat(FrameRanges.all(24).last()).isEqualTo(23);
    }
}
