package simpleray.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * A file that is read once, and leaves its SHA-256 and, if it is not long, its bytes. <em>Mutable,</em> for one thread.
 *
 * <p>What is longer than 64 KiB is digested by another thread meanwhile, so that a long file is read as fast as ever. That thread takes the
 * JDK's digest: it needs 40 ms to load, but a third of the time for 39 MB, as processors have instructions for it.
 */
public class SceneBytes extends InputStream {
    private static final byte[] SIGNATURE = PngChunks.signature();
    private static final Piece END = new Piece(new byte[0], 0, true);
    private static final int AHEAD = 16;                      // pieces
    private static final int PIECE = 1 << 13;
    private static final int SHORT = 1 << 16;                 // a file that is not longer is digested by the thread that asks

    /** Bytes that were read, from 0 to the length, and whether they are kept. */
    private record Piece(byte[] bytes, int length, boolean kept) {
    }

    private final InputStream in;
    private final int longest;
    private final byte[] head = new byte[SIGNATURE.length];   // what was looked at to see what it is
    private int headEnd;
    private int headAt;
    private List<byte[]> pieces = new ArrayList<>();          // null if they are too long
    private long length;
    private final Sha256 sum = new Sha256();                  // of a short file
    private MessageDigest fastSum;                            // of a long one; the digester's
    private final BlockingQueue<Piece> undigested = new ArrayBlockingQueue<>(AHEAD);
    private final BlockingQueue<byte[]> used = new ArrayBlockingQueue<>(AHEAD);   // to be used again, or a gigabyte would be allocated
    private Thread digester;                                  // null as long as the file is short
    private Throwable fault;                                  // what ended it; to be looked at once it has ended
    private List<Piece> first = new ArrayList<>();           // what was read until then
    private String hex;

    /**
     * Begins to read.
     *
     * @param in the file
     * @param longest so many bytes are kept at most, and none of a longer file
     */
    public SceneBytes(InputStream in, int longest) {
        this.in = in;
        this.longest = longest;
    }

    /**
     * Looks at the first bytes, before any is read. No more are waited for than are needed.
     *
     * @return whether it is a PNG file
     * @throws IOException if it cannot be read
     */
    public boolean isPng() throws IOException {
        while (headEnd < head.length && (headEnd == 0 || head[headEnd - 1] == SIGNATURE[headEnd - 1])) {
            if (in.read(head, headEnd, 1) <= 0) {
                return false;
            }
            headEnd++;
        }
        return Arrays.equals(head, SIGNATURE);
    }

    /** {@return the file behind the bytes that were looked at, which is neither kept nor digested} */
    public InputStream behindHead() {
        return in;
    }

    @Override
    public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
    }

    @Override
    public int read(byte[] bytes, int from, int most) throws IOException {
        int some = Math.min(most, headEnd - headAt);
        if (some > 0) {
            System.arraycopy(head, headAt, bytes, from, some);
            headAt += some;
            some += Math.max(0, in.read(bytes, from + some, most - some));
        } else {
            some = in.read(bytes, from, most);
        }
        if (some > 0) {
            take(bytes, from, some);
        }
        return some;
    }

    private void take(byte[] bytes, int from, int some) throws IOException {
        length += some;
        if (length > longest) {
            pieces = null;
        }
        byte[] free = pieces == null ? used.poll() : null;
        byte[] copy = free != null && free.length >= some ? free : new byte[some];
        System.arraycopy(bytes, from, copy, 0, some);
        if (pieces != null) {
            pieces.add(copy);
        }
        Piece piece = new Piece(copy, some, pieces != null);
        if (length <= SHORT) {
            first.add(piece);
            return;
        }
        if (digester == null) {
            digester = new Thread("simpleray-digest") {
                @Override
                public void run() {
                    digest();
                }
            };
            digester.setDaemon(true);
            digester.start();
            for (Piece before : first) {
                hand(before);
            }
            first = List.of();
        }
        hand(piece);
    }

    private void hand(Piece piece) throws IOException {
        try {
            while (!undigested.offer(piece, 1, TimeUnit.SECONDS)) {
                if (!digester.isAlive()) {
                    throw digestFault();
                }
            }
        } catch (InterruptedException e) {
            throw interrupted();
        }
    }

    @SuppressWarnings("ReferenceEquality")                     // the end is that very piece
    private void digest() {
        try {
            fastSum = MessageDigest.getInstance("SHA-256");
            for (Piece piece = undigested.take(); piece != END; piece = undigested.take()) {
                digest(piece.bytes, piece.length);
                if (!piece.kept) {
                    used.offer(piece.bytes);
                }
            }
        } catch (InterruptedException e) {
            return;                                           // nobody does
        } catch (NoSuchAlgorithmException | RuntimeException | Error e) {   // of want of memory, above all
            fault = e;
        }
    }

    /** Takes some bytes into the digest. */
    void digest(byte[] bytes, int count) {
        if (fastSum == null) {
            sum.update(bytes, 0, count);
        } else {
            fastSum.update(bytes, 0, count);
        }
    }

    /** {@return what is to be thrown for a digest that ended} An error is thrown at once. */
    private IOException digestFault() {
        if (fault instanceof Error error) {
            throw error;
        }
        return new IOException("the digest cannot be computed", fault);
    }

    /**
     * Finds the digest of what was read; nothing more may be read then.
     *
     * @return its SHA-256, 64 hexadecimal digits in lower case
     * @throws InterruptedIOException if this thread is interrupted while it waits
     */
    public String sha256() throws IOException {
        if (hex == null) {
            if (digester != null) {
                hand(END);
                try {
                    digester.join();
                } catch (InterruptedException e) {
                    throw interrupted();
                }
                if (fault != null) {
                    throw digestFault();
                }
                hex = HexFormat.of().formatHex(fastSum.digest());
            } else {
                for (Piece piece : first) {
                    digest(piece.bytes, piece.length);
                }
                hex = sum.hex();
            }
        }
        return hex;
    }

    private static IOException interrupted() {
        Thread.currentThread().interrupt();
        return new InterruptedIOException("the reading was interrupted");
    }

    /** {@return how many bytes were read} */
    public long length() {
        return length;
    }

    /** {@return the bytes that were read; null if they were too many} */
    public byte[] kept() {
        if (pieces == null) {
            return null;
        }
        byte[] all = new byte[(int) length];
        int at = 0;
        for (byte[] piece : pieces) {
            System.arraycopy(piece, 0, all, at, piece.length);
            at += piece.length;
        }
        return all;
    }

    /**
     * Reads on to the end of the file, or until it is too long. What was read before is part of it.
     *
     * @param most the most bytes, fewer than are kept
     * @return all bytes of the file; null if they are more
     * @throws IOException if it cannot be read
     */
    public byte[] rest(int most) throws IOException {
        byte[] some = new byte[PIECE];
        int read = 0;
        while (read >= 0 && length <= most) {                 // an endless stream is not read to its end
            read = read(some, 0, some.length);
        }
        return length <= most ? kept() : null;
    }

    /** Lets the thread that digests go, and leaves the file open. */
    public void release() {
        if (digester != null && hex == null) {
            digester.interrupt();
        }
    }

    @Override
    public void close() throws IOException {
        release();
        in.close();
    }
}
