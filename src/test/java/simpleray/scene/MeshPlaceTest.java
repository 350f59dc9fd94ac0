package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/** A mesh where it stands: moved and scaled along each axis in its own way. */
class MeshPlaceTest {
    /** Two triangles of unlike sides: one that faces +z, and one that faces +x, ten units farther along z. */
    private static final double[] CORNERS = {1, 2, 3, 5, 2, 3, 1, 10, 3, 7, 0, 10, 7, 4, 10, 7, 0, 20};
    private static final double ROUNDING = 1e-12;

    @TempDir
    private Path folder;

    private static Mesh mesh(Point offset, double scale) {
        return new Mesh(new Material(), "a.obj", offset, scale,
            new Triangles(CORNERS, new int[] {0, 1, 2, 3, 4, 5}, new double[0], null));
    }

    @Test
    void theNormalIsThatOfTheTriangleThatIsNearestWhereTheMeshStands() {
        Mesh mesh = mesh(new Point(100, 200, 300), 2);

        assertThat(mesh.normal(new Point(104, 206, 306.1))).hasToString("[0.0,0.0,1.0]");
        assertThat(mesh.normal(new Point(114.1, 202, 324))).hasToString("[1.0,0.0,0.0]");
    }

    @ParameterizedTest
    @CsvSource({"2", "-2", "0.25"})
    void itsBoxIsThatOfItsCornersScaledAndMoved(double scale) {
        Bounds box = mesh(new Point(100, 200, 300), scale).bounds();

        assertThat(box.xmin()).isEqualTo(100 + Math.min(scale, 7 * scale), within(ROUNDING)).isLessThan(100 + Math.min(scale, 7 * scale));
        assertThat(box.xmax()).isEqualTo(100 + Math.max(scale, 7 * scale), within(ROUNDING))
            .isGreaterThan(100 + Math.max(scale, 7 * scale));
        assertThat(box.ymin()).isEqualTo(200 + Math.min(0, 10 * scale), within(ROUNDING)).isLessThan(200 + Math.min(0, 10 * scale));
        assertThat(box.ymax()).isEqualTo(200 + Math.max(0, 10 * scale), within(ROUNDING)).isGreaterThan(200 + Math.max(0, 10 * scale));
        assertThat(box.zmin()).isEqualTo(300 + Math.min(3 * scale, 20 * scale), within(ROUNDING))
            .isLessThan(300 + Math.min(3 * scale, 20 * scale));
        assertThat(box.zmax()).isEqualTo(300 + Math.max(3 * scale, 20 * scale), within(ROUNDING))
            .isGreaterThan(300 + Math.max(3 * scale, 20 * scale));
    }

    @Test
    void raysFindItWhereItStands() {
        Mesh mesh = mesh(new Point(100, 200, 300), 2);

        assertThat(mesh.intersect(new Ray(new Point(104, 206, 400), new Vector(0, 0, -1)))).isEqualTo(94, within(ROUNDING));
        assertThat(mesh.intersect(new Ray(new Point(120, 202, 324), new Vector(-2, 0, 0)))).isEqualTo(3, within(ROUNDING));
        assertThat(mesh.intersect(new Ray(new Point(104, 100, 306), new Vector(0, 1, 0)))).as("along its plane").isEqualTo(Object.MISS);
        Ray ray = new Ray(new Point(120, 202, 324), new Vector(-1, 0, 0));
        Hit hit = new Hit();
        mesh.intersect(ray, 0, hit);
        Interaction at = new Interaction();
        at.set(ray, hit, mesh);
        assertThat(at.outward).hasToString("[1.0,0.0,0.0]");
    }

    @ParameterizedTest
    @CsvSource({"1e60, true", "-1e60, true", "1.1e60, false", "-1.1e60, false"})
    void theScaleIsUpTo1e60(String scale, boolean good) {
        String text = "1 4 \"none.obj\" 0 0 0 " + scale + " 1 1 1 1 1 1 0 0 0 2 0 0 0 0";
        SceneFormatException e = catchThrowableOfType(SceneFormatException.class, () -> new Scene().read(reader(text)));

        assertThat(e.problems()).as("with that of the missing file").hasSize(good ? 1 : 2);
        assertThat(e.problems()).last().extracting(Diagnostic::message).asString()
            .startsWith(good ? "expected object 1's OBJ file" : "expected object 1's scale from -1e60 to 1e60, found '" + scale + "'");
    }

    @ParameterizedTest
    @CsvSource({"1e100, 1, true", "1e100, -1, true", "1e100, 1.1, false", "-1e50, 1e50, true", "-1e50, -1.1e50, false", "1e-100, 1e60, true"})
    void scaledCoordinatesAreNoLargerThanOtherLengths(String coordinate, String scale, boolean good) throws IOException {
        Path obj = Files.writeString(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 " + coordinate + " 0\nf 1 2 3\n");
        String text = "1 4 \"" + obj.getFileName() + "\" 0 0 0 " + scale + " 1 1 1 1 1 1 0 0 0 2  0 0 0  0";
        Path scene = Files.writeString(folder.resolve("a.scene"), text);

        if (good) {
            assertThat(SceneFile.read(scene).scene().getNumberObjects()).isEqualTo(1);
        } else {
            assertThatThrownBy(() -> SceneFile.read(scene)).isInstanceOf(SceneFormatException.class).hasMessageContaining(
                "expected object 1's scale that leaves the mesh's coordinates from -1e100 to 1e100, found '" + scale + "'");
        }
    }

    @Test
    void theLargestMeshIsSeenAndHasANormal() {
        double[] vertices = {-1e100, -1e100, 0, 1e100, -1e100, 0, 0, 1e100, 0};
        Triangles huge = new Triangles(vertices, new int[] {0, 1, 2}, new double[0], null);
        Mesh mesh = new Mesh(new Material(), "a.obj", new Point(), 1e-100, huge);

        assertThat(mesh.intersect(new Ray(new Point(0, 0, 3), new Vector(0, 0, -1)))).isEqualTo(3, within(ROUNDING));
        assertThat(mesh.normal(new Point(0, 0, 0.5))).hasToString("[0.0,0.0,1.0]");
        assertThat(huge.squaredDistance(0, new double[] {0, 0, 1e100})).isEqualTo(1e200, within(1e188));
        assertThat(huge.squaredDistance(0, new double[] {0, 2e100, 0})).isEqualTo(1e200, within(1e188));
    }
}
