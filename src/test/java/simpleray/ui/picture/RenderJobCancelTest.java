package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import simpleray.math.Ray;
import simpleray.render.Stage;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;

/** Cancelling a rendering while a finished picture is shown. */
class RenderJobCancelTest {
    private static final int SIDE = 100;

    private final AtomicReference<Consumer<Ray>> hurdle = new AtomicReference<>(ray -> { });
    private final TestScenes.Gate half = new TestScenes.Gate(0, SIDE);
    private final TestScenes.Gate all = new TestScenes.Gate(1);
    private OpenWindow window;

    @BeforeEach
    void finishThePicture() {
        window = new OpenWindow(TestScenes.watched(TestScenes.THESIS, ray -> hurdle.get().accept(ray)), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        half.open();
        all.open();
        window.close();
    }

    @WindowTest
    void beforeTheFirstRowThePictureStaysAndCanBeSaved() {
        hurdle.set(all);
        window.screen.press(KeyEvent.VK_2);
        Screen.until("it renders", () -> window.job().state() == RenderJob.State.RENDERING);
        window.screen.press(KeyEvent.VK_ESCAPE);
        all.open();

        window.untilState(RenderJob.State.CANCELLED);
        assertThat(window.status()).startsWith("Cancelled: 0 of 10,000 rays");
        window.untilShown("the picture before", TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE));
        assertThat(window.canDo("Save Picture As…")).isTrue();
    }

    @WindowTest
    void halfWayWhatIsShownIsNoWholePictureAndCannotBeSaved() {
        hurdle.set(half);
        window.screen.press(KeyEvent.VK_2);
        window.untilShown("the upper half", TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE, Stage.LIGHTING), 0, SIDE / 2);
        window.screen.press(KeyEvent.VK_ESCAPE);
        half.open();

        window.untilState(RenderJob.State.CANCELLED);
        assertThat(window.status()).startsWith("Cancelled: 6,250 of 10,000 rays");
        assertThat(window.canDo("Save Picture As…")).isFalse();
    }
}
