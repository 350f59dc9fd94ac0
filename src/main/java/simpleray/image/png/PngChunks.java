package simpleray.image.png;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.CRC32;

/**
 * Reads the chunks of a PNG file in turn, and checks their sums (W3C, "Portable Network Graphics Specification", second edition, 2003).
 * <em>Mutable,</em> for one thread.
 */
public final class PngChunks {
    /** The first bytes of each file; no text in UTF-8 begins with them. */
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    /** The bytes of a chunk's length and type, and of its checksum. */
    private static final int HEAD = 8;
    private static final int SUM = 4;
    /** The chunk of a text. */
    static final String TEXT = "iTXt";
    /** The last chunk. */
    static final String LAST = "IEND";
    private static final int NAME = 4;
    private static final int BUFFER = 1 << 16;

    private final InputStream in;
    private final String file;
    private final CRC32 sum = new CRC32();
    private byte[] passed;                                    // for bytes that are skipped
    private String name = "";
    private boolean ended;
    private long left = -1;                                   // bytes of the chunk's data; -1: there is no chunk

    /**
     * Begins after the signature of a file.
     *
     * @param in the file
     * @param file its name in messages
     */
    public PngChunks(InputStream in, String file) {
        this.in = in;
        this.file = file;
    }

    /** {@return the first bytes of a PNG file} */
    public static byte[] signature() {
        return SIGNATURE.clone();
    }

    /**
     * Reads the signature, if the file is a PNG; else reads nothing. It waits for no more bytes than it needs.
     *
     * @param in the file, which can take back 8 bytes; behind the signature then, or at its beginning again if it is none
     * @return whether it has the signature
     * @throws IOException if it cannot be read
     */
    public static boolean begin(PushbackInputStream in) throws IOException {
        byte[] head = new byte[SIGNATURE.length];
        int end = 0;
        while (end < head.length && in.read(head, end, 1) > 0) {
            end++;
            if (head[end - 1] != SIGNATURE[end - 1]) {
                break;
            }
        }
        if (Arrays.equals(head, SIGNATURE)) {
            return true;
        }
        in.unread(head, 0, end);
        return false;
    }

    /**
     * Reads a PNG file up to the end of its last chunk; of any other file the first bytes only. Does not check the chunks.
     *
     * @param in the file
     * @return its bytes, fewer if it breaks off
     * @throws IOException if it cannot be read
     */
    public static byte[] readFile(InputStream in) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.write(in.readNBytes(SIGNATURE.length));
        boolean more = Arrays.equals(file.toByteArray(), SIGNATURE);
        while (more) {
            byte[] head = in.readNBytes(HEAD);
            long length = head.length < HEAD ? 0 : Integer.toUnsignedLong(ByteBuffer.wrap(head).getInt()) + SUM;
            byte[] rest = in.readNBytes((int) Math.min(length, Integer.MAX_VALUE));
            file.write(head);
            file.write(rest);
            more = length > 0 && rest.length == length && !new String(head, StandardCharsets.US_ASCII).endsWith(LAST);
        }
        return file.toByteArray();
    }

    /**
     * Reads the signature.
     *
     * @return these chunks
     * @throws PictureFormatException if it is none
     */
    public PngChunks begin() throws IOException {
        if (!Arrays.equals(in.readNBytes(SIGNATURE.length), SIGNATURE)) {
            throw fault("is no PNG");
        }
        return this;
    }

    /**
     * Moves to the next chunk. The rest of the current one is skipped; its checksum is checked.
     *
     * @return its name; null after the last one
     * @throws PictureFormatException if the file is damaged
     */
    String next() throws IOException {
        if (ended) {
            return null;
        }
        if (left >= 0) {
            passOver();
            ended = name.equals(LAST);
            if (ended) {
                return null;
            }
        }
        String before = name.isEmpty() ? "behind its signature" : "behind the chunk " + name;
        byte[] head = in.readNBytes(2 * NAME);
        if (head.length < 2 * NAME) {
            throw fault("is cut off " + before);
        }
        left = word(head);
        for (int i = NAME; i < head.length; i++) {
            if (!Character.isLetter(head[i])) {
                throw fault("is damaged " + before);
            }
        }
        if (left < 0) {
            throw fault("is damaged " + before);
        }
        name = new String(head, NAME, NAME, StandardCharsets.US_ASCII);
        sum.reset();
        sum.update(head, NAME, NAME);
        return name;
    }

    /**
     * Reads some of the chunk's data.
     *
     * @param bytes gets the data
     * @param from the index of the first byte
     * @param most the largest number of bytes to read
     * @return the number of bytes read; -1 at the chunk's end
     * @throws PictureFormatException if the file ends
     */
    int read(byte[] bytes, int from, int most) throws IOException {
        if (left <= 0) {
            return -1;
        }
        int some = in.read(bytes, from, (int) Math.min(most, left));
        if (some < 0) {
            throw fault("is cut off in the chunk " + name);
        }
        sum.update(bytes, from, some);
        left -= some;
        return some;
    }

    /**
     * Reads the rest of the chunk.
     *
     * @param most the largest number of bytes allowed
     * @return its data
     * @throws PictureFormatException if it is more
     */
    byte[] rest(int most) throws IOException {
        if (left > most) {
            throw fault("has a chunk " + name + " that is too long: " + left + " bytes of at most " + most);
        }
        byte[] data = new byte[(int) left];
        int at = 0;
        while (left > 0) {
            at += read(data, at, (int) left);
        }
        return data;
    }

    /**
     * Creates an exception about the file.
     *
     * @param fault what is wrong with it
     * @return the exception
     */
    PictureFormatException fault(String fault) {
        return new PictureFormatException(file, fault);
    }

    private void passOver() throws IOException {
        if (passed == null) {
            passed = new byte[BUFFER];
        }
        while (read(passed, 0, passed.length) >= 0) {
            continue;
        }
        byte[] told = in.readNBytes(NAME);
        if (told.length < NAME) {
            throw fault("is cut off in the chunk " + name);
        }
        if (word(told) != (int) sum.getValue()) {
            throw fault("is damaged in the chunk " + name + ": its checksum is wrong");
        }
    }

    private static int word(byte[] bytes) {
        return bytes[0] << 24 | (bytes[1] & 0xFF) << 16 | (bytes[2] & 0xFF) << 8 | bytes[3] & 0xFF;
    }
}
