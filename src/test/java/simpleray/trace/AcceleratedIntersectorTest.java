package simpleray.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.BruteForceIntersector;
import simpleray.scene.Hit;
import simpleray.scene.Intersector;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.PointLight;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.Sphere;

/** Hits and shadows by light buffers, trees and grids, in a scene whose objects have parts. */
class AcceleratedIntersectorTest {
    private static final long SEED = 1984;
    private static final int MANY = 4000;
    private static final String CUBE = """
        v -1 -1 -1
        v 1 -1 -1
        v 1 1 -1
        v -1 1 -1
        v -1 -1 1
        v 1 -1 1
        v 1 1 1
        v -1 1 1
        f 4 3 2 1
        f 5 6 7 8
        f 1 2 6 5
        f 2 3 7 6
        f 3 4 8 7
        f 4 1 5 8
        """;
    /** A floor; a cube at the origin; one of glass, turned inside out, above it; balls of steel and of glass beside them; and a sun. */
    private static final String SCENE = """
        6
        1  0 1 0  -3           1 1 1  1 1 1  0 0 0  1
        4  "cube.obj" 0 0 0    1     1 1 1  1 1 1  0 0 0  1
        4  "cube.obj" 0 2.5 0  -0.5  1 1 1  1 1 1  0 0 0  1  transmit 0.5 0.25 0.125 1
        0  2 0 0  0.75         1 1 1  1 1 1  0 0 0  1
        0  0 4 0  0.5          1 1 1  1 1 1  0 0 0  1  transmit 0.75 0.5 0.5 1
        2  -2 0 -1  -2 0 1  -2 2 0  1 1 1  1 1 1  0 0 0  1
        0 0 0
        3
        0  1 1 1  0 9 0
        0  1 1 1  0.1 0.2 0.3
        1  1 1 1  0 -1 0
        """;
    private static final Point EYE = new Point(0, 3, 12);
    /** The places of the lights. */
    private static final int LAMP = 0;
    private static final int INSIDE = 1;
    private static final int SUN = 2;

    @TempDir
    Path folder;

    private Scene scene;

    @BeforeEach
    void read() throws IOException {
        Files.writeString(folder.resolve("cube.obj"), CUBE);
        scene = SceneFile.read(Files.writeString(folder.resolve("cubes.scene"), SCENE)).scene();
    }

    private CompiledScene compiled(CompiledScene.Structure structure, boolean buffers) {
        return new CompiledScene(scene, EYE, 1, structure, buffers);
    }

    private static Intersector of(CompiledScene compiled) {
        return compiled.intersector(new RayStats());
    }

    private static Ray ray(double x, double y, double z, double dx, double dy, double dz) {
        return new Ray(new Point(x, y, z), new Vector(dx, dy, dz).normalised());
    }

    private Ray anyRay(Random random, Point from) {
        return ray(from.x, from.y, from.z, 3 * random.nextGaussian() - from.x, 1 + 3 * random.nextGaussian() - from.y,
            random.nextGaussian() - from.z);
    }

    private static void same(Hit actual, Hit expected, String where) {
        assertThat(actual.place).as(where).isEqualTo(expected.place);
        assertThat(actual.t).as(where).isEqualTo(expected.t);
        if (expected.place == 1 || expected.place == 2) {     // a mesh
            assertThat(actual.part).as(where).isEqualTo(expected.part);
            assertThat(actual.weights).as(where).containsExactly(expected.weights);
        }
    }

    @Test
    void lightBuffersListEachTriangleOfAMesh() {
        CompiledScene compiled = compiled(CompiledScene.Structure.AUTO, true);

        assertThat(compiled.bounded).isEqualTo(5);
        assertThat(compiled.firstParts).startsWith(0).endsWith(2 * 12 + 3);
        assertThat(compiled.eyeBuffer).isNotNull();
        assertThat(compiled.lightBuffers[LAMP]).isNotNull();
        assertThat(compiled.lightBuffers[INSIDE]).isNotNull();
        assertThat(compiled.lightBuffers[SUN]).as("it has no place").isNull();
        int[] owned = new int[5];
        for (int part = 0; part < 2 * 12 + 3; part++) {
            owned[compiled.owner(part)]++;
        }
        for (int i = 0; i < 5; i++) {
            assertThat(owned[i]).isEqualTo(compiled.objects[i].parts());
        }
    }

    @ParameterizedTest
    @EnumSource
    void primaryRaysHitWhatTheLoopOverAllObjectsFinds(CompiledScene.Structure structure) {
        Random random = new Random(SEED);
        Hit hit = new Hit();
        Hit expected = new Hit();
        int hits = 0;
        for (boolean buffers : new boolean[] {true, false}) {
            Intersector intersector = of(compiled(structure, buffers));
            Intersector loop = new BruteForceIntersector(scene);
            for (int i = 0; i < MANY; i++) {
                Point from = i % 3 == 0 ? new Point(4 * random.nextGaussian(), 3, 4 * random.nextGaussian()) : EYE;
                Ray ray = anyRay(random, from);
                boolean found = loop.intersect(ray, expected);
                assertThat(intersector.intersect(ray, hit)).isEqualTo(found);
                same(hit, expected, "seed " + SEED + ", ray " + i);
                hits += hit.place > 0 ? 1 : 0;
            }
        }
        assertThat(hits).as("hits on what is bounded").isGreaterThan(MANY / 4);
    }

    @ParameterizedTest
    @EnumSource
    void shadowRaysLeaveTheSameLightAsTheLoopOverAllObjects(CompiledScene.Structure structure) {
        Random random = new Random(SEED);
        int dimmed = 0;
        int blocked = 0;
        for (boolean buffers : new boolean[] {true, false}) {
            Intersector intersector = of(compiled(structure, buffers));
            Intersector loop = new BruteForceIntersector(scene);
            for (int i = 0; i < MANY; i++) {
                int light = i % 3;
                Point from = new Point(random.nextGaussian(), 6 * random.nextDouble() - 1, random.nextGaussian());
                Vector towards = new Vector();
                double distance = scene.getLight(light).towards(from, towards);
                Ray ray = new Ray(from, towards);
                Colour expected = new Colour(1, 2, 3);
                Colour left = new Colour(1, 2, 3);

                boolean dark = loop.occluded(ray, distance, light, expected);

                assertThat(intersector.occluded(ray, distance, light, left)).as("seed %d, ray %d", SEED, i).isEqualTo(dark);
                assertThat(left).as("seed %d, ray %d", SEED, i).hasToString(expected.toString());
                blocked += dark ? 1 : 0;
                dimmed += !dark && left.r < 1 ? 1 : 0;
            }
        }
        assertThat(dimmed).as("dimmed").isGreaterThan(MANY / 10);
        assertThat(blocked).as("blocked").isGreaterThan(MANY / 10);
    }

    /** The lists have the twelve triangles of the cube, two of which are hit; a grid has each object in many cells. */
    @ParameterizedTest
    @EnumSource
    void glassThatIsListedManyTimesDimsOnce(CompiledScene.Structure structure) {
        for (boolean buffers : new boolean[] {true, false}) {
            Intersector intersector = of(compiled(structure, buffers));
            for (int light : new int[] {LAMP, SUN}) {
                Colour left = new Colour(1, 1, 1);
                double distance = light == LAMP ? 7.5 : Double.POSITIVE_INFINITY;

                assertThat(intersector.occluded(ray(0.01, 1.5, 0.02, -0.01, 7.5, -0.02), distance, light, left)).isFalse();
                assertThat(left).as("by the cube and the ball").hasToString("(0.375,0.125,0.0625)");
            }
        }
    }

    @Test
    void opaqueObjectsBlockAllLight() {
        for (boolean buffers : new boolean[] {true, false}) {
            Intersector intersector = of(compiled(CompiledScene.Structure.AUTO, buffers));
            Colour left = new Colour(1, 1, 1);

            assertThat(intersector.occluded(ray(0.1, -2, 0.1, 0, 1, 0), 11, LAMP, left)).isTrue();
            assertThat(left).hasToString("(0.0,0.0,0.0)");
            assertThat(intersector.occluded(ray(0.1, -4, 0.1, 0, 1, 0), 0.5, SUN, new Colour(1, 1, 1))).as("short of the floor").isFalse();
            assertThat(intersector.occluded(ray(9, -4, 9, 0, 1, 0), 2, SUN, new Colour(1, 1, 1))).as("the floor").isTrue();
        }
    }

    /** Rays of the one that looks into the cube from within, where boxes begin at no distance. */
    @Test
    void fromInsideACubeTheCubeIsHit() {
        CompiledScene inside = new CompiledScene(scene, new Point(0.1, 0.2, 0.3), 1, CompiledScene.Structure.AUTO, true);
        Intersector intersector = of(inside);
        Hit hit = new Hit();
        assertThat(inside.eyeBuffer).isNotNull();
        assertThat(intersector.intersect(ray(0.1, 0.2, 0.3, 1, 0, 0), hit)).isTrue();
        assertThat(hit.place).isEqualTo(1);
        assertThat(hit.t).isEqualTo(0.9);
        assertThat(intersector.intersect(ray(0.1, 0.2, 0.3, 0, 0, -1), hit)).isTrue();
        assertThat(hit.t).isEqualTo(1.3);
    }

    @Test
    void anotherEyeSeesTheSameWithAndWithoutALightBuffer() {
        CompiledScene first = compiled(CompiledScene.Structure.AUTO, true);
        Point eye = new Point(-5, 1, 7);
        CompiledScene second = first.seenFrom(eye);
        CompiledScene third = second.listed();
        assertThat(second.eyeBuffer).isNull();
        assertThat(third.eyeBuffer).isNotNull();
        assertThat(third.listed()).isSameAs(third);
        assertThat(first.seenFrom(new Point(0, 3, 12)).eyeBuffer).as("of the same place").isSameAs(first.eyeBuffer);

        Random random = new Random(SEED);
        Hit hit = new Hit();
        Hit expected = new Hit();
        for (int i = 0; i < MANY; i++) {
            Ray ray = anyRay(random, eye);
            new BruteForceIntersector(scene).intersect(ray, expected);
            for (CompiledScene compiled : new CompiledScene[] {second, third}) {
                of(compiled).intersect(ray, hit);
                same(hit, expected, "seed " + SEED + ", ray " + i);
            }
        }
    }

    /** An object of two parts and one of none have, together, as many parts as there are objects. */
    @Test
    void objectsWithNoPartOrTwoKeepTheirParts() throws IOException {
        Files.writeString(folder.resolve("square.obj"), "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
        scene = new Scene();
        scene.setNumberObjects(12);
        scene.setObject(0, new Mesh());
        scene.setObject(1, new Mesh(new Material(), folder.resolve("square.obj").toString(), new Point(), 1));
        for (int i = 2; i < 12; i++) {
            scene.setObject(i, new Sphere(new Material(), new Point(i, 0, -2), 0.4));
        }
        CompiledScene listed = new CompiledScene(scene, new Point(0, 0, 5), 1, Long.MAX_VALUE).seenFrom(new Point(0, 0, 6)).listed();
        Hit hit = new Hit();

        for (double[] to : new double[][] {{0.5, -0.5}, {-0.5, 0.5}}) {
            assertThat(of(listed).intersect(ray(0, 0, 6, to[0], to[1], -6), hit)).isTrue();
            assertThat(hit.place).isEqualTo(1);
        }
    }

    @ParameterizedTest
    @EnumSource
    void ofEqualObjectsTheFirstInTheSceneIsHit(CompiledScene.Structure structure) {
        scene = new Scene();
        scene.setNumberObjects(30);
        for (int i = 0; i < 30; i++) {
            scene.setObject(i, new Sphere(new Material(), new Point(i % 3 * 4, 0, 0), 1));
        }
        for (boolean buffers : new boolean[] {true, false}) {
            Intersector intersector = of(compiled(structure, buffers));
            Hit hit = new Hit();
            for (int i = 0; i < 3; i++) {
                assertThat(intersector.intersect(ray(0, 3, 12, 4 * i, -3, -12), hit)).isTrue();
                assertThat(hit.place).isEqualTo(i);
                assertThat(intersector.intersect(ray(4 * i, 0, 9, 0, 0, -1), hit)).isTrue();
                assertThat(hit.place).isEqualTo(i);
            }
        }
    }

    @Test
    void testsAndStepsAreCounted() {
        RayStats stats = new RayStats();
        Intersector intersector = compiled(CompiledScene.Structure.BVH, false).intersector(stats);
        intersector.intersect(ray(50, 50, 50, 1, 0, 0), new Hit());
        assertThat(stats.tests).as("the floor").isEqualTo(1);
        assertThat(stats.steps).as("a ray past all has no way in the tree").isZero();

        intersector.intersect(ray(0, 4, 12, 0, 0, -1), new Hit());
        assertThat(stats.tests).isBetween(3L, 7L);
        assertThat(stats.steps).isBetween(1L, 8L);
    }

    @Test
    void anEmptySceneIsHitByNothing() {
        scene = new Scene();
        scene.setNumberLights(1);
        scene.setLight(0, new PointLight(new Point(1, 2, 3)));
        Intersector intersector = of(new CompiledScene(scene, EYE, 2, Long.MAX_VALUE));
        Colour left = new Colour(1, 2, 3);

        assertThat(intersector.intersect(ray(0, 0, 0, 0, 0, 1), new Hit())).isFalse();
        assertThat(intersector.occluded(ray(0, 0, 0, 0, 0, 1), 5, 0, left)).isFalse();
        assertThat(left).hasToString("(1.0,2.0,3.0)");
    }
}
