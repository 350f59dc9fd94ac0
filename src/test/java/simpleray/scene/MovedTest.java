package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Objects and lights in another place. */
class MovedTest {
    private static final Material RED = new Material();
    private static final String FAR = "numbers from -1e100 to 1e100";

    private static Vector v(double x, double y, double z) {
        return new Vector(x, y, z);
    }

    @Test
    void aSphereIsMovedByItsCentre() {
        Sphere sphere = new Sphere(RED, new Point(1, 2, 3), 4);
        Sphere moved = (Sphere) sphere.moved(v(0.5, -2, 8));

        assertThat(moved.centre.equals(new Point(1.5, 0, 11))).isTrue();
        assertThat(moved.radius).isEqualTo(4);
        assertThat(moved.surfaceMaterial).isSameAs(RED);
        assertThat(sphere.centre.equals(new Point(1, 2, 3))).isTrue();
    }

    /** 2 y = 3 is y = 1.5; moved up by 4 it is y = 5.5. */
    @Test
    void aPlanesConstantGetsTheNormalTimesTheOffset() {
        Plane moved = (Plane) new Plane(RED, v(0, 2, 0), 3).moved(v(7, 4, -9));

        assertThat(moved.constant).isEqualTo(11);
        assertThat(moved.normal.y).isEqualTo(2);
        assertThat(moved.surfaceMaterial).isSameAs(RED);
        assertThat(moved.intersect(new Ray(new Point(0, 6.5, 0), v(0, -1, 0)))).isEqualTo(1);
    }

    @Test
    void aTriangleIsMovedByItsVertices() {
        Triangle moved = (Triangle) new Triangle(RED, new Point(), new Point(1, 0, 0), new Point(0, 1, 0)).moved(v(1, 2, 3));

        assertThat(moved.a.equals(new Point(1, 2, 3)) && moved.b.equals(new Point(2, 2, 3)) && moved.c.equals(new Point(1, 3, 3))).isTrue();
        assertThat(moved.surfaceMaterial).isSameAs(RED);
    }

    @Test
    void aCylinderIsMovedByItsEnds() {
        Cylinder moved = (Cylinder) new Cylinder(RED, new Point(), new Point(0, 1, 0), 0.25).moved(v(1, 2, 3));

        assertThat(moved.start.equals(new Point(1, 2, 3)) && moved.end.equals(new Point(1, 3, 3))).isTrue();
        assertThat(moved.radius).isEqualTo(0.25);
        assertThat(moved.surfaceMaterial).isSameAs(RED);
    }

    @Test
    void aConeIsMovedByItsEnds() {
        Cone cone = new Cone(RED, new Point(), 0.25, new Point(0, 1, 0), 0.5);
        Cone moved = (Cone) cone.moved(v(1, 2, 3));

        assertThat(moved.start.equals(new Point(1, 2, 3)) && moved.end.equals(new Point(1, 3, 3))).isTrue();
        assertThat(moved.startRadius).isEqualTo(0.25);
        assertThat(moved.endRadius).isEqualTo(0.5);
        assertThat(moved.surfaceMaterial).isSameAs(RED);
        assertThat(cone.start.equals(new Point())).isTrue();
        assertThatIllegalArgumentException().isThrownBy(() -> cone.moved(v(1e101, 0, 0))).withMessage(FAR);
    }

    @Test
    void aMeshIsMovedByItsOffsetAndHasTheSameTriangles(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("a.mtl"), "newmtl a\nKd 1 0 0\n");
        Files.writeString(folder.resolve("a.obj"), "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
        Files.writeString(folder.resolve("a.scene"), "1\n4 \"a.obj\" 1 2 3 2  0 0 0 0 0 0 0 0 0 5 mtl\n0 0 0\n0\n");
        Mesh mesh = (Mesh) SceneFile.read(folder.resolve("a.scene")).scene().getObject(0);
        Mesh moved = (Mesh) mesh.moved(v(10, 20, 30));

        assertThat(moved.offset.equals(new Point(11, 22, 33))).isTrue();
        assertThat(mesh.offset.equals(new Point(1, 2, 3))).isTrue();
        assertThat(moved.mesh()).isSameAs(mesh.mesh());
        assertThat(moved.materials()).isSameAs(mesh.materials()).isNotNull();
        assertThat(written(moved::write)).isEqualTo(written(mesh::write).replace("1.0 2.0 3.0 2.0", "11.0 22.0 33.0 2.0"));
        assertThat(moved.intersect(new Ray(new Point(11.25, 22.25, 34), v(0, 0, -1)))).isEqualTo(1);
        assertThatIllegalArgumentException().isThrownBy(() -> mesh.moved(v(0, 0, 1e101))).withMessage(FAR);
    }

    @Test
    void aPointLightIsMovedAndKeepsItsColour() {
        PointLight lamp = new PointLight(new Point(1, 2, 3));
        lamp.intensity = new Colour(0.5, 0.25, 1);
        Light moved = lamp.moved(v(1, 1, -1));

        assertThat(moved.origin().equals(new Point(2, 3, 2))).isTrue();
        assertThat(moved.intensity).hasToString("(0.5,0.25,1.0)");
        assertThat(lamp.isDistant()).isFalse();
    }

    @Test
    void anAreaLightIsMovedByItsCornerAndKeepsItsColour() {
        AreaLight area = new AreaLight(new Point(1, 2, -0.0), v(4, 0, 0), v(0, 5, 0), 6);
        area.intensity = new Colour(0.5, 0.25, 1);
        AreaLight moved = (AreaLight) area.moved(v(1, 1, -1));

        assertThat(moved.corner.equals(new Point(2, 3, -1))).isTrue();
        assertThat(moved.u).isSameAs(area.u);
        assertThat(moved.v).isSameAs(area.v);
        assertThat(moved.side).isEqualTo(6);
        assertThat(moved.intensity).isSameAs(area.intensity);
        assertThat(area.corner.equals(new Point(1, 2, 0))).isTrue();
        assertThat(area.isDistant()).isFalse();
        assertThat(((AreaLight) area.coloured(new Colour())).corner.z).isEqualTo(-0.0);
        assertThatIllegalArgumentException().isThrownBy(() -> area.moved(v(0, 1e101, 0))).withMessage(FAR);
    }

    @Test
    void aDirectionalLightIsInfinitelyFarAndStaysThere() {
        DirectionalLight sun = new DirectionalLight(v(1, 2, 3));
        sun.intensity = new Colour(0.5, 0.25, 1);
        DirectionalLight moved = (DirectionalLight) sun.moved(v(1, 1, 1));

        assertThat(sun.isDistant()).isTrue();
        assertThat(moved).isNotSameAs(sun);
        assertThat(moved.direction).isSameAs(sun.direction);
        assertThat(moved.intensity).isSameAs(sun.intensity);
    }

    @Test
    void aLightInAnotherColourIsInTheSamePlaceToTheLastBit() {
        PointLight lamp = new PointLight(new Point(-0.0, 0.1, 0));
        Colour red = new Colour(1, 0, 0);
        PointLight other = (PointLight) lamp.coloured(red);

        assertThat(other.intensity).isSameAs(red);
        assertThat(lamp.intensity).isNotSameAs(red);
        assertThat(other.origin.x).isEqualTo(-0.0);
        assertThat(other.origin.y).isEqualTo(0.1);
        assertThat(other.origin.z).isEqualTo(0.0);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void noPointMayBeBeyondTheLimit(int axis) {
        double[] t = {0, 0, 0};
        Sphere ball = new Sphere(RED, new Point(), 1);
        Triangle half = new Triangle(RED, new Point(), new Point(1e99, 0, 0), new Point(0, 1e99, 0));
        for (double sign : new double[] {-1, 1}) {
            t[axis] = sign * 1e100;
            assertThat(ball.moved(v(t[0], t[1], t[2]))).isNotNull();
            t[axis] = sign * Math.nextUp(1e100);
            Vector far = v(t[0], t[1], t[2]);
            assertThatIllegalArgumentException().isThrownBy(() -> ball.moved(far)).withMessage(FAR);
            assertThatIllegalArgumentException().isThrownBy(() -> half.moved(far)).withMessage(FAR);
        }
        t[axis] = Double.NaN;
        assertThatIllegalArgumentException().isThrownBy(() -> ball.moved(v(t[0], t[1], t[2]))).withMessage(FAR);
    }

    @Test
    void aPlanesConstantHasTheSameLimit() {
        Plane floor = new Plane(RED, v(0, 1, 0), 0);

        assertThat(((Plane) floor.moved(v(0, -1e100, 0))).constant).isEqualTo(-1e100);
        assertThat(floor.moved(v(1e300, 0, 0))).isNotNull();
        assertThatIllegalArgumentException().isThrownBy(() -> floor.moved(v(0, -1.01e100, 0))).withMessage(FAR);
    }

    @Test
    void whatRoundingMakesFlatMayNotBeThere() {
        Cylinder rod = new Cylinder(RED, new Point(), new Point(0, 1, 0), 1);

        assertThat(rod.moved(v(1e20, 0, 0))).isNotNull();
        assertThat(new Cone().moved(v(1e20, 0, 0))).isNotNull();
        assertThatIllegalArgumentException().isThrownBy(() -> new Cone().moved(v(0, 1e20, 0))).withMessage("second end that differs from the first");
        assertThatIllegalArgumentException().isThrownBy(() -> rod.moved(v(0, 1e20, 0))).withMessage("two ends that differ");
        assertThatIllegalArgumentException().isThrownBy(() -> new Triangle().moved(v(0, 1e20, 0))).withMessage("three vertices not on one line");
        assertThat(new Triangle().moved(v(0, 0, 1e20))).isNotNull();
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void aPointLightMayBeAnywhereThatIsANumber(int axis) {
        double[] t = {0, 0, 0};
        t[axis] = Double.MAX_VALUE;
        PointLight lamp = new PointLight(new Point(1e300, 1e300, 1e300));

        assertThat(new PointLight().moved(v(t[0], t[1], t[2]))).isNotNull();
        assertThatIllegalArgumentException().isThrownBy(() -> lamp.moved(v(t[0], t[1], t[2]))).withMessage("finite numbers");
    }
}
