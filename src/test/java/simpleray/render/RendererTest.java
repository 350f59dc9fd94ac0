package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.BrokenBarrierException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CyclicBarrier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.math.Vector;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.scene.SimpleCamera;
import simpleray.scene.ThesisScene;

class RendererTest {
    private static final int WIDTH = 30;
    private static final int HEIGHT = 20;
    private static final int DEPTH = 10;

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = {"NORMALS", "DEPTH", "OBJECTS", "BOUNCES", "SHADOWS"})
    void eachPixelIsTheColourOfItsRay(Stage stage) throws IOException {
        Scene scene = ThesisScene.read();
        SimpleCamera camera = new SimpleCamera(WIDTH, HEIGHT);

        Picture picture = new Renderer(scene, camera, new RenderSettings(stage, DEPTH, 1, 2)).render(RenderListener.NONE);

        assertThat(picture.width()).isEqualTo(WIDTH);
        assertThat(picture.height()).isEqualTo(HEIGHT);
        for (int y = 0; y < HEIGHT; y++) {
            double[] row = new double[3 * WIDTH];
            for (int x = 0; x < WIDTH; x++) {
                Colour seen = new Colour();
                scene.intersect(camera.ray(x, y), seen, DEPTH, stage.terms());
                row[3 * x] = seen.r;
                row[3 * x + 1] = seen.g;
                row[3 * x + 2] = seen.b;
            }
            assertThat(picture.row(y)).as("row " + y).isEqualTo(row);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 7})
    void thePictureDoesNotDependOnTheNumberOfThreads(int threads) throws IOException {
        Scene scene = ThesisScene.read();
        SimpleCamera camera = new SimpleCamera(WIDTH, HEIGHT);
        RenderSettings one = new RenderSettings(Stage.FINAL, DEPTH, 1, 1);
        RenderSettings many = new RenderSettings(Stage.FINAL, DEPTH, 1, threads);

        Picture byOne = new Renderer(scene, camera, one).render(RenderListener.NONE);
        Picture byMany = new Renderer(scene, camera, many).render(RenderListener.NONE);

        for (int y = 0; y < HEIGHT; y++) {
            assertThat(byMany.row(y)).as("row " + y).isEqualTo(byOne.row(y));
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {0, 1, 100_000, Long.MAX_VALUE})
    void thePictureDoesNotDependOnTheTimeForEarlyRows(long nanoseconds) throws IOException {
        Scene scene = ThesisScene.read();
        RenderSettings settings = new RenderSettings(Stage.FINAL, DEPTH, 1, 1);
        Picture expected = new Renderer(scene, new SimpleCamera(WIDTH, HEIGHT), settings).render(RenderListener.NONE);
        CountingCamera camera = new CountingCamera(new SimpleCamera(WIDTH, HEIGHT));
        Renderer renderer = new Renderer(scene, camera, settings);
        renderer.setMaxEarlyTime(nanoseconds);

        Picture picture = renderer.render(RenderListener.NONE);

        for (int y = 0; y < HEIGHT; y++) {
            assertThat(picture.row(y)).as("row " + y).isEqualTo(expected.row(y));
        }
        assertThat(camera.rays()).isEqualTo(WIDTH * HEIGHT);
    }

    /** Whichever thread begins a row, and whichever's turn it is. */
    @RepeatedTest(20)
    void noRowIsRenderedTwiceByManyThreads() throws IOException {
        CountingCamera camera = new CountingCamera(new SimpleCamera(WIDTH, HEIGHT));
        Renderer renderer = new Renderer(ThesisScene.read(), camera, new RenderSettings(Stage.FINAL, DEPTH, 1, 16));

        renderer.render(RenderListener.NONE);

        assertThat(camera.rays()).isEqualTo(WIDTH * HEIGHT);
        assertThat(renderer.stats().rays().primary).isEqualTo(WIDTH * HEIGHT);
    }

    /** So a slow picture that is told to stop has rows to keep. */
    @Test
    void rowsAreFinishedFromTheFirstOnceTheTimeForEarlyRowsIsOver() {
        CountingCamera camera = new CountingCamera(new SimpleCamera(WIDTH, 80));
        Renderer renderer = new Renderer(new Scene(), camera, new RenderSettings(Stage.FINAL, 0, 1, 1));
        renderer.setMaxEarlyTime(0);
        List<Long> rays = new CopyOnWriteArrayList<>();

        renderer.render(y -> rays.add(camera.rays()));

        assertThat(rays).hasSize(80).startsWith((long) WIDTH, 2L * WIDTH).endsWith(80L * WIDTH);
    }

    @Test
    void theListenerIsCalledOnceForEachFinishedRow() {
        Renderer renderer = new Renderer(new Scene(), new SimpleCamera(3, 100), new RenderSettings(Stage.FINAL, 0, 1, 4));
        List<Integer> heard = new CopyOnWriteArrayList<>();
        List<Integer> missing = new CopyOnWriteArrayList<>();

        Picture picture = renderer.render(y -> {
            heard.add(y);
            if (renderer.picture().row(y) == null) {
                missing.add(y);
            }
        });

        assertThat(heard).containsExactlyInAnyOrderElementsOf(IntStream.range(0, 100).boxed().collect(Collectors.toList()));
        assertThat(missing).isEmpty();
        assertThat(picture).isSameAs(renderer.picture());
    }

    @Test
    void raysThatMissAreBlack() {
        Picture picture = new Renderer(new Scene(), new SimpleCamera(2, 1), new RenderSettings()).render(RenderListener.NONE);

        assertThat(picture.row(0)).containsExactly(0, 0, 0, 0, 0, 0);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 3, SceneSettings.MAX_DEPTH})
    void theSettingsLimitTheDepthAndTheStackHoldsTheDeepest(int depth) {
        // two mirrors of Ka = Ks = 1 face each other along the axis of the one ray: each reflection adds 1
        Scene scene = facingMirrors(SceneSettings.MAX_DEPTH);

        Picture picture = new Renderer(scene, new SimpleCamera(1, 1), new RenderSettings(Stage.FINAL, depth, 1, 1))
            .render(RenderListener.NONE);

        assertThat(picture.row(0)).containsExactly(1 + depth, 1 + depth, 1 + depth);
    }

    @Test
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void theSettingsSayHowManyThreadsWork() {
        // each of three rows waits until three threads are at work
        CyclicBarrier three = new CyclicBarrier(3);
        Obstacle obstacle = new Obstacle(ray -> {
            try {
                three.await();
            } catch (InterruptedException | BrokenBarrierException e) {
                throw new IllegalStateException(e);
            }
            return Object.MISS;
        });

        new Renderer(obstacle.alone(), new SimpleCamera(1, 3), new RenderSettings(Stage.FINAL, 0, 1, 3)).render(RenderListener.NONE);

        assertThat(obstacle.threads).hasSize(3).allMatch(Thread::isDaemon).noneMatch(Thread::isAlive);
    }

    @Test
    void moreThreadsThanRowsRenderTheSame() {
        Obstacle obstacle = new Obstacle(ray -> Object.MISS);

        Picture picture = new Renderer(obstacle.alone(), new SimpleCamera(5, 2), new RenderSettings(Stage.FINAL, 0, 1, 7))
            .render(RenderListener.NONE);

        assertThat(picture.row(0)).isNotNull();
        assertThat(picture.row(1)).isNotNull();
    }

    private static Scene facingMirrors(double shininess) {
        Scene scene = new Scene();
        scene.ambient = new Colour(1, 1, 1);
        scene.setNumberObjects(2);
        for (int i = 0; i < 2; i++) {
            Plane mirror = new Plane();
            mirror.normal = new Vector(0, 0, 1);
            mirror.constant = 4 * i;
            mirror.surfaceMaterial.specular = new Colour(1, 1, 1);
            mirror.surfaceMaterial.shininess = shininess;
            scene.setObject(i, mirror);
        }
        return scene;
    }
}
