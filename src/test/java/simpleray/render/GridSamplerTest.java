package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.scene.Camera;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;
import simpleray.scene.ThesisScene;

/** n × n samples a pixel. */
class GridSamplerTest {
    private static final Offset<Double> ROUNDING = within(1e-15);
    private static final int DEPTH = 10;

    @Test
    void oneSampleIsTheRayThroughTheCentreAndIsNotClamped() throws IOException {
        Scene scene = ThesisScene.read();
        SimpleCamera camera = new SimpleCamera(9, 7);
        Picture picture = render(scene, camera, 1);

        for (int y = 0; y < 7; y++) {
            for (int x = 0; x < 9; x++) {
                Colour seen = new Colour();
                scene.intersect(camera.ray(x, y), seen, DEPTH);
                assertThat(picture.row(y)).containsSequence(seen.r, seen.g, seen.b);
            }
        }
        assertThat(render(edge(-10, 7), new SimpleCamera(1, 1), 1).row(0)).containsOnly(7);
    }

    @Test
    void samplesAreTheCentresOfTheSubCells() {
        CountingCamera two = new CountingCamera(new SimpleCamera(1, 1));
        render(new Scene(), two, 2);
        assertThat(two.places()).containsExactlyInAnyOrder("0.25 0.25", "0.75 0.25", "0.25 0.75", "0.75 0.75");

        CountingCamera secondPixel = new CountingCamera(new SimpleCamera(2, 1));
        render(new Scene(), secondPixel, 2);
        assertThat(secondPixel.places()).endsWith("1.25 0.25", "1.75 0.25", "1.25 0.75", "1.75 0.75");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 16})
    void aPixelHasNTimesNSamples(int n) {
        CountingCamera camera = new CountingCamera(new SimpleCamera(5, 3));
        render(new Scene(), camera, n);

        assertThat(camera.rays()).isEqualTo(15L * n * n);
    }

    /** The one pixel is [-2,2] wide, white from the edge on: its sub-cells' centres lie at -1 and 1, at -4/3, 0 and 4/3, ... */
    @ParameterizedTest
    @CsvSource({"1, 0.5, 0", "1, -0.5, 1", "2, 0, 0.5", "2, 1.1, 0", "2, -1.1, 1", "3, 0.5, 0.3333333333333333",
        "3, -0.5, 0.6666666666666667", "4, 0, 0.5", "4, 1, 0.25", "4, 0.4, 0.5", "4, 0.6, 0.25", "16, 0, 0.5", "16, 1, 0.25"})
    void aPixelIsTheMeanOfItsSamples(int n, double edge, double expected) throws IOException {
        for (double component : render(edge(edge, 1), new SimpleCamera(1, 1), n).row(0)) {
            assertThat(component).isEqualTo(expected, ROUNDING);
        }
    }

    @Test
    void aSampleIsClampedBeforeTheMean() throws IOException {
        assertThat(render(edge(0, 10), new SimpleCamera(1, 1), 2).row(0)).containsOnly(0.5);
        assertThat(render(edge(-10, 10), new SimpleCamera(1, 1), 2).row(0)).containsOnly(1);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3})
    void aPictureOfTheThesisIsTheMeanOfItsRays(int n) throws IOException {
        Scene scene = ThesisScene.read();
        SimpleCamera camera = new SimpleCamera(8, 8);
        Picture picture = render(scene, camera, n);
        SimpleCamera fine = new SimpleCamera(8 * n, 8 * n);

        for (int y = 0; y < 8; y++) {
            for (int x = 0; x < 8; x++) {
                double mean = 0;
                for (int i = 0; i < n * n; i++) {
                    Colour seen = new Colour();
                    scene.intersect(fine.ray(n * x + i % n, n * y + i / n), seen, DEPTH);
                    mean += Math.min(1, seen.g) / (n * n);
                }
                assertThat(picture.row(y)[3 * x + 1]).as(x + "," + y).isEqualTo(mean, within(1e-12));
            }
        }
    }

    /** {@return a half plane that glows right of the edge; a triangle large enough} */
    private static Scene edge(double x, double light) throws IOException {
        Scene scene = new Scene();
        scene.read(reader("1  2  " + x + " -900 0  " + x + " 900 0  900 0 0  1 1 1  0 0 0  0 0 0  0   "
            + (light + " ").repeat(3) + " 0"));
        return scene;
    }

    private static Picture render(Scene scene, Camera camera, int samples) {
        return new Renderer(scene, camera, new RenderSettings(Stage.FINAL, DEPTH, samples, 1)).render(RenderListener.NONE);
    }
}
