package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simpleray.image.Picture;
import simpleray.scene.Object;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;

/** Renderings that are cancelled. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RendererEndTest {
    /** A side so long that no machine renders the square of it before the test is over. */
    private static final int ENDLESS = Picture.LONGEST_SIDE;

    @Test
    void cancellingEndsTheRenderingWithinAPixel() throws Exception {
        CountDownLatch entered = new CountDownLatch(1);
        CountDownLatch open = new CountDownLatch(1);
        AtomicInteger pixels = new AtomicInteger();
        Obstacle gate = new Obstacle(ray -> {
            pixels.incrementAndGet();
            entered.countDown();
            await(open);
            return Object.MISS;
        });
        Renderer renderer = new Renderer(gate.alone(), new SimpleCamera(10, 10), new RenderSettings(Stage.FINAL, 0, 1, 1));
        List<Integer> heard = new CopyOnWriteArrayList<>();
        ExecutorService executor = Executors.newSingleThreadExecutor();
        try {
            Future<Picture> rendering = executor.submit(() -> renderer.render(heard::add));
            entered.await();
            renderer.cancel();
            open.countDown();

            assertThatThrownBy(rendering::get).isInstanceOf(ExecutionException.class)
                .cause().isInstanceOf(CancellationException.class).hasMessage("the rendering was cancelled");
        } finally {
            executor.shutdown();
        }
        assertThat(pixels).hasValue(1);
        assertThat(renderer.picture().row(0)).isNull();
        assertThat(heard).isEmpty();
        assertThat(gate.threads).hasSize(1).noneMatch(Thread::isAlive);
    }

    @Test
    void cancellingBetweenRowsKeepsThoseThatAreFinished() {
        Renderer renderer = new Renderer(new Scene(), new SimpleCamera(2, 10), new RenderSettings(Stage.FINAL, 0, 1, 1));
        List<Integer> heard = new CopyOnWriteArrayList<>();

        assertThatThrownBy(() -> renderer.render(y -> {
            heard.add(y);
            if (y == 2) {
                renderer.cancel();
            }
        })).isInstanceOf(CancellationException.class);

        assertThat(heard).containsExactly(0, 1, 2);
        assertThat(renderer.picture().row(2)).isNotNull();
        assertThat(renderer.picture().row(3)).isNull();
    }

    @Test
    void cancellingBeforeTheBeginningLeavesNothingToDo() {
        Obstacle obstacle = new Obstacle(ray -> Object.MISS);
        Renderer renderer = new Renderer(obstacle.alone(), new SimpleCamera(10, 10), new RenderSettings());
        renderer.cancel();

        assertThatThrownBy(() -> renderer.render(RenderListener.NONE)).isInstanceOf(CancellationException.class);

        assertThat(obstacle.threads).isEmpty();
    }

    @Test
    void anInterruptOfTheCallerEndsEvenAnEndlessRendering() {
        Obstacle obstacle = new Obstacle(ray -> Object.MISS);
        Renderer renderer = new Renderer(obstacle.alone(), new SimpleCamera(ENDLESS, ENDLESS), new RenderSettings(Stage.FINAL, 0, 1, 2));
        Thread.currentThread().interrupt();

        assertThatThrownBy(() -> renderer.render(RenderListener.NONE)).isInstanceOf(CancellationException.class);

        assertThat(Thread.interrupted()).as("the interrupt is passed on").isTrue();
        assertThat(obstacle.threads).noneMatch(Thread::isAlive);
    }

    @Test
    void cancellingEndsAllThreadsOfAnEndlessRendering() {
        Obstacle obstacle = new Obstacle(ray -> Object.MISS);
        Renderer renderer = new Renderer(obstacle.alone(), new SimpleCamera(1, ENDLESS), new RenderSettings(Stage.FINAL, 0, 1, 3));

        assertThatThrownBy(() -> renderer.render(y -> renderer.cancel())).isInstanceOf(CancellationException.class);

        assertThat(renderer.picture().row(ENDLESS - 1)).isNull();
        assertThat(obstacle.threads).isNotEmpty().noneMatch(Thread::isAlive);
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
