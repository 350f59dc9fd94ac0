package simpleray.image.png;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.zip.Adler32;
import java.util.zip.Deflater;
import simpleray.image.Picture;

/**
 * Some neighbouring rows of a picture that are written to a PNG file. They are filtered and compressed independently of other strips:
 * the first row is predicted from the left, and each of the others from the row above it, which gives smaller files
 * at this level than choosing among all of PNG's filters for each row. <em>Mutable</em>; different threads may set different rows.
 */
final class PngStrip {
    /** Bytes of a row before its levels: the filter's number. */
    private static final int HEAD = 1;
    /** The filters of the first row, and of the others. */
    static final byte SUB = 1;
    static final byte UP = 2;
    private static final int USUAL_GAIN = 4;
    /** The number of bytes that are subtracted in one go. */
    private static final int AT_ONCE = 6;

    private final int count;
    private byte[][] rows;                                    // null once they are compressed
    private final AtomicInteger missing;
    private final int pixel;                                  // bytes of a pixel
    private final int bytes;                                  // of a row
    private int sum;

    /**
     * Begins a strip.
     *
     * @param rows its number of rows
     * @param channels the numbers of a pixel
     */
    PngStrip(int rows, int width, int channels) {
        count = rows;
        this.rows = new byte[rows][];
        missing = new AtomicInteger(rows);
        pixel = channels;
        bytes = bytes(width, channels);
    }

    /** {@return the number of bytes that a row takes before it is compressed} */
    static int bytes(int width, int channels) {
        return HEAD + channels * width;
    }

    /**
     * Sets a row; to be called once for each.
     *
     * @param i the row's number, 0 for the strip's first
     * @param picture the picture that has it
     * @param y its number in the picture
     * @param sink also gets its levels; null for none
     * @return whether it was the last missing one
     */
    boolean put(int i, Picture picture, int y, RowSink sink) {
        byte[] row = new byte[HEAD + (bytes - HEAD + AT_ONCE - 1) / AT_ONCE * AT_ONCE];   // see subtract()
        picture.levels(y, row, HEAD);
        if (sink != null) {
            sink.row(y, row, HEAD);                           // before another thread filters it
        }
        rows[i] = row;
        return missing.decrementAndGet() == 0;                // its thread sees all rows
    }

    /**
     * Filters and compresses the rows, and releases their memory.
     *
     * @param chunk gets the blocks, which do not end the deflate stream
     */
    void compress(PngChunk chunk) {
        filter();
        Adler32 adler = new Adler32();
        Deflater deflater = new Deflater(Deflater.BEST_SPEED, true);
        try {
            for (byte[] row : rows) {
                adler.update(row, 0, bytes);
                deflater.setInput(row, 0, bytes);
                chunk.putAll(deflater, Deflater.NO_FLUSH);
            }
            chunk.putAll(deflater, Deflater.SYNC_FLUSH);      // up to a whole byte
        } finally {
            deflater.end();
        }
        sum = (int) adler.getValue();
        rows = null;
    }

    /** {@return room for the compressed bytes of most pictures} */
    int usualSize() {
        return (int) (length() / USUAL_GAIN);
    }

    /** {@return the number of bytes before they were compressed} */
    long length() {
        return (long) count * bytes;
    }

    /** {@return the Adler-32 of the bytes before they were compressed} */
    int sum() {
        return sum;
    }

    /** Filters from the last row up, so that the row above is still as it was. */
    private void filter() {
        for (int i = rows.length - 1; i > 0; i--) {
            subtract(rows[i], rows[i - 1]);
            rows[i][0] = UP;
        }
        byte[] first = rows[0];
        byte[] left = new byte[first.length];                 // the row moved a pixel to the right, black before it
        System.arraycopy(first, HEAD, left, HEAD + pixel, bytes - HEAD - pixel);
        subtract(first, left);
        first[0] = SUB;
    }

    /** Six bytes at a time: a shorter loop takes longer where it is not yet compiled, and many times as long to compile. */
    private static void subtract(byte[] row, byte[] prediction) {
        for (int i = HEAD; i < row.length; i += AT_ONCE) {
            row[i] -= prediction[i];
            row[i + 1] -= prediction[i + 1];
            row[i + 2] -= prediction[i + 2];
            row[i + 3] -= prediction[i + 3];
            row[i + 4] -= prediction[i + 4];
            row[i + 5] -= prediction[i + 5];
        }
    }
}
