package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import org.junit.jupiter.api.AfterEach;
import simpleray.render.Progress;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;

/** A rendering that is held for a while. */
class RenderJobPauseTest {
    private static final int SIDE = 100;

    private final TestScenes.Gate gate = new TestScenes.Gate(0, SIDE);
    private final OpenWindow window = new OpenWindow(TestScenes.watched(TestScenes.THESIS, gate), SIDE, SIDE);

    @AfterEach
    void close() {
        gate.open();
        window.close();
    }

    @WindowTest
    void spaceHoldsTheRenderingAndLetsItGoOn() {
        pauseHalfWay();
        gate.open();
        Screen.until("its threads wait", RenderJobPauseTest::workersWait);

        Screen.until("the status bar says so", () -> window.status().matches("Paused: 6,250 of 10,000 rays, [\\d.:]+ (s|min)"));
        assertThat(OpenWindow.ask(window.item("Pause")::isSelected)).isTrue();
        assertThat(window.job().snapshot().progress().finished()).isEqualTo(50);

        window.screen.press(KeyEvent.VK_SPACE);
        window.untilState(RenderJob.State.FINISHED);
        window.untilShown("the picture", TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE));
        assertThat(OpenWindow.ask(window.item("Pause")::isSelected)).isFalse();
        assertThat(window.canDo("Pause")).isFalse();
    }

    @WindowTest
    void theTimeShownStandsMeanwhile() {
        pauseHalfWay();
        double then = window.job().snapshot().seconds();
        Screen.until("the kicker came by", () -> true);

        assertThat(window.job().snapshot().seconds()).isEqualTo(then);
    }

    @WindowTest
    void aHeldRenderingCanBeCancelled() {
        pauseHalfWay();
        gate.open();
        window.screen.press(KeyEvent.VK_ESCAPE);

        window.untilState(RenderJob.State.CANCELLED);
        assertThat(window.status()).startsWith("Cancelled: 6,250 of 10,000 rays");
        Screen.until("all threads end", () -> OpenWindow.threads().isEmpty());
    }

    @WindowTest
    void anotherRenderingIsNotHeld() {
        pauseHalfWay();
        gate.open();
        window.screen.press(KeyEvent.VK_F5);

        window.untilState(RenderJob.State.FINISHED);
        assertThat(OpenWindow.ask(() -> window.picture().isPaused())).isFalse();
    }

    private void pauseHalfWay() {
        Screen.until("the upper half is finished", () -> {
            Progress progress = window.picture().job().snapshot().progress();
            return progress != null && progress.finished() == SIDE / 2;
        });
        window.screen.press(KeyEvent.VK_SPACE);
        Screen.until("it is paused", () -> window.picture().isPaused() && window.status().startsWith("Paused"));
    }

    private static boolean workersWait() {
        return Thread.getAllStackTraces().keySet().stream().filter(thread -> thread.getName().startsWith("simpleray-worker"))
            .allMatch(thread -> thread.getState() == Thread.State.WAITING);
    }
}
