package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.image.Picture;
import simpleray.math.Ray;
import simpleray.scene.Object;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;
import simpleray.scene.ThesisScene;

/** Pictures rendered in passes, as in a window. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RendererPassesTest {
    private static final int WIDTH = 45;
    private static final int HEIGHT = 31;

    /** Records its calls. */
    private static class Told implements PassListener {
        final Set<Integer> rows = new ConcurrentSkipListSet<>();
        final Map<Integer, Throwable> faults = new ConcurrentSkipListMap<>();
        final Map<Long, double[]> pixels = new ConcurrentHashMap<>();
        final AtomicInteger coarse = new AtomicInteger();

        @Override
        public void runFinished(PixelRun run, double[] rgb) {
            for (int x = run.x(), i = 0; x < run.end(); x += run.step(), i += 3) {
                pixels.put((long) run.y() * WIDTH + x, new double[] {rgb[i], rgb[i + 1], rgb[i + 2]});
            }
        }

        @Override
        public void coarseFinished() {
            coarse.incrementAndGet();
        }

        @Override
        public void rowFailed(int y, Throwable fault) {
            faults.put(y, fault);
        }

        @Override
        public void rowFinished(int y) {
            rows.add(y);
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1, 3", "2, 2", "0, 1", "0, 3"})
    void passesGiveTheSamePictureAndTheListenerReceivesEachPixel(int samples, int threads) throws IOException {
        Picture expected = renderer(ThesisScene.read(), samples, threads).render(RenderListener.NONE);
        for (Region first : new Region[] {null, new Region(7, 5, 20, 11), new Region(0, 0, WIDTH, HEIGHT)}) {
            Told told = new Told();
            Picture picture = renderer(ThesisScene.read(), samples, threads).renderPasses(told, first, false);

            assertThat(told.coarse).hasValue(1);
            assertThat(told.rows).hasSize(HEIGHT);
            assertThat(told.faults).isEmpty();
            for (int y = 0; y < HEIGHT; y++) {
                assertThat(picture.row(y)).as("row " + y).isEqualTo(expected.row(y));
                for (int x = 0; x < WIDTH; x++) {
                    assertThat(told.pixels.get((long) y * WIDTH + x)).as("pixel " + x + ", " + y)
                        .containsExactly(picture.row(y)[3 * x], picture.row(y)[3 * x + 1], picture.row(y)[3 * x + 2]);
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 0})
    void aRegionAloneHasTheSamePixels(int samples) throws IOException {
        Region region = new Region(7, 5, 20, 11);
        Picture expected = renderer(ThesisScene.read(), samples, 2).render(RenderListener.NONE);
        Told told = new Told();
        renderer(ThesisScene.read(), samples, 2).renderPasses(told, region, true);

        assertThat(told.rows).containsExactly(5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
        for (int y = region.y(); y < region.bottom(); y++) {
            for (int x = region.x(); x < region.right(); x++) {
                assertThat(told.pixels.get((long) y * WIDTH + x)).as("pixel " + x + ", " + y)
                    .containsExactly(expected.row(y)[3 * x], expected.row(y)[3 * x + 1], expected.row(y)[3 * x + 2]);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "3, 9"})
    void noPixelIsTracedTwice(int samples, int rays) {
        AtomicInteger counted = new AtomicInteger();
        Obstacle obstacle = new Obstacle(ray -> {
            counted.incrementAndGet();
            return Object.MISS;
        });
        renderer(obstacle.alone(), samples, 2).renderPasses(new Told(), new Region(7, 5, 20, 11), false);

        assertThat(counted).hasValue(rays * WIDTH * HEIGHT);
    }

    @Test
    void adaptiveSamplingTracesAPixelsFirstPointOnce() {
        AtomicInteger counted = new AtomicInteger();
        Obstacle obstacle = new Obstacle(ray -> {
            counted.incrementAndGet();
            return Object.MISS;
        });
        renderer(obstacle.alone(), RenderSettings.ADAPTIVE, 2).renderPasses(new Told(), null, false);

        assertThat(counted).hasValue(WIDTH * HEIGHT);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 0})
    void anExceptionInARowIsReportedAndTheOtherRowsAreFinished(int samples) {
        IllegalStateException fault = new IllegalStateException("a fault of this object");
        Scene scene = new Obstacle(ray -> {
            if (row(ray) == 12) {
                throw fault;
            }
            return Object.MISS;
        }).alone();
        Told told = new Told();
        Picture picture = renderer(scene, samples, 3).renderPasses(told, null, false);

        int around = samples == 0 ? 1 : 0;                    // adaptive sampling compares a pixel with its neighbours
        for (int y = 0; y < HEIGHT; y++) {
            boolean fails = Math.abs(y - 12) <= around;
            assertThat(told.faults.get(y)).as("fault of row " + y).isSameAs(fails ? fault : null);
            assertThat(told.rows.contains(y)).as("row " + y + " is finished").isNotEqualTo(fails);
            assertThat(picture.row(y) == null).as("row " + y + " is missing").isEqualTo(fails);
        }
    }

    /** {@return the row of the picture that a ray goes through} */
    private static int row(Ray ray) {
        double y = ray.direction.y / -ray.direction.z * SimpleCamera.DEFAULT_COP;
        double half = 2.0 * HEIGHT / Math.min(WIDTH, HEIGHT);
        return (int) Math.floor((half - y) / (2 * half) * HEIGHT);
    }

    @Test
    void aPausedRenderingWaitsAndCanBeCancelled() throws InterruptedException {
        CountDownLatch early = new CountDownLatch(1);
        Renderer[] renderer = new Renderer[1];
        renderer[0] = renderer(new Scene(), 1, 2);
        Told told = new Told() {
            @Override
            public void coarseFinished() {
                renderer[0].setPaused(true);
                early.countDown();
            }

            @Override
            public void runFinished(PixelRun run, double[] rgb) {
                if (run.size() < 8) {                        // however slow the other thread is, the picture is not whole before the pause
                    try {
                        early.await();
                    } catch (InterruptedException e) {
                        throw new IllegalStateException(e);
                    }
                }
                super.runFinished(run, rgb);
            }
        };
        Thread rendering = new Thread(() ->
            assertThatThrownBy(() -> renderer[0].renderPasses(told, null, false)).isInstanceOf(CancellationException.class));
        rendering.start();
        early.await();
        while (!workersWait()) {
            Thread.onSpinWait();
        }
        assertThat(rendering.isAlive()).isTrue();
        renderer[0].cancel();
        rendering.join();

        assertThat(told.rows).hasSizeLessThan(HEIGHT);
    }

    private static boolean workersWait() {
        return Thread.getAllStackTraces().keySet().stream().filter(thread -> thread.getName().startsWith("simpleray-worker"))
            .allMatch(thread -> thread.getState() == Thread.State.WAITING);
    }

    @Test
    void aRenderingPausedBeforeItBeganCanBeResumed() throws IOException {
        Renderer renderer = renderer(ThesisScene.read(), 1, 2);
        renderer.setPaused(true);
        Thread later = new Thread(() -> {
            while (Thread.getAllStackTraces().keySet().stream().noneMatch(t -> t.getName().startsWith("simpleray-worker"))
                || !workersWait()) {
                Thread.onSpinWait();
            }
            renderer.setPaused(true);                         // a second time changes nothing
            renderer.setPaused(false);
        });
        later.start();
        Told told = new Told();
        renderer.renderPasses(told, null, false);

        assertThat(told.rows).hasSize(HEIGHT);
    }

    @Test
    void cancellingBeforeTheBeginningLeavesNothingToDo() {
        Obstacle obstacle = new Obstacle(ray -> Object.MISS);
        Renderer renderer = renderer(obstacle.alone(), 1, 2);
        renderer.cancel();

        assertThatThrownBy(() -> renderer.renderPasses(new Told(), null, false)).isInstanceOf(CancellationException.class);
        assertThat(obstacle.threads).isEmpty();
    }

    @Test
    void aRegionThatThePictureDoesNotHaveIsRefused() {
        assertThatThrownBy(() -> renderer(new Scene(), 1, 1).renderPasses(new Told(), new Region(40, 0, 10, 10), false))
            .isInstanceOf(IllegalArgumentException.class).hasMessage("the region 40,0,10,10 is not inside the picture of 45x31");
    }

    @Test
    void aRendererOfARegionDoesNotRenderInPasses() {
        RenderSettings piece = new RenderSettings(Stage.FINAL, 0, 1, Accel.AUTO, 1, new Region(0, 0, 5, 5));
        assertThatThrownBy(() -> new Renderer(new Scene(), new SimpleCamera(9, 9), piece).renderPasses(new Told(), null, false))
            .isInstanceOf(IllegalArgumentException.class).hasMessage("a region is not rendered in passes");
    }

    @Test
    void anExceptionOfTheListenerEndsTheRendering() {
        IllegalStateException fault = new IllegalStateException("a fault of this listener");
        Told told = new Told() {
            @Override
            public void runFinished(PixelRun run, double[] rgb) {
                throw fault;
            }
        };
        assertThatThrownBy(() -> renderer(new Scene(), 1, 2).renderPasses(told, null, false)).isSameAs(fault);
    }

    private static Renderer renderer(Scene scene, int samples, int threads) {
        return new Renderer(scene, new SimpleCamera(WIDTH, HEIGHT), new RenderSettings(Stage.FINAL, 10, samples, threads));
    }
}
