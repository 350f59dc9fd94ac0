package simpleray.scene;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import simpleray.image.png.PictureFormatException;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/**
 * Reads bytes as a scene, and as an OBJ, and finds whether the outcome is one that is allowed: a scene, or errors with their places. Jazzer
 * calls it by the name that it looks for.
 */
public final class SceneFuzzer {
    private static final String OBJ_KEYWORDS = "vf";
    private static final ThreadMXBean CLOCK = ManagementFactory.getThreadMXBean();
    private static final long MAX_TIME = 2_000_000_000L;

    private SceneFuzzer() {
    }

    /**
     * Reads all that the fuzzer begins with, before it looks at the clock: on a busy machine Jazzer's changes to the classes take longer
     * than an input may.
     *
     * @throws IOException if they cannot be read
     * @throws URISyntaxException likewise
     */
    public static void fuzzerInitialize() throws IOException, URISyntaxException {
        try (Stream<Path> files = Files.list(Path.of(SceneFuzzer.class.getResource("/fuzz/corpus").toURI()))) {
            for (Path file : files.toList()) {
                outcome(Files.readAllBytes(file));
            }
        }
    }

    /**
     * Reads the bytes.
     *
     * @param data the bytes
     * @throws IOException never: from memory it would be an error of the reader
     * @throws AssertionError if it takes too long; only the time that this thread has a processor counts, as the machine may be busy
     */
    public static void fuzzerTestOneInput(byte[] data) throws IOException {
        long begin = CLOCK.getCurrentThreadCpuTime();
        outcome(data);
        if (CLOCK.getCurrentThreadCpuTime() - begin > MAX_TIME) {
            throw new AssertionError("it took longer than 2 s");
        }
    }

    /**
     * Reads bytes that begin like an OBJ as one, all others as a scene.
     *
     * @return what is wrong; null for a scene
     * @throws AssertionError if an error has no place
     */
    static IOException outcome(byte[] data) throws IOException {
        try {
            if (data.length > 1 && OBJ_KEYWORDS.indexOf(data[0]) >= 0) {
                new TriangleMesh(ObjReader.read(new ByteArrayInputStream(data), "<obj>", warning -> check(warning, false))).tree();
            } else {
                SceneFile.read(new ByteArrayInputStream(data)).warnings().forEach(warning -> check(warning, false));
            }
            return null;
        } catch (SceneFormatException e) {
            if (e.problems().isEmpty()) {
                throw new AssertionError("an exception without a problem", e);
            }
            e.problems().forEach(error -> check(error, true));
            return e;
        } catch (PictureFormatException e) {                  // the bytes begin as a PNG does
            return e;
        }
    }

    private static void check(Diagnostic problem, boolean error) {
        boolean complete = problem.line() >= 1 && problem.column() >= 1 && problem.error() == error
            && (!error || problem.message().startsWith("expected ") && problem.message().contains(", found "));
        if (!complete) {
            throw new AssertionError("not line, column, expected and found: " + problem);
        }
    }
}
