package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import simpleray.Sample;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** Windows come and go, and leave nothing behind. */
class ManyWindowsTest {
    private static final int CYCLES = Sample.size(1000, 100);
    private static final int WARM = CYCLES / 5;
    private static final long MEBIBYTE = 1 << 20;

    /** A window is made with its native peer and begins to render, but is not shown: that would take the test minutes. */
    @WindowTest
    void manyWindowsThatOpenedRenderedAndClosedLeaveNoThreadAndNoHeap() throws InterruptedException {
        OpenWindow.run(FlatLightLaf::setup);
        List<WeakReference<ViewerFrame>> frames = new ArrayList<>();
        long early = 0;
        long begin = System.nanoTime();
        for (int i = 1; i <= CYCLES; i++) {
            ViewerFrame frame = OpenWindow.ask(
                () -> new ViewerFrame(SceneSource.file(TestScenes.THESIS), OpenWindow.request(64, 64), () -> { }));
            if (i % 2 == 0) {                                 // every second is closed while it renders, or reads
                RenderJob job = OpenWindow.ask(() -> frame.picture().job());
                job.await();
            }
            OpenWindow.run(frame::close);
            frame.await();
            frames.add(new WeakReference<>(frame));
            if (i == WARM) {
                early = heap();
            }
        }
        OpenWindow.run(() -> { });
        Screen.until("all threads end", () -> OpenWindow.threads().isEmpty());
        long late = heap();
        System.out.println(CYCLES + " windows in " + (System.nanoTime() - begin) / 1_000_000
            + " ms; heap after " + WARM + " windows " + early + " bytes, after " + CYCLES + ' ' + late);

        assertThat(late - early).isLessThan(4 * MEBIBYTE);    // 5 KiB a window: less than one of its parts takes
        assertThat(frames.stream().filter(frame -> frame.get() != null).count()).isLessThan(20);
    }

    /** How soon is told, not judged: within 500 ms on a quiet machine. */
    @WindowTest
    void aWindowClosedMidRenderHasNoThreadsAndItsPictureIsNotFinished() {
        double longest = 0;
        for (int i = 0; i < 3; i++) {
            OpenWindow window = new OpenWindow(TestScenes.slow(TestScenes.THESIS), 200, 200);
            Screen.until("it renders", () -> window.picture().job().state() == RenderJob.State.RENDERING
                && OpenWindow.threads().size() > 1);
            Screen.until("the icon is made, which is once", () -> !window.frame.getIconImages().isEmpty());
            long begin = System.nanoTime();
            window.close();                                   // and waits until the threads have ended
            longest = Math.max(longest, (System.nanoTime() - begin) / 1e6);
            assertThat(window.job().state()).isEqualTo(RenderJob.State.CANCELLED);
        }
        System.out.println("threads gone after " + longest + " ms");
    }

    @WindowTest
    void soIsOneThatIsPaused() {
        OpenWindow window = new OpenWindow(TestScenes.slow(TestScenes.THESIS), 200, 200);
        Screen.until("it renders", () -> window.picture().job().state() == RenderJob.State.RENDERING
            && OpenWindow.threads().size() > 1);
        OpenWindow.run(() -> window.picture().setPaused(true));
        window.close();
    }

    private static long heap() throws InterruptedException {
        long least = Long.MAX_VALUE;
        for (int i = 0; i < 4; i++) {
            System.gc();
            TimeUnit.MILLISECONDS.sleep(20);                  // for what waits to be finalised
            OpenWindow.run(() -> { });
            least = Math.min(least, Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory());
        }
        return least;
    }
}
