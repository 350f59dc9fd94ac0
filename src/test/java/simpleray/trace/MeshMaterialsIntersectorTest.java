package simpleray.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.Sample;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.BruteForceIntersector;
import simpleray.scene.Intersector;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.Terms;
import simpleray.scene.WhittedIntegrator;

/** A mesh of many materials, of which some are glass, looks like one mesh for each material; with and without tree and lists. */
class MeshMaterialsIntersectorTest {
    private static final double ERROR = 1e-11;
    private static final String MTL = "newmtl a\nKa 0.1 0.1 0\nKd 0.6 0.2 0.1\nKs 0.2 0.2 0.2\nNs 20\nillum 2\n"
        + "newmtl b\nKd 0.1 0.1 0.1\nKs 0.1 0.1 0.1\nNs 9\nd 0.3\nNi 1.2\nnewmtl c\nKd 0.1 0.1 0.1\nTf 0.9 0.3 0.6\nd 0.5\nNs 5\n";

    @TempDir
    private Path folder;

    /** {@return a scene of a mesh of triangles at random, each of a material at random or of the mesh's own} */
    private Scene scene(Random random, String own) throws IOException {
        StringBuilder obj = new StringBuilder("mtllib a.mtl\n");
        int triangles = 5 + random.nextInt(60);
        for (int i = 0; i < triangles; i++) {
            double x = random.nextDouble() * 4 - 2;
            double y = random.nextDouble() * 4 - 2;
            double z = random.nextDouble() * 4 - 2;
            for (int k = 0; k < 3; k++) {
                obj.append("v ").append(x + random.nextDouble()).append(' ').append(y + random.nextDouble()).append(' ').append(z + random.nextDouble())
                    .append('\n');
            }
            obj.append(List.of("", "usemtl a\n", "usemtl b\n", "usemtl c\n", "usemtl\n").get(random.nextInt(5))).append("f -3 -2 -1\n");
        }
        Files.writeString(folder.resolve("a.mtl"), MTL);
        Files.writeString(folder.resolve("a.obj"), obj);
        return SceneFile.read(Files.writeString(folder.resolve("a.scene"), "3\n0  0.5 0 0  0.7  0.1 0.1 0.1  0.3 0.3 0.3  0 0 0  5  transmit 0.5 0.7 0.9 1.1\n"
            + "4 \"a.obj\" 0 0 0 " + (random.nextBoolean() ? 1 : -1) + " " + own + " mtl\n1  0 1 0  -3  0.1 0.1 0.1  0.6 0.6 0.6  0 0 0  1\n"
            + "0.5 0.5 0.5\n2\n0  1 1 1  1 4 2\n1  0.5 0.4 0.3  0.3 -1 0.2\nbackground 0.1 0.2 0.3\n")).scene();
    }

    private static Scene split(Scene scene) {
        List<Object> objects = new ArrayList<>();
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            objects.addAll(scene.getObject(i) instanceof Mesh mesh ? mesh.pieces() : List.of(scene.getObject(i)));
        }
        Scene split = new Scene();
        split.ambient = scene.ambient;
        split.settings = scene.settings;
        split.setNumberObjects(objects.size());
        for (int i = 0; i < objects.size(); i++) {
            split.setObject(i, objects.get(i));
        }
        split.setNumberLights(scene.getNumberLights());
        for (int i = 0; i < scene.getNumberLights(); i++) {
            split.setLight(i, scene.getLight(i));
        }
        return split;
    }

    private static Colour trace(Scene scene, Intersector intersector, Ray ray) {
        Colour colour = new Colour();
        new WhittedIntegrator(scene, intersector, Terms.ALL, new RayStats(), null).trace(ray, colour, 5);
        return colour;
    }

    @Test
    void itLooksLikeAMeshForEachMaterial() throws IOException {
        Random random = new Random(20261130);
        for (int k = 0; k < Sample.size(200, 40); k++) {
            boolean glass = random.nextBoolean();
            Scene scene = scene(random, "0.1 0.1 0.1  0.2 0.4 0.5  0 0 0  3" + (glass ? " transmit 0.3 0.3 0.3 1" : ""));
            Scene split = split(scene);
            Point eye = new Point(0.3, 0.5, 7);
            CompiledScene compiled = new CompiledScene(scene, eye, 1, 1 << 20);
            Intersector plain = new BruteForceIntersector(scene);
            Intersector plainSplit = new BruteForceIntersector(split);
            Intersector fast = compiled.intersector(new RayStats());
            Intersector listed = compiled.listed().intersector(new RayStats());
            for (int i = 0; i < 60; i++) {
                Vector direction = new Vector(random.nextDouble() - 0.5, random.nextDouble() - 0.5, -1).normalised();
                Ray ray = new Ray(eye, direction);
                Colour expected = trace(split, plainSplit, ray);
                Colour colour = trace(scene, plain, ray);

                assertThat(List.of(colour.r, colour.g, colour.b)).usingElementComparator((a, b) -> Math.abs(a - b) < ERROR ? 0 : 1)
                    .containsExactly(expected.r, expected.g, expected.b);
                assertThat(trace(scene, fast, ray)).hasToString(colour.toString());
                assertThat(trace(scene, listed, ray)).hasToString(colour.toString());
            }
        }
    }

    /** A shadow ray through panes of one material is dimmed once, through one of each of two materials twice, and stopped by what is opaque. */
    @Test
    void eachMaterialDimsALightOnce() throws IOException {
        Files.writeString(folder.resolve("a.mtl"), MTL);
        StringBuilder obj = new StringBuilder("mtllib a.mtl\n");
        for (int i = 1; i <= 4; i++) {
            obj.append("v -9 -9 ").append(i).append("\nv 9 -9 ").append(i).append("\nv 0 9 ").append(i).append("\nusemtl ").append("bbca".charAt(i - 1))
                .append("\nf -3 -2 -1\n");
        }
        Files.writeString(folder.resolve("a.obj"), obj);
        Scene scene = SceneFile.read(Files.writeString(folder.resolve("a.scene"), "1\n4 \"a.obj\" 0 0 0 1  1 1 1  1 1 1  0 0 0  1 mtl\n0 0 0\n"
            + "1\n1 1 1 1 0 0 -1\n")).scene();
        double[] red = {1, 0.7, 0.7, 0.7 * 0.9, 0};
        Intersector fast = new CompiledScene(scene, new Point(), 1, 1).intersector(new RayStats());
        for (Intersector intersector : List.of(new BruteForceIntersector(scene), fast)) {
            for (int i = 0; i < red.length; i++) {
                Colour left = new Colour(1, 1, 1);
                boolean blocked = intersector.occluded(new Ray(new Point(0, 0, 0.5), new Vector(0, 0, 1)), i + 0.1, 0, left);

                assertThat(left.r).isCloseTo(red[i], within(ERROR));
                assertThat(blocked).isEqualTo(i == 4);
            }
        }
    }
}
