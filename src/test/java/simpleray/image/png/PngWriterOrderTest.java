package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.image.Picture;
import simpleray.image.Pictures;

/** A picture that is written while it is rendered: strips of 16 rows, here six and a piece. */
class PngWriterOrderTest {
    private static final long SEED = 1950;
    private static final int WIDTH = 1500;
    private static final int HEIGHT = 100;
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();

    @Test
    void theBytesDoNotDependOnTheOrderOfRows() throws IOException {
        byte[] inOrder = Pictures.png(Pictures.noise(WIDTH, HEIGHT, SEED));
        for (int i = 0; i < 5; i++) {
            Picture picture = Pictures.noise(WIDTH, HEIGHT, SEED);
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            PngWriter writer = new PngWriter(picture, bytes);
            for (int y : shuffled(SEED + i)) {
                writer.row(y);
                picture.release(y);
            }
            writer.end();

            assertThat(bytes.toByteArray()).as("seed " + (SEED + i)).isEqualTo(inOrder);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7})
    void theBytesDoNotDependOnTheThreads(int threads) throws Exception {
        Picture picture = Pictures.noise(WIDTH, HEIGHT, SEED);
        PngWriter writer = new PngWriter(picture, out);
        ExecutorService workers = Executors.newFixedThreadPool(threads);
        try {
            List<Callable<Void>> rows = shuffled(SEED).stream().map(y -> (Callable<Void>) () -> {
                writer.row(y);
                return null;
            }).collect(Collectors.toList());
            for (Future<Void> row : workers.invokeAll(rows)) {
                row.get();
            }
        } finally {
            workers.shutdownNow();
        }
        writer.end();

        assertThat(out.toByteArray()).isEqualTo(Pictures.png(picture));
    }

    @Test
    void whatCanBeWrittenIsWrittenAtOnce() throws IOException {
        PngWriter writer = new PngWriter(Pictures.noise(WIDTH, HEIGHT, SEED), out);
        List<Integer> sizes = new ArrayList<>();
        for (int y = 16; y < 32; y++) {
            writer.row(y);
        }
        sizes.add(out.size());
        for (int y = 0; y < 15; y++) {
            writer.row(y);
        }
        sizes.add(out.size());
        writer.row(15);
        sizes.add(out.size());
        for (int y = 32; y < 48; y++) {
            writer.row(y);
        }
        sizes.add(out.size());

        int strip = 16 * 3 * WIDTH;                           // bytes that no compression makes fewer
        assertThat(sizes.subList(0, 2)).containsOnly(0);
        assertThat(sizes.get(2)).isBetween(2 * strip, 3 * strip);
        assertThat(sizes.get(3)).isBetween(3 * strip, 4 * strip);
    }

    @Test
    void aPictureWithoutAllItsRowsHasNoEnd() throws IOException {
        PngWriter writer = new PngWriter(Pictures.noise(WIDTH, HEIGHT, SEED), out);
        for (int y = 0; y < HEIGHT; y++) {
            if (y != 40) {
                writer.row(y);
            }
        }

        assertThatThrownBy(writer::end).isInstanceOf(IllegalStateException.class)
            .hasMessage("rows of the picture are missing from row 32 on");
    }

    @Test
    void afterAFailureNothingMoreIsWritten() throws IOException {
        List<Integer> written = new ArrayList<>();
        PngWriter writer = new PngWriter(Pictures.noise(WIDTH, HEIGHT, SEED), new OutputStream() {
            @Override
            public void write(int b) {
                written.add(1);
            }

            @Override
            public void write(byte[] bytes, int from, int count) throws IOException {
                written.add(count);
                if (count > 16 * 3 * WIDTH) {
                    throw new IOException("no paper");
                }
            }
        });
        for (int y = 0; y < 15; y++) {
            writer.row(y);
        }
        assertThatThrownBy(() -> writer.row(15)).isInstanceOf(IOException.class).hasMessage("no paper");
        int before = written.size();
        for (int y = 16; y < HEIGHT; y++) {
            writer.row(y);
        }

        assertThat(written).hasSize(before);
        assertThatThrownBy(writer::end).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void memoryIsThatOfSomeRowsWhateverTheHeight() {
        // twice 256 rows and two strips of 16, 3 bytes a pixel and one for the filter
        assertThat(PngWriter.bytesNeeded(new Picture(20000, 1), 256)).isEqualTo(2 * (256 + 32) * 60001L);
        // strips of 65536 / 301 = 217 rows
        assertThat(PngWriter.bytesNeeded(new Picture(100, 1), 256)).isEqualTo(2 * (256 + 434) * 301L);
    }

    private static List<Integer> shuffled(long seed) {
        List<Integer> rows = IntStream.range(0, HEIGHT).boxed().collect(Collectors.toList());
        Collections.shuffle(rows, new Random(seed));
        return rows;
    }
}
