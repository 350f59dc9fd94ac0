package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.BitSet;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.scene.Object;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;

/** Renderings in which an object or a listener throws an exception. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RendererFaultTest {
    private static final int EARLY_ROWS = 64;

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void anExceptionOfAnObjectIsThrownWhenAllThreadsHaveEnded(int threads) {
        IllegalStateException fault = new IllegalStateException("a fault of this object");
        AtomicReference<Thread> thrower = new AtomicReference<>();
        Obstacle obstacle = new Obstacle(ray -> {
            if (thrower.compareAndSet(null, Thread.currentThread())) {
                throw fault;
            }
            untilItRests(thrower.get());                      // a thread that goes on after that was not stopped
            return Object.MISS;
        });
        Renderer renderer = new Renderer(obstacle.alone(), new SimpleCamera(1, 100), new RenderSettings(Stage.FINAL, 0, 1, threads));

        assertThatThrownBy(() -> renderer.render(RenderListener.NONE)).isSameAs(fault);

        assertThat(obstacle.threads).isNotEmpty().noneMatch(Thread::isAlive);
        for (int y = 0; y < 100; y++) {
            assertThat(renderer.picture().row(y)).as("row " + y).isNull();
        }
    }

    @Test
    void anErrorOfAnObjectIsThrownWhenAllThreadsHaveEnded() {
        StackOverflowError fault = new StackOverflowError();
        Obstacle obstacle = new Obstacle(ray -> {
            throw fault;
        });
        Renderer renderer = new Renderer(obstacle.alone(), new SimpleCamera(10, 10), new RenderSettings());

        assertThatThrownBy(() -> renderer.render(RenderListener.NONE)).isSameAs(fault);
        assertThat(obstacle.threads).isNotEmpty().noneMatch(Thread::isAlive);
    }

    @Test
    void anExceptionOfAListenerIsThrown() {
        IllegalStateException fault = new IllegalStateException("a fault of this listener");
        Renderer renderer = new Renderer(new Scene(), new SimpleCamera(10, 10), new RenderSettings());

        assertThatThrownBy(() -> renderer.render(y -> {
            throw fault;
        })).isSameAs(fault);
    }

    @Test
    void anExceptionEndsThreadsThatWaitForItsRow() {
        IllegalStateException fault = new IllegalStateException("a fault of this object");
        AtomicReference<Thread> thrower = new AtomicReference<>();
        AtomicReference<Thread> other = new AtomicReference<>();
        Map<Thread, Integer> rays = new ConcurrentHashMap<>();
        BitSet finished = new BitSet();
        Obstacle obstacle = new Obstacle(ray -> {
            // the first rays of each thread are of early rows, for which no thread waits
            boolean early = rays.merge(Thread.currentThread(), 1, Integer::sum) <= EARLY_ROWS / 2;
            if (!early && thrower.compareAndSet(null, Thread.currentThread())) {
                while (other.get() == null || other.get().getState() != Thread.State.WAITING) {
                    Thread.onSpinWait();
                }
                throw fault;
            }
            if (thrower.get() != null && thrower.get() != Thread.currentThread()) {
                other.set(Thread.currentThread());
            }
            return Object.MISS;
        });
        Renderer renderer = new Renderer(obstacle.alone(), new SimpleCamera(1, 10_000), new RenderSettings(Stage.FINAL, 0, 1, 2));

        assertThatThrownBy(() -> renderer.render(y -> {
            synchronized (finished) {
                finished.set(y);
            }
        })).isSameAs(fault);

        int faulty = finished.nextClearBit(0);
        assertThat(finished.nextClearBit(faulty + 1)).as("256 rows may be begun").isEqualTo(faulty + 256).isEqualTo(finished.length());
        assertThat(obstacle.threads).hasSize(2).noneMatch(Thread::isAlive);
    }

    /** Waits until a thread has left its picture: it waits for another one, or has ended. */
    private static void untilItRests(Thread thread) {
        while (thread.getState() == Thread.State.RUNNABLE || thread.getState() == Thread.State.BLOCKED) {
            Thread.onSpinWait();
        }
    }
}
