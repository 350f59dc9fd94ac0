package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.text.SceneText.written;

import org.junit.jupiter.api.Test;
import simpleray.math.Point;
import simpleray.math.Vector;

/** Each shape as POV-Ray has it, without its closing brace, and which of them have an inside. */
class PovShapesTest {
    private static final double[] CORNERS = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    /** Each corner of a cube cut off: four triangles that look outward. */
    private static final int[] CLOSED = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

    private static Mesh mesh(Point offset, double scale, Triangles triangles) {
        return new Mesh(new Material(), "a.obj", offset, scale, triangles);
    }

    @Test
    void aTrianglesVerticesRunTheOtherWayRound() {
        Triangle triangle = new Triangle(new Material(), new Point(1, 2, 3), new Point(4, 5, 6), new Point(-7, 8, -0.0));

        assertThat(written(triangle::writePov)).isEqualTo("triangle { <1.0,2.0,3.0>, <-7.0,8.0,0.0>, <4.0,5.0,6.0>");
    }

    @Test
    void aCylinderHasTwoEndsAndARadius() {
        Cylinder cylinder = new Cylinder(new Material(), new Point(1, 2, 3), new Point(4, 5, 6), 0.5);

        assertThat(written(cylinder::writePov)).isEqualTo("cylinder { <1.0,2.0,3.0>, <4.0,5.0,6.0>, 0.5");
    }

    @Test
    void aPlanesConstantIsItsDistanceFromTheOrigin() {
        assertThat(written(new Plane(new Material(), new Vector(0, 0, -4), 2)::writePov)).isEqualTo("plane { <0.0,0.0,-1.0>, 0.5");
    }

    @Test
    void aMeshIsWrittenAsItStands() {
        // twice as large, and moved by (10, 20, 30)
        Mesh mesh = mesh(new Point(10, 20, 30), 2, new Triangles(CORNERS, new int[] {0, 1, 2, 1, 2, 3}, new double[0], null));

        assertThat(written(mesh::writePov)).isEqualTo("""
            mesh {
            triangle { <10.0,20.0,30.0>, <10.0,22.0,30.0>, <12.0,20.0,30.0> }
            triangle { <12.0,20.0,30.0>, <10.0,20.0,32.0>, <10.0,22.0,30.0> }
            inside_vector <0.1, 0.2, 1>""");
    }

    @Test
    void whereAMeshHasNormalsItsTrianglesAreSmooth() {
        Triangles triangles = new Triangles(CORNERS, new int[] {0, 1, 2, 1, 2, 3}, new double[] {0, 0, 1, 0.6, 0, 0.8, 0, 1, 0},
            new int[] {-1, -1, -1, 0, 1, 2});

        assertThat(written(mesh(new Point(), 1, triangles)::writePov)).isEqualTo("""
            mesh {
            triangle { <0.0,0.0,0.0>, <0.0,1.0,0.0>, <1.0,0.0,0.0> }
            smooth_triangle { <1.0,0.0,0.0>, <0.0,0.0,1.0>, <0.0,0.0,1.0>, <0.0,1.0,0.0>, <0.0,1.0,0.0>, <0.6,0.0,0.8> }
            inside_vector <0.1, 0.2, 1>""");
    }

    @Test
    void aMeshHasAnInsideIfEachEdgeIsThereInBothDirections() {
        assertThat(mesh(new Point(), 1, new Triangles(CORNERS, CLOSED, new double[0], null)).isSolid()).isTrue();
        for (int left = 0; left < 12; left += 3) {
            int[] open = new int[9];
            System.arraycopy(CLOSED, 0, open, 0, left);
            System.arraycopy(CLOSED, left + 3, open, left, 9 - left);
            assertThat(mesh(new Point(), 1, new Triangles(CORNERS, open, new double[0], null)).isSolid()).isFalse();
            int[] turned = CLOSED.clone();
            turned[left] = CLOSED[left + 1];
            turned[left + 1] = CLOSED[left];
            assertThat(mesh(new Point(), 1, new Triangles(CORNERS, turned, new double[0], null)).isSolid()).isFalse();
        }
    }

    @Test
    void spheresAndCylindersHaveAnInsidePlanesAndTrianglesNone() {
        assertThat(new Sphere().isSolid()).isTrue();
        assertThat(new Cylinder().isSolid()).isTrue();
        assertThat(new Plane().isSolid()).isFalse();
        assertThat(new Triangle().isSolid()).isFalse();
    }
}
