package simpleray.bench;

import java.util.Random;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Integrator;
import simpleray.scene.Material;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;
import simpleray.scene.Terms;
import simpleray.scene.WhittedIntegrator;
import simpleray.trace.CompiledScene;

/** The way of rays in all directions through 10,000 spheres: spread evenly, which makes a grid, or in a few heaps, which makes a tree. */
public class Traversal extends Bench {
    private static final int SPHERES = 10_000;
    private static final int RAYS = 1024;
    private static final long SEED = 1987;
    private static final int HEAPS = 10;
    private static final double HEAP = 0.01;
    private static final double RADIUS = 0.01;

    /** How the spheres lie. */
    @Param({"evenly", "heaped"})
    public String spheres;

    private final Ray[] rays = new Ray[RAYS];
    private Integrator integrator;

    /** Makes the spheres and the rays. */
    @Setup
    public void prepare() {
        Random random = new Random(SEED);
        boolean heaped = spheres.equals("heaped");
        Scene scene = new Scene();
        scene.setNumberObjects(SPHERES);
        Point heap = new Point();
        for (int i = 0; i < SPHERES; i++) {
            if (heaped && i % (SPHERES / HEAPS) == 0) {
                heap = point(random, 1);
            }
            Point centre = heaped ? Point.add(heap, Vector.subtract(point(random, HEAP), new Point())) : point(random, 1);
            scene.setObject(i, new Sphere(new Material(), centre, heaped ? RADIUS * HEAP : RADIUS));
        }
        RayStats stats = new RayStats();
        CompiledScene compiled = new CompiledScene(scene, new Point(0, 0, 2), 1, Long.MAX_VALUE);
        integrator = new WhittedIntegrator(scene, compiled.intersector(stats), Terms.ALL, stats, null);
        for (int i = 0; i < RAYS; i++) {
            Vector direction = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            direction.normalise();
            rays[i] = new Ray(point(random, 1), direction);
        }
    }

    private static Point point(Random random, double extent) {
        return new Point(extent * (2 * random.nextDouble() - 1), extent * (2 * random.nextDouble() - 1),
            extent * (2 * random.nextDouble() - 1));
    }

    /** {@return how many rays hit something} */
    @Benchmark
    @OperationsPerInvocation(RAYS)
    public int follow() {
        int hits = 0;
        Colour colour = new Colour();
        for (Ray ray : rays) {
            hits += integrator.trace(ray, colour, 0) ? 1 : 0;
        }
        return hits;
    }
}
