package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.InflaterInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.image.Picture;
import simpleray.image.Pictures;

class PngWriterTest {
    private static final long SEED = 2010;

    @ParameterizedTest
    @CsvSource({"1, 1", "1, 7", "7, 1", "300, 200", "65535, 1", "1, 65535"})
    void anotherReaderSeesEveryPixel(int width, int height) throws IOException {
        Picture picture = Pictures.noise(width, height, SEED);

        assertThat(Pictures.decoded(Pictures.png(picture))).as("seed " + SEED).isDeepEqualTo(Pictures.expected(picture));
    }

    @Test
    void aSmoothPictureComesBackAndIsSmall() throws IOException {
        Picture picture = new Picture(256, 256);
        for (int y = 0; y < 256; y++) {
            double[] row = new double[3 * 256];
            for (int i = 0; i < row.length; i++) {
                row[i] = (i / 3 + y) / 510.0;
            }
            picture.setRow(y, row);
        }

        byte[] png = Pictures.png(picture);

        assertThat(Pictures.decoded(png)).isDeepEqualTo(Pictures.expected(picture));
        assertThat(png.length).isLessThan(3 * 256 * 256 / 50);
    }

    @Test
    void picturesOfAnyShapeComeBack() throws IOException {
        for (int width = 1; width <= 20; width++) {
            for (int height = 1; height <= 40; height += 3) {
                Picture picture = Pictures.noise(width, height, SEED);
                assertThat(Pictures.decoded(Pictures.png(picture))).as(width + "x" + height + ", seed " + SEED)
                    .isDeepEqualTo(Pictures.expected(picture));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {15, 16, 17, 31, 32, 33, 40})
    void aPictureOfSeveralStripsComesBack(int height) throws IOException {
        Picture picture = Pictures.noise(2000, height, SEED);     // 16 rows a strip: full ones, and one that is not

        byte[] png = Pictures.png(picture);

        assertThat(Pictures.decoded(png)).as("seed " + SEED).isDeepEqualTo(Pictures.expected(picture));
        assertThat(chunks(png)).as("a header, a chunk for each strip, the end of the image data, and the end")
            .hasSize(3 + (height + 15) / 16);
    }

    @Test
    void theFileIsASignatureAHeaderImageDataAndAnEnd() throws IOException {
        List<String> chunks = chunks(Pictures.png(Pictures.plain(3, 2, 0.5)));

        assertThat(chunks).hasSize(4);
        // width 3, height 2, 8 bits, colour type 2 (RGB), deflate, filters 0 to 4, not interlaced
        assertThat(chunks.get(0)).isEqualTo("IHDR 13 00000003000000020802000000");
        assertThat(chunks.get(1)).startsWith("IDAT ").contains(" 7801").endsWith("0000ffff");   // and up to a whole byte
        // the end of the stream, and the sum of 1, then filter 1 and 128, 128, 128 and six zeros, then filter 2 and nine zeros:
        // 1 + 1 + 3 * 128 + 2 = 388, and 2 + 130 + 258 + 386 + 6 * 386 + 388 + 9 * 388 = 6972
        assertThat(chunks.get(2)).isEqualTo("IDAT 6 0300" + "1b3c" + "0184");
        assertThat(chunks.get(3)).isEqualTo("IEND 0 ");
    }

    @Test
    void theFirstRowOfAStripIsPredictedFromItsLeftAndTheOthersFromAbove() throws Exception {
        byte[] data = inflated(Pictures.png(Pictures.noise(2000, 40, SEED)));

        for (int y = 0; y < 40; y++) {
            assertThat(data[y * 6001]).as("row " + y).isEqualTo((byte) (y % 16 == 0 ? 1 : 2));
        }
    }

    /** {@return the stream of the image data, taken apart by the JDK, which checks its sum} */
    private static byte[] inflated(byte[] png) throws IOException {
        StringBuilder stream = new StringBuilder();
        chunks(png).stream().filter(chunk -> chunk.startsWith("IDAT ")).forEach(chunk -> stream.append(chunk.split(" ")[2]));
        byte[] bytes = new byte[stream.length() / 2];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) Integer.parseInt(stream.substring(2 * i, 2 * i + 2), 16);
        }
        try (InputStream in = new InflaterInputStream(new ByteArrayInputStream(bytes))) {
            return in.readAllBytes();
        }
    }

    @Test
    void theStreamIsFlushedAndStaysOpen() throws IOException {
        List<String> calls = new ArrayList<>();
        PngWriter.write(Pictures.plain(1, 1, 0), new ByteArrayOutputStream() {
            @Override
            public void flush() {
                calls.add("flush");
            }

            @Override
            public void close() {
                calls.add("close");
            }
        });

        assertThat(calls).isNotEmpty().containsOnly("flush");
    }

    @Test
    void aMissingRowIsAnError() {
        Picture picture = new Picture(1, 2);
        picture.setRow(0, new double[3]);

        assertThatThrownBy(() -> Pictures.png(picture)).isInstanceOf(IllegalStateException.class)
            .hasMessage("row 1 of the picture is not there");
    }

    /** {@return each chunk as its name, its length and its data in hexadecimal; the sums are checked} */
    private static List<String> chunks(byte[] png) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(png));
        assertThat(in.readNBytes(8)).containsExactly(0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n');
        List<String> chunks = new ArrayList<>();
        while (in.available() > 0) {
            int length = in.readInt();
            byte[] nameAndData = in.readNBytes(4 + length);
            CRC32 crc = new CRC32();
            crc.update(nameAndData);
            assertThat(in.readInt()).isEqualTo((int) crc.getValue());
            String name = new String(nameAndData, 0, 4, StandardCharsets.US_ASCII);
            StringBuilder data = new StringBuilder();
            for (int i = 4; i < nameAndData.length; i++) {
                data.append(String.format("%02x", nameAndData[i]));
            }
            chunks.add(name + ' ' + length + ' ' + data);
        }
        return chunks;
    }
}
