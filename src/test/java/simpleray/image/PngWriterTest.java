package simpleray.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PngWriterTest {
    private static final long SEED = 2010;
    private static final int CHUNK = 65536;

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
    void theFileIsASignatureAHeaderImageDataAndAnEnd() throws IOException {
        List<String> chunks = chunks(Pictures.png(Pictures.plain(3, 2, 0.5)));

        assertThat(chunks).hasSize(3);
        // width 3, height 2, 8 bits, colour type 2 (RGB), deflate, filters 0 to 4, not interlaced
        assertThat(chunks.get(0)).isEqualTo("IHDR 13 00000003000000020802000000");
        assertThat(chunks.get(1)).startsWith("IDAT ");
        assertThat(chunks.get(2)).isEqualTo("IEND 0 ");
    }

    @Test
    void imageDataIsCutIntoChunksOf64KiB() throws IOException {
        // 200 rows of 900 random bytes: about 180000 bytes, however they are compressed: two whole chunks and a piece
        List<String> chunks = chunks(Pictures.png(Pictures.noise(300, 200, SEED)));

        assertThat(chunks).hasSize(5);
        assertThat(chunks.get(1)).startsWith("IDAT " + CHUNK + ' ');
        assertThat(chunks.get(2)).startsWith("IDAT " + CHUNK + ' ');
        assertThat(chunks.get(3)).startsWith("IDAT ").doesNotStartWith("IDAT " + CHUNK + ' ').doesNotStartWith("IDAT 0 ");
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
            .hasMessage("row 1 of the picture is not there yet");
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
