package simpleray.rays;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.Project;
import simpleray.math.Colour;
import simpleray.scene.Camera;
import simpleray.scene.ParallelCamera;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.RayTreeRecorder;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SimpleCamera;

/** What a viewer calls the objects of a scene. */
class ObjectNamesTest {
    @Test
    void theThesissObjectsAreNamedAsOneSeesThem() throws IOException {
        assertThat(names(SceneFile.read(Project.scene("thesis")).scene(), new SimpleCamera())).isEqualTo("yellow right wall, mirror floor, "
            + "green ceiling, blue left wall, red back wall, brown sphere, white sphere, mirror sphere, brown sphere");
    }

    @Test
    void wallsAreNamedAsTheCameraLooks() throws IOException {
        Scene room = new Scene();
        room.read(reader("""
            4
            1 1 0 0 -2   0 0 0  0.5 0.5 0.5  0 0 0  1
            1 0 0 -4 8   0 0 0  0.5 0.5 0.5  0 0 0  1
            1 0 2 0 6    0 0 0  0.5 0.5 0.5  0 0 0  1
            1 1 1 0 -2   0 0 0  0.5 0.5 0.5  0 0 0  1
            0 0 0  0
            """));

        assertThat(names(room, new SimpleCamera())).isEqualTo("grey left wall, grey back wall, grey ceiling, grey plane");
        assertThat(names(room, new PerspectiveCamera(new PerspectiveCamera.Pose(0, 0, 0, -1, 0, 0, 60), 9, 9)))
            .isEqualTo("grey back wall, grey right wall, grey ceiling, grey plane");
        assertThat(names(room, new ParallelCamera(new ParallelCamera.View(0, 0, 0, -1, 0, 0, 5), null, 9, 9)))
            .isEqualTo("grey back wall, grey right wall, grey ceiling, grey plane");
    }

    @Test
    void glassAndFiltersAreNamedByWhatPassesThrough() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("""
            3
            0 0 0 0 1  0 0 0  0 0 0  0 0 0  9  transmit 1 1 1 1.5
            0 0 0 0 1  0 0 0  0 0 0  0 0 0  9  transmit 0 0.1 0.9 1.5
            2 0 0 0 1 0 0 0 1 0  0 0 0  0 0 0  0 0 0  9  transmit 0.9 0 0 1
            0 0 0  0
            """));

        assertThat(names(scene, new SimpleCamera())).isEqualTo("glass sphere, blue glass sphere, red transparent triangle");
    }

    @ParameterizedTest
    @CsvSource({"0.05,0,0,black", "0.8,0.8,0.7,white", "0.4,0.4,0.4,grey", "0.9,0.1,0.1,red", "0.9,0.1,0.2,red", "0.9,0.5,0.1,orange",
        "0.5,0.3,0.1,brown", "0.8,0.8,0.1,yellow", "0.1,0.8,0.1,green", "0.1,0.8,0.8,turquoise", "0.1,0.1,0.8,blue", "0.5,0.1,0.8,violet",
        "0.9,0.1,0.7,pink"})
    void coloursHaveWords(double r, double g, double b, String word) {
        assertThat(ObjectNames.colour(new Colour(r, g, b))).isEqualTo(word);
    }

    private static String names(Scene scene, Camera camera) {
        ObjectNames names = new ObjectNames(scene, camera);
        return IntStream.range(0, scene.getNumberObjects()).mapToObj(i -> names.of(RayTreeRecorder.object(scene, i), null))
            .collect(Collectors.joining(", "));
    }
}
