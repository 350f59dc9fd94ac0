package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.image.Picture;
import simpleray.image.PictureText;
import simpleray.image.Pictures;

class PngRowReaderTest {
    private static final String FOREIGN = "is not as SimpleRay writes pictures: another program has written it anew";

    @TempDir
    Path folder;
    private Path file;

    private Path write(byte[] png) throws IOException {
        file = folder.resolve("a.png");
        return Files.write(file, png);
    }

    private List<byte[]> read(byte[] png) throws IOException {
        try (PngRowReader reader = new PngRowReader(write(png))) {
            List<byte[]> rows = new ArrayList<>();
            for (int y = 0; y < reader.height(); y++) {
                rows.add(reader.next());
            }
            reader.end();
            return rows;
        }
    }

    private void assertFails(byte[] png, String message) {
        assertThatThrownBy(() -> read(png)).isInstanceOf(PictureFormatException.class).hasMessage(file + ": " + message);
    }

    /** {@return a file of these chunks, each with its sum} */
    private static byte[] png(Object... namesAndData) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(PngChunks.signature());
        for (int i = 0; i < namesAndData.length; i += 2) {
            byte[] data = (byte[]) namesAndData[i + 1];
            byte[] all = ByteBuffer.allocate(4 + data.length).put(((String) namesAndData[i]).getBytes(StandardCharsets.US_ASCII)).put(data)
                .array();
            CRC32 crc = new CRC32();
            crc.update(all);
            out.write(ByteBuffer.allocate(4).putInt(data.length).array());
            out.write(all);
            out.write(ByteBuffer.allocate(4).putInt((int) crc.getValue()).array());
        }
        return out.toByteArray();
    }

    private static byte[] header(int width, int height, int... format) {
        ByteBuffer header = ByteBuffer.allocate(8 + format.length).putInt(width).putInt(height);
        for (int b : format) {
            header.put((byte) b);
        }
        return header.array();
    }

    private static byte[] packed(int... data) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (DeflaterOutputStream deflater = new DeflaterOutputStream(out)) {
            for (int b : data) {
                deflater.write(b);
            }
        }
        return out.toByteArray();
    }

    /** {@return a file of a picture of 2 x 2 with this image data} */
    private static byte[] small(byte[] data) throws IOException {
        return png("IHDR", header(2, 2, 8, 2, 0, 0, 0), "IDAT", data, "IEND", new byte[0]);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1, 40", "7, 3", "300, 200", "2000, 33"})
    void theRowsAreThoseOfThePicture(int width, int height) throws IOException {
        Picture picture = Pictures.noise(width, height, 2010);
        picture.tell(List.of(new PictureText("Software", "SimpleRay")));

        List<byte[]> rows = read(Pictures.png(picture));

        assertThat(rows).hasSize(height);
        for (int y = 0; y < height; y++) {
            assertThat(rows.get(y)).as("row " + y).isEqualTo(picture.levels(y));
        }
    }

    @Test
    void sizesAreThoseOfTheHeader() throws IOException {
        try (PngRowReader reader = new PngRowReader(write(Pictures.png(Pictures.plain(5, 4, 0.5))))) {
            assertThat(reader.width()).isEqualTo(5);
            assertThat(reader.height()).isEqualTo(4);
        }
    }

    @Test
    void nothingIsReadOnceItIsClosed() throws IOException {
        PngRowReader reader = new PngRowReader(write(Pictures.png(Pictures.plain(5, 4, 0.5))));
        reader.close();

        assertThatThrownBy(reader::next).isInstanceOf(NullPointerException.class);
    }

    @Test
    void theFiltersAreAddedUp() throws IOException {
        assertThat(read(small(packed(1, 1, 2, 3, 10, 20, 255, 2, 1, 1, 1, 1, 1, 1)))).containsExactly(
            new byte[] {1, 2, 3, 11, 22, 2}, new byte[] {2, 3, 4, 12, 23, 3});
        assertThat(read(small(packed(1, 1, 2, 3, 10, 20, 255, 1, 1, 1, 1, 1, 1, 1)))).last().isEqualTo(new byte[] {1, 1, 1, 2, 2, 2});
    }

    @Test
    void imageDataMayBeCutAnywhere() throws IOException {
        byte[] data = packed(1, 1, 2, 3, 10, 20, 255, 2, 1, 1, 1, 1, 1, 1);
        for (int cut = 0; cut <= data.length; cut++) {
            assertThat(read(png("IHDR", header(2, 2, 8, 2, 0, 0, 0), "IDAT", Arrays.copyOf(data, cut), "IDAT", new byte[0],
                "IDAT", Arrays.copyOfRange(data, cut, data.length), "IEND", new byte[0]))).as("at " + cut).hasSize(2);
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "2, 3", "7, 40", "300, 200", "3, 20000"})
    void picturesWithAlphaComeBack(int width, int height) throws IOException {
        Picture picture = Pictures.alphaNoise(width, height, 5);

        List<byte[]> rows = read(Pictures.png(picture));

        for (int y = 0; y < height; y++) {
            assertThat(rows.get(y)).as("row " + y).isEqualTo(picture.levels(y));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 3, 4, 5, 255})
    void otherFiltersAreThoseOfOtherPrograms(int filter) throws IOException {
        assertFails(small(packed(1, 1, 2, 3, 4, 5, 6, filter, 1, 1, 1, 1, 1, 1)), FOREIGN);
        assertFails(small(packed(2, 1, 2, 3, 4, 5, 6, 2, 1, 1, 1, 1, 1, 1)), FOREIGN);
    }

    @ParameterizedTest
    @CsvSource({"0, 2, 8 2 0 0 0", "2, 0, 8 2 0 0 0", "65536, 2, 8 2 0 0 0", "2, 65536, 8 2 0 0 0", "-1, 2, 8 2 0 0 0", "2, 2, 16 2 0 0 0",
        "2, 2, 16 6 0 0 0", "2, 2, 8 4 0 0 0", "2, 2, 8 6 0 0 1", "2, 2, 8 2 1 0 0", "2, 2, 8 2 0 1 0", "2, 2, 8 2 0 0 1", "2, 2, 8 2 0 0"})
    void anotherHeaderIsThatOfAnotherProgram(int width, int height, String format) throws IOException {
        int[] bytes = Arrays.stream(format.split(" ")).mapToInt(Integer::parseInt).toArray();

        assertFails(png("IHDR", header(width, height, bytes), "IEND", new byte[0]), FOREIGN);
    }

    @Test
    void whatHasNoHeaderOrALongOneIsRefused() throws IOException {
        assertFails(png("IDAT", new byte[13], "IEND", new byte[0]), FOREIGN);
        assertFails(png("IHDR", new byte[3], "IEND", new byte[0]), FOREIGN);
        assertFails(png("IHDR", header(2, 2, 8, 2, 0, 0, 0, 0), "IEND", new byte[0]),
            "has a chunk IHDR that is too long: 14 bytes of at most 13");
    }

    @Test
    void theLargestSidesAreRead() throws IOException {
        Picture wide = Pictures.plain(65535, 1, 0.5);
        Picture high = Pictures.plain(1, 65535, 0.5);

        try (PngRowReader reader = new PngRowReader(write(Pictures.png(wide)))) {
            assertThat(reader.next()).isEqualTo(wide.levels(0));
        }
        try (PngRowReader reader = new PngRowReader(write(Pictures.png(high)))) {
            assertThat(reader.height()).isEqualTo(65535);
        }
    }

    @Test
    void rowsThatAreMissingAreNamed() throws IOException {
        assertFails(small(packed(1, 1, 2, 3, 4, 5, 6)), "is damaged: its pixels cannot be read from row 1 on");
        assertFails(small(packed(1, 1, 2, 3, 4, 5, 6, 2, 1, 1)), "is damaged: its pixels cannot be read from row 1 on");
        assertFails(small(packed(1, 1, 2, 3, 4, 5, 6, 2, 1, 1, 1, 1, 1)), "is damaged: its pixels cannot be read from row 1 on");
        assertFails(small(new byte[0]), "is damaged: its pixels cannot be read from row 0 on");
        assertFails(png("IHDR", header(2, 2, 8, 2, 0, 0, 0), "IEND", new byte[0]), "is damaged: its pixels cannot be read from row 0 on");
    }

    @Test
    void rowsThatAreTooManyAreNoticed() throws IOException {
        assertFails(small(packed(1, 1, 2, 3, 4, 5, 6, 2, 1, 1, 1, 1, 1, 1, 2)), "is damaged: its pixels cannot be read from row 2 on");
    }

    @Test
    void imageDataThatIsNoneOrHasAWrongSumIsDamaged() throws IOException {
        assertFails(small(new byte[] {1, 2, 3, 4}), "is damaged: its pixels cannot be read from row 0 on");
        byte[] data = packed(1, 1, 2, 3, 4, 5, 6, 2, 1, 1, 1, 1, 1, 1);
        assertFails(small(Arrays.copyOf(data, data.length - 1)), "is damaged: its pixels cannot be read from row 2 on");
        data[data.length - 1]++;
        assertFails(small(data), "is damaged: its pixels cannot be read from row 1 on");
    }

    @Test
    void anyCutIsNoticed() throws IOException {
        byte[] png = Pictures.png(Pictures.noise(3, 3, 1));
        for (int length = 0; length < png.length; length++) {
            byte[] cut = Arrays.copyOf(png, length);
            assertThatThrownBy(() -> read(cut)).as("length " + length).isInstanceOf(PictureFormatException.class);
        }
    }

    @Test
    void anyWrongBitIsNoticed() throws IOException {
        byte[] png = Pictures.png(Pictures.noise(3, 3, 1));
        for (int bit = 0; bit < 8 * png.length; bit += 7) {
            byte[] other = png.clone();
            other[bit / 8] ^= (byte) (1 << bit % 8);
            assertThatThrownBy(() -> read(other)).as("bit " + bit).isInstanceOf(IOException.class);
        }
    }

    @Test
    void whatIsNoPngOrNotThereIsTold() {
        assertFails("no picture".getBytes(StandardCharsets.US_ASCII), "is no PNG");
        assertThatThrownBy(() -> new PngRowReader(folder.resolve("none"))).isInstanceOf(NoSuchFileException.class);
    }
}
