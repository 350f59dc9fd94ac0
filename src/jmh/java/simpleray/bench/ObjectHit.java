package simpleray.bench;

import java.io.IOException;
import java.util.Random;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Object;

/** The intersection of a ray with one object about as large as the unit sphere around the origin. */
public abstract class ObjectHit extends Bench {
    private static final int RAYS = 1024;
    private static final double FAR = 4;

    /** Whether all rays hit the object, or all miss it by little. */
    @Param({"hit", "miss"})
    public String rays;

    private final Ray[] all = new Ray[RAYS];
    private Object object;

    /** For subclasses. */
    protected ObjectHit() {
    }

    /** {@return the object} */
    abstract Object object() throws IOException;

    /** Takes from random rays, from all around through the cube around the unit sphere, those that are wanted. */
    @Setup
    public void aim() throws IOException {
        object = object();
        Random random = new Random(1);
        for (int i = 0; i < RAYS;) {
            Vector from = new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalised();
            Point origin = new Point(FAR * from.x, FAR * from.y, FAR * from.z);
            Vector direction = new Vector(coordinate(random) - origin.x, coordinate(random) - origin.y, coordinate(random) - origin.z);
            Ray ray = new Ray(origin, direction.normalised());
            if (object.intersect(ray) >= 0 == rays.equals("hit")) {
                all[i++] = ray;
            }
        }
    }

    private static double coordinate(Random random) {
        return 2 * random.nextDouble() - 1;
    }

    /** {@return the sum of the distances, so that none is left out} */
    @Benchmark
    @OperationsPerInvocation(RAYS)
    public double intersect() {
        double sum = 0;
        for (Ray ray : all) {
            sum += object.intersect(ray);
        }
        return sum;
    }
}
