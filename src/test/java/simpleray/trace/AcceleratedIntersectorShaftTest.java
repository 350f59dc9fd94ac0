package simpleray.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import simpleray.Sample;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.AreaLight;
import simpleray.scene.BruteForceIntersector;
import simpleray.scene.Interaction;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.scene.PointLight;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.Scenes;
import simpleray.scene.Sphere;
import simpleray.scene.VisibilityTester;

/** Shadow rays to the points of an area light: those objects that lie between are found once, and the answers stay the same. */
class AcceleratedIntersectorShaftTest {
    private final Random random = new Random(11);

    private static AreaLight light(int n) {
        return new AreaLight(new Point(-1, 5, -1), new Vector(2, 0, 0), new Vector(0, 0, 2), n);
    }

    private static Scene scene(AreaLight light, Object... objects) {
        Scene scene = Scenes.of(objects);
        Scenes.light(scene, light);
        return scene;
    }

    private static Interaction floor(double x, double y, double z) {
        Interaction at = new Interaction();
        at.point.set(x, y, z);
        at.normal.set(0, 1, 0);
        return at;
    }

    /** {@return how much of each point arrives, as text} */
    private static String arriving(VisibilityTester tester, Scene scene, Interaction at) {
        AreaLight light = (AreaLight) scene.getLight(0);
        StringBuilder all = new StringBuilder();
        PointLight lamp = new PointLight();
        tester.approach(light, at);
        for (int i = 0; i < light.points(); i++) {
            Colour left = new Colour(1, 1, 1);
            light.point(i, lamp);
            tester.reaches(lamp, 0, at, left);
            all.append(left);
        }
        tester.leave();
        return all.toString();
    }

    @Test
    void theAnswersAreThoseOfTheLoopOverAllObjects() {
        Material matt = new Material();
        int partly = 0;
        for (int i = 0; i < Sample.size(400, 60); i++) {
            Object[] objects = new Object[1 + random.nextInt(i % 4 == 0 ? 300 : 20)];
            for (int k = 0; k < objects.length; k++) {
                Material material = random.nextInt(3) == 0 ? Scenes.glass(0, random.nextInt(3) / 2.0, 1.5) : matt;
                Point middle = new Point(random.nextGaussian() * 2, 5 * random.nextDouble(), random.nextGaussian() * 2);
                objects[k] = new Sphere(material, middle, 0.05 + 0.4 * random.nextDouble());
            }
            Scene scene = scene(light(1 + random.nextInt(5)), objects);
            CompiledScene compiled = new CompiledScene(scene, new Point(0, 2, 8), 1, i % 2 == 0 ? Long.MAX_VALUE : 0);
            assertThat(compiled.bvh).isNotNull();
            assertThat(compiled.grid).isNull();
            VisibilityTester fast = new VisibilityTester(compiled.intersector(new RayStats()), true, new RayStats());
            VisibilityTester plain = new VisibilityTester(new BruteForceIntersector(scene), true, new RayStats());
            for (int k = 0; k < 10; k++) {
                Interaction at = floor(random.nextGaussian(), -0.5 * random.nextDouble(), random.nextGaussian());
                String expected = arriving(plain, scene, at);
                assertThat(arriving(fast, scene, at)).isEqualTo(expected);
                partly += expected.contains("(0.0,0.0,0.0)") && expected.contains("(1.0,1.0,1.0)") ? 1 : 0;
            }
        }
        assertThat(partly).isGreaterThan(20);
    }

    /** A ball that blocks all, one beside the light, and many far away: only the first is tested, once for each ray. */
    @Test
    void onlyWhatLiesBetweenIsTested() {
        Object[] objects = new Object[40];
        objects[0] = new Sphere(new Material(), new Point(0, 2, 0), 1);
        for (int i = 1; i < objects.length; i++) {
            objects[i] = new Sphere(new Material(), new Point(20 + 5 * i, 2, 0), 1);
        }
        Scene scene = scene(light(8), objects);
        RayStats stats = new RayStats();
        VisibilityTester tester = new VisibilityTester(new CompiledScene(scene, new Point(0, 2, 8), 1, 0).intersector(stats), true, stats);
        assertThat(arriving(tester, scene, floor(0, 0, 0))).doesNotContain("1");
        assertThat(stats.shadow).isEqualTo(64);
        assertThat(stats.tests).isBetween(64L, 64L + 8);
        assertThat(stats.steps).isZero();
        assertThat(arriving(tester, scene, floor(-9, 0, 0))).doesNotContain("(0.0");
        assertThat(stats.tests).as("nothing is between").isBetween(64L, 64L + 8);
    }

    @Test
    void afterALightTheTreeIsAskedAgain() {
        Object[] objects = new Object[12];
        for (int i = 0; i < objects.length; i++) {
            objects[i] = new Sphere(new Material(), new Point(3 * i, 2, 0), 0.5);
        }
        Scene scene = scene(light(2), objects);
        RayStats stats = new RayStats();
        VisibilityTester tester = new VisibilityTester(new CompiledScene(scene, new Point(0, 2, 8), 1, 0).intersector(stats), true, stats);
        assertThat(arriving(tester, scene, floor(-20, 0, 0))).doesNotContain("(0.0");
        assertThat(tester.reaches(new PointLight(new Point(9, 5, 0)), 0, floor(9, 0, 0), new Colour(1, 1, 1))).isFalse();
        assertThat(stats.steps).isPositive();
    }

    /** Fewer than four points do not pay for a shaft. */
    @Test
    void theShaftOfASinglePointIsNotMade() {
        Object[] objects = new Object[12];
        for (int i = 0; i < objects.length; i++) {
            objects[i] = new Sphere(new Material(), new Point(3 * i, 2, 0), 0.5);
        }
        for (int n = 1; n <= 2; n++) {
            Scene scene = scene(light(n), objects);
            RayStats stats = new RayStats();
            CompiledScene compiled = new CompiledScene(scene, new Point(0, 2, 8), 1, 0);
            VisibilityTester tester = new VisibilityTester(compiled.intersector(stats), true, stats);
            arriving(tester, scene, floor(0, 0, 0));
            assertThat(stats.steps > 0).isEqualTo(n == 1);
        }
    }
}
