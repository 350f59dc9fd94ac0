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

/** Cylinders read, written and printed. */
class CylinderTextTest {
    private static final String MATERIAL = "1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0";

    private final Cylinder cylinder = new Cylinder(new Material(), new Point(1.2, 0.4, -0.4), new Point(2, 3, 4), 0.5);

    @Test
    void aCylinderIsWrittenAsEndsRadiusMaterial() {
        assertThat(written(cylinder::write)).isEqualTo("1.2 0.4 -0.4  2.0 3.0 4.0  0.5  " + MATERIAL);
    }

    @Test
    void aCylinderPrintsItsEndsAndRadius() {
        assertThat(written(cylinder::print)).isEqualTo("Cylinder with ends: [1.2,0.4,-0.4] and [2.0,3.0,4.0] and radius: 0.5\n"
            + "Material: ambient (1.0,1.0,1.0) diffuse (1.0,1.0,1.0) specular (0.0,0.0,0.0) shininess 2.0");
    }

    @Test
    void aCylinderReadsBackBitForBit() throws IOException {
        Cylinder before = new Cylinder(new Material(), new Point(1.0 / 3, -0.0, 1e90), new Point(0.1, Double.MIN_VALUE, -1e-300),
            1e100);
        Cylinder after = new Cylinder();
        after.read(reader(written(before::write)));

        assertThat(SceneBits.of(after)).isEqualTo(SceneBits.of(before));
    }

    @Test
    void readingMakesACylinderItsOwnEnds() throws IOException {
        Point shared = new Point(7, 7, 7);
        new Cylinder(new Material(), shared, shared, 1).read(reader("0 0 0 0 1 0 5  0 0 0 0 0 0 0 0 0 9"));

        assertThat(shared).hasToString("[7.0,7.0,7.0]");
    }

    @ParameterizedTest
    @ValueSource(strings = {"0 0 0  0 0 0", "1 2 3  1.0 2.0 3e0", "0 0 0  -0 0 0"})
    void aCylinderOfZeroLengthIsNone(String ends) {
        String line = ' ' + ends + " 1 " + MATERIAL;
        assertThatThrownBy(() -> new Cylinder().read(reader(line))).hasMessage(
            "<stdin>:1:2: error: expected two ends that differ, found '" + ends + "'\n" + line + "\n ^");
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-0.0", "-1", "-1e-300"})
    void aCylinderHasARadiusAboveZero(String radius) {
        String line = "0 0 0 0 1 0 " + radius + ' ' + MATERIAL;
        assertThatThrownBy(() -> new Cylinder().read(reader(line))).hasMessage(
            "<stdin>:1:13: error: expected radius above 0, found '" + radius + "'\n" + line + "\n            ^");
    }

    @Test
    void eachMissingPartOfACylinderIsNamed() {
        assertThatThrownBy(() -> new Cylinder().read(reader("0 0"))).hasMessage(
            "<stdin>:1:4: error: expected first end z, found the end of the file\n0 0\n   ^");
        assertThatThrownBy(() -> new Cylinder().read(reader("0 0 0 x"))).hasMessage(
            "<stdin>:1:7: error: expected second end x, found 'x'\n0 0 0 x\n      ^");
        assertThatThrownBy(() -> new Cylinder().read(reader("0 0 0\n1 0 0"))).hasMessage(
            "<stdin>:2:6: error: expected radius, found the end of the file\n1 0 0\n     ^");
        assertThatThrownBy(() -> new Cylinder().read(reader("0 0 0 1 0 0 5 #"))).hasMessage(
            "<stdin>:1:16: error: expected ambient red, found the end of the file\n0 0 0 1 0 0 5 #\n               ^");
    }
}
