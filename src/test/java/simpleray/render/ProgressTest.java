package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ProgressTest {
    private static final long SECOND = 1_000_000_000L;
    /** Times of {@link System#nanoTime} may be anything, and wrap round. */
    private static final long START = Long.MAX_VALUE - SECOND;

    @Test
    void rowsAreCountedOneByOne() {
        Progress progress = finished(3, 2);

        assertThat(progress.rows()).isEqualTo(3);
        assertThat(progress.finished()).isEqualTo(2);
    }

    @ParameterizedTest
    @CsvSource({"3, 0, 0", "3, 1, 33", "3, 2, 66", "3, 3, 100", "200, 199, 99", "200, 1, 0"})
    void thePercentageIsRoundedDown(int rows, int finished, int percent) {
        assertThat(finished(rows, finished).percent()).isEqualTo(percent);
    }

    @Test
    void thePercentageOfManyRowsDoesNotOverflow() {
        // 100 · 22 000 000 is more than an int holds
        assertThat(finished(44_000_000, 22_000_000).percent()).isEqualTo(50);
    }

    @Test
    void timeElapsesFromTheStart() {
        assertThat(finished(4, 0).elapsed(START)).isZero();
        assertThat(finished(4, 0).elapsed(START + 3 * SECOND / 2)).isEqualTo(1.5);
        assertThat(Progress.seconds(5, 5 + SECOND / 4)).isEqualTo(0.25);
    }

    @Test
    void theRowsLeftWillTakeAsLongAsThoseFinished() {
        // 1 of 4 rows in 2 s: 3 more take 6 s; 4 of 4: nothing is left
        assertThat(finished(4, 1).left(START + 2 * SECOND)).isEqualTo(6);
        assertThat(finished(4, 4).left(START + 2 * SECOND)).isZero();
    }

    @Test
    void beforeTheFirstRowTheTimeLeftIsUnknown() {
        assertThat(finished(4, 0).left(START + 2 * SECOND)).isNaN();
    }

    @Test
    void anyThreadMayCount() {
        Progress progress = new Progress(100_000, START);

        IntStream.range(0, 100_000).parallel().forEach(i -> progress.rowFinished());

        assertThat(progress.finished()).isEqualTo(100_000);
    }

    @ParameterizedTest
    @CsvSource({"0, 0.0 s", "0.04, 0.0 s", "0.3, 0.3 s", "9.94, 9.9 s", "9.96, 10 s", "12.4, 12 s", "59.4, 59 s", "59.6, 1:00 min",
        "60, 1:00 min", "185, 3:05 min", "3599.4, 59:59 min", "3599.6, 1:00:00 h", "3723, 1:02:03 h", "360000, 100:00:00 h",
        "NaN, ?"})
    void timesAreFormattedForPeople(double seconds, String text) {
        assertThat(Progress.time(seconds)).isEqualTo(text);
    }

    private static Progress finished(int rows, int finished) {
        Progress progress = new Progress(rows, START);
        for (int i = 0; i < finished; i++) {
            progress.rowFinished();
        }
        return progress;
    }
}
