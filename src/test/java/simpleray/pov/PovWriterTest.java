package simpleray.pov;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.AreaLight;
import simpleray.scene.Cone;
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
    void aConeHasARadiusAtEachEndAndIsOpen() {
        Cone cone = new Cone(new Material(), new Point(1, 2, 3), 0.5, new Point(4, 5, 6), 0);

        assertThat(shape(cone)).isEqualTo("cone { <1.0,2.0,3.0>, 0.5, <4.0,5.0,6.0>, 0.0 open");
    }

    private static String light(int n) {
        AreaLight light = new AreaLight(new Point(1, 2, 3), new Vector(16 * n, 0, 0), new Vector(0, 0, 8 * n), n);
        return written(os -> PovWriter.light(os, light, 0, new Colour(n * n, 0, 0)));
    }

    @Test
    void aSmallAreaLightIsAsManyPointLights() {
        assertThat(light(1)).isEqualTo("light_source { <9.0,2.0,7.0>, rgb <1.0,0.0,0.0> }\n");
        assertThat(light(2)).isEqualTo("""
            light_source { <9.0,2.0,7.0>, rgb <1.0,0.0,0.0> }
            light_source { <25.0,2.0,7.0>, rgb <1.0,0.0,0.0> }
            light_source { <9.0,2.0,15.0>, rgb <1.0,0.0,0.0> }
            light_source { <25.0,2.0,15.0>, rgb <1.0,0.0,0.0> }
            """);
        assertThat(light(7).lines()).hasSize(49).noneMatch(line -> line.contains("area_light"));
    }

    /** The blocks of 9 points a side: 2, 2, 2, 2 and 1. */
    @Test
    void aLargerOneIsOfBlocksWhosePointsLieFromEdgeToEdge() {
        List<String> lines = light(9).lines().toList();
        assertThat(lines).hasSize(4 * 4 + 4 * 2 + 9);
        assertThat(lines.get(0)).isEqualTo("light_source { <17.0,2.0,11.0>, rgb <4.0,0.0,0.0> area_light <16.0,0.0,0.0>, <0.0,0.0,8.0>, 2, 2 "
            + "area_illumination on }");
        assertThat(lines.get(1)).startsWith("light_source { <49.0,2.0,11.0>, rgb <4.0,0.0,0.0> area_light ");
        assertThat(lines.get(4)).isEqualTo("light_source { <137.0,2.0,7.0>, rgb <1.0,0.0,0.0> }");
        assertThat(lines.get(5)).isEqualTo("light_source { <137.0,2.0,15.0>, rgb <1.0,0.0,0.0> }");
        assertThat(light(8).lines()).hasSize(16);
        assertThat(light(16).lines()).hasSize(16).allMatch(line -> line.contains("area_light <48.0,0.0,0.0>, <0.0,0.0,24.0>, 4, 4 "));
        assertThat(light(64).lines()).hasSize(256).allMatch(line -> line.contains("rgb <16.0,0.0,0.0>"));
    }

    /** However its points are put together, they are all there: their mean is in the middle, and their sum the whole light. */
    @ParameterizedTest
    @ValueSource(ints = {3, 10, 13, 19, 23, 63})
    void allPointsAreInSomeBlock(int n) {
        double[] sums = new double[3];
        Pattern numbers = Pattern.compile("<([^,]*),[^,]*,([^>]*)>, rgb <([^,]*),");
        light(n).lines().forEach(line -> {
            Matcher found = numbers.matcher(line);
            assertThat(found.find()).isTrue();
            double share = Double.parseDouble(found.group(3));
            sums[0] += share;
            sums[1] += share * Double.parseDouble(found.group(1));
            sums[2] += share * Double.parseDouble(found.group(2));
        });
        assertThat(sums[0]).isEqualTo(n * n, within(1e-9));
        assertThat(sums[1] / (n * n)).isEqualTo(1 + 8.0 * n, within(1e-9));
        assertThat(sums[2] / (n * n)).isEqualTo(3 + 4.0 * n, within(1e-9));
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
