package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.image.Picture;
import simpleray.image.PictureText;

class ApngWriterTest {
    private static final int WIDTH = 300;
    private static final int HEIGHT = 200;                    // more than one strip

    @TempDir
    Path folder;

    private record Chunk(String name, byte[] data) {
        int number(int at) {
            return ByteBuffer.wrap(data).getInt(at);
        }
    }

    private static List<Chunk> chunks(byte[] file) throws IOException {
        PngChunks in = new PngChunks(new ByteArrayInputStream(file), "film").begin();
        List<Chunk> all = new ArrayList<>();
        for (String name = in.next(); name != null; name = in.next()) {
            all.add(new Chunk(name, in.rest(Integer.MAX_VALUE)));
        }
        return all;
    }

    private List<Path> frames(int count) throws IOException {
        List<Path> files = new ArrayList<>();
        Random random = new Random(7);
        for (int i = 0; i < count; i++) {
            Picture picture = new Picture(WIDTH, HEIGHT);
            for (int y = 0; y < HEIGHT; y++) {
                picture.setRow(y, random.doubles(3 * WIDTH).toArray());
            }
            picture.tell(List.of(new PictureText("scene", "frame " + i)));
            Path file = folder.resolve(i + ".png");
            try (PictureFile png = new PictureFile(file)) {
                png.write(picture);
            }
            files.add(file);
        }
        return files;
    }

    private static byte[] film(List<Path> files) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ApngWriter.write(files, 1001, 30000, out);
        return out.toByteArray();
    }

    @Test
    void aFilmHasItsFramesInOrder() throws IOException {
        List<Chunk> film = chunks(film(frames(3)));

        assertThat(film).extracting(Chunk::name).startsWith("IHDR", "iTXt", "acTL", "fcTL", "IDAT", "IDAT").endsWith("fdAT", "IEND");
        Chunk control = film.get(2);
        assertThat(control.number(0)).as("frames").isEqualTo(3);
        assertThat(control.number(4)).as("for ever").isZero();
        assertThat(new String(film.get(1).data)).endsWith("frame 0");
        List<Chunk> controls = film.stream().filter(chunk -> chunk.name.equals("fcTL")).toList();
        assertThat(controls).hasSize(3).allSatisfy(chunk -> {
            assertThat(chunk.data).hasSize(26);
            assertThat(List.of(chunk.number(4), chunk.number(8), chunk.number(12), chunk.number(16))).containsExactly(WIDTH, HEIGHT, 0, 0);
            assertThat(chunk.number(20)).as("1001/30000 s").isEqualTo(1001 << 16 | 30000);
            assertThat(chunk.data[24]).isZero();
            assertThat(chunk.data[25]).isZero();
        });
        List<Integer> sequence = film.stream().filter(chunk -> chunk.name.equals("fcTL") || chunk.name.equals("fdAT"))
            .map(chunk -> chunk.number(0)).toList();
        assertThat(sequence).hasSizeGreaterThan(5);
        for (int i = 0; i < sequence.size(); i++) {
            assertThat(sequence.get(i)).isEqualTo(i);
        }
    }

    @Test
    void eachFrameIsAsItsPicture() throws IOException, DataFormatException {
        List<Path> files = frames(3);
        List<byte[]> frames = new ArrayList<>();
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        for (Chunk chunk : chunks(film(files))) {
            if ((chunk.name.equals("fcTL") || chunk.name.equals("IEND")) && data.size() > 0) {
                frames.add(inflated(data.toByteArray()));
                data.reset();
            } else if (chunk.name.equals("IDAT")) {
                data.write(chunk.data);
            } else if (chunk.name.equals("fdAT")) {
                data.write(chunk.data, Integer.BYTES, chunk.data.length - Integer.BYTES);
            }
        }
        assertThat(frames).hasSize(3);
        for (int i = 0; i < 3; i++) {
            ByteArrayOutputStream expected = new ByteArrayOutputStream();
            for (Chunk chunk : chunks(Files.readAllBytes(files.get(i)))) {
                if (chunk.name.equals("IDAT")) {
                    expected.write(chunk.data);
                }
            }
            assertThat(frames.get(i)).isEqualTo(inflated(expected.toByteArray()));
        }
    }

    private static byte[] inflated(byte[] data) throws DataFormatException {
        Inflater inflater = new Inflater();
        inflater.setInput(data);
        byte[] rows = new byte[(1 + 3 * WIDTH) * HEIGHT + 1];
        int length = inflater.inflate(rows);
        assertThat(inflater.finished()).isTrue();
        inflater.end();
        return Arrays.copyOf(rows, length);
    }

    @Test
    void aDamagedFrameIsNoFilm() throws IOException {
        List<Path> files = frames(2);
        byte[] damaged = Files.readAllBytes(files.get(1));
        damaged[damaged.length / 2]++;
        Files.write(files.get(1), damaged);

        assertThatThrownBy(() -> film(files)).isInstanceOf(PictureFormatException.class).hasMessageContaining("1.png: is damaged");
    }
}
