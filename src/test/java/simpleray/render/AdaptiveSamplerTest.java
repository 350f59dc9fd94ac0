package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.image.Picture;
import simpleray.scene.Camera;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.SimpleCamera;
import simpleray.scene.ThesisScene;

/** Adaptive sampling is as good as four by four samples, and much cheaper. */
class AdaptiveSamplerTest {
    private static final int SIDE = 100;
    private static final double GOOD = 40;
    private static final Map<String, Measured> MEASURED = new ConcurrentHashMap<>();

    @ParameterizedTest
    @MethodSource("scenes")
    void thePictureIsNearlyThatOfFourByFourSamples(String name) {
        assertThat(measured(name).psnr).isGreaterThanOrEqualTo(GOOD);
    }

    @Test
    void itTracesAtMostAThirdOfTheRaysOnAverage() {
        assertThat(scenes().mapToDouble(name -> measured(name).rays).average().orElseThrow())
            .isLessThanOrEqualTo(16.0 * SIDE * SIDE / 3);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 7})
    void thePictureDoesNotDependOnTheThreads(int threads) throws IOException {
        Scene scene = ThesisScene.read();
        Picture one = render(scene, new SimpleCamera(60, 40), RenderSettings.ADAPTIVE, 1);
        Picture picture = render(scene, new SimpleCamera(60, 40), RenderSettings.ADAPTIVE, threads);

        for (int y = 0; y < 40; y++) {
            assertThat(picture.row(y)).containsExactly(one.row(y));
        }
    }

    @Test
    void evenPicturesTakeOneRayPerPixel() throws IOException {
        CountingCamera camera = new CountingCamera(new SimpleCamera(13, 50));
        Picture picture = render(scene("1  1 0 0 1 -2  1 1 1  0 0 0  0 0 0  0  0.5 0.25 7  0"), camera, RenderSettings.ADAPTIVE, 1);

        assertThat(camera.rays()).isEqualTo(13 * 50);
        for (int y = 0; y < 50; y++) {
            assertThat(picture.row(y)).startsWith(0.5, 0.25, 1).containsOnly(0.5, 0.25, 1);
        }
    }

    @Test
    void theMemoryDoesNotGrowWithTheHeight() {
        RenderSettings adaptive = new RenderSettings(Stage.FINAL, 10, RenderSettings.ADAPTIVE, 2);

        // a row of each thread, and first points of twice two rows and eight; 24 bytes a pixel and 24 a row
        assertThat(new Renderer(new Scene(), new SimpleCamera(20000, 20000), adaptive).bytesNeeded()).isEqualTo((2 + 12) * 480_024L);
        assertThat(new Renderer(new Scene(), new SimpleCamera(20000, 65535), adaptive).bytesNeeded()).isEqualTo((2 + 12) * 480_024L);
    }

    @Test
    void pixelsAtAnEdgeTakeSixteenRaysAndOthersOne() throws IOException {
        // columns 0 to 4 are white from column 2 on: columns 1 and 2 see a neighbour that differs, in each of 3 rows
        CountingCamera camera = new CountingCamera(new SimpleCamera(5, 3));
        double edge = 4.0 * 5 / 3 * (2.0 / 5 - 0.5);
        Scene scene = scene("1  2  " + edge + " -900 0  " + edge + " 900 0  900 0 0  1 1 1  0 0 0  0 0 0  0  1 1 1  0");
        Picture picture = render(scene, camera, RenderSettings.ADAPTIVE, 1);

        assertThat(camera.rays()).isEqualTo(3 * (3 + 2 * 16));
        for (int y = 0; y < 3; y++) {
            assertThat(picture.row(y)).containsExactly(0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1);
        }
    }

    @Test
    void aPixelAtAnEdgeIsTheMeanOfFourByFourSamples() throws IOException {
        // one column of four sub-cells in white: 0.25; its neighbours' first points are all black and white
        Scene scene = scene("1  2  1 -900 0  1 900 0  900 0 0  1 1 1  0 0 0  0 0 0  0  1 1 1  0");
        SimpleCamera camera = new SimpleCamera(3, 1);
        camera.setVPWindow(-6, 6, -2, 2);

        assertThat(render(scene, camera, RenderSettings.ADAPTIVE, 1).row(0)).containsExactly(0, 0, 0, 0.25, 0.25, 0.25, 1, 1, 1);
        assertThat(render(scene, camera, 4, 1).row(0)).containsExactly(0, 0, 0, 0.25, 0.25, 0.25, 1, 1, 1);
    }

    @Test
    void samplesAreClampedBeforeTheyAreComparedAndAdded() throws IOException {
        // white of 10 beside white of 20 is no edge; beside black it is one, of half white
        CountingCamera camera = new CountingCamera(new SimpleCamera(5, 3));
        Scene bright = scene("2  2  0 -900 0  0 900 0  900 0 0  1 1 1  0 0 0  0 0 0  0  1 0 0 1 -1  2 2 2  0 0 0  0 0 0  0  10 10 10  0");
        render(bright, camera, RenderSettings.ADAPTIVE, 1);
        assertThat(camera.rays()).isEqualTo(5 * 3);

        Scene half = scene("1  2  0 -900 0  0 900 0  900 0 0  1 1 1  0 0 0  0 0 0  0  10 10 10  0");
        assertThat(render(half, new SimpleCamera(3, 3), RenderSettings.ADAPTIVE, 1).row(1)[3]).isEqualTo(0.5, within(1e-15));
    }

    private static Stream<String> scenes() {
        return Stream.of("thesis", "open-floor", "coloured-shadows", "glass", "facing-mirrors");   // all: docs/pictures.md
    }

    /** The similarity of a scene's picture to that of four by four samples, in decibels, and its number of primary rays. */
    private record Measured(double psnr, long rays) {
    }

    private static Measured measured(String name) {
        return MEASURED.computeIfAbsent(name, AdaptiveSamplerTest::measure);
    }

    private static Measured measure(String name) {
        try {
            Scene scene = SceneFile.read(Project.scene(name)).scene();
            SceneSettings size = new SceneSettings();
            size.resolution = new SceneSettings.Resolution(SIDE, SIDE);
            Camera camera = scene.settings.under(size).newCamera();
            CountingCamera counting = new CountingCamera(camera);
            Picture adaptive = render(scene, counting, RenderSettings.ADAPTIVE, 1);
            return new Measured(psnr(adaptive, render(scene, camera, 4, 1)), counting.rays());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Scene scene(String text) throws IOException {
        Scene scene = new Scene();
        scene.read(reader(text));
        return scene;
    }

    private static Picture render(Scene scene, Camera camera, int samples, int threads) {
        return new Renderer(scene, camera, new RenderSettings(Stage.FINAL, 10, samples, threads)).render(RenderListener.NONE);
    }

    /** {@return the peak signal to noise ratio in decibels, of clamped light} */
    private static double psnr(Picture one, Picture other) {
        double squares = 0;
        for (int y = 0; y < SIDE; y++) {
            for (int i = 0; i < 3 * SIDE; i++) {
                double difference = Math.min(1, one.row(y)[i]) - Math.min(1, other.row(y)[i]);
                squares += difference * difference;
            }
        }
        return 10 * Math.log10(3 * SIDE * SIDE / squares);
    }
}
