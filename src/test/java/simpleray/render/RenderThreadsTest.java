package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import simpleray.scene.ThesisScene;
import simpleray.image.Picture;
import simpleray.scene.SceneSettings;

class RenderThreadsTest {
    private static final int SIDE = 24;
    private static final RenderListener NOBODY = row -> { };

    private RenderThreads threads = new RenderThreads(2);

    @AfterEach
    void close() {
        threads.close();
    }

    @Test
    void picturesThatAreBegunTogetherAreAsAlone() throws IOException {
        Renderer first = renderer(Stage.FINAL);
        Renderer second = renderer(Stage.AMBIENT);
        first.begin(threads, NOBODY);
        second.begin(threads, NOBODY);

        assertIsSame(first.end(), renderer(Stage.FINAL).render(NOBODY));
        assertIsSame(second.end(), renderer(Stage.AMBIENT).render(NOBODY));
    }

    @Test
    void noRowOfTheNextIsBegunWhileAllThreadsHaveRowsOfTheFirst() throws IOException {
        List<String> order = new CopyOnWriteArrayList<>();
        threads = new RenderThreads(1);
        Renderer first = renderer(Stage.FINAL);
        Renderer second = renderer(Stage.FINAL);
        first.begin(threads, row -> order.add("first"));
        second.begin(threads, row -> order.add("second"));
        first.end();
        second.end();

        assertThat(order.subList(0, SIDE)).containsOnly("first");
        assertThat(order.subList(SIDE, 2 * SIDE)).containsOnly("second");
    }

    @Test
    void theNextIsRenderedAfterOneThatFailed() throws IOException {
        Renderer faulty = renderer(Stage.FINAL);
        Renderer next = renderer(Stage.FINAL);
        faulty.begin(threads, row -> {
            throw new IllegalStateException("row " + row);
        });
        next.begin(threads, NOBODY);

        assertThatThrownBy(faulty::end).isInstanceOf(IllegalStateException.class).hasMessageStartingWith("row ");
        assertIsSame(next.end(), renderer(Stage.FINAL).render(NOBODY));
    }

    @Test
    void oneThatWaitsCanBeCancelled() throws IOException {
        Renderer first = renderer(Stage.FINAL);
        Renderer second = renderer(Stage.FINAL);
        first.begin(threads, row -> second.cancel());
        second.begin(threads, NOBODY);

        first.end();
        assertThatThrownBy(second::end).isInstanceOf(CancellationException.class);
    }

    @Test
    void closingWaitsForWhatIsBegun() throws IOException {
        Renderer renderer = renderer(Stage.FINAL);
        renderer.begin(threads, NOBODY);
        threads.close();

        for (int y = 0; y < SIDE; y++) {
            assertThat(renderer.picture().row(y)).isNotNull();
        }
    }

    @Test
    void aPictureWhoseThreadsHaveDiedIsNotAwaitedForEver() throws IOException {
        threads = new RenderThreads(2, work -> new Thread());
        Renderer renderer = renderer(Stage.FINAL);
        renderer.begin(threads, NOBODY);

        assertThatThrownBy(renderer::end).isInstanceOf(OutOfMemoryError.class).hasMessage("no thread is left to render");
    }

    @Test
    void fewerThreadsAreEnough() throws IOException {
        AtomicInteger asked = new AtomicInteger();
        threads = new RenderThreads(2, work -> {
            if (asked.incrementAndGet() > 1) {
                throw new OutOfMemoryError("unable to create native thread");
            }
            return new Thread(work);
        });
        Renderer renderer = renderer(Stage.FINAL);
        renderer.begin(threads, NOBODY);

        assertIsSame(renderer.end(), renderer(Stage.FINAL).render(NOBODY));
    }

    private static void assertIsSame(Picture picture, Picture wanted) {
        for (int y = 0; y < SIDE; y++) {
            assertThat(picture.row(y)).containsExactly(wanted.row(y));
        }
    }

    private static Renderer renderer(Stage stage) throws IOException {
        SceneSettings settings = new SceneSettings();
        settings.resolution = new SceneSettings.Resolution(SIDE, SIDE);
        return new RenderRequest(settings, stage, false, 2).renderer(ThesisScene.read());
    }
}
