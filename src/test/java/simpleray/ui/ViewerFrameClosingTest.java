package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** Closing the window. */
class ViewerFrameClosingTest {
    private static final int SIDE = 200;
    private OpenWindow window;

    @AfterEach
    void close() {
        if (window != null) {
            window.close();
        }
    }

    @WindowTest
    void closingAWindowThatRendersEndsItsThreads() {
        window = openRendering();
        OpenWindow.run(() -> window.frame.dispatchEvent(new WindowEvent(window.frame, WindowEvent.WINDOW_CLOSING)));

        Screen.until("all threads end", () -> OpenWindow.threads().isEmpty());
        assertThat(window.job().state()).isEqualTo(RenderJob.State.CANCELLED);
        assertThat(window.closed).isTrue();
        assertThat(OpenWindow.ask(window.frame::isDisplayable)).isFalse();
    }

    @WindowTest
    void quittingEndsTheThreadsOfARendering() {
        window = openRendering();
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);

        Screen.until("all threads end", () -> OpenWindow.threads().isEmpty());
        assertThat(window.job().state()).isEqualTo(RenderJob.State.CANCELLED);
    }

    @WindowTest
    void aRenderingThatTookThePlaceOfAnotherEndsIt() {
        window = openRendering();
        RenderJob first = window.job();
        window.screen.press(KeyEvent.VK_F5);

        Screen.until("the first is cancelled", () -> first.state() == RenderJob.State.CANCELLED);
        assertThat(window.job()).isNotSameAs(first);
        assertThat(window.job().state().ended()).isFalse();
    }

    @WindowTest
    void viewReturnsWhenTheWindowIsClosedAndItsThreadsHaveEnded() throws InterruptedException {
        Thread viewing = view(TestScenes.slow(TestScenes.THESIS), SIDE);
        ViewerFrame frame = OpenWindow.appears("the window", ViewerFrame.class, f -> f.isFocused() && isRendering(f));
        assertThat(frame.getTitle()).isEqualTo("thesis.scene - SimpleRay");
        assertThat(viewing.isAlive()).isTrue();
        OpenWindow.run(() -> frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING)));

        untilEnded(viewing);
        assertThat(OpenWindow.threads()).isEmpty();
    }

    @WindowTest
    void aPictureThatIsBeingSavedIsSavedToTheEnd(@TempDir Path folder) throws Exception {
        Path saved = folder.resolve("large.png");
        Thread viewing = view(SceneSource.file(TestScenes.THESIS), 900);
        ViewerFrame frame = OpenWindow.appears("the window", ViewerFrame.class, f -> f.isFocused() && f.picture().whole() != null);
        Screen screen = new Screen();
        screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        FileDialog dialog = new FileDialog(screen);
        dialog.enter(saved);
        OpenWindow.run(frame::close);

        untilEnded(viewing);
        assertThat(saved).exists();
        BufferedImage expected = TestScenes.rendered(TestScenes.THESIS, 900, 900);
        assertThat(Screen.shows(ImageIO.read(saved.toFile()), 0, 0, expected, 0, 900)).isTrue();
        Screen.until("all threads end", () -> OpenWindow.threads().isEmpty());
    }

    /** A pipe that nobody writes to, for example. */
    @WindowTest
    void viewReturnsThoughTheSceneCannotBeReadToItsEnd() throws InterruptedException {
        CountDownLatch never = new CountDownLatch(1);
        Thread viewing = view(TestScenes.read(() -> {
            try {
                never.await();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        }), SIDE);
        try {
            ViewerFrame frame = OpenWindow.appears("the window", ViewerFrame.class, ViewerFrame::isFocused);
            OpenWindow.run(frame::close);
            untilEnded(viewing);
        } finally {
            never.countDown();
        }
    }

    private static Thread view(SceneSource source, int side) {
        Thread viewing = new Thread(() -> Viewer.view(source, OpenWindow.request(side, side)));
        viewing.start();
        return viewing;
    }

    private static void untilEnded(Thread thread) throws InterruptedException {
        thread.join(TimeUnit.SECONDS.toMillis(20));
        assertThat(thread.isAlive()).isFalse();
    }

    /** {@return a window whose picture is begun and takes long} */
    private static OpenWindow openRendering() {
        OpenWindow window = new OpenWindow(TestScenes.slow(TestScenes.THESIS), SIDE, SIDE);
        Screen.until("it renders", () -> isRendering(window.viewer()));
        return window;
    }

    private static boolean isRendering(ViewerFrame frame) {
        return frame.picture().job().state() == RenderJob.State.RENDERING && OpenWindow.threads().size() > 1;
    }
}
