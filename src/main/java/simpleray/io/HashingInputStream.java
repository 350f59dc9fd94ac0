package simpleray.io;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.security.MessageDigest;

/** A stream that leaves the SHA-256 of what was read and, if that is not long, the bytes. <em>Mutable,</em> for one thread. */
public final class HashingInputStream extends InputStream {
    private static final int BLOCK = 1 << 13;

    private final InputStream in;
    private final int longest;
    private ByteArrayOutputStream kept = new ByteArrayOutputStream();   // null if it would be too long
    private MessageDigest digest;                             // of what is not kept

    /**
     * Begins to read.
     *
     * @param in the stream
     * @param longest so many bytes are kept at most, and none of a longer stream
     */
    public HashingInputStream(InputStream in, int longest) {
        this.in = in;
        this.longest = longest;
    }

    @Override
    public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
    }

    @Override
    public int read(byte[] bytes, int from, int most) throws IOException {
        int some = in.read(bytes, from, most);
        if (some > 0) {
            take(bytes, from, some);
        }
        return some;
    }

    private void take(byte[] bytes, int from, int count) {
        if (kept != null && count <= longest - kept.size()) {
            kept.write(bytes, from, count);
            return;
        }
        if (kept != null) {
            digest = Sha256.begin();
            digest.update(kept.toByteArray());
            kept = null;
        }
        digest.update(bytes, from, count);
    }

    /** {@return the SHA-256 of what was read, 64 hexadecimal digits in lower case} It is to be asked for once, at the end. */
    public String sha256() {
        return kept == null ? Sha256.hex(digest.digest()) : Sha256.of(kept.toByteArray());
    }

    /** {@return the bytes that were read; null if they were too many} */
    public byte[] kept() {
        return kept == null ? null : kept.toByteArray();
    }

    /**
     * Reads on to the end of the stream, or until it is too long. What was read before is part of it.
     *
     * @param most the most bytes, fewer than are kept
     * @return all bytes of the stream; null if they are more
     * @throws IOException if it cannot be read
     */
    public byte[] rest(int most) throws IOException {
        byte[] some = new byte[BLOCK];
        int read = 0;
        while (read >= 0 && kept != null && kept.size() <= most) {   // an endless stream is not read to its end
            read = read(some, 0, some.length);
        }
        return read < 0 && kept.size() <= most ? kept.toByteArray() : null;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
