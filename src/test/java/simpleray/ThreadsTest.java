package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.render.RenderSettings;
import simpleray.render.Stage;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SimpleCamera;

/** A picture is the same file, byte for byte, whoever works on it: docs/decisions/0003. */
class ThreadsTest {
    @ParameterizedTest
    @ValueSource(strings = {"thesis", "facing-mirrors", "sphere-flake", "shininess"})
    void anyNumberOfThreadsMakesTheSameFile(String name) throws IOException {
        byte[] one = png(name, 1);

        assertThat(png(name, 1)).as("once more").isEqualTo(one);
        for (int threads : new int[] {2, 3, 7}) {
            assertThat(png(name, threads)).as(threads + " threads").isEqualTo(one);
        }
    }

    private static byte[] png(String name, int threads) throws IOException {
        Scene scene = SceneFile.read(Project.scene(name)).scene();
        return Rendered.png(scene, new SimpleCamera(97, 61), new RenderSettings(Stage.FINAL, RenderSettings.DEFAULT_DEPTH, 1, threads));
    }
}
