package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.text.SceneReader;

class SceneRoundTripTest {
    private static final int SCENES = 500;
    private static final long SEED = 20100623;

    @Test
    void aSceneIsWrittenALineForEachThing() {
        Scene scene = Scenes.of(new Sphere(), new Plane());
        scene.ambient = new Colour(0.25, 0.5, 1);
        Scenes.light(scene, new PointLight(), new DirectionalLight());

        assertThat(written(scene::write)).isEqualTo("""
            # number of objects
            2
            0  0.0 0.0 0.0 1.0  1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0
            1  0.0 1.0 0.0 0.0  1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0
            # ambient light
            0.25 0.5 1.0
            # number of lights
            2
            0  1.0 1.0 1.0  0.0 0.0 0.0
            1  1.0 1.0 1.0  0.0 -1.0 0.0
            """);
    }

    @Tag("slow")
    @Test
    void anySceneReadsBackBitForBit() throws IOException {
        for (int i = 0; i < SCENES; i++) {
            Scene before = RandomScenes.scene(new Random(SEED + i));
            Scene after = new Scene();
            try (SceneReader is = reader(written(before::write))) {
                after.read(is);
                assertThat(is.warnings()).isEmpty();
            }
            assertThat(SceneBits.of(after)).as("seed " + (SEED + i)).isEqualTo(SceneBits.of(before));
        }
    }

    @Test
    void transmissionAndSettingsAreWrittenWhereThereAreAny() {
        Sphere glass = new Sphere();
        glass.surfaceMaterial.transmission = new Colour(0.5, 0.25, 1);
        glass.surfaceMaterial.index = 1.5;
        Scene scene = Scenes.of(glass);
        scene.settings.background = new Colour(0.1, 0.2, 0.4);
        scene.settings.window = new SceneSettings.Window(-1, 1, -0.5, 0.5);
        scene.settings.cop = 3.0;
        scene.settings.resolution = new SceneSettings.Resolution(640, 480);
        scene.settings.depth = 5;
        scene.settings.samples = 4;

        assertThat(written(scene::write)).isEqualTo("""
            # number of objects
            1
            0  0.0 0.0 0.0 1.0  1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0  transmit 0.5 0.25 1.0  1.5
            # ambient light
            0.0 0.0 0.0
            # number of lights
            0
            background 0.1 0.2 0.4
            window -1.0 1.0 -0.5 0.5
            cop 3.0
            resolution 640 480
            depth 5
            samples 4
            """);
    }

    @Test
    void aCameraIsWrittenAsEyeLookAtFieldOfView() {
        Scene scene = new Scene();
        scene.settings.camera = new PerspectiveCamera.Pose(3, 2, 5, 0, 0.5, 0, 40);

        assertThat(written(scene::write)).endsWith("\n0\ncamera 3.0 2.0 5.0 0.0 0.5 0.0 40.0\n");
    }

    @Test
    void anObjectOfAClassWithoutCodeCannotBeWritten() {
        Scene scene = Scenes.of(new StandIn());

        assertThatThrownBy(() -> written(scene::write)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("a scene file has no code for " + StandIn.class.getName());
    }
}
