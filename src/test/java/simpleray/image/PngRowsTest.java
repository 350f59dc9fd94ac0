package simpleray.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.Random;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.text.PictureFormatException;

/** Files of our own and of another writer, which uses all filters. */
class PngRowsTest {
    private static final long SEED = 8;

    private static byte[][] read(byte[] file) throws IOException {
        try (PngRows rows = new PngRows(new ByteArrayInputStream(file), "a.png")) {
            byte[][] all = new byte[rows.height()][];
            for (int y = 0; y < all.length; y++) {
                all[y] = rows.next();
                assertThat(all[y]).hasSize(3 * rows.width());
            }
            return all;
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "7, 3", "300, 200", "1, 3000", "30000, 2"})
    void ourOwnFilesComeBack(int width, int height) throws IOException {
        Picture picture = Pictures.noise(width, height, SEED);

        byte[][] rows = read(Pictures.png(picture));

        for (int y = 0; y < height; y++) {
            assertThat(rows[y]).as("row " + y).isEqualTo(picture.levels(y));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {BufferedImage.TYPE_INT_RGB, BufferedImage.TYPE_INT_ARGB, BufferedImage.TYPE_BYTE_GRAY,
        BufferedImage.TYPE_USHORT_GRAY,
        BufferedImage.TYPE_BYTE_BINARY, BufferedImage.TYPE_BYTE_INDEXED})
    void filesOfAnotherWriterComeBack(int type) throws IOException {
        BufferedImage image = new BufferedImage(37, 29, type);
        draw(image);

        byte[][] rows = read(written(image, false));

        assertSamples(image, rows);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void palettesOfFewColoursComeBack(int bits) throws IOException {
        byte[] colours = {0, 17, 34, 51, 68, 85, 102, 119, (byte) 136, (byte) 153, (byte) 170, (byte) 187,
            (byte) 204, (byte) 221, (byte) 238, -1};
        byte[] others = {9, 8, 7, 6, 5, 4, 3, 2, 1, 0, 10, 11, 12, 13, 14, 15};
        IndexColorModel palette = new IndexColorModel(bits, 1 << bits, colours, others, colours);
        BufferedImage image = new BufferedImage(13, 7, BufferedImage.TYPE_BYTE_BINARY, palette);
        draw(image);

        byte[][] rows = read(written(image, false));

        for (int y = 0; y < 7; y++) {
            for (int x = 0; x < 13; x++) {
                int index = image.getRaster().getSample(x, y, 0);
                assertThat(Arrays.copyOfRange(rows[y], 3 * x, 3 * x + 3)).as(x + ", " + y)
                    .containsExactly(colours[index], others[index], colours[index]);
            }
        }
    }

    private static void draw(BufferedImage image) {
        Random random = new Random(SEED);
        int most = 1 << image.getSampleModel().getSampleSize(0);
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                for (int band = 0; band < image.getRaster().getNumBands(); band++) {
                    int smooth = (x * 5 + y * 3) * most / 512;   // so that the writer has reasons to choose this filter and that
                    image.getRaster().setSample(x, y, band, Math.floorMod(y % 3 == 0 ? random.nextInt(most) : smooth, most));
                }
            }
        }
    }

    private static void assertSamples(BufferedImage image, byte[][] rows) {
        int bands = image.getRaster().getNumBands();
        int bits = image.getSampleModel().getSampleSize(0);
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                for (int c = 0; c < 3; c++) {
                    int sample = image.getRaster().getSample(x, y, bands >= 3 ? c : 0);
                    int level = image.getColorModel() instanceof IndexColorModel palette ? palette.getRGB(sample) >> 16 - 8 * c & 0xFF
                        : bits == 16 ? sample >> 8 : sample;
                    assertThat(rows[y][3 * x + c] & 0xFF).as(x + ", " + y + ", " + c).isEqualTo(level);
                }
            }
        }
    }

    private static byte[] written(BufferedImage image, boolean interlaced) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        ImageWriteParam param = writer.getDefaultWriteParam();
        param.setProgressiveMode(interlaced ? ImageWriteParam.MODE_DEFAULT : ImageWriteParam.MODE_DISABLED);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ImageOutputStream out = ImageIO.createImageOutputStream(bytes)) {
            writer.setOutput(out);
            writer.write(null, new IIOImage(image, null, null), param);
        }
        return bytes.toByteArray();
    }

    @Test
    void anInterlacedFileIsRefused() throws IOException {
        byte[] file = written(new BufferedImage(9, 9, BufferedImage.TYPE_INT_RGB), true);

        assertThatThrownBy(() -> read(file)).isInstanceOf(PictureFormatException.class)
            .hasMessage("a.png: is an interlaced PNG, which is not read here");
    }

    @Test
    void everyFileThatIsCutOffIsAnError() throws IOException {
        byte[] file = Pictures.png(Pictures.noise(3, 2, SEED));
        for (int n = 0; n < file.length; n++) {
            byte[] cut = Arrays.copyOf(file, n);
            assertThatThrownBy(() -> read(cut)).as("cut after " + n).isInstanceOf(PictureFormatException.class)
                .hasMessageStartingWith("a.png: ");
        }
    }

    @Test
    void everyBitThatIsWrongIsFound() throws IOException {
        byte[] file = Pictures.png(Pictures.noise(3, 2, SEED));
        for (int bit = 0; bit < 8 * file.length; bit++) {
            byte[] wrong = file.clone();
            wrong[bit / 8] ^= (byte) (1 << bit % 8);
            assertThatThrownBy(() -> read(wrong)).as("bit " + bit).isInstanceOf(PictureFormatException.class)
                .hasMessageStartingWith("a.png: ");
        }
    }

    @Test
    void closingClosesTheFile() throws IOException {
        boolean[] closed = new boolean[1];
        InputStream in = new ByteArrayInputStream(Pictures.png(Pictures.plain(1, 1, 0))) {
            @Override
            public void close() {
                closed[0] = true;
            }
        };
        new PngRows(in, "a.png").close();
        assertThat(closed).containsExactly(true);
    }
}
