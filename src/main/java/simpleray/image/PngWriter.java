package simpleray.image;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * Writes a picture as PNG: RGB, 8 bits each, row after row (W3C, "Portable Network Graphics Specification", second edition, 2003).
 * Why it is not left to ImageIO: docs/decisions/0002.
 */
public final class PngWriter {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    private static final int BITS = 8;
    private static final int RGB = 2;
    private static final int PIXEL = 3;
    private static final int CHUNK = 1 << 16;

    private PngWriter() {
    }

    /**
     * Writes a picture. The stream is flushed and stays open.
     *
     * @param picture the picture, all its rows set
     * @param out where to
     * @throws IOException if it cannot be written
     */
    public static void write(Picture picture, OutputStream out) throws IOException {
        out.write(SIGNATURE);
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        DataOutputStream fields = new DataOutputStream(header);
        fields.writeInt(picture.width());
        fields.writeInt(picture.height());
        fields.write(new byte[] {BITS, RGB, 0, 0, 0});        // deflate, the five filters, not interlaced
        chunk(out, "IHDR", header.toByteArray(), header.size());
        Deflater deflater = new Deflater();
        try (OutputStream pixels = new DeflaterOutputStream(new ImageData(out), deflater)) {
            byte[] above = new byte[PIXEL * picture.width()];
            for (int y = 0; y < picture.height(); y++) {
                byte[] row = picture.levels(y);
                pixels.write(PngFilter.best(row, above));
                above = row;
            }
        } finally {
            deflater.end();
        }
        chunk(out, "IEND", new byte[0], 0);
        out.flush();
    }

    private static void chunk(OutputStream out, String type, byte[] data, int length) throws IOException {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 crc = new CRC32();
        crc.update(name);
        crc.update(data, 0, length);
        DataOutputStream fields = new DataOutputStream(out);
        fields.writeInt(length);
        fields.write(name);
        fields.write(data, 0, length);
        fields.writeInt((int) crc.getValue());
    }

    /** Cuts what is written to it into chunks of image data. */
    private static final class ImageData extends OutputStream {
        private final OutputStream out;
        private final byte[] data = new byte[CHUNK];
        private int length;

        ImageData(OutputStream out) {
            this.out = out;
        }

        @Override
        public void write(int b) throws IOException {
            write(new byte[] {(byte) b}, 0, 1);
        }

        @Override
        public void write(byte[] bytes, int from, int count) throws IOException {
            for (int done = 0; done < count;) {
                int some = Math.min(count - done, CHUNK - length);
                System.arraycopy(bytes, from + done, data, length, some);
                length += some;
                done += some;
                if (length == CHUNK) {
                    end();
                }
            }
        }

        @Override
        public void close() throws IOException {
            end();
        }

        private void end() throws IOException {
            if (length > 0) {
                chunk(out, "IDAT", data, length);
                length = 0;
            }
        }
    }
}
