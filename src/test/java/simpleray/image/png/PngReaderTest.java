package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.zip.Deflater;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.image.Picture;
import simpleray.image.Pictures;

/** Files of our own and of another writer, which uses all filters. */
class PngReaderTest {
    private static final long SEED = 8;

    @TempDir
    Path folder;

    private static byte[][] read(byte[] file) throws IOException {
        try (PngReader rows = PngReader.open(new ByteArrayInputStream(file), "a.png")) {
            byte[][] all = new byte[rows.height()][];
            for (int y = 0; y < all.length; y++) {
                all[y] = rows.next();
                assertThat(all[y]).hasSize(rows.channels() * rows.width());
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
        if (image.getColorModel().hasAlpha()) {
            assertPixels(image, rows);
            return;
        }
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

    private static void assertPixels(BufferedImage image, byte[][] rows) {
        for (int y = 0; y < image.getHeight(); y++) {
            int[] packed = Picture.packed(rows[y], Picture.RGBA);
            for (int x = 0; x < image.getWidth(); x++) {
                int argb = image.getRGB(x, y);
                assertThat(packed[x]).as(x + ", " + y).isEqualTo(argb >>> 24 == 0 ? 0 : argb);
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

    @ParameterizedTest
    @ValueSource(ints = {BufferedImage.TYPE_INT_RGB, BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_USHORT_GRAY,
        BufferedImage.TYPE_BYTE_INDEXED})
    void interlacedFilesComeBack(int type) throws IOException {
        BufferedImage image = new BufferedImage(19, 21, type);
        draw(image);

        assertSamples(image, read(written(image, true)));
    }

    @Test
    void ourOwnFilesWithAlphaComeBack() throws IOException {
        Picture picture = Pictures.alphaNoise(50, 33, SEED);

        byte[][] rows = read(Pictures.png(picture));

        for (int y = 0; y < 33; y++) {
            assertThat(rows[y]).as("row " + y).isEqualTo(picture.levels(y));
        }
        assertThat(Pictures.decoded(Pictures.png(picture))).isDeepEqualTo(Pictures.expected(picture));
    }

    /** Two pixels of some kind, of which the first is transparent: a colour of a palette, one of a chunk tRNS, or by its own alpha. */
    @ParameterizedTest
    @CsvSource({"8, 3, 9 8 7 4 5 6, 0, 0 0 1", "8, 2, '', 0 9 0 8 0 7, 0 9 8 7 4 5 6", "8, 6, '', '', 0 9 8 7 0 4 5 6 255",
        "16, 6, '', '', 0 9 9 8 8 7 7 0 0 4 4 5 5 6 6 255 255", "16, 2, '', 9 9 8 8 7 7, 0 9 9 8 8 7 7 4 4 5 5 6 6"})
    void whatIsTransparentIsBlackAndHasNoAlpha(int bits, int kind, String palette, String transparent, String row) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.write(PngChunks.signature());
        chunk("IHDR", 0, 0, 0, 2, 0, 0, 0, 1, bits, kind, 0, 0, 0).writeTo(file);
        if (!palette.isEmpty()) {
            chunk("PLTE", numbers(palette)).writeTo(file);
        }
        if (!transparent.isEmpty()) {
            chunk("tRNS", numbers(transparent)).writeTo(file);
        }
        Deflater deflater = new Deflater();
        byte[] raw = new byte[numbers(row).length];
        for (int i = 0; i < raw.length; i++) {
            raw[i] = (byte) numbers(row)[i];
        }
        deflater.setInput(raw);
        deflater.finish();
        PngChunk data = new PngChunk("IDAT", 1);
        data.putAll(deflater, Deflater.NO_FLUSH);
        deflater.end();
        data.finished().writeTo(file);
        chunk("IEND").writeTo(file);

        assertThat(read(file.toByteArray())[0]).containsExactly(0, 0, 0, 0, 4, 5, 6, 255);
    }

    private static int[] numbers(String words) {
        return Arrays.stream(words.split(" ")).mapToInt(Integer::parseInt).toArray();
    }

    @Test
    void greyWithAlphaComesBack() throws IOException {
        ColorModel model = new ComponentColorModel(ColorSpace.getInstance(ColorSpace.CS_GRAY), true, false, Transparency.TRANSLUCENT,
            DataBuffer.TYPE_BYTE);
        BufferedImage image = new BufferedImage(model, Raster.createInterleavedRaster(DataBuffer.TYPE_BYTE, 2, 1, 2, null), false, null);
        image.getRaster().setPixels(0, 0, 2, 1, new int[] {70, 3, 80, 0});

        assertThat(read(written(image, false))[0]).containsExactly(70, 70, 70, 3, 0, 0, 0, 0);
    }

    /** The upper 8 of 16 bits. */
    @Test
    void coloursOf16BitsComeBack() throws IOException {
        ColorModel model = new ComponentColorModel(ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false, Transparency.OPAQUE,
            DataBuffer.TYPE_USHORT);
        BufferedImage image = new BufferedImage(model, Raster.createInterleavedRaster(DataBuffer.TYPE_USHORT, 11, 5, 3, null), false, null);
        draw(image);

        assertSamples(image, read(written(image, false)));
        assertSamples(image, read(written(image, true)));
    }

    /** What does not fit into memory is read in strips. */
    @Test
    void aStripIsReadBehindTheOther() throws IOException {
        Picture picture = Pictures.noise(40, 50, SEED);
        try (PngReader rows = PngReader.open(new ByteArrayInputStream(Pictures.png(picture)), "a.png", 7)) {
            for (int y = 0; y < 50; y++) {
                assertThat(rows.next()).as("row " + y).isEqualTo(picture.levels(y));
            }
        }
    }

    @Test
    void aPipeIsRead() throws Exception {
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/mkfifo")), "no mkfifo here");
        Path pipe = folder.resolve("pipe");
        assertThat(new ProcessBuilder("/usr/bin/mkfifo", pipe.toString()).start().waitFor()).isZero();
        byte[] file = Pictures.png(Pictures.plain(2, 1, 1));
        CompletableFuture<Void> written = CompletableFuture.runAsync(() -> write(pipe, file));

        try (PngReader rows = PngReader.open(pipe.toString())) {
            assertThat(rows.next()).containsOnly(-1);
        }
        written.get();
    }

    private static void write(Path path, byte[] file) {
        try {
            Files.write(path, file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Sums that are right do not make right data. */
    @Test
    void dataThatCannotBeUnpackedIsAnError() throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.write(PngChunks.signature());
        chunk("IHDR", 0, 0, 0, 3, 0, 0, 0, 2, 8, 2, 0, 0, 0).writeTo(file);
        chunk("IDAT", 1, 2, 3, 4).writeTo(file);
        chunk("IEND").writeTo(file);

        assertThatThrownBy(() -> read(file.toByteArray())).isInstanceOf(PictureFormatException.class)
            .hasMessage("a.png: is damaged: its pixels cannot be read from row 0 on");
    }

    @ParameterizedTest
    @CsvSource({"0, 2", "65536, 2", "-1, 2"})
    void sizesOfNoPictureAreAnError(int width, int height) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.write(PngChunks.signature());
        chunk("IHDR", width >> 24, width >> 16, width >> 8, width, 0, 0, 0, height, 8, 2, 0, 0, 0).writeTo(file);
        chunk("IDAT", 1, 2, 3, 4).writeTo(file);
        chunk("IEND").writeTo(file);

        assertThatThrownBy(() -> read(file.toByteArray())).isInstanceOf(PictureFormatException.class).hasMessageStartingWith("a.png: is ");
    }

    private static PngChunk chunk(String name, int... data) {
        PngChunk chunk = new PngChunk(name, data.length + 1);
        chunk.put(data);
        return chunk.finished();
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
}
