package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.ray;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

class MeshTest {
    /** The cube from -1 to 1, its quadrilaterals anticlockwise from outside. */
    static final String CUBE = """
        v -1 -1 -1
        v  1 -1 -1
        v  1  1 -1
        v -1  1 -1
        v -1 -1  1
        v  1 -1  1
        v  1  1  1
        v -1  1  1
        f 5 6 7 8
        f 2 1 4 3
        f 1 5 8 4
        f 6 2 3 7
        f 8 7 3 4
        f 1 2 6 5
        """;
    private static final double ROUNDING = 1e-12;

    @TempDir
    private Path folder;

    private Mesh mesh(String obj, Point offset, double scale) throws IOException {
        return new Mesh(new Material(), Files.writeString(folder.resolve("a.obj"), obj).toString(), offset, scale);
    }

    private Mesh cube() throws IOException {
        return mesh(CUBE, new Point(), 1);
    }

    @Test
    void aCubeOfSixSquaresHasTwelveTriangles() throws IOException {
        assertThat(cube().size()).isEqualTo(12);
    }

    @Test
    void aVertexLiesWhereScaleAndOffsetPutIt() throws IOException {
        Mesh mesh = mesh("v 9 9 9\nv 1 2 3\nv 4 5 6\nv 7 8 10\nf 2 3 4\nf 3 4 1\n", new Point(100, 200, 400), -2);

        assertThat(mesh.vertex(0, 0)).hasToString("[98.0,196.0,394.0]");
        assertThat(mesh.vertex(0, 2)).hasToString("[86.0,184.0,380.0]");
        assertThat(mesh.vertex(1, 1)).hasToString("[86.0,184.0,380.0]");
        assertThat(mesh.vertex(1, 2)).hasToString("[82.0,182.0,382.0]");
    }

    @Test
    void aVertexNormalIsTheFiles() throws IOException {
        Mesh mesh = mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 3 0 4\nvn 0 5 12\nvn 8 15 0\nf 1 2 3\nf 1//1 2//2 3//3\n", new Point(), 1);

        assertThat(mesh.vertexNormal(0, 0)).isNull();
        assertThat(mesh.vertexNormal(1, 0).dot(new Vector(3, 0, 4))).isEqualTo(5, within(ROUNDING));
        assertThat(mesh.vertexNormal(1, 1).dot(new Vector(0, 5, 12))).isEqualTo(13, within(ROUNDING));
        assertThat(mesh.vertexNormal(1, 2).dot(new Vector(8, 15, 0))).isEqualTo(17, within(ROUNDING));
        assertThat(cube().vertexNormal(3, 1)).isNull();
    }

    /** The triangle in the plane z = 2 k has the number k. */
    @Test
    void eachTriangleIsAPartOfItsOwn() throws IOException {
        String obj = "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 2\nv 3 0 2\nv 0 3 2\nf 1 2 3\nf 4 5 6\n";
        Mesh mesh = mesh(obj, new Point(10, 20, 30), 2);
        Ray ray = ray(11, 21, 44, 0, 0, -1);
        Hit hit = new Hit();

        assertThat(mesh.parts()).isEqualTo(2);
        mesh.intersect(ray, 5, 0, hit);
        assertThat(hit.t).isEqualTo(14, within(ROUNDING));
        assertThat(hit.part).isZero();
        mesh.intersect(ray, 5, 1, hit);
        assertThat(hit.t).isEqualTo(10, within(ROUNDING));
        assertThat(hit.part).isEqualTo(1);
        assertThat(hit.place).isEqualTo(5);
        assertThat(hit.weights[0] / (hit.weights[0] + hit.weights[1] + hit.weights[2])).isEqualTo(2 / 3.0, within(ROUNDING));
        assertThat(hit.weights[1]).isEqualTo(hit.weights[2]).isNotZero();
        mesh.intersect(ray, 5, 0, hit);
        assertThat(hit.part).as("it is farther").isEqualTo(1);

        Hit scratch = new Hit();
        assertThat(mesh.occludes(ray, 9.9, 1, scratch)).isFalse();
        assertThat(mesh.occludes(ray, 10.1, 1, scratch)).isTrue();
        assertThat(mesh.occludes(ray, 13.9, 0, scratch)).isFalse();
        assertThat(mesh.occludes(ray, 14.1, 0, scratch)).isTrue();
        scratch.reset();
        assertThat(mesh.occludes(ray(11, 21, 44, 0, 0, 1), 99, 1, scratch)).as("away from it").isFalse();
    }

    @Test
    void ofTwoPartsAtTheSameDistanceTheFirstIsHit() throws IOException {
        Mesh mesh = mesh("v 0 0 0\nv 3 0 0\nv 0 3 0\nf 1 2 3\nf 1 2 3\n", new Point(), 1);
        Hit hit = new Hit();
        mesh.intersect(ray(1, 1, 4, 0, 0, -1), 7, 1, hit);
        mesh.intersect(ray(1, 1, 4, 0, 0, -1), 7, 0, hit);
        assertThat(hit.part).isZero();
        mesh.intersect(ray(1, 1, 4, 0, 0, -1), 7, 1, hit);
        assertThat(hit.part).isZero();
        mesh.intersect(ray(1, 1, 4, 0, 0, -1), 8, 1, hit);
        assertThat(hit.place).isEqualTo(7);
    }

    @Test
    void aPartIsWithinItsBounds() throws IOException {
        double[] box = new double[6];
        for (double scale : new double[] {2, -2}) {
            Mesh mesh = mesh("v 1 2 3\nv 4 6 8\nv 0 7 9\nv 90 90 90\nf 4 2 3\nf 1 2 3\n", new Point(10, 20, 30), scale);
            mesh.partBounds(1, box);
            double[] exact = scale > 0 ? new double[] {10, 24, 36, 18, 34, 48} : new double[] {2, 6, 12, 10, 16, 24};
            for (int i = 0; i < 6; i++) {
                assertThat(box[i]).isEqualTo(exact[i], within(1e-9));
                assertThat(box[i]).isBetween(i < 3 ? -1e9 : exact[i], i < 3 ? exact[i] : 1e9);
            }
        }
    }

    @Test
    void aMeshOfNoFileIsWhatItsNumbersSay() {
        Mesh tetrahedron = Mesh.of(new Material(), new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1},
            new int[] {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
        assertThat(tetrahedron.size()).isEqualTo(4);
        assertThat(tetrahedron.isSolid()).isTrue();
        assertThat(tetrahedron.intersect(ray(0.25, 0.25, 5, 0, 0, -1))).isEqualTo(4.5, within(ROUNDING));
        assertThat(tetrahedron.normal(new Point(0.25, 0.25, 0)).z).isEqualTo(-1);
    }

    @Test
    void rayHitsTheNearSide() throws IOException {
        assertThat(cube().intersect(ray(0.25, 0.5, 5, 0, 0, -1))).isEqualTo(4);
        assertThat(cube().intersect(ray(5, 0.5, 0.25, -1, 0, 0))).isEqualTo(4);
        assertThat(cube().intersect(ray(0.5, -5, 0.25, 0, 1, 0))).isEqualTo(4);
    }

    @Test
    void rayThroughTheDiagonalOfASquareHits() throws IOException {
        assertThat(cube().intersect(ray(0, 0, 5, 0, 0, -1))).isEqualTo(4);
    }

    @Test
    void rayBesideTheCubeMisses() throws IOException {
        assertThat(cube().intersect(ray(1.001, 0, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(cube().intersect(ray(0, 0, 5, 0, 1, 0))).isEqualTo(Object.MISS);
    }

    @Test
    void rayAlongASideHitsTheEdgeBetweenTheOthers() throws IOException {
        assertThat(cube().intersect(ray(1, 0.5, 5, 0, 0, -1))).isEqualTo(4);
        assertThat(cube().intersect(ray(1, 1, 5, 0, 0, -1))).isEqualTo(4);
    }

    @Test
    void rayFromInsideHitsTheFarSide() throws IOException {
        assertThat(cube().intersect(ray(0, 0, 0, 0, 0.5, 0))).isEqualTo(2);
        assertThat(cube().intersect(ray(0.25, 0.5, 1, 0, 0, -1))).as("from the surface").isEqualTo(2);
    }

    @Test
    void cubeBehindTheRayIsMissed() throws IOException {
        assertThat(cube().intersect(ray(0.25, 0.5, 5, 0, 0, 1))).isEqualTo(Object.MISS);
        assertThat(cube().intersect(ray(0.25, 0.5, 1, 0, 0, 1))).isEqualTo(Object.MISS);
    }

    @Test
    void aLongerDirectionCountsFewerOfIts() throws IOException {
        assertThat(cube().intersect(ray(0.25, 0.5, 5, 0, 0, -4))).isEqualTo(1);
    }

    @Test
    void aMeshIsScaledAndThenMoved() throws IOException {
        // half as large, from -0.5 to 0.5, about (10, 20, 30)
        Mesh mesh = mesh(CUBE, new Point(10, 20, 30), 0.5);
        assertThat(mesh.intersect(ray(10.25, 20.375, 35, 0, 0, -1))).isEqualTo(4.5);
        assertThat(mesh.intersect(ray(10.6, 20, 35, 0, 0, -1))).isEqualTo(Object.MISS);
        assertNormal(mesh.normal(new Point(10.5, 20.1, 30)), 1.0, 0.0, 0.0);
    }

    @Test
    void theNormalIsThatOfTheNearestTriangle() throws IOException {
        assertNormal(cube().normal(new Point(0.2, 0.1, 1)), 0.0, 0.0, 1.0);
        assertNormal(cube().normal(new Point(0, -3, 0.2)), 0.0, -1.0, 0.0);
        assertNormal(cube().normal(new Point(-0.9, 0.1, 0.2)), -1.0, 0.0, 0.0);
        assertNormal(cube().normal(new Point(4, 1.5, 1.5)), 0.0, 0.0, 1.0);  // three are as near, at a corner: the first of them
    }

    @Test
    void aRayEntersAndLeavesACube() throws IOException {
        Interaction front = surface(cube(), ray(0.25, 0.5, 5, 0, 0, -1));
        assertNormal(front.outward, 0.0, 0.0, 1.0);
        assertThat(front.enters).isTrue();
        assertThat(surface(cube(), ray(0.25, 0.5, 0, 0, 0, -1)).enters).isFalse();
    }

    @Test
    void aScaleBelowZeroMirrorsAtTheOriginAndTurnsInsideOut() throws IOException {
        // a single triangle at z = 1 that faces the viewer comes to z = -2, with x and y turned about, and still faces the viewer:
        // of a solid that would be its inside
        Mesh mesh = mesh("v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3", new Point(), -2);
        Ray ray = ray(-0.5, -0.5, 3, 0, 0, -1);
        assertThat(mesh.intersect(ray)).isEqualTo(5);
        assertNormal(surface(mesh, ray).outward, 0.0, 0.0, 1.0);

        Ray towardsCube = ray(0.25, 0.5, 5, 0, 0, -1);
        assertThat(surface(mesh(CUBE, new Point(), -1), towardsCube).enters).isFalse();
    }

    @Test
    void aPolygonIsAFanFromItsFirstVertex() throws IOException {
        // an arrowhead: the fan from (0,0) is right
        String vertices = "v 0 0 0\nv 2 -1 0\nv 1 0 0\nv 2 1 0\n";
        Mesh mesh = mesh(vertices + "f 1 2 3 4\n", new Point(), 1);
        assertThat(mesh.size()).isEqualTo(2);
        assertThat(mesh.intersect(ray(0.9, 0.1, 5, 0, 0, -1))).isEqualTo(5);
        assertThat(mesh.intersect(ray(1.5, 0, 5, 0, 0, -1))).isEqualTo(Object.MISS);
    }

    @Test
    void indicesMayCountBackwards() throws IOException {
        Mesh mesh = mesh("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 2\nv 1 0 2\nv 0 1 2\nf -3 -2 -1\n", new Point(), 1);
        assertThat(mesh.intersect(ray(0.25, 0.25, 5, 0, 0, -1))).isEqualTo(3);
        assertThat(mesh.intersect(ray(0.25, 0.25, 1, 0, 0, -1))).isEqualTo(1);
    }

    @Test
    void vertexNormalsShadeAndTheTrueNormalDecidesWhichSideIt() throws IOException {
        // corners lean to (0.6,0,0.8), (-0.6,0,0.8) and straight up; half way between the first two it is straight
        Mesh mesh = mesh("""
            v 0 0 0
            v 2 0 0
            v 0 2 0
            vn 0.6 0 0.8
            vn -3 0 4
            vn 0 0 1
            f 1//1 2//2 3//3
            """, new Point(), 1);
        Interaction middle = surface(mesh, ray(1, 0, 1, 0, 0, -1));
        assertThat(middle.normal.x).isEqualTo(0, within(ROUNDING));
        assertThat(middle.normal.z).isEqualTo(1, within(ROUNDING));
        Interaction left = surface(mesh, ray(0, 0, 1, 0, 0, -1));
        assertThat(left.normal.x).isEqualTo(0.6, within(ROUNDING));
        assertNormal(left.outward, 0.0, 0.0, 1.0);
        // a quarter of the way: 3/4 (0.6,0,0.8) + 1/4 (-0.6,0,0.8) = (0.3,0,0.8)
        Interaction quarter = surface(mesh, ray(0.5, 0, 1, 0, 0, -1));
        assertThat(quarter.normal.x).isEqualTo(0.3 / Math.sqrt(0.73), within(ROUNDING));
        assertThat(quarter.normal.dot(quarter.normal)).isEqualTo(1, within(ROUNDING));
    }

    @Test
    void facesWithoutNormalsAndNormalsThatCancelAreFlat() throws IOException {
        Mesh mesh = mesh("""
            v 0 0 0
            v 2 0 0
            v 0 2 0
            f 1 2 3
            v 0 0 -1
            v 2 0 -1
            v 0 2 -1
            vn 1 0 0
            vn -1 0 0
            vn 0 0 0
            f 4//1 5//2 6//3
            f 4//3 5//3 6//3
            """, new Point(), 1);
        assertNormal(surface(mesh, ray(0.5, 0.5, 1, 0, 0, -1)).normal, 0.0, 0.0, 1.0);
        assertNormal(surface(mesh, ray(1, 0, -0.5, 0, 0, -1)).normal, 0.0, 0.0, 1.0);
    }

    @Test
    void ofTwoTrianglesAtTheSameDistanceTheFirstWins() throws IOException {
        String vertices = "v 0 0 0\nv 2 0 0\nv 0 2 0\n";
        Ray ray = ray(0.5, 0.5, 1, 0, 0, -1);
        assertThat(surface(mesh(vertices + "f 1 2 3\nf 1 3 2\n", new Point(), 1), ray).outward.z).isEqualTo(1);
        assertThat(surface(mesh(vertices + "f 1 3 2\nf 1 2 3\n", new Point(), 1), ray).outward.z).isEqualTo(-1);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, -2, 1e-3, 1e4})
    void theBoundsHoldTheMeshAndLittleElse(double scale) throws IOException {
        Bounds box = mesh(CUBE, new Point(0.1, 0.2, 0.3), scale).bounds();
        double half = Math.abs(scale);
        for (int i = 0; i < 8; i++) {
            Point corner = new Point(0.1 + (i % 2 * 2 - 1) * half, 0.2 + (i / 2 % 2 * 2 - 1) * half, 0.3 + (i / 4 * 2 - 1) * half);
            assertThat(box.contains(corner)).isTrue();
        }
        assertThat(box.xmin()).isEqualTo(0.1 - half, within(ROUNDING * (1 + half)));
        assertThat(box.zmax()).isEqualTo(0.3 + half, within(ROUNDING * (1 + half)));
    }

    @Test
    void aNewMeshIsHitByNoRay() {
        assertThat(new Mesh().intersect(ray(0, 0, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(new Mesh().size()).isZero();
        assertThat(new Mesh().bounds()).isEqualTo(Bounds.of(new Point()));
    }

    private static void assertNormal(Vector normal, double x, double y, double z) {
        assertThat(normal.x == x && normal.y == y && normal.z == z).as(normal.toString()).isTrue();   // -0 is 0
    }

    private static Interaction surface(Mesh mesh, Ray ray) {
        Hit hit = new Hit();
        mesh.intersect(ray, 0, hit);
        Interaction at = new Interaction();
        at.set(ray, hit, mesh);
        return at;
    }
}
