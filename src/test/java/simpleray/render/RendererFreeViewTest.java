package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.image.Picture;
import simpleray.scene.Camera;
import simpleray.scene.FreeView;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings.Resolution;

/** A simple camera and the free camera in its place give the same picture. */
class RendererFreeViewTest {
    @ParameterizedTest
    @CsvSource({"thesis, 120, 90", "thesis, 200, 200", "open-floor, 90, 120", "many-spheres, 100, 70"})
    void noLevelOfThePictureDiffersByMoreThanOne(String name, int width, int height) throws IOException {
        Scene scene = SceneFile.read(Path.of(System.getProperty("simpleray.scenes"), name + ".scene")).scene();
        scene.settings.camera = null;
        scene.settings.resolution = new Resolution(width, height);
        Picture simple = rendered(scene, scene.settings.newCamera());
        Picture free = rendered(scene, new PerspectiveCamera(FreeView.of(scene.settings), width, height));

        assertThat(FreeView.isExact(scene.settings)).isTrue();
        for (int y = 0; y < height; y++) {
            byte[] expected = simple.levels(y);
            byte[] actual = free.levels(y);
            for (int i = 0; i < expected.length; i++) {
                assertThat(Math.abs((expected[i] & 0xFF) - (actual[i] & 0xFF))).as("row %d, level %d", y, i).isLessThanOrEqualTo(1);
            }
        }
    }

    private static Picture rendered(Scene scene, Camera camera) {
        return new Renderer(scene, camera, new RenderSettings(Stage.FINAL, RenderSettings.DEFAULT_DEPTH, 1, 2))
            .render(RenderListener.NONE);
    }
}
