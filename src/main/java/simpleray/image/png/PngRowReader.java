package simpleray.image.png;

import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;
import java.util.zip.ZipException;
import simpleray.image.Picture;

/**
 * Reads the rows of a file that a {@link PngWriter} has written, from the top. Two rows are in memory, however large the picture is;
 * a {@link PngReader}, which reads the files of other programs too, holds many, or decodes the file more than once. <em>Mutable,</em> for one
 * thread.
 */
public final class PngRowReader implements Closeable {
    private static final String HEADER = "IHDR";
    private static final String DATA = "IDAT";
    private static final int SIDES = 2 * Integer.BYTES;
    private static final int LENGTH = SIDES + PngWriter.format(Picture.RGB).length;
    private static final int BUFFER = 1 << 16;

    private final InputStream file;
    private final PngChunks chunks;
    private final Inflater inflater = new Inflater();
    private final InputStream data;
    private final int width;
    private final int height;
    private final int channels;
    private byte[] above;                                     // null in the first row
    private int next;

    /**
     * Opens a file.
     *
     * @param path the file
     * @throws PictureFormatException if it is no PNG, a damaged one, or written by another program
     * @throws IOException if it cannot be read
     */
    public PngRowReader(Path path) throws IOException {
        file = new BufferedInputStream(Files.newInputStream(path));
        try {
            chunks = new PngChunks(file, path.toString()).begin();
            byte[] header = HEADER.equals(chunks.next()) ? chunks.rest(LENGTH) : new byte[0];
            ByteBuffer sides = ByteBuffer.wrap(Arrays.copyOf(header, SIDES));
            width = sides.getInt();
            height = sides.getInt();
            byte[] format = Arrays.copyOfRange(header, Math.min(SIDES, header.length), header.length);
            channels = Arrays.equals(format, PngWriter.format(Picture.RGBA)) ? Picture.RGBA : Picture.RGB;
            if (!Arrays.equals(format, PngWriter.format(channels))
                || Math.min(width, height) < 1 || Math.max(width, height) > Picture.LONGEST_SIDE) {
                throw foreign();
            }
            String name = chunks.next();
            while (name != null && !name.equals(DATA)) {
                name = chunks.next();
            }
        } catch (IOException e) {
            close();
            throw e;
        }
        data = new InflaterInputStream(new ImageData(), inflater, BUFFER);
    }

    /** The data of the chunks of one name that follow one another. */
    private final class ImageData extends InputStream {
        private boolean ended;

        @Override
        public int read() {
            throw new UnsupportedOperationException("an inflater reads many bytes at a time");
        }

        @Override
        public int read(byte[] bytes, int from, int most) throws IOException {
            int some = -1;
            while (!ended && some < 0) {
                some = chunks.read(bytes, from, most);
                ended = some < 0 && !DATA.equals(chunks.next());
            }
            return some;
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

    /** {@return the numbers of a pixel: {@link Picture#RGB} or {@link Picture#RGBA}} */
    public int channels() {
        return channels;
    }

    /**
     * Reads the next row.
     *
     * @return red, green and blue of each pixel from the left, and its alpha if there is any, 0 to 255 each; not to be changed
     * @throws PictureFormatException if the file is damaged, or written by another program
     * @throws IOException if it cannot be read
     */
    public byte[] next() throws IOException {
        byte[] row = new byte[channels * width];
        int filter = read();
        try {
            if (data.readNBytes(row, 0, row.length) < row.length) {
                throw damaged(null);
            }
        } catch (EOFException | ZipException e) {
            throw damaged(e);
        }
        if (filter == PngStrip.SUB) {
            for (int i = channels; i < row.length; i++) {
                row[i] += row[i - channels];
            }
        } else if (filter == PngStrip.UP && above != null) {
            for (int i = 0; i < row.length; i++) {
                row[i] += above[i];
            }
        } else {
            throw foreign();
        }
        next++;
        above = row;
        return row;
    }

    /**
     * Reads the rest of the file, once all rows were read.
     *
     * @throws PictureFormatException if the file is damaged, or has more rows
     * @throws IOException if it cannot be read
     */
    public void end() throws IOException {
        if (read() >= 0) {
            throw damaged(null);
        }
        while (chunks.next() != null) {
            continue;                                         // checks their checksums
        }
    }

    private int read() throws IOException {
        try {
            return data.read();
        } catch (EOFException | ZipException e) {
            throw damaged(e);
        }
    }

    private PictureFormatException damaged(IOException cause) {
        PictureFormatException fault = chunks.fault("is damaged: its pixels cannot be read from row " + next + " on");
        fault.initCause(cause);
        return fault;
    }

    private PictureFormatException foreign() {
        return chunks.fault("is not as SimpleRay writes pictures: another program has written it anew");
    }

    @Override
    public void close() throws IOException {
        inflater.end();
        file.close();
    }
}
