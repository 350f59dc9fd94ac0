package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import org.junit.jupiter.api.Test;
import simpleray.image.Picture;
import simpleray.image.Pictures;
import simpleray.io.Sha256;

class PngSealTest {
    private static final String ROWS = "rows 3 to 4 of 9";
    private static final String KEYWORD = "simpleray.part";

    private static byte[] sealed(Picture picture, String rows) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PngWriter writer = new PngWriter(picture, out, null, rows);
        for (int y = 0; y < picture.height(); y++) {
            writer.row(y);
        }
        writer.end();
        return out.toByteArray();
    }

    private static boolean holds(byte[] file, String rows) throws IOException {
        return PngSeal.holds(new ByteArrayInputStream(file), file.length, rows);
    }

    @Test
    void itIsTheRowsAndTheDigestOfAllBeforeIt() throws IOException {
        Picture picture = Pictures.noise(5, 2, 1);
        byte[] file = sealed(picture, ROWS);

        byte[] plain = Pictures.png(picture);
        byte[] before = Arrays.copyOf(plain, plain.length - 12);            // without IEND
        Map<String, byte[]> texts = PngTextReader.read(new PngChunks(new ByteArrayInputStream(file), "a.png").begin());
        ByteArrayOutputStream summed = new ByteArrayOutputStream();
        summed.write(before);
        summed.write((ROWS + '\n').getBytes("US-ASCII"));
        assertThat(Arrays.copyOf(file, before.length)).isEqualTo(before);
        assertThat(texts).containsOnlyKeys(KEYWORD);
        assertThat(new String(texts.get(KEYWORD), "US-ASCII")).isEqualTo(ROWS + "\nsha256 " + Sha256.of(summed.toByteArray()) + '\n');
        assertThat(Pictures.decoded(file)).isDeepEqualTo(Pictures.expected(picture));
        assertThat(holds(file, ROWS)).isTrue();
    }

    @Test
    void noBitOfTheFileMayBeAnother() throws IOException {
        byte[] file = sealed(Pictures.noise(3, 2, 1), ROWS);

        for (int bit = 0; bit < 8 * file.length; bit += 7) {  // each place in a byte has its turn
            byte[] other = file.clone();
            other[bit / 8] ^= (byte) (1 << bit % 8);
            assertThat(holds(other, ROWS)).as("bit " + bit).isFalse();
        }
    }

    @Test
    void theFileMayNotBeShorterOrLonger() throws IOException {
        byte[] file = sealed(Pictures.noise(3, 2, 1), ROWS);

        for (int length = 0; length < file.length; length++) {
            assertThat(holds(Arrays.copyOf(file, length), ROWS)).as("length " + length).isFalse();
        }
        assertThat(holds(Arrays.copyOf(file, file.length + 1), ROWS)).isFalse();
        assertThat(PngSeal.holds(new ByteArrayInputStream(Arrays.copyOf(file, file.length + 1)), file.length, ROWS)).isFalse();
        assertThat(PngSeal.holds(new ByteArrayInputStream(file), file.length + 1, ROWS)).isFalse();
        assertThat(PngSeal.holds(new ByteArrayInputStream(file), 1L << 20, ROWS)).isFalse();
    }

    @Test
    void itHoldsForItsRowsAlone() throws IOException {
        byte[] file = sealed(Pictures.noise(3, 2, 1), ROWS);

        assertThat(holds(file, "rows 3 to 5 of 9")).isFalse();
        assertThat(holds(file, "rows 3 to 4 of 10")).isFalse();
        assertThat(holds(Pictures.png(Pictures.noise(3, 2, 1)), ROWS)).isFalse();
    }

    @Test
    void aFileOfMegabytesIsSummedInPieces() throws IOException {
        byte[] file = sealed(Pictures.noise(700, 100, 1), ROWS);

        assertThat(file.length).isGreaterThan(3 << 16);
        assertThat(holds(file, ROWS)).isTrue();
        file[file.length / 2]++;
        assertThat(holds(file, ROWS)).isFalse();
    }
}
