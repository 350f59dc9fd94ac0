package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import javax.swing.Timer;
import org.junit.jupiter.api.Test;

/** The event thread is never blocked. */
class EventThreadTest {
    private static final int TICK = 5;
    private static final double MAX = 1;

    @Test
    void itAnswersWhileRowsTakeForEver() {
        TestScenes.Gate gate = new TestScenes.Gate(0);
        try (OpenWindow window = new OpenWindow(TestScenes.watched(TestScenes.THESIS, gate), 200, 200)) {
            assertThat(longestSilence(100)).isLessThan(MAX);
            assertThat(window.rendering().state()).isEqualTo(Rendering.State.RENDERING);
            gate.open();
        } finally {
            gate.open();
        }
    }

    @Test
    void itAnswersWhileALargePictureIsRendered() {
        try (OpenWindow window = new OpenWindow(SceneSource.file(TestScenes.MIRRORS), 3200, 2400)) {
            assertThat(longestSilence(100)).isLessThan(MAX);
            assertThat(window.rendering().state()).isEqualTo(Rendering.State.RENDERING);
        }
    }

    /** {@return the longest time in seconds between two of that many ticks, which come every 5 ms to an event thread that is free} */
    private static double longestSilence(int ticks) {
        CountDownLatch left = new CountDownLatch(ticks);
        AtomicLong longest = new AtomicLong();
        AtomicLong last = new AtomicLong(System.nanoTime());
        Timer timer = new Timer(TICK, e -> {
            long now = System.nanoTime();
            longest.accumulateAndGet(now - last.getAndSet(now), Math::max);
            left.countDown();
        });
        timer.start();
        Screen.until("the event thread has ticked " + ticks + " times", () -> left.getCount() == 0);
        timer.stop();
        return longest.get() / 1e9;
    }
}
