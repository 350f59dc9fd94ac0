package simpleray.ui.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.LocalTime;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simpleray.image.Picture;
import simpleray.ui.OpenWindow;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

/** Which pictures are kept to be compared. */
class HistoryTest {
    private static final int BYTES = 10 * 10 * 4;

    @WindowTest
    void theLastEightAreKept() {
        History history = new History();
        List<FinishedRender> made = finished(10);
        made.forEach(history::add);

        assertThat(history.pictures()).isEqualTo(made.subList(2, 10));
    }

    @WindowTest
    void theOldestGoWhereThereIsNotRoomForAll() {
        History history = new History(3 * BYTES);
        List<FinishedRender> made = finished(5);
        made.forEach(history::add);

        assertThat(history.pictures()).isEqualTo(made.subList(2, 5));
    }

    @WindowTest
    void aPictureLargerThanTheRoomIsNotKept() {
        History history = new History(BYTES - 1);
        finished(2).forEach(history::add);

        assertThat(history.pictures()).isEmpty();
    }

    @WindowTest
    void onesThatTheMachineTookBackAreGone() {
        History history = new History();
        List<FinishedRender> made = finished(3);
        made.forEach(history::add);
        made.get(1).drop();

        assertThat(history.pictures()).containsExactly(made.get(0), made.get(2));
    }

    private static List<FinishedRender> finished(int count) {
        Picture picture = new Picture(10, 10);
        IntStream.range(0, 10).forEach(y -> picture.setRow(y, new double[30]));
        return IntStream.range(0, count).mapToObj(i -> new FinishedRender(picture, SceneSource.NONE, OpenWindow.request(10, 10), 0,
            LocalTime.of(1, 2, i))).collect(Collectors.toList());
    }
}
