package simpleray;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Random;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * Compresses bytes that are always the same, as pictures are compressed, to see whether two Javas have the same zlib. Run as a program
 * of its own, too.
 */
public final class DeflateProbe {
    private static final int LENGTH = 1 << 16;

    private DeflateProbe() {
    }

    /**
     * Writes the compressed bytes to standard output.
     *
     * @param args none
     * @throws IOException if they cannot be written
     */
    public static void main(String[] args) throws IOException {
        System.out.write(compressed());
        System.out.flush();
    }

    /** {@return the compressed bytes: small numbers, as filtered rows of a picture are} */
    static byte[] compressed() throws IOException {
        Random random = new Random(1);
        byte[] bytes = new byte[LENGTH];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) random.nextInt(1 + (i >> 12));
        }
        ByteArrayOutputStream compressed = new ByteArrayOutputStream();
        Deflater fast = new Deflater(Deflater.BEST_SPEED, true);
        try (DeflaterOutputStream deflater = new DeflaterOutputStream(compressed, fast, LENGTH, true)) {
            deflater.write(bytes);
            deflater.flush();
        } finally {
            fast.end();
        }
        return compressed.toByteArray();
    }
}
