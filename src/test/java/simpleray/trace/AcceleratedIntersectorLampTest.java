package simpleray.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.BruteForceIntersector;
import simpleray.scene.Intersector;
import simpleray.scene.RayStats;
import simpleray.scene.Reach;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.Terms;
import simpleray.scene.WhittedIntegrator;

/** A lamp in a surface lights the floor; a surface well before the lamp blocks it. */
class AcceleratedIntersectorLampTest {
    private static final String MATT = "  0 0 0  1 1 1  0 0 0  1";

    @TempDir
    Path folder;

    @BeforeEach
    void makeMesh() throws IOException {
        Files.writeString(folder.resolve("panel.obj"), "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 2 3 4\n");
    }

    /** A floor at height 0, a shape, and a lamp 2 above the floor, all times a scale and moved aside. */
    private Scene scene(String shape, double scale, double aside, double lamp) throws IOException {
        StringBuilder filled = new StringBuilder();
        for (String word : shape.split(" ")) {
            char kind = word.charAt(0);                       // x, y, z: a place; r: a length; else it stands as it is
            double value = "xyzr".indexOf(kind) < 0 ? 0 : Double.parseDouble(word.substring(1)) * scale + (kind == 'r' ? 0 : aside);
            filled.append("xyzr".indexOf(kind) < 0 ? word : Double.toString(value)).append(' ');
        }
        String text = String.format(Locale.ROOT, "2%n1  0 1 0  %s%s%n%s%s%n0 0 0%n1%n0  1 1 1  %s %s %s%n", aside, MATT, filled, MATT,
            aside, 2 * scale + aside + lamp, aside);
        Path file = folder.resolve("lamp.scene");
        Files.writeString(file, text);
        return SceneFile.read(file, Reach.ANYWHERE).scene();
    }

    /** {@return the sum of the floor's brightness at some places around the lamp's foot, at most 1 each} */
    private static double brightness(Scene scene, double scale, double aside, boolean accelerated) {
        RayStats stats = new RayStats();
        Point eye = new Point(aside, aside + scale, aside);
        Intersector intersector = accelerated
            ? new CompiledScene(scene, eye, 1, CompiledScene.Structure.BVH, true).intersector(stats) : new BruteForceIntersector(scene);
        WhittedIntegrator integrator = new WhittedIntegrator(scene, intersector, Terms.ALL, stats, null);
        double sum = 0;
        Colour colour = new Colour();
        for (int i = 0; i < 50; i++) {
            Vector down = new Vector(0.037 * i % 1 - 0.5, -1, 0.061 * i % 1 - 0.5);
            down.normalise();
            integrator.trace(new Ray(eye, down), colour, 0);
            double dx = -down.x / down.y;
            double dz = -down.z / down.y;
            sum += colour.r * Math.sqrt(dx * dx + dz * dz + 4) / 2;    // without the cosine
        }
        return sum;
    }

    @ParameterizedTest
    @CsvSource({"1 0 1 0 y2", "1 0 -1 0 y2", "2 x-3 y2 z-3 x3 y2 z-3 x0 y2 z4", "4 \"panel.obj\" x0 y2 z0 r1", "0 x0 y3 z0 r1",
        "3 x0 y2 z0 x0 y4 z0 r1", "3 x-2 y2.5 z0 x2 y2.5 z0 r0.5"})
    void aLampInASurfaceLightsTheFloor(String shape) throws IOException {
        for (double[] place : new double[][] {{1, 0}, {0.01, 0}, {1000, 0}, {1, 7.3}, {0.013, -3.7}, {1, 1e5}, {1e7, 0}}) {
            for (boolean accelerated : new boolean[] {false, true}) {
                assertThat(brightness(scene(shape, place[0], place[1], 0), place[0], place[1], accelerated))
                    .as("%s, scale %s, moved by %s, accelerated %s", shape, place[0], place[1], accelerated).isBetween(49.99, 50.01);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1 0 1 0 y2", "2 x-3 y2 z-3 x3 y2 z-3 x0 y2 z4", "4 \"panel.obj\" x0 y2 z0 r1", "0 x0 y3 z0 r1", "3 x0 y2 z0 x0 y4 z0 r1"})
    void aLampAMillimetreBehindTheSurfaceDoesNotLightTheFloor(String shape) throws IOException {
        for (boolean accelerated : new boolean[] {false, true}) {
            assertThat(brightness(scene(shape, 1, 0, 0.001), 1, 0, accelerated)).isZero();
        }
    }
}
