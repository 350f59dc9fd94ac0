package simpleray.image.png;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.Closeable;
import java.io.File;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.IIOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.FileImageInputStream;
import javax.imageio.stream.ImageInputStream;
import simpleray.image.Picture;

/**
 * Reads the pixels of a PNG file row by row, as red, green and blue from 0 to 255, and alpha if the file has any: the upper 8 of 16 bits,
 * greys three times. What is wholly transparent is black, since nothing of its colour is seen. ImageIO decodes them, in strips that fit into
 * memory; the file's checksums, which it ignores, are checked first. <em>Mutable,</em> for one thread.
 */
public final class PngReader implements Closeable {
    /** A strip takes at most this part of the heap. For each strip the file is decoded from its beginning. */
    private static final int PART_OF_HEAP = 8;
    private static final int MAX_PIXEL_BYTES = 8;             // red, green, blue and opacity of 16 bits
    /** The chunk that names a colour, or colours of a palette, as transparent. */
    private static final String TRANSPARENCY = "tRNS";
    private static final int OPAQUE = 255;

    private final ImageInputStream in;
    private final PngChunks chunks;
    private final ImageReader reader;
    private final int width;
    private final int height;
    private final int channels;
    private final int stripRows;
    private BufferedImage strip;                              // the rows before end; null for none
    private int[] samples;                                    // of a row
    private int end;
    private int next;

    private PngReader(ImageInputStream in, String file, int maxStripRows) throws IOException {
        this.in = in;
        chunks = new PngChunks(new InputStream() {
            @Override
            public int read() throws IOException {
                return in.read();
            }

            @Override
            public int read(byte[] bytes, int from, int most) throws IOException {
                return in.read(bytes, from, most);
            }
        }, file).begin();
        boolean transparent = false;
        for (String name = chunks.next(); name != null; name = chunks.next()) {   // checks their checksums
            transparent |= name.equals(TRANSPARENCY);
        }
        in.seek(0);
        reader = ImageIO.getImageReadersByFormatName("png").next();
        reader.setInput(in, false, true);
        try {
            width = reader.getWidth(0);
            height = reader.getHeight(0);
            channels = transparent || reader.getRawImageType(0).getColorModel().hasAlpha() ? Picture.RGBA : Picture.RGB;
        } catch (IIOException | RuntimeException e) {
            throw damaged("its header cannot be read", e);
        }
        if (Math.min(width, height) < 1 || Math.max(width, height) > Picture.LONGEST_SIDE) {
            throw chunks.fault("is " + width + 'x' + height + "; sides of 1 to " + Picture.LONGEST_SIDE + " pixels can be read");
        }
        stripRows = Math.min(maxStripRows, stripRows(width, height));
    }

    /**
     * Opens a file.
     *
     * @param file its path, as in messages
     * @return a reader of its rows
     * @throws PictureFormatException if it is no PNG, or a damaged one
     * @throws IOException if it cannot be read
     */
    public static PngReader open(String file) throws IOException {
        if (Files.isRegularFile(Path.of(file))) {
            return open(new FileImageInputStream(new File(file)), file, Picture.LONGEST_SIDE);
        }
        try (InputStream in = new FileInputStream(file)) {    // a pipe
            return open(in, file);
        }
    }

    /**
     * Opens a file that comes as a stream, and reads it to its end.
     *
     * @param in the stream, which stays open
     * @param file its name in messages
     * @return a reader of its rows
     * @throws PictureFormatException if it is no PNG, or a damaged one
     * @throws IOException if it cannot be read
     */
    public static PngReader open(InputStream in, String file) throws IOException {
        return open(in, file, Picture.LONGEST_SIDE);
    }

    /** Opens a file, of which at most so many rows are held in memory. */
    static PngReader open(InputStream in, String file, int maxStripRows) throws IOException {
        return open(ImageIO.createImageInputStream(in), file, maxStripRows);
    }

    private static PngReader open(ImageInputStream in, String file, int maxStripRows) throws IOException {
        try {
            return new PngReader(in, file, maxStripRows);
        } catch (IOException e) {
            in.close();
            throw e;
        }
    }

    private PictureFormatException damaged(String what, Exception cause) {
        PictureFormatException fault = chunks.fault("is damaged: " + what);
        fault.initCause(cause);
        return fault;
    }

    /** {@return the width in pixels} */
    public int width() {
        return width;
    }

    /** {@return the height in pixels} */
    public int height() {
        return height;
    }

    /** {@return the numbers of a pixel: {@link Picture#RGB}, or {@link Picture#RGBA} if the file has alpha} */
    public int channels() {
        return channels;
    }

    /**
     * Estimates the memory that reading takes.
     *
     * @param width the picture's width in pixels
     * @param height the picture's height in pixels
     * @return the number of bytes
     */
    public static long bytesNeeded(int width, int height) {
        return (long) MAX_PIXEL_BYTES * width * stripRows(width, height);
    }

    private static int stripRows(int width, int height) {
        long rows = Runtime.getRuntime().maxMemory() / PART_OF_HEAP / MAX_PIXEL_BYTES / width;
        return (int) Math.max(1, Math.min(height, rows));
    }

    /**
     * Reads the next row.
     *
     * @return red, green and blue of each pixel from the left, and its alpha if the file has any; a new array
     * @throws PictureFormatException if the file is damaged
     * @throws IOException if it cannot be read
     */
    public byte[] next() throws IOException {
        if (next == end) {
            readStrip();
        }
        try {
            samples = strip.getRaster().getPixels(0, strip.getHeight() - (end - next), width, 1, samples);
            return levels();
        } finally {
            next++;
        }
    }

    private void readStrip() throws IOException {
        int rows = Math.min(stripRows, height - next);
        ImageReadParam param = reader.getDefaultReadParam();
        param.setSourceRegion(new Rectangle(0, next, width, rows));
        strip = null;                                         // its memory is needed
        try {
            strip = reader.read(0, param);
        } catch (IIOException | RuntimeException e) {
            throw damaged("its pixels cannot be read from row " + next + " on", e);
        }
        end = next + rows;
    }

    private byte[] levels() {
        byte[] levels = new byte[channels * width];
        int bands = strip.getRaster().getNumBands();
        boolean alpha = strip.getColorModel().hasAlpha();
        int unused = strip.getSampleModel().getSampleSize(0) - Byte.SIZE;   // the lower bits of 16
        for (int x = 0; x < width; x++) {
            int first = x * bands;
            int at = channels * x;
            IndexColorModel palette = strip.getColorModel() instanceof IndexColorModel indexed ? indexed : null;
            if (channels == Picture.RGBA) {
                levels[at + Picture.RGB] = (byte) (!alpha ? OPAQUE
                    : palette != null ? palette.getAlpha(samples[first]) : samples[first + bands - 1] >> unused);
                if (levels[at + Picture.RGB] == 0) {
                    continue;
                }
            }
            for (int c = 0; c < Picture.RGB; c++) {
                levels[at + c] = (byte) (palette != null ? palette.getRGB(samples[first]) >> 16 - 8 * c
                    : samples[bands < Picture.RGB ? first : first + c] >> unused);
            }
        }
        return levels;
    }

    @Override
    public void close() throws IOException {
        reader.dispose();
        in.close();
    }
}
