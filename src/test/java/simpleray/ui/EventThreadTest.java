package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import javax.swing.Timer;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** The event thread is never blocked. */
class EventThreadTest {
    private static final int TICK = 5;
    private static final int TICKS = 100;

    @WindowTest
    void itAnswersWhileRowsTakeForEver() {
        TestScenes.Gate gate = new TestScenes.Gate(0);
        try (OpenWindow window = new OpenWindow(TestScenes.watched(TestScenes.THESIS, gate), 200, 200)) {
            tick();
            assertThat(window.job().state()).isEqualTo(RenderJob.State.RENDERING);
            gate.open();
        } finally {
            gate.open();
        }
    }

    @WindowTest
    void itAnswersWhileALargePictureIsRendered() {
        try (OpenWindow window = new OpenWindow(SceneSource.file(TestScenes.MIRRORS), 3200, 2400)) {
            tick();
            assertThat(window.job().state()).isEqualTo(RenderJob.State.RENDERING);
        }
    }

    /** Waits for ticks that come every 5 ms to an event thread that is free. */
    private static void tick() {
        CountDownLatch left = new CountDownLatch(TICKS);
        Timer timer = new Timer(TICK, e -> left.countDown());
        timer.start();
        Screen.until("the event thread has ticked " + TICKS + " times", () -> left.getCount() == 0);
        timer.stop();
    }
}
