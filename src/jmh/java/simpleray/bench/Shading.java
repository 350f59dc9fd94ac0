package simpleray.bench;

import java.io.IOException;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Setup;
import simpleray.math.Colour;
import simpleray.math.Ray;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SimpleCamera;

/** The thesis's shading of the thesis's scene, with shadows and up to ten reflections. */
public class Shading extends Bench {
    private static final int SIDE = 32;
    private static final int DEPTH = 10;

    private final Ray[] rays = new Ray[SIDE * SIDE];
    private Scene scene;

    /** Reads the scene, and makes a ray for each pixel of a small picture. */
    @Setup
    public void read() throws IOException {
        scene = SceneFile.read(sample("thesis.scene")).scene();
        SimpleCamera camera = new SimpleCamera(SIDE, SIDE);
        for (int i = 0; i < rays.length; i++) {
            rays[i] = camera.ray(i % SIDE, i / SIDE);
        }
    }

    /** {@return the sum of the colours, so that none is left out} */
    @Benchmark
    @OperationsPerInvocation(SIDE * SIDE)
    public Colour shade() {
        Colour sum = new Colour();
        Colour colour = new Colour();
        for (Ray ray : rays) {
            scene.intersect(ray, colour, DEPTH);
            sum.add(colour);
        }
        return sum;
    }
}
