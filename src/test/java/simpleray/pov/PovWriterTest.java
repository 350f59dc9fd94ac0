package simpleray.pov;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Cylinder;
import simpleray.scene.Light;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.Triangle;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** Each shape in POV-Ray's language, without its closing brace. */
class PovWriterTest {
    private static final double[] CORNERS = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};

    private static String shape(Object shape) {
        return written(os -> PovWriter.shape(os, shape, 0));
    }

    @Test
    void aTrianglesVerticesRunTheOtherWayRound() {
        Triangle triangle = new Triangle(new Material(), new Point(1, 2, 3), new Point(4, 5, 6), new Point(-7, 8, -0.0));

        assertThat(shape(triangle)).isEqualTo("triangle { <1.0,2.0,3.0>, <-7.0,8.0,0.0>, <4.0,5.0,6.0>");
    }

    @Test
    void aCylinderHasTwoEndsAndARadius() {
        Cylinder cylinder = new Cylinder(new Material(), new Point(1, 2, 3), new Point(4, 5, 6), 0.5);

        assertThat(shape(cylinder)).isEqualTo("cylinder { <1.0,2.0,3.0>, <4.0,5.0,6.0>, 0.5");
    }

    @Test
    void aPlanesConstantIsItsDistanceFromTheOrigin() {
        assertThat(shape(new Plane(new Material(), new Vector(0, 0, -4), 2))).isEqualTo("plane { <0.0,0.0,-1.0>, 0.5");
    }

    @Test
    void aMeshIsWrittenAsItStands() {
        Mesh mesh = Mesh.of(new Material(), CORNERS, new int[] {0, 1, 2, 1, 2, 3});
        mesh.scale = 2;
        mesh.offset = new Point(10, 20, 30);

        assertThat(shape(mesh)).isEqualTo("""
            mesh {
            triangle { <10.0,20.0,30.0>, <10.0,22.0,30.0>, <12.0,20.0,30.0> }
            triangle { <12.0,20.0,30.0>, <10.0,20.0,32.0>, <10.0,22.0,30.0> }
            inside_vector <0.1, 0.2, 1>""");
    }

    @Test
    void whereAMeshHasNormalsItsTrianglesAreSmooth(@TempDir Path folder) throws IOException {
        String obj = """
            v 0 0 0
            v 1 0 0
            v 0 1 0
            v 0 0 1
            vn 0 0 1
            vn 0.6 0 0.8
            vn 0 1 0
            f 1 2 3
            f 2//1 3//2 4//3
            """;
        String file = Files.writeString(folder.resolve("a.obj"), obj).toString();

        assertThat(shape(new Mesh(new Material(), file, new Point(), 1))).isEqualTo("""
            mesh {
            triangle { <0.0,0.0,0.0>, <0.0,1.0,0.0>, <1.0,0.0,0.0> }
            smooth_triangle { <1.0,0.0,0.0>, <0.0,0.0,1.0>, <0.0,0.0,1.0>, <0.0,1.0,0.0>, <0.0,1.0,0.0>, <0.6,0.0,0.8> }
            inside_vector <0.1, 0.2, 1>""");
    }

    @Test
    void aPlaneThroughTheOriginKeepsTheSignOfItsConstant() {
        assertThat(shape(new Plane(new Material(), new Vector(0, 1, 0), -0.0))).isEqualTo("plane { <0.0,1.0,0.0>, -0.0");
    }

    /** A light that POV-Ray has no form of. */
    private static final class Lantern extends Light {
        @Override
        public double towards(Point p, Vector l) {
            return 1;
        }

        @Override
        public Point origin() {
            return null;
        }

        @Override
        public Light moved(Vector t) {
            throw new UnsupportedOperationException();
        }

        @Override
        public void print(SceneWriter os) {
        }

        @Override
        public void read(SceneReader is) {
        }

        @Override
        public void write(SceneWriter os) {
        }
    }

    @Test
    void aLightWithoutAFormIsNamed() {
        assertThatThrownBy(() -> written(os -> PovWriter.light(os, new Lantern(), 2, new Colour())))
            .isInstanceOf(UnsupportedOperationException.class).hasMessage("light 3: no form for POV-Ray is known of a Lantern");
    }
}
