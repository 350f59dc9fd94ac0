package simpleray.image;

import java.io.Closeable;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.zip.InflaterInputStream;
import java.util.zip.ZipException;
import simpleray.text.PngChunks;

/**
 * Reads the pixels of a PNG file row by row, as red, green and blue from 0 to 255: of 16 bits the upper 8, greys three times, without
 * transparency. Interlaced files are not read (W3C, "Portable Network Graphics Specification", second edition, 2003). <em>Mutable,</em> for
 * one thread.
 */
public final class PngRows implements Closeable {
    private static final int GREY = 0;
    private static final int RGB = 2;
    private static final int PALETTE = 3;
    private static final int GREY_ALPHA = 4;
    private static final int RGB_ALPHA = 6;
    private static final int HEADER = 13;
    private static final int BITS_AT = 8;
    private static final int KIND_AT = 9;
    private static final int INTERLACED_AT = 12;
    private static final int LEVEL = 0xFF;

    private final InputStream in;
    private final PngChunks chunks;
    private final int width;
    private final int height;
    private final int bits;
    private final int kind;
    private final int samples;                                // of a pixel
    private byte[] palette = {};
    private final DataInputStream data;
    private byte[] row;
    private byte[] above;
    private int next;

    /** The image data as one stream, of however many chunks. */
    private final class ImageData extends InputStream {
        private boolean over;

        @Override
        public int read() throws IOException {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & LEVEL;
        }

        @Override
        public int read(byte[] bytes, int from, int most) throws IOException {
            int some = over ? -1 : chunks.read(bytes, from, most);
            while (some < 0 && !over) {
                over = !"IDAT".equals(chunks.next());
                some = over ? -1 : chunks.read(bytes, from, most);
            }
            return some;
        }
    }

    /**
     * Begins a file.
     *
     * @param in the file; closed with this
     * @param file what messages call it
     * @throws simpleray.text.PictureFormatException if it is no PNG, or none that can be read
     * @throws IOException if it cannot be read
     */
    public PngRows(InputStream in, String file) throws IOException {
        this.in = in;
        chunks = new PngChunks(in, file).begin();
        if (!"IHDR".equals(chunks.next()) || chunks.left() != HEADER) {
            throw chunks.fault("is damaged: it does not begin with a header");
        }
        byte[] header = chunks.rest(HEADER);
        width = side(header, 0);
        height = side(header, Integer.BYTES);
        bits = header[BITS_AT];
        kind = header[KIND_AT];
        samples = switch (kind) {
            case GREY, PALETTE -> 1;
            case GREY_ALPHA -> 2;
            case RGB -> 3;
            case RGB_ALPHA -> 4;
            default -> 0;
        };
        boolean deep = bits == 8 || bits == 16 && kind != PALETTE;
        boolean flat = samples == 1 && (bits == 1 || bits == 2 || bits == 4);
        if (samples == 0 || !deep && !flat || header[INTERLACED_AT - 2] != 0 || header[INTERLACED_AT - 1] != 0) {
            throw chunks.fault("is damaged: there is no PNG of kind " + kind + " with " + bits + " bits");
        }
        if (header[INTERLACED_AT] != 0) {
            throw chunks.fault("is an interlaced PNG, which is not read here");
        }
        toImageData();
        int length = (int) (((long) width * samples * bits + 7) / 8);
        row = new byte[length];
        above = new byte[length];
        data = new DataInputStream(new InflaterInputStream(new ImageData()));
    }

    private int side(byte[] header, int at) throws IOException {
        int side = (header[at] & LEVEL) << 24 | (header[at + 1] & LEVEL) << 16 | (header[at + 2] & LEVEL) << 8 | header[at + 3] & LEVEL;
        if (side < 1 || side > Picture.LONGEST_SIDE) {
            throw chunks.fault("has a side of " + (side & 0xFFFFFFFFL) + " pixels; 1 to " + Picture.LONGEST_SIDE + " can be read");
        }
        return side;
    }

    private void toImageData() throws IOException {
        String name = chunks.next();
        while (!"IDAT".equals(name)) {
            if (name == null) {
                throw chunks.fault("is damaged: it has no pixels");
            }
            if (name.equals("PLTE")) {
                palette = chunks.rest(3 * (LEVEL + 1));
            }
            name = chunks.next();
        }
    }

    /** {@return the width in pixels} */
    public int width() {
        return width;
    }

    /** {@return the height in pixels} */
    public int height() {
        return height;
    }

    /**
     * Reads the next row; behind the last one, the file is read to its end.
     *
     * @return red, green and blue of each pixel from the left; a new array
     * @throws simpleray.text.PictureFormatException if the file is damaged
     * @throws IOException if it cannot be read
     */
    public byte[] next() throws IOException {
        byte[] freed = above;
        above = row;
        row = freed;
        try {
            int filter = data.readUnsignedByte();
            data.readFully(row);
            unfilter(filter);
            if (next == height - 1) {
                data.read();                                  // nothing more: the sum of all is checked
            }
        } catch (EOFException | ZipException e) {
            throw (IOException) chunks.fault("is damaged: its pixels cannot be read from row " + next + " on").initCause(e);
        }
        byte[] levels = levels();
        if (++next == height) {
            while (chunks.next() != null) {
                continue;
            }
        }
        return levels;
    }

    @SuppressWarnings("NarrowingCompoundAssignment")          // the format counts modulo 256
    private void unfilter(int filter) throws IOException {
        int pixel = Math.max(1, samples * bits / 8);
        for (int i = 0; i < row.length; i++) {
            int left = i < pixel ? 0 : row[i - pixel] & LEVEL;
            int up = above[i] & LEVEL;
            int corner = i < pixel ? 0 : above[i - pixel] & LEVEL;
            row[i] += switch (filter) {
                case 0 -> 0;
                case 1 -> left;
                case 2 -> up;
                case 3 -> (left + up) / 2;
                case 4 -> paeth(left, up, corner);
                default -> throw new ZipException("no filter has the number " + filter);
            };
        }
    }

    /** {@return which of three is nearest to left + up - corner} */
    private static int paeth(int left, int up, int corner) {
        int a = Math.abs(up - corner);
        int b = Math.abs(left - corner);
        int c = Math.abs(left + up - 2 * corner);
        return a <= b && a <= c ? left : b <= c ? up : corner;
    }

    private byte[] levels() throws IOException {
        byte[] rgb = new byte[3 * width];
        for (int x = 0; x < width; x++) {
            for (int c = 0; c < 3; c++) {
                rgb[3 * x + c] = (byte) (samples >= 3 ? sample(x * samples + c) : kind == PALETTE ? colour(sample(x), c)
                    : sample(x * samples) * (bits < 8 ? LEVEL / ((1 << bits) - 1) : 1));
            }
        }
        return rgb;
    }

    /** {@return a sample of the row: a byte of it, the upper one of two, or a part of one} */
    private int sample(int i) {
        if (bits >= 8) {
            return row[i * (bits / 8)] & LEVEL;
        }
        int shift = 8 - bits - i * bits % 8;
        return row[i * bits / 8] >> shift & (1 << bits) - 1;
    }

    private int colour(int i, int c) throws IOException {
        if (3 * i + c >= palette.length) {
            throw chunks.fault("is damaged: it has no colour " + i);
        }
        return palette[3 * i + c] & LEVEL;
    }

    @Override
    public void close() throws IOException {
        data.close();
        in.close();
    }
}
