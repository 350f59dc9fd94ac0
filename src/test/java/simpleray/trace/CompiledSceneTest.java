package simpleray.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simpleray.RandomScenes;
import simpleray.Sample;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Integrator;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;
import simpleray.scene.Terms;
import simpleray.scene.WhittedIntegrator;

/** The compiled scene's colours are those of the thesis's loop over all objects, bit for bit. */
class CompiledSceneTest {
    private static final long SEED = 19860101;
    private static final int SCENES = Sample.size(10_000, 1000);
    private static final int SIDE = 6;
    private static final int DEPTH = 3;

    @TempDir
    Path folder;

    @ParameterizedTest
    @EnumSource
    void everyStructureFindsTheColoursOfTheLoop(CompiledScene.Structure structure) {
        RandomScenes scenes = new RandomScenes(SEED + structure.ordinal(), folder);
        int lit = 0;
        for (int i = 0; i < SCENES / 2; i++) {
            Scene scene = scenes.next(i % 20 == 0 ? 100 : 25);
            SimpleCamera camera = new SimpleCamera(SIDE, SIDE);
            if (i % 3 == 0) {
                camera.setCOP(Math.pow(10, i % 7));
            }
            Integrator accelerated = accelerated(scene, new CompiledScene(scene, camera.ray(0, 0).origin, 1, structure, i % 2 == 0));
            for (int p = 0; p < SIDE * SIDE; p++) {
                lit += same(scene, accelerated, camera.ray(p % SIDE, p / SIDE),
                    "seed " + (SEED + structure.ordinal()) + ", scene " + i + ", pixel " + p);
            }
        }
        assertThat(lit).as("rays that hit something").isGreaterThan(SCENES * SIDE);
    }

    private static Integrator accelerated(Scene scene, CompiledScene compiled) {
        RayStats stats = new RayStats();
        return new WhittedIntegrator(scene, compiled.intersector(stats), Terms.ALL, stats, null);
    }

    private static int same(Scene scene, Integrator accelerated, Ray ray, String where) {
        Colour expected = new Colour();
        Colour actual = new Colour();
        boolean hit = scene.intersect(ray, expected, DEPTH, Terms.ALL);
        assertThat(accelerated.trace(ray, actual, DEPTH)).as(where).isEqualTo(hit);
        if (expected.r != actual.r || expected.g != actual.g || expected.b != actual.b) {
            assertThat(actual).as(where).hasToString(expected.toString());
        }
        return hit ? 1 : 0;
    }

    @Test
    void raysFromFarAwayFindTheSame() {
        RandomScenes scenes = new RandomScenes(SEED, folder);
        Random random = new Random(SEED);
        for (int i = 0; i < 600; i++) {
            Scene scene = scenes.next(60);
            CompiledScene.Structure structure = CompiledScene.Structure.values()[i % 3];
            Integrator accelerated = accelerated(scene, new CompiledScene(scene, new Point(), 1, structure, true));
            for (int k = 0; k < 40; k++) {
                double far = Math.pow(10, random.nextInt(12) - 3);
                Vector from = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
                from.normalise();
                Vector to = Vector.scale(from, -far);
                to.add(new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()));
                to.normalise();
                if (k % 5 == 0) {
                    to = new Vector(k % 3 == 0 ? 1 : 0, k % 3 == 1 ? -1 : 0, k % 3 == 2 ? 1 : 0);
                }
                same(scene, accelerated, new Ray(new Point(far * from.x, far * from.y, far * from.z), to),
                    "seed " + SEED + ", scene " + i + ", ray " + k);
            }
        }
    }
}
