package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.scene.MaterialText.assertMissing;
import static simpleray.scene.MaterialText.assertWrong;
import static simpleray.scene.MaterialText.read;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Colour;
import simpleray.text.SceneReader;

/** Transmission in a scene file: {@code transmit r g b n} after the shininess. */
class MaterialGlassTextTest {
    private static final String MATT = "1 1 1  1 1 1  0 0 0  2";

    @ParameterizedTest
    @ValueSource(strings = {MATT + " transmit 0.5 0.25 1 1.5", MATT + "\ntransmit 0.5 0.25 1 1.5",
        MATT + " # glass\n\n  transmit\n0.5 0.25\n1 1.5"})
    void transmissionFollowsTheShininess(String text) throws IOException {
        Material glass = read(text);

        assertThat(glass.transmission).hasToString("(0.5,0.25,1.0)");
        assertThat(glass.index).isEqualTo(1.5);
        assertThat(glass.shininess).isEqualTo(2);
    }

    @Test
    void withoutItNothingPasses() throws IOException {
        assertThat(read(MATT).transmission).hasToString("(0.0,0.0,0.0)");
        assertThat(read(MATT).index).isEqualTo(1);
        assertThat(SceneBits.of(read(MATT))).isEqualTo(SceneBits.of(new Material()));
    }

    @Test
    void eachObjectHasItsOwn() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("3\n0 0 0 0 1 " + MATT + "\n1 0 1 0 0 " + MATT + "\ntransmit 1 1 1 2\n0 0 0 0 1 " + MATT + "\n0 0 0\n0\n"));

        assertThat(scene.getObject(0).surfaceMaterial.index).isEqualTo(1);
        assertThat(scene.getObject(1).surfaceMaterial.index).isEqualTo(2);
        assertThat(scene.getObject(2).surfaceMaterial.transmission.isBlack()).isTrue();
    }

    @Test
    void aMisspeltOneIsAHeadingWithAWarning() throws IOException {
        SceneReader is = reader("1\n0 0 0 0 1 " + MATT + "\ntransmits 1 1 1 2\n0 0 0\n0\n");
        new Scene().read(is);

        assertThat(is.warnings()).hasToString("""
            [<stdin>:3:1: warning: unknown setting 'transmits': did you mean transmit? The line is skipped
            transmits 1 1 1 2
            ^]""");
    }

    @ParameterizedTest
    @CsvSource({"0.5 0.5 0.5 1", "0 0 0 1.5", "0 0 1 1", "0.1 0.2 0.3 2.4"})
    void itIsWrittenAndPrintedWhereThereIsAny(String values) throws IOException {
        Material glass = read(MATT + " transmit " + values);
        Colour kt = glass.transmission;

        assertThat(written(glass::write)).isEqualTo("1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0  transmit "
            + kt.r + ' ' + kt.g + ' ' + kt.b + "  " + glass.index);
        assertThat(written(glass::print)).isEqualTo("Material: ambient (1.0,1.0,1.0) diffuse (1.0,1.0,1.0) specular (0.0,0.0,0.0)"
            + " shininess 2.0 transmission " + kt + " index " + glass.index);
        assertThat(SceneBits.of(read(written(glass::write)))).isEqualTo(SceneBits.of(glass));
    }

    @Test
    void aCopyHasATransmissionOfItsOwn() throws IOException {
        Material glass = read(MATT + " transmit 0.5 0.25 1 1.5");
        Material copy = new Material(glass);
        glass.transmission.r = 9;
        glass.index = 9;

        assertThat(copy.transmission).hasToString("(0.5,0.25,1.0)");
        assertThat(copy.index).isEqualTo(1.5);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
        "transmit 0 -1 0 1 | 12 | transmitted green of 0 or more, found '-1'",
        "transmit 0 0 NaN 1 | 14 | transmitted blue, found 'NaN' (numbers must be finite)",
        "transmit 0 0 0 0.999 | 16 | refractive index of 1 or more (a bubble in glass: docs/pictures.md), found '0.999'",
        "transmit 0 0 0 Infinity | 16 | refractive index, found 'Infinity' (numbers must be finite)"})
    void whatIsWrongWithItIsNamed(String line, int column, String expected) {
        assertWrong(MATT, line, column, expected);
    }

    @ParameterizedTest
    @CsvSource({"transmit, transmitted red", "transmit 1, transmitted green", "transmit 1 1, transmitted blue",
        "transmit 1 1 1, refractive index"})
    void whatIsMissingOfItIsNamed(String line, String expected) {
        assertMissing(MATT, line, expected);
    }

    @Test
    void twiceIsOnceTooMany() {
        String line = "transmit 1 1 1 1 transmit 0 0 0 1";

        assertThatThrownBy(() -> new Scene().read(reader("1\n0 0 0 0 1 " + MATT + '\n' + line + "\n0 0 0\n0\n"))).hasMessage(
            "<stdin>:3:18: error: expected object 1's keyword transmit only once, found 'transmit'\n" + line + '\n' + " ".repeat(17) + '^');
    }
}
