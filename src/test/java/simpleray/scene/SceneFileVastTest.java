package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.text.SceneFormatException;

/**
 * Lines of 100 MB and a file of 1 GB, made while they are read: each is refused with no more than 64 MB of memory beyond its length, and within 2 s of
 * processor time, for which the test allows four times as much because it is measured with the counters of the coverage in every loop.
 */
@Tag("slow")
class SceneFileVastTest {
    private static final long MAX_BYTES = 64L << 20;
    private static final long MAX_NANOS = 4 * 2_000_000_000L;
    private static final long LINE = 100_000_000;
    private static final long FILE = 1L << 30;
    private static final com.sun.management.ThreadMXBean THREADS = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();

    /** A stream of a byte and a blank, or of a byte alone, so many bytes long. */
    private static final class Repeated extends InputStream {
        private final byte[] pattern;
        private long left;
        private int at;

        Repeated(String pattern, long length) {
            this.pattern = pattern.getBytes(StandardCharsets.ISO_8859_1);
            left = length;
        }

        @Override
        public int read() {
            throw new UnsupportedOperationException("a reader that reads byte by byte");
        }

        @Override
        public int read(byte[] b, int off, int len) {
            int read = (int) Math.min(left, len);
            for (int i = 0; i < read && pattern.length > 1; i++) {
                b[off + i] = pattern[at];
                at = (at + 1) % pattern.length;
            }
            if (pattern.length == 1) {
                Arrays.fill(b, off, off + read, pattern[0]);
            }
            left -= read;
            return read == 0 ? -1 : read;
        }
    }

    /** Looks twice if it seems to take too long: what other programs do to the machine makes a thread slower, too. */
    private static String refusal(String pattern, long length) {
        long[] nanos = {0};
        String message = refusal(pattern, length, nanos);
        if (nanos[0] >= MAX_NANOS) {
            refusal(pattern, length, nanos);
        }
        assertThat(nanos[0]).as("ns").isLessThan(MAX_NANOS);
        return message;
    }

    private static String refusal(String pattern, long length, long[] nanos) {
        long thread = Thread.currentThread().getId();
        long bytes = THREADS.getThreadAllocatedBytes(thread);
        long start = THREADS.getCurrentThreadCpuTime();

        SceneFormatException e = catchThrowableOfType(SceneFormatException.class, () -> SceneFile.read(new Repeated(pattern, length)));

        nanos[0] = THREADS.getCurrentThreadCpuTime() - start;
        assertThat(THREADS.getThreadAllocatedBytes(thread) - bytes).as("bytes").isLessThan(MAX_BYTES + length);
        return e.problems().get(0).message();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '\'', value = {
        "x | expected a heading of at most 1048576 bytes, found a longer one",
        "9 | expected the number of objects, found ''999999999999999999999999999999999999999999999999999999999999...'' (beyond 1.8e308, the largest number)",
        "* | expected the number of objects, found ''************************************************************...''",
        "' ' | expected the number of objects, found the end of the file",
        "# | expected the number of objects, found the end of the file",
        "'0 ' | expected the end of the scene (after 0 objects and 0 lights), found ''0''"})
    void aLineOfAHundredMegabytesIsRefused(String pattern, String message) {
        assertThat(refusal(pattern, LINE)).isEqualTo(message.replace("''", "'"));
    }

    @Test
    void aGigabyteOfNothingIsRefused() {
        assertThat(refusal("\0", FILE)).isEqualTo("expected a scene, as text in UTF-8, found NUL bytes");
    }

    @Test
    void aLineOfAHundredMegabytesInAnObjIsRefused() throws IOException {
        long thread = Thread.currentThread().getId();
        long bytes = THREADS.getThreadAllocatedBytes(thread);

        SceneFormatException e = catchThrowableOfType(SceneFormatException.class,
            () -> ObjReader.read(new Repeated("v", LINE), "line.obj", warning -> { }));

        assertThat(e.problems().get(0).headline()).isEqualTo(
            "line.obj:1:1: error: expected a line of at most 1048576 characters, found a longer one");
        assertThat(THREADS.getThreadAllocatedBytes(thread) - bytes).as("bytes").isLessThan(MAX_BYTES);
    }
}
