package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;
import simpleray.text.SceneReader;

/** Triangles read, written and printed. */
class TriangleTextTest {
    private static final String MATERIAL = "1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0";
    private static final long SEED = 2013;
    private static final int LINES = 2000;

    private final Triangle triangle = new Triangle(new Material(), new Point(1.2, 0.4, -0.4), new Point(2, 3, 4), new Point(-1, 0, 5));

    @Test
    void aTriangleIsWrittenAsVerticesMaterial() {
        assertThat(written(triangle::write)).isEqualTo("1.2 0.4 -0.4  2.0 3.0 4.0  -1.0 0.0 5.0  " + MATERIAL);
    }

    @Test
    void aTrianglePrintsItsVertices() {
        assertThat(written(triangle::print)).isEqualTo("Triangle with vertices: [1.2,0.4,-0.4], [2.0,3.0,4.0], [-1.0,0.0,5.0]\n"
            + "Material: ambient (1.0,1.0,1.0) diffuse (1.0,1.0,1.0) specular (0.0,0.0,0.0) shininess 2.0");
    }

    @Test
    void aTriangleReadsBackBitForBit() throws IOException {
        Triangle before = new Triangle(new Material(), new Point(1.0 / 3, -0.0, 1e90), new Point(-1e90, Double.MIN_VALUE, 0),
            new Point(1e100, 0.1, 0.2));
        Triangle after = new Triangle();
        after.read(reader(written(before::write)));

        assertThat(SceneBits.of(after)).isEqualTo(SceneBits.of(before));
    }

    @Test
    void readingMakesATriangleItsOwnVertices() throws IOException {
        Point shared = new Point(7, 7, 7);
        new Triangle(new Material(), shared, shared, shared).read(reader("0 0 0 1 0 0 0 1 0  0 0 0 0 0 0 0 0 0 9"));

        assertThat(shared).hasToString("[7.0,7.0,7.0]");
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "0 0 0  0 0 0  0 0 0", "1 2 3  4 5 6  1 2 3", "1 2 3  1 2 3  4 5 6", "4 5 6  1 2 3  1 2 3", "0 0 0  1 1 1  3 3 3",
        "0.1 0.2 0.3  0.2 0.4 0.6  0.3 0.6 0.9", "-2 0 1e-200  -1 0 1e-200  5 0 1e-200", "1e-200 0 0  2e-200 0 0  3e-200 0 0"})
    void threeVerticesOnOneLineAreNoTriangle(String vertices) {
        String line = vertices + "  " + MATERIAL;
        assertThatThrownBy(() -> new Triangle().read(reader(line))).hasMessage(
            "<stdin>:1:1: error: expected three vertices not on one line, found '" + vertices + "'\n" + line + "\n^");
    }

    @Test
    void decimalsOnOneLineAreOnItThoughTheirDoublesAreNot() {
        Random random = new Random(SEED);
        for (int i = 0; i < LINES; i++) {
            StringBuilder line = new StringBuilder();
            int[] start = {digits(random), digits(random), digits(random)};
            int[] step = {digits(random), digits(random), digits(random)};
            int[] steps = {0, random.nextInt(9), -random.nextInt(9)};
            for (int k : steps) {
                for (int axis = 0; axis < 3; axis++) {
                    line.append(start[axis] + k * step[axis]).append("e-5 ");
                }
            }
            assertThatThrownBy(() -> new Triangle().read(reader(line + MATERIAL))).as("seed " + SEED + ", " + line)
                .hasMessageContaining("expected three vertices not on one line");
        }
    }

    private static int digits(Random random) {
        return random.nextInt(2_000_001) - 1_000_000;
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "0 0 0  1e-200 0 0  0 1e-200 0", "0 0 0  1 0 0  0.5 1e-200 0", "1e6 1e6 1e6  1000000.001 1e6 1e6  1e6 1000000.001 1e6",
        "0 0 0  1e100 0 0  0 1e100 0", "0 0 0  5e-324 0 0  0 5e-324 0"})
    void aTriangleMayBeSmallThinOrLarge(String vertices) throws IOException {
        Triangle thin = new Triangle();
        thin.read(reader(vertices + ' ' + MATERIAL));

        assertThat(thin.normal(thin.a)).hasToString("[0.0,0.0,1.0]");
    }

    @Test
    void verticesOnOneLineOverMoreLinesOfTheFileAreNamedByTheFirst() {
        assertThatThrownBy(() -> new Triangle().read(reader("0 0 0\n1 1 1\n2 2 2\n" + MATERIAL))).hasMessage(
            "<stdin>:1:1: error: expected three vertices not on one line, found '0'\n0 0 0\n^");
    }

    @Test
    void eachMissingPartOfATriangleIsNamed() {
        assertThatThrownBy(() -> new Triangle().read(reader("0 0"))).hasMessage(
            "<stdin>:1:4: error: expected first vertex z, found the end of the file\n0 0\n   ^");
        assertThatThrownBy(() -> new Triangle().read(reader("0 0 0 x"))).hasMessage(
            "<stdin>:1:7: error: expected second vertex x, found 'x'\n0 0 0 x\n      ^");
        assertThatThrownBy(() -> new Triangle().read(reader("0 0 0 1 0 0 0 y"))).hasMessage(
            "<stdin>:1:15: error: expected third vertex y, found 'y'\n0 0 0 1 0 0 0 y\n              ^");
        assertThatThrownBy(() -> new Triangle().read(reader("0 0 0 1 0 0 0 1 0 #"))).hasMessage(
            "<stdin>:1:20: error: expected ambient red, found the end of the file\n0 0 0 1 0 0 0 1 0 #\n                   ^");
    }

    @Test
    void aBadNumberIsNotTakenForAFlatTriangleToo() {
        SceneReader is = reader("0 0 0  1 x 0  2 0 0 " + MATERIAL);
        is.tolerate(20);

        assertThatThrownBy(() -> {
            new Triangle().read(is);
            is.complete("the end");
        }).hasMessage("<stdin>:1:10: error: expected second vertex y, found 'x'\n0 0 0  1 x 0  2 0 0 " + MATERIAL + "\n         ^");
    }
}
