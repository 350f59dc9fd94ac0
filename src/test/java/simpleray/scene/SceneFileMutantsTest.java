package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simpleray.Project;
import simpleray.Sample;
import simpleray.text.SceneWriter;

/**
 * A million mutants of all sample scenes and of their OBJ, of which the sample takes 40,000: each is a scene, or has errors with line and
 * column, within 2 s and 64 MB. Of long scenes the mutants are of the first objects and lights and, less often, of the whole.
 */
class SceneFileMutantsTest {
    private static final int ALL_BATCHES = 200;
    private static final int BATCHES = Sample.size(ALL_BATCHES, 8);
    private static final int MUTANTS = 5000 * BATCHES;
    private static final int SHORT = 400;
    private static final int FEW = 1;
    private static final int EVERY = 1000;
    private static final long MAX_BYTES = 64L << 20;
    private static final long MAX_NANOS = 2_000_000_000L;
    private static final com.sun.management.ThreadMXBean THREADS = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();

    @Test
    void manyMutantsAreScenesOrHaveErrorsWithTheirPlaces() throws IOException {
        long seed = Long.getLong("simpleray.mutants.seed", 2014);
        System.out.println("seed of the mutants: " + seed + " (another by -Dsimpleray.mutants.seed=...)");
        List<byte[]> whole = new ArrayList<>();
        for (String name : Project.scenes()) {
            whole.add(Files.readAllBytes(Project.scene(name)));
        }
        whole.add(Arrays.copyOf(Files.readAllBytes(Project.scene("mesh").resolveSibling("knot.obj")), 1 << 13));
        List<byte[]> shortened = whole.stream().map(SceneFileMutantsTest::shortened).toList();
        AtomicLong scenes = new AtomicLong();
        AtomicLong errors = new AtomicLong();

        IntStream.range(0, BATCHES).parallel().forEach(batch -> {
            Mutator some = new Mutator(seed * ALL_BATCHES + batch, shortened);
            Mutator others = new Mutator(seed * ALL_BATCHES - batch - 1, whole);
            for (int i = 0; i < MUTANTS / BATCHES; i++) {
                byte[] mutant = i % EVERY == 0 ? others.next() : some.next();
                (read(mutant, "seed " + seed + ", batch " + batch + ", mutant " + i) ? scenes : errors).incrementAndGet();
            }
        });

        assertThat(scenes.get() + errors.get()).isEqualTo(MUTANTS);
        assertThat(scenes).as("some mutants are harmless").hasValueGreaterThan(MUTANTS / 1000);
        assertThat(errors).as("most are not").hasValueGreaterThan(MUTANTS / 2);
    }

    /** {@return a scene of the first objects and lights} */
    private static byte[] shortened(byte[] text) {
        if (text.length <= SHORT) {
            return text;
        }
        ByteArrayOutputStream few = new ByteArrayOutputStream();
        try {
            Scene scene = SceneFile.read(new ByteArrayInputStream(text)).scene();
            scene.setNumberObjects(Math.min(FEW, scene.getNumberObjects()));
            scene.setNumberLights(Math.min(FEW, scene.getNumberLights()));
            SceneWriter writer = new SceneWriter(few);
            scene.write(writer);
            writer.flush();
            return few.toByteArray();
        } catch (IOException e) {                             // an OBJ, or a scene that names one
            return Arrays.copyOf(text, SHORT);
        }
    }

    private static boolean read(byte[] mutant, String name) {
        long thread = Thread.currentThread().getId();
        long bytes = THREADS.getThreadAllocatedBytes(thread);
        long start = System.nanoTime();
        boolean scene = outcome(mutant, name) == null;
        long took = System.nanoTime() - start;
        assertLess(THREADS.getThreadAllocatedBytes(thread) - bytes, MAX_BYTES + mutant.length, name + ": bytes");
        if (took > MAX_NANOS) {                              // or others had the processor meanwhile
            long busy = THREADS.getCurrentThreadCpuTime();
            outcome(mutant, name);
            assertLess(THREADS.getCurrentThreadCpuTime() - busy, MAX_NANOS, name + ": ns");
        }
        return scene;
    }

    private static IOException outcome(byte[] mutant, String name) {
        try {
            return SceneFuzzer.outcome(mutant);
        } catch (IOException e) {
            throw new UncheckedIOException(name, e);
        } catch (RuntimeException | Error e) {
            throw new AssertionError(name + ": " + Base64.getEncoder().encodeToString(mutant), e);
        }
    }

    private static void assertLess(long value, long limit, String what) {
        if (value > limit) {                                  // assertThat takes longer than reading a mutant
            throw new AssertionError(what + ' ' + value + " > " + limit);
        }
    }
}
