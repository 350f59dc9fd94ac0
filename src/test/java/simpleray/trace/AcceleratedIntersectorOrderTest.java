package simpleray.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
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
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;
import simpleray.scene.StandIn;

/** Which objects are tested, and in which order they dim a light. */
class AcceleratedIntersectorOrderTest {
    private static final long SEED = 1984;

    private Scene scene;

    private CompiledScene compiled(CompiledScene.Structure structure, boolean buffers) {
        return new CompiledScene(scene, new Point(0, 3, 12), 1, structure, buffers);
    }

    private static Intersector of(CompiledScene compiled) {
        return compiled.intersector(new RayStats());
    }

    private static Ray ray(double x, double y, double z, double dx, double dy, double dz) {
        return new Ray(new Point(x, y, z), new Vector(dx, dy, dz).normalised());
    }

    @Test
    void eachTestIsCountedOnce() {
        scene = new Scene();
        scene.setNumberObjects(5);
        scene.setObject(0, new Plane(new Material(), new Vector(0, 0, 1), -5));
        for (int i = 1; i < 5; i++) {
            scene.setObject(i, new Sphere(new Material(), new Point(0, 0, 0), 1));
        }
        scene.setNumberLights(1);
        scene.setLight(0, new PointLight(new Point(0, 0, 50)));
        CompiledScene.Structure[] both = {CompiledScene.Structure.BVH, CompiledScene.Structure.GRID};
        for (CompiledScene.Structure structure : both) {
            RayStats stats = new RayStats();
            Intersector intersector = compiled(structure, false).intersector(stats);
            intersector.intersect(ray(0, 0, 9, 0, 0, 1), new Hit());
            assertThat(stats.tests).as("away from all").isEqualTo(1);
            intersector.intersect(ray(0, 0, 9, 0, 0, -1), new Hit());
            assertThat(stats.tests - 1).as("towards them").isGreaterThanOrEqualTo(5);
            stats.tests = 0;
            intersector.occluded(ray(0, 0, -9, 0, 0, 1), 59, 0, new Colour(1, 1, 1));
            assertThat(stats.tests).as("the plane ends the search").isEqualTo(1);
            stats.tests = 0;
            intersector.occluded(ray(0, 0, -4, 0, 0, 1), 54, 0, new Colour(1, 1, 1));
            assertThat(stats.tests).as("after the plane the first sphere").isEqualTo(2);
            stats.tests = 0;
            intersector.occluded(ray(0, 0, 4, 0, 0, 1), 46, 0, new Colour(1, 1, 1));
            assertThat(stats.tests).as("nothing is in the way but the plane, behind").isEqualTo(1);
        }
    }

    /** Light that is dimmed in another order may differ in the last bit. */
    @ParameterizedTest
    @EnumSource
    void glassObjectsDimLightInTheOrderOfTheScene(CompiledScene.Structure structure) {
        Random random = new Random(SEED);
        scene = new Scene();
        scene.setNumberObjects(50);
        for (int i = 0; i < 50; i++) {
            Material glass = new Material();
            glass.transmission = new Colour(0.5 + random.nextDouble() / 2, 0.5 + random.nextDouble() / 2, 0.9);
            scene.setObject(i, i == 9 ? new Plane(glass, new Vector(0, 0, 1), 2.5)
                : new Sphere(glass, new Point(0, 0, 50 * random.nextDouble()), 0.5 + random.nextDouble()));
        }
        scene.setNumberLights(1);
        scene.setLight(0, new PointLight(new Point(0, 0, 60)));
        for (boolean buffers : new boolean[] {true, false}) {
            Intersector intersector = of(compiled(structure, buffers));
            for (int i = 0; i < 200; i++) {
                Ray ray = ray(0, 0, -5 - random.nextDouble(), 0, 0, 1);
                Colour expected = new Colour(1, 2, 3);
                Colour left = new Colour(1, 2, 3);
                new BruteForceIntersector(scene).occluded(ray, 60 - ray.origin.z, 0, expected);
                assertThat(intersector.occluded(ray, 60 - ray.origin.z, 0, left)).isFalse();
                assertThat(left).as("seed %d, ray %d", SEED, i).hasToString(expected.toString());
            }
        }
    }

    /** A half-space, y below -1: infinite, and no plane. */
    private static final class Ground extends StandIn {
        private final Plane surface = new Plane(new Material(), new Vector(0, 1, 0), -1);

        Ground(Material material) {
            super(material);
        }

        @Override
        public double intersect(Ray ray) {
            return surface.intersect(ray);
        }

        @Override
        public Vector normal(Point pt) {
            return surface.normal(pt);
        }
    }

    @Test
    void infiniteObjectsOtherThanPlanesAreTested() {
        Material glass = new Material();
        glass.transmission = new Colour(0.5, 0.5, 0.5);
        for (Material material : new Material[] {new Material(), glass}) {
            scene = new Scene();
            scene.setNumberObjects(3);
            scene.setObject(0, new Ground(material));
            scene.setObject(1, new Plane(new Material(), new Vector(0, 1, 0), -1));
            scene.setObject(2, new Sphere(glass, new Point(0, 5, 0), 1));
            scene.setNumberLights(1);
            scene.setLight(0, new PointLight(new Point(0, -2, 0)));
            Intersector intersector = of(compiled(CompiledScene.Structure.AUTO, true));
            Hit hit = new Hit();
            Colour left = new Colour(1, 1, 1);

            assertThat(intersector.intersect(ray(0, 0, 0, 0, -1, 0), hit)).isTrue();
            assertThat(hit.place).as("listed before the plane").isZero();
            assertThat(intersector.intersect(ray(0, 0, 0, 0, 1, 0), hit)).isTrue();
            assertThat(hit.place).isEqualTo(2);
            assertThat(intersector.occluded(ray(0, 0, 0, 0, -1, 0), 1, 0, left)).as("up to the ground").isFalse();
            assertThat(left.r).isEqualTo(1);
            scene.setObject(1, new Sphere(glass, new Point(0, -9, 0), 1));
            intersector = of(compiled(CompiledScene.Structure.AUTO, true));
            assertThat(intersector.occluded(ray(0, 0, 0, 0, -1, 0), 2, 0, left)).isEqualTo(material != glass);
            assertThat(left.r).isEqualTo(material == glass ? 0.5 : 0);
        }
    }
}
