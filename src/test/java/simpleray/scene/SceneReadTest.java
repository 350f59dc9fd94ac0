package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneReader;

class SceneReadTest {
    private static final String MATERIAL = "1 1 1  1 1 1  0 0 0  2";
    private static final String SPHERE = "0  0 0 0 1  " + MATERIAL + '\n';
    private static final String AMBIENT = "0.3 0.3 0.3\n";
    private static final String LIGHT = "0  1 1 1  0 5 0\n";

    @Test
    void aSceneIsObjectsAmbientLightAndLights() throws IOException {
        Scene scene = read("2\n" + SPHERE + "1 0 1 0 -2 " + MATERIAL + '\n' + AMBIENT + "2\n" + LIGHT + "1 1 1 1 0 -1 0");

        assertThat(scene.getNumberObjects()).isEqualTo(2);
        assertThat(scene.getObject(0)).isInstanceOf(Sphere.class);
        assertThat(scene.getObject(1)).isInstanceOf(Plane.class);
        assertThat(scene.ambient).hasToString("(0.3,0.3,0.3)");
        assertThat(scene.getNumberLights()).isEqualTo(2);
        assertThat(scene.getLight(0)).isInstanceOf(PointLight.class);
        assertThat(scene.getLight(1)).isInstanceOf(DirectionalLight.class);
    }

    @Test
    void aSceneMayHaveNothingInIt() throws IOException {
        Scene scene = read("0 0 0 0 0");

        assertThat(scene.getNumberObjects()).isZero();
        assertThat(scene.getNumberLights()).isZero();
    }

    @Test
    void readingTakesThePlaceOfWhatWasThere() throws IOException {
        Scene scene = Scenes.of(new Sphere(), new Sphere(), new Sphere());
        Scenes.light(scene, new PointLight(), new PointLight());
        scene.read(reader("1\n" + SPHERE + AMBIENT + "1\n" + LIGHT));

        assertThat(scene.getNumberObjects()).isEqualTo(1);
        assertThat(scene.getNumberLights()).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1\n" + SPHERE + AMBIENT + "2\n" + LIGHT, "1\n" + SPHERE + "0 0 x 0", "0 0 0 0 0 0", "", "x\n-1"})
    void readingThatFailsLeavesWhatWasThere(String text) {
        Scene scene = Scenes.of(new Sphere(), new Plane());
        Scenes.light(scene, new DirectionalLight());
        scene.ambient.r = 0.5;
        List<java.lang.Object> before = SceneBits.of(scene);

        assertThatThrownBy(() -> scene.read(reader(text))).isInstanceOf(SceneFormatException.class);

        assertThat(SceneBits.of(scene)).isEqualTo(before);
    }

    @Test
    void anEmptyFileLacksTheNumberOfObjects() {
        assertThatThrownBy(() -> read("# nothing")).hasMessage("""
            <stdin>:1:10: error: expected the number of objects, found the end of the file
            # nothing
                     ^""");
    }

    @Test
    void aBadValueNamesItsObjectAndField() {
        assertThatThrownBy(() -> read("3\n" + SPHERE + SPHERE + "0 0 0 0 1 1 1 1 1 1 abc 0 0 0 2\n" + AMBIENT + "0")).hasMessage("""
            <stdin>:4:21: error: expected object 3's diffuse blue, found 'abc'
            0 0 0 0 1 1 1 1 1 1 abc 0 0 0 2
                                ^""");
    }

    @Test
    void aBadValueNamesItsLightAndField() {
        assertThatThrownBy(() -> read("0\n" + AMBIENT + "2\n" + LIGHT + "1 1 1 1 0 down 0")).hasMessage("""
            <stdin>:5:11: error: expected light 2's direction y, found 'down'
            1 1 1 1 0 down 0
                      ^""");
    }

    @Test
    void aBadAmbientLightIsTheScenes() {
        assertThatThrownBy(() -> read("0\n0.3 -0.3 0.3\n0")).hasMessage("""
            <stdin>:2:5: error: expected the scene's ambient green of 0 or more, found '-0.3'
            0.3 -0.3 0.3
                ^""");
    }

    @Test
    void aMissingValueNamesWhatItBelongsTo() {
        assertThatThrownBy(() -> read("1\n0  0 0 0 1  1 1 1  1 1 1  0 0\n")).hasMessage(
            "<stdin>:3:1: error: expected object 1's specular blue, found the end of the file\n\n^");
        assertThatThrownBy(() -> read("0\n" + AMBIENT + "1\n0 1 1 1 0")).hasMessage("""
            <stdin>:4:10: error: expected light 1's origin y, found the end of the file
            0 1 1 1 0
                     ^""");
    }

    @Test
    void allValuesOutOfTheirRangesAreReportedTogether() {
        assertThatThrownBy(() -> read("2\n0 0 0 0 -1 1 1 1 1 1 1 0 0 0 -2\n1 0 0 0 5 " + MATERIAL + '\n' + AMBIENT + "0")).hasMessage("""
            <stdin>:2:9: error: expected object 1's radius above 0, found '-1'
            0 0 0 0 -1 1 1 1 1 1 1 0 0 0 -2
                    ^
            <stdin>:2:30: error: expected object 1's shininess of 0 or more, found '-2'
            0 0 0 0 -1 1 1 1 1 1 1 0 0 0 -2
                                         ^
            <stdin>:3:3: error: expected object 2's normal other than zero, found '0 0 0'
            1 0 0 0 5 1 1 1  1 1 1  0 0 0  2
              ^""");
    }

    private static Scene read(String text) throws IOException {
        Scene scene = new Scene();
        try (SceneReader is = reader(text)) {
            scene.read(is);
        }
        return scene;
    }
}
