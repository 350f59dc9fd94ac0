package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;

/** Cones read, written and printed. */
class ConeTextTest {
    private static final String MATERIAL = "1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0";

    private final Cone cone = new Cone(new Material(), new Point(1.2, 0.4, -0.4), 0.5, new Point(2, 3, 4), 0);

    @Test
    void aConeIsWrittenAsEachEndWithItsRadiusAndMaterial() {
        assertThat(written(cone::write)).isEqualTo("1.2 0.4 -0.4 0.5  2.0 3.0 4.0 0.0  " + MATERIAL);
    }

    @Test
    void aConePrintsItsEndsAndRadii() {
        assertThat(written(cone::print)).isEqualTo("Cone with ends: [1.2,0.4,-0.4] and [2.0,3.0,4.0] and radii: 0.5 and 0.0\n"
            + "Material: ambient (1.0,1.0,1.0) diffuse (1.0,1.0,1.0) specular (0.0,0.0,0.0) shininess 2.0");
    }

    @Test
    void aConeReadsBackBitForBit() throws IOException {
        Cone before = new Cone(new Material(), new Point(1.0 / 3, -0.0, 1e100), 1e100, new Point(0.1, Double.MIN_VALUE, -1e-300), -0.0);
        Cone after = new Cone();
        after.read(reader(written(before::write)));

        assertThat(SceneBits.of(after)).isEqualTo(SceneBits.of(before));
    }

    @Test
    void eitherRadiusMayBeZero() throws IOException {
        Cone up = new Cone();
        up.read(reader("0 0 0 2  0 1 0 0  " + MATERIAL));
        assertThat(up.startRadius).isEqualTo(2);
        assertThat(up.endRadius).isZero();
        Cone down = new Cone();
        down.read(reader("0 0 0 0  0 1 0 2  " + MATERIAL));
        assertThat(down.startRadius).isZero();
        assertThat(down.endRadius).isEqualTo(2);
    }

    @Test
    void readingMakesAConeItsOwnEnds() throws IOException {
        Point shared = new Point(7, 7, 7);
        new Cone(new Material(), shared, 1, shared, 1).read(reader("0 0 0 5 0 1 0 5  0 0 0 0 0 0 0 0 0 9"));

        assertThat(shared).hasToString("[7.0,7.0,7.0]");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1 2 3", "1.0 2.0 3e0"})
    void aConeOfZeroLengthIsNone(String end) {
        String line = "1 2 3 1 " + end + " 1 " + MATERIAL;
        assertThatThrownBy(() -> new Cone().read(reader(line))).hasMessage(
            "<stdin>:1:9: error: expected second end that differs from the first, found '" + end + "'\n" + line + "\n        ^");
    }

    @Test
    void aConeHasARadiusAtOneEndAtLeast() {
        String line = "0 0 0 0 0 1 0 -0.0 " + MATERIAL;
        assertThatThrownBy(() -> new Cone().read(reader(line))).hasMessage(
            "<stdin>:1:15: error: expected second radius above 0, since the first is 0, found '-0.0'\n" + line + "\n              ^");
    }

    @Test
    void noRadiusIsBelowZero() {
        assertThatThrownBy(() -> new Cone().read(reader("0 0 0 -1 0 1 0 1 " + MATERIAL))).hasMessageStartingWith(
            "<stdin>:1:7: error: expected first radius of 0 or more, found '-1'\n");
        assertThatThrownBy(() -> new Cone().read(reader("0 0 0 1 0 1 0 -1e-300 " + MATERIAL))).hasMessageStartingWith(
            "<stdin>:1:15: error: expected second radius of 0 or more, found '-1e-300'\n");
    }

    @Test
    void noNumberIsBeyond1e100() {
        assertThatThrownBy(() -> new Cone().read(reader("0 0 0 1.1e100 0 1 0 1 " + MATERIAL))).hasMessageStartingWith(
            "<stdin>:1:7: error: expected first radius of 1e100 or less, found '1.1e100'\n");
        assertThatThrownBy(() -> new Cone().read(reader("0 -2e100 0 1 0 1 0 1 " + MATERIAL))).hasMessageStartingWith(
            "<stdin>:1:1: error: expected first end of numbers from -1e100 to 1e100, found '0 -2e100 0'\n");
        assertThatThrownBy(() -> new Cone().read(reader("0 0 0 1 0 1 2e100 1 " + MATERIAL))).hasMessageStartingWith(
            "<stdin>:1:9: error: expected second end of numbers from -1e100 to 1e100, found '0 1 2e100'\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"NaN", "Infinity", "1e999", "0x1p3", "1f"})
    void aRadiusIsAFiniteNumber(String radius) {
        assertThatThrownBy(() -> new Cone().read(reader("0 0 0 " + radius + " 0 1 0 1 " + MATERIAL)))
            .hasMessageStartingWith("<stdin>:1:7: error: expected first radius, found '" + radius + "'");
    }

    @Test
    void eachMissingPartOfAConeIsNamed() {
        assertThatThrownBy(() -> new Cone().read(reader("0 0"))).hasMessage(
            "<stdin>:1:4: error: expected first end z, found the end of the file\n0 0\n   ^");
        assertThatThrownBy(() -> new Cone().read(reader("0 0 0 x"))).hasMessage(
            "<stdin>:1:7: error: expected first radius, found 'x'\n0 0 0 x\n      ^");
        assertThatThrownBy(() -> new Cone().read(reader("0 0 0 1\n*"))).hasMessage(
            "<stdin>:2:1: error: expected second end x, found '*'\n*\n^");
        assertThatThrownBy(() -> new Cone().read(reader("0 0 0 1 1 0 0"))).hasMessage(
            "<stdin>:1:14: error: expected second radius, found the end of the file\n0 0 0 1 1 0 0\n             ^");
        assertThatThrownBy(() -> new Cone().read(reader("0 0 0 1 1 0 0 5 #"))).hasMessage(
            "<stdin>:1:18: error: expected ambient red, found the end of the file\n0 0 0 1 1 0 0 5 #\n                 ^");
    }
}
