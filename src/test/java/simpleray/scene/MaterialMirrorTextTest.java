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
import simpleray.text.SceneReader;

/** A mirror share of its own in a scene file: {@code mirror r g b} after the shininess, before or after {@code transmit}. */
class MaterialMirrorTextTest {
    private static final String SHINY = "1 1 1  1 1 1  0.5 0.5 0.5  20";

    @ParameterizedTest
    @ValueSource(strings = {SHINY + " mirror 0.25 0 1", SHINY + "\nmirror 0.25 0 1", SHINY + " # varnish\n\n  mirror\n0.25 0\n1"})
    void itFollowsTheShininess(String text) throws IOException {
        Material material = read(text);

        assertThat(material.mirrored()).isSameAs(material.mirror).hasToString("(0.25,0.0,1.0)");
        assertThat(material.specular).hasToString("(0.5,0.5,0.5)");
        assertThat(material.shininess).isEqualTo(20);
        assertThat(material.transmission.isBlack()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {" mirror 0.25 0 1 transmit 0.5 0.5 1 1.5", " transmit 0.5 0.5 1 1.5 mirror 0.25 0 1",
        "\nmirror 0.25 0 1\ntransmit 0.5 0.5 1 1.5", "\ntransmit 0.5 0.5 1 1.5\nmirror 0.25 0 1", " transmit 0.5 0.5 1\n1.5\n\nmirror 0.25 0 1"})
    void itStandsBeforeOrAfterTransmit(String words) throws IOException {
        assertThat(written(read(SHINY + words)::write)).isEqualTo(
            "1.0 1.0 1.0  1.0 1.0 1.0  0.5 0.5 0.5  20.0  mirror 0.25 0.0 1.0  transmit 0.5 0.5 1.0  1.5");
    }

    @Test
    void withoutItKsIsTheMirrorRaysShare() throws IOException {
        Material material = read(SHINY);

        assertThat(material.mirror).isNull();
        assertThat(material.mirrored()).isSameAs(material.specular);
        assertThat(written(material::write)).doesNotContain("mirror");
        assertThat(written(material::print)).doesNotContain("mirror");
    }

    @Test
    void eachObjectHasItsOwn() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("3\n0 0 0 0 1 " + SHINY + "\n1 0 1 0 0 " + SHINY + "\nmirror 0 0 0\n0 0 0 0 1 " + SHINY + "\n0 0 0\n0\n"));

        assertThat(scene.getObject(0).surfaceMaterial.mirror).isNull();
        assertThat(scene.getObject(1).surfaceMaterial.mirror).hasToString("(0.0,0.0,0.0)");
        assertThat(scene.getObject(2).surfaceMaterial).isSameAs(scene.getObject(0).surfaceMaterial);
    }

    @ParameterizedTest
    @CsvSource({"0 0 0", "-0.0 0 0", "0.5 0.5 0.5", "0.1 0.2 0.3", "2 1 7"})
    void itIsWrittenAndPrintedWhereverItIsGiven(String values) throws IOException {
        Material material = read(SHINY + " mirror " + values);

        assertThat(written(material::print)).isEqualTo("Material: ambient (1.0,1.0,1.0) diffuse (1.0,1.0,1.0) specular (0.5,0.5,0.5)"
            + " shininess 20.0 mirror " + material.mirror);
        assertThat(SceneBits.of(read(written(material::write)))).isEqualTo(SceneBits.of(material)).isNotEqualTo(SceneBits.of(read(SHINY)));
    }

    @Test
    void aCopyHasAMirrorOfItsOwn() throws IOException {
        Material material = read(SHINY + " mirror 0.25 0 1");
        Material copy = new Material(material);
        material.mirror.r = 9;

        assertThat(copy.mirror).hasToString("(0.25,0.0,1.0)");
        assertThat(new Material(read(SHINY)).mirror).isNull();
    }

    @Test
    void readingAMaterialAnewForgetsIt() throws IOException {
        Material material = read(SHINY + " mirror 0.25 0 1");
        material.read(reader(SHINY));

        assertThat(SceneBits.of(material)).isEqualTo(SceneBits.of(read(SHINY)));
    }

    @Test
    void aMisspeltOneIsAHeadingWithAWarning() throws IOException {
        SceneReader is = reader("1\n0 0 0 0 1 " + SHINY + "\nmirrors 1 1 1\n0 0 0\n0\n");
        new Scene().read(is);

        assertThat(is.warnings()).hasToString("""
            [<stdin>:3:1: warning: unknown setting 'mirrors': did you mean mirror? The line is skipped
            mirrors 1 1 1
            ^]""");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
        "mirror -1 0 0 | 8 | mirrored red of 0 or more, found '-1'",
        "mirror 0 1,5 0 | 10 | mirrored green, found '1,5' (a decimal point is a '.')",
        "mirror 0 0 NaN | 12 | mirrored blue, found 'NaN' (numbers must be finite)",
        "mirror 0 0 0 mirror 1 1 1 | 14 | keyword mirror only once, found 'mirror'",
        "mirror 0 0 0 transmit 1 1 1 1 mirror 1 1 1 | 31 | keyword mirror only once, found 'mirror'",
        "transmit 0 0 0 1 transmit 1 1 1 1 | 18 | keyword transmit only once, found 'transmit'",
        "transmit 1 1 1 1 mirror 0 0 0 transmit 1 1 1 1 | 31 | keyword transmit only once, found 'transmit'"})
    void whatIsWrongWithItIsNamed(String line, int column, String expected) {
        assertWrong(SHINY, line, column, expected);
    }

    @Test
    void twiceIsOnceTooManyOnALineOfItsOwnToo() {
        assertThatThrownBy(() -> new Scene().read(reader("1\n0 0 0 0 1 " + SHINY + " mirror 1 1 1\nmirror 1 1 1\n0 0 0\n0\n")))
            .hasMessageStartingWith("<stdin>:3:1: error: expected object 1's keyword mirror only once, found 'mirror'");
    }

    @Test
    void soIsASecondTransmit() {
        assertThatThrownBy(() -> new Scene().read(reader("1\n0 0 0 0 1 " + SHINY + " transmit 1 1 1 1\n transmit 1 1 1 1\n0 0 0\n0\n")))
            .hasMessageStartingWith("<stdin>:3:2: error: expected object 1's keyword transmit only once, found 'transmit'").hasMessageEndingWith("^");
    }

    @ParameterizedTest
    @CsvSource({"mirror, mirrored red", "mirror 1, mirrored green", "mirror 1 1, mirrored blue"})
    void whatIsMissingOfItIsNamed(String line, String expected) {
        assertMissing(SHINY, line, expected);
    }
}
