package simpleray.bench;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Setup;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;

/** The reading of a scene of 10,000 spheres. */
@OutputTimeUnit(TimeUnit.MILLISECONDS)
public class Parsing extends Bench {
    private static final int SPHERES = 10_000;

    private byte[] text;

    /** Writes the scene, a line for each sphere and one for its material. */
    @Setup
    public void write() {
        Random random = new Random(1);
        StringBuilder scene = new StringBuilder().append(SPHERES).append(" # objects\n");
        for (int i = 0; i < SPHERES; i++) {
            scene.append(String.format(Locale.ROOT, "0  %.6f %.6f %.6f  %.6f%n", random.nextDouble(), random.nextDouble(),
                -random.nextDouble(), 0.01 * (1 + random.nextDouble())));
            scene.append(String.format(Locale.ROOT, "%.3f 0.2 0.1  %.3f 0.4 0.2  0.3 0.3 0.3  20%n", random.nextDouble(),
                random.nextDouble()));
        }
        scene.append("0.2 0.2 0.2\n1\n0  0.9 0.9 0.8  -2 3 2\n");
        text = scene.toString().getBytes(StandardCharsets.UTF_8);
    }

    /** {@return the scene} */
    @Benchmark
    public Scene read() throws IOException {
        return SceneFile.read(new ByteArrayInputStream(text)).scene();
    }
}
