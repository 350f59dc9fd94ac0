package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class SceneFileLinesTest {
    @Test
    void eachObjectAndLightHasItsLine() throws IOException {
        String ball = "0  0 0 0  1\n 1 1 1  0 0 0  0 0 0  1\n";
        String text = "# a comment\n40\n" + ball + ("\n" + ball).repeat(39) + "1 1 1  2\n\n0  1 1 1  0 0 0 0  1 1 1  0 0 0\n";

        SceneFile file = SceneFile.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));

        for (int i = 0; i < 40; i++) {
            assertThat(file.lineOfObject(i)).isEqualTo(3 + 3 * i);
        }
        assertThat(file.lineOfLight(0)).isEqualTo(124);
        assertThat(file.lineOfLight(1)).isEqualTo(124);
        assertThat(file.lineOfObject(40)).as("there is none").isZero();
    }

    @Test
    void aSceneThatWasNotReadHasNoLines() {
        Scene scene = new Scene();
        scene.setNumberObjects(1);
        scene.setObject(0, new Sphere());

        assertThat(new SceneFile(scene, List.of()).lineOfObject(0)).isZero();
    }
}
