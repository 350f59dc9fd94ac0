package simpleray.image.png;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.Arrays;
import simpleray.image.PictureText;
import simpleray.io.Sha256;

/**
 * The last text of a file that is a part of a picture: a line that names its rows, and a line with the SHA-256 of that line and of all bytes
 * before the text's chunk. <em>Mutable,</em> for one thread.
 */
public final class PngSeal {
    /** The text's keyword. */
    public static final String KEYWORD = "simpleray.part";
    private static final String SUM = "sha256 ";
    private static final int BUFFER = 1 << 16;

    private final MessageDigest digest = Sha256.begin();
    private final OutputStream out;
    private final String rows;

    /**
     * Begins a file.
     *
     * @param out where to; it stays open
     * @param rows the line that names the rows
     */
    PngSeal(OutputStream out, String rows) {
        this.out = new DigestOutputStream(out, digest);
        this.rows = rows + '\n';
    }

    /** {@return where the file is to be written} */
    OutputStream out() {
        return out;
    }

    /** {@return the seal of what was written; to be asked for once} */
    PictureText text() {
        return text(rows, digest);
    }

    private static PictureText text(String rows, MessageDigest before) {
        before.update(rows.getBytes(StandardCharsets.UTF_8));
        return new PictureText(KEYWORD, rows + SUM + Sha256.hex(before.digest()) + '\n');
    }

    /**
     * Tells whether a file is as it was written.
     *
     * @param in the file, from its first byte; read to its end
     * @param size its number of bytes
     * @param rows the line that it ought to name its rows by
     * @return whether it ends with its seal
     * @throws IOException if it cannot be read
     */
    public static boolean holds(InputStream in, long size, String rows) throws IOException {
        MessageDigest digest = Sha256.begin();
        byte[] end = end(new PictureText(KEYWORD, rows + '\n' + SUM + Sha256.hex(new byte[digest.getDigestLength()]) + '\n'));
        byte[] buffer = new byte[BUFFER];
        long left = size - end.length;
        while (left > 0) {
            int some = in.read(buffer, 0, (int) Math.min(buffer.length, left));
            if (some < 0) {
                return false;
            }
            digest.update(buffer, 0, some);
            left -= some;
        }
        return Arrays.equals(in.readNBytes(end.length + 1), end(text(rows + '\n', digest)));
    }

    private static byte[] end(PictureText seal) throws IOException {
        ByteArrayOutputStream end = new ByteArrayOutputStream();
        PngChunk.of(seal).writeTo(end);
        PngChunk.end().writeTo(end);
        return end.toByteArray();
    }
}
