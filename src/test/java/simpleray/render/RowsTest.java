package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RowsTest {
    @Test
    void rowsAreHandedOutFromTheTopEachOnce() {
        Rows rows = new Rows(5, 1);

        assertThat(next(rows, 7)).containsExactly(0, 1, 2, 3, 4, -1, -1);
    }

    @Test
    void noRowIsBegunFarBelowOneThatIsNotFinished() throws Exception {
        Rows rows = new Rows(1000, 2);
        assertThat(next(rows, 256)).isEqualTo(IntStream.range(0, 256).boxed().collect(Collectors.toList()));
        for (int y = 1; y < 200; y++) {
            rows.finished(y);                                 // all but the first
        }
        CompletableFuture<Integer> waiting = waiting(rows);
        assertThat(waiting).isNotDone();

        rows.finished(0);

        assertThat(waiting.get()).isEqualTo(256);
        assertThat(next(rows, 199)).hasSize(199).endsWith(455);   // 200 are finished: up to 200 + 256
        assertThat(waiting(rows)).isNotDone();
        rows.stop();
    }

    @Test
    void toStopEndsTheWaiting() throws Exception {
        Rows rows = new Rows(1000, 2);
        next(rows, 256);
        CompletableFuture<Integer> waiting = waiting(rows);

        rows.stop();

        assertThat(waiting.get()).isEqualTo(-1);
        assertThat(rows.next()).isEqualTo(-1);
    }

    @Test
    void afterTheLastRowNobodyWaits() {
        Rows rows = new Rows(256, 2);
        next(rows, 256);

        assertThat(rows.next()).isEqualTo(-1);
    }

    @Test
    void manyThreadsMayBeginMoreRows() {
        assertThat(Rows.ahead(1)).isEqualTo(256);
        assertThat(Rows.ahead(64)).isEqualTo(256);
        assertThat(Rows.ahead(1024)).isEqualTo(4096);
    }

    /** {@return the next row, once there is one, from a thread that waits for it by now} */
    private static CompletableFuture<Integer> waiting(Rows rows) throws InterruptedException {
        CompletableFuture<Integer> next = new CompletableFuture<>();
        Thread thread = new Thread(() -> next.complete(rows.next()));
        thread.setDaemon(true);
        thread.start();
        while (thread.getState() != Thread.State.WAITING && thread.isAlive()) {
            Thread.sleep(1);
        }
        return next;
    }

    private static List<Integer> next(Rows rows, int count) {
        List<Integer> next = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            next.add(rows.next());
        }
        return next;
    }
}
