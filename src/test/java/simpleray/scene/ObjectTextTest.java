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
import simpleray.math.Vector;

/** Spheres and planes read, written and printed. */
class ObjectTextTest {
    private static final String MATERIAL = "1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0";
    private static final String MATERIAL_PRINT =
        "Material: ambient (1.0,1.0,1.0) diffuse (1.0,1.0,1.0) specular (0.0,0.0,0.0) shininess 2.0";

    @Test
    void aSphereIsWrittenAsCentreRadiusMaterial() {
        assertThat(written(new Sphere(new Material(), new Point(1.2, 0.4, -0.4), 0.5)::write))
            .isEqualTo("1.2 0.4 -0.4 0.5  " + MATERIAL);
    }

    @Test
    void aSphereReadsBackBitForBit() throws IOException {
        Sphere before = new Sphere(new Material(), new Point(1.0 / 3, -0.0, 1e90), Double.MIN_VALUE);
        Sphere after = new Sphere();
        after.read(reader(written(before::write)));

        assertThat(SceneBits.of(after)).isEqualTo(SceneBits.of(before));
    }

    @Test
    void readingMakesASphereItsOwnCentreAndMaterial() throws IOException {
        Material shared = new Material();
        Point centre = new Point(7, 7, 7);
        new Sphere(shared, centre, 1).read(reader("1 2 3 4  0 0 0 0 0 0 0 0 0 9"));

        assertThat(shared.shininess).isEqualTo(2);
        assertThat(centre).hasToString("[7.0,7.0,7.0]");
    }

    @Test
    void aSpherePrintsAsInTheThesis() {
        assertThat(written(new Sphere(new Material(), new Point(1.2, 0.4, -0.4), 0.5)::print))
            .isEqualTo("Sphere with centre: [1.2,0.4,-0.4] and radius: 0.5\n" + MATERIAL_PRINT);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-0.0", "-1", "-1e-300"})
    void aSphereHasARadiusAboveZero(String radius) {
        String line = "0 0 0 " + radius + ' ' + MATERIAL;
        assertThatThrownBy(() -> new Sphere().read(reader(line))).hasMessage(
            "<stdin>:1:7: error: expected radius above 0, found '" + radius + "'\n" + line + "\n      ^");
    }

    @Test
    void eachMissingPartOfASphereIsNamed() {
        assertThatThrownBy(() -> new Sphere().read(reader("0 0"))).hasMessage(
            "<stdin>:1:4: error: expected centre z, found the end of the file\n0 0\n   ^");
        assertThatThrownBy(() -> new Sphere().read(reader("0 0 0"))).hasMessage(
            "<stdin>:1:6: error: expected radius, found the end of the file\n0 0 0\n     ^");
        assertThatThrownBy(() -> new Sphere().read(reader("0 0 0 1\n1 1"))).hasMessage(
            "<stdin>:2:4: error: expected ambient blue, found the end of the file\n1 1\n   ^");
    }

    @Test
    void aPlaneIsWrittenAsNormalConstantMaterial() {
        assertThat(written(new Plane(new Material(), new Vector(0, -1, 0), -2)::write))
            .isEqualTo("0.0 -1.0 0.0 -2.0  " + MATERIAL);
    }

    @Test
    void aPlaneReadsBackBitForBit() throws IOException {
        Plane before = new Plane(new Material(), new Vector(1.0 / 3, -0.0, 1e90), -Double.MIN_VALUE);
        Plane after = new Plane();
        after.read(reader(written(before::write)));

        assertThat(SceneBits.of(after)).isEqualTo(SceneBits.of(before));
    }

    @Test
    void readingMakesAPlaneItsOwnNormal() throws IOException {
        Vector shared = new Vector(7, 7, 7);
        new Plane(new Material(), shared, 1).read(reader("1 2 3 4  0 0 0 0 0 0 0 0 0 9"));

        assertThat(shared).hasToString("[7.0,7.0,7.0]");
    }

    @Test
    void aPlanePrintsAsInTheThesis() {
        assertThat(written(new Plane(new Material(), new Vector(-1, 0, 0), -2)::print))
            .isEqualTo("Plane with normal: [-1.0,0.0,0.0] and constant: -2.0\n" + MATERIAL_PRINT);
    }

    @Test
    void aPlaneHasANormalOtherThanZero() {
        String line = " 0 0.0 -0  4 " + MATERIAL;
        assertThatThrownBy(() -> new Plane().read(reader(line))).hasMessage(
            "<stdin>:1:2: error: expected normal other than zero, found '0 0.0 -0'\n" + line + "\n ^");
    }

    @Test
    void eachMissingPartOfAPlaneIsNamed() {
        assertThatThrownBy(() -> new Plane().read(reader("0 y"))).hasMessage(
            "<stdin>:1:3: error: expected normal y, found 'y'\n0 y\n  ^");
        assertThatThrownBy(() -> new Plane().read(reader("0 1 0 c"))).hasMessage(
            "<stdin>:1:7: error: expected constant, found 'c'\n0 1 0 c\n      ^");
        assertThatThrownBy(() -> new Plane().read(reader("0 1 0 -2 #"))).hasMessage(
            "<stdin>:1:11: error: expected ambient red, found the end of the file\n0 1 0 -2 #\n          ^");
    }
}
