package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Colour;
import simpleray.text.SceneFormatException;

class MaterialTest {
    @Test
    void theDefaultIsWhiteAndMatt() {
        assertThat(written(new Material()::print)).isEqualTo(
            "Material: ambient (1.0,1.0,1.0) diffuse (1.0,1.0,1.0) specular (0.0,0.0,0.0) shininess 2.0");
    }

    @Test
    void aCopyHasColoursOfItsOwn() {
        Material material = new Material();
        material.ambient = new Colour(0.5, 0.25, 0.125);
        material.shininess = 7;
        Material copy = new Material(material);
        material.ambient.r = 9;
        material.diffuse.r = 9;
        material.specular.r = 9;
        material.shininess = 9;

        assertThat(written(copy::print)).isEqualTo(
            "Material: ambient (0.5,0.25,0.125) diffuse (1.0,1.0,1.0) specular (0.0,0.0,0.0) shininess 7.0");
    }

    @Test
    void twoNewMaterialsShareNothing() {
        new Material().diffuse.r = 9;
        assertThat(new Material().diffuse.r).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "0.9, 0", "1, 1", "2.999, 2", "5, 5", "1e300, 2147483647"})
    void theWholePartOfTheShininessIsTheMostReflections(double shininess, int reflections) {
        Material material = new Material();
        material.shininess = shininess;
        assertThat(material.reflections()).isEqualTo(reflections);
    }

    @Test
    void aMaterialIsWrittenAsThreeColoursAndTheShininess() throws IOException {
        Material material = new Material();
        material.read(reader("0.1 0.2 0.3\n0.4 0.5 0.6\n0.7 0.8 0.9\n5"));

        assertThat(written(material::write)).isEqualTo("0.1 0.2 0.3  0.4 0.5 0.6  0.7 0.8 0.9  5.0");
    }

    @Test
    void aMaterialReadsBackBitForBit() throws IOException {
        Material before = new Material();
        before.ambient = new Colour(1.0 / 3, -0.0, Double.MIN_VALUE);
        before.diffuse = new Colour(1e300, 0.1, 7);
        before.specular = new Colour(2.0 / 3, 1e-10, 1e23);
        before.shininess = Math.PI;
        Material after = new Material();
        after.read(reader(written(before::write)));

        assertThat(SceneBits.of(after)).isEqualTo(SceneBits.of(before));
    }

    @Test
    void eachMissingPartIsNamed() {
        assertThatThrownBy(() -> new Material().read(reader("1 1 1 1 *"))).hasMessage(
            "<stdin>:1:9: error: expected diffuse green, found '*'\n1 1 1 1 *\n        ^");
        assertThatThrownBy(() -> new Material().read(reader("1 1 1 1 1 1 0"))).hasMessage(
            "<stdin>:1:14: error: expected specular green, found the end of the file\n1 1 1 1 1 1 0\n             ^");
        assertThatThrownBy(() -> new Material().read(reader("1 1 1 1 1 1 0 0 0"))).hasMessage(
            "<stdin>:1:18: error: expected shininess, found the end of the file\n1 1 1 1 1 1 0 0 0\n                 ^");
    }

    @Test
    void colourAndShininessAreNotBelowZero() {
        assertThatThrownBy(() -> new Material().read(reader("1 -1 1 1 1 1 0 0 0 2"))).isInstanceOf(SceneFormatException.class)
            .hasMessage("<stdin>:1:3: error: expected ambient green of 0 or more, found '-1'\n1 -1 1 1 1 1 0 0 0 2\n  ^");
        assertThatThrownBy(() -> new Material().read(reader("1 1 1 1 1 1 0 0 0 -2"))).isInstanceOf(SceneFormatException.class)
            .hasMessage("<stdin>:1:19: error: expected shininess of 0 or more, found '-2'\n1 1 1 1 1 1 0 0 0 -2\n"
                + " ".repeat(18) + '^');
    }
}
