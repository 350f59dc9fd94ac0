package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ScanlineQueueTest {
    @Test
    void rowsAreHandedOutFromTheTopEachOnce() {
        ScanlineQueue rows = new ScanlineQueue(5, 1);

        assertThat(next(rows, 7)).containsExactly(0, 1, 2, 3, 4, -1, -1);
    }

    @Test
    void noRowIsBegunFarBelowOneThatIsNotFinished() throws Exception {
        ScanlineQueue rows = new ScanlineQueue(1000, 2);
        assertThat(next(rows, 256)).isEqualTo(IntStream.range(0, 256).boxed().collect(Collectors.toList()));
        for (int y = 1; y < 200; y++) {
            rows.finished(y);                                 // all but the first
        }
        CompletableFuture<Integer> waiting = waiting(rows::next);
        assertThat(waiting).isNotDone();

        rows.finished(0);

        assertThat(waiting.get()).isEqualTo(256);
        assertThat(next(rows, 199)).hasSize(199).endsWith(455);   // 200 are finished: up to 200 + 256
        assertThat(waiting(rows::next)).isNotDone();
        rows.stop();
    }

    @Test
    void stopEndsTheWaiting() throws Exception {
        ScanlineQueue rows = new ScanlineQueue(1000, 2);
        next(rows, 256);
        CompletableFuture<Integer> waiting = waiting(rows::next);

        rows.stop();

        assertThat(waiting.get()).isEqualTo(-1);
        assertThat(rows.next()).isEqualTo(-1);
    }

    @Test
    void afterTheLastRowNoThreadWaits() {
        ScanlineQueue rows = new ScanlineQueue(256, 2);
        next(rows, 256);

        assertThat(rows.next()).isEqualTo(-1);
    }

    @Test
    void manyThreadsMayBeginMoreRows() {
        assertThat(ScanlineQueue.ahead(1)).isEqualTo(256);
        assertThat(ScanlineQueue.ahead(64)).isEqualTo(256);
        assertThat(ScanlineQueue.ahead(1024)).isEqualTo(4096);
    }

    /** {@return a result to come, from a thread that waits for it by now} */
    static <T> CompletableFuture<T> waiting(Supplier<T> source) throws InterruptedException {
        CompletableFuture<T> next = new CompletableFuture<>();
        Thread thread = new Thread(() -> next.complete(source.get()));
        thread.setDaemon(true);
        thread.start();
        while (thread.getState() != Thread.State.WAITING && thread.isAlive()) {
            Thread.sleep(1);
        }
        return next;
    }

    private static List<Integer> next(ScanlineQueue rows, int count) {
        List<Integer> next = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            next.add(rows.next());
        }
        return next;
    }
}
