package simpleray.image.png;

import java.io.IOException;
import java.io.OutputStream;
import java.util.HashMap;
import java.util.Map;
import simpleray.image.Picture;
import simpleray.image.PictureText;

/**
 * Writes a picture as PNG while its rows are being finished, in any order and by any threads: RGB or RGBA, 8 bits each (W3C, "Portable Network
 * Graphics Specification", second edition, 2003). docs/decisions/0002 tells why ImageIO does not do it. <em>Mutable</em>; any thread may call.
 *
 * <p>The picture is cut into strips. The thread that adds a strip's last row compresses the strip, and writes it if it is the next one. The
 * bytes depend on the picture alone.
 */
public final class PngWriter {
    /** Behind width and height in the header: bits, RGB or RGBA, deflate, the five filters, not interlaced. */
    private static final byte[] FORMAT = {8, 2, 0, 0, 0};
    private static final byte[] ALPHA_FORMAT = {8, 6, 0, 0, 0};
    private static final int[] ZLIB = {0x78, 0x01};           // deflate with a window of 32 KiB, compressed fast
    private static final int[] LAST_BLOCK = {0x03, 0x00};     // of no bytes
    /** The least number of rows of a strip; there are more if they have fewer bytes than the next number. */
    private static final int FEWEST_ROWS = 16;
    private static final int FEWEST_BYTES = 1 << 16;

    private final Picture picture;
    private final OutputStream out;
    private final RowSink sink;                               // null for none
    private final PngSeal seal;                               // null for none
    private final int stripRows;
    private final Map<Integer, PngStrip> begun = new HashMap<>();
    private final Map<Integer, Compressed> waiting = new HashMap<>();
    private final Adler sum = new Adler();                    // of all bytes written
    private int written;                                      // strips

    /** A strip that is to be written. */
    private record Compressed(PngStrip strip, PngChunk chunk) {
    }

    /**
     * Begins a file; nothing is written yet.
     *
     * @param picture the picture, whose rows may still be missing
     * @param out the stream to write to; stays open
     */
    public PngWriter(Picture picture, OutputStream out) {
        this(picture, out, null);
    }

    /**
     * Begins a file; nothing is written yet.
     *
     * @param picture the picture, whose rows may still be missing
     * @param out the stream to write to; stays open
     * @param sink also gets each row, on the thread that adds it; null for none
     */
    public PngWriter(Picture picture, OutputStream out, RowSink sink) {
        this(picture, out, sink, null);
    }

    /**
     * Begins a file; nothing is written yet.
     *
     * @param picture the picture, whose rows may still be missing
     * @param out the stream to write to; stays open
     * @param sink also gets each row, on the thread that adds it; null for none
     * @param rows the rows of a larger picture that this one is, which a {@link PngSeal} at the end tells; null for none
     */
    public PngWriter(Picture picture, OutputStream out, RowSink sink, String rows) {
        this.picture = picture;
        seal = rows == null ? null : new PngSeal(out, rows);
        this.out = seal == null ? out : seal.out();
        this.sink = sink;
        stripRows = stripRows(picture.width(), picture.channels());
    }

    /** {@return what is behind width and height in the header of a picture with so many numbers a pixel} */
    static byte[] format(int channels) {
        return channels == Picture.RGBA ? ALPHA_FORMAT : FORMAT;
    }

    private static int stripRows(int width, int channels) {
        return Math.max(FEWEST_ROWS, FEWEST_BYTES / PngStrip.bytes(width, channels));
    }

    /**
     * Estimates the memory that writing takes, in addition to the rows that are set in the picture.
     *
     * @param picture the picture, whose rows may still be missing
     * @param ahead how many rows are begun at most, of which the first is not taken
     * @return the number of bytes
     */
    public static long bytesNeeded(Picture picture, int ahead) {
        int rows = ahead + 2 * stripRows(picture.width(), picture.channels());
        return 2L * rows * PngStrip.bytes(picture.width(), picture.channels());   // as they are and, at worst, no smaller compressed
    }

    /**
     * Writes a whole picture. The stream is flushed and stays open.
     *
     * @param picture the picture, all its rows set
     * @param out the stream to write to
     * @throws IOException if it cannot be written
     */
    public static void write(Picture picture, OutputStream out) throws IOException {
        PngWriter writer = new PngWriter(picture, out);
        for (int y = 0; y < picture.height(); y++) {
            writer.row(y);
        }
        writer.end();
    }

    /**
     * Adds a row of the picture, which may then release it. All strips that are next are written.
     *
     * @param y the row, 0 at the top; each once
     * @throws IOException if it cannot be written; nothing more is then
     * @throws IllegalStateException if the picture does not have the row
     */
    public void row(int y) throws IOException {
        int i = y / stripRows;
        PngStrip strip = strip(i);
        if (strip.put(y % stripRows, picture, y, sink)) {
            PngChunk chunk = new PngChunk("IDAT", ZLIB.length + strip.usualSize());
            if (i == 0) {
                chunk.put(ZLIB);
            }
            strip.compress(chunk);
            write(i, new Compressed(strip, chunk.finished()));
        }
    }

    private synchronized PngStrip strip(int i) {
        PngStrip strip = begun.get(i);
        if (strip == null) {
            strip = new PngStrip(Math.min(stripRows, picture.height() - i * stripRows), picture.width(), picture.channels());
            begun.put(i, strip);
        }
        return strip;
    }

    /** Writes a strip, if it is the next, and those that waited for it. Other threads wait meanwhile, so that no rows pile up. */
    private synchronized void write(int i, Compressed strip) throws IOException {
        begun.remove(i);
        waiting.put(i, strip);
        for (Compressed next = waiting.remove(written); next != null; next = waiting.remove(written)) {
            if (written == 0) {
                begin();
            }
            next.chunk.writeTo(out);
            written++;
            sum.append(next.strip.sum(), next.strip.length());
        }
    }

    private void begin() throws IOException {
        out.write(PngChunks.signature());
        byte[] format = format(picture.channels());
        PngChunk header = new PngChunk("IHDR", 2 * Integer.BYTES + format.length);
        header.putInt(picture.width());
        header.putInt(picture.height());
        header.put(format);
        header.finished().writeTo(out);
        for (PictureText text : picture.texts()) {
            PngChunk.of(text).writeTo(out);
        }
    }

    /**
     * Writes the end of the file and flushes the stream; to be called after all rows were added.
     *
     * @throws IOException if it cannot be written
     * @throws IllegalStateException if a row is missing
     */
    public synchronized void end() throws IOException {
        if (written * stripRows < picture.height()) {
            throw new IllegalStateException("rows of the picture are missing from row " + written * stripRows + " on");
        }
        PngChunk last = new PngChunk("IDAT", LAST_BLOCK.length + Integer.BYTES);
        last.put(LAST_BLOCK);
        last.putInt(sum.value());
        last.finished().writeTo(out);
        if (seal != null) {
            PngChunk.of(seal.text()).writeTo(out);
        }
        PngChunk.end().writeTo(out);
        out.flush();
    }
}
