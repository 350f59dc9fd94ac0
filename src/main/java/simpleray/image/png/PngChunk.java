package simpleray.image.png;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import simpleray.image.PictureText;

/** A chunk of a PNG file to be written: the length of its data, its name, its data and a checksum. <em>Mutable.</em> */
final class PngChunk {
    private static final int HEAD = 8;                        // length and name
    private static final int SUM = 4;
    private static final int NO_LANGUAGE = 5;                 // the bytes between keyword and text

    private byte[] bytes;
    private int end = HEAD;

    /**
     * Begins a chunk.
     *
     * @param name its four letters
     * @param room the number of bytes of data to make room for, 1 or more; it grows
     */
    PngChunk(String name, int room) {
        bytes = Arrays.copyOf(ByteBuffer.allocate(HEAD).putInt(0).put(name.getBytes(StandardCharsets.US_ASCII)).array(), HEAD + room + SUM);
    }

    void put(int... data) {
        for (int b : data) {
            makeRoom();
            bytes[end++] = (byte) b;
        }
    }

    void put(byte[] data) {
        if (bytes.length - SUM - end < data.length) {
            bytes = Arrays.copyOf(bytes, Math.addExact(end + SUM, data.length));
        }
        System.arraycopy(data, 0, bytes, end, data.length);
        end += data.length;
    }

    /** {@return the chunk of a text} */
    static PngChunk of(PictureText text) {
        byte[] keyword = text.keyword().getBytes(StandardCharsets.US_ASCII);
        PngChunk chunk = new PngChunk(PngChunks.TEXT, keyword.length + NO_LANGUAGE + text.text().length);
        chunk.put(keyword);
        chunk.put(0, 0, 0, 0, 0);                             // uncompressed, without language and translated keyword
        chunk.put(text.text());
        return chunk.finished();
    }

    /** {@return the last chunk of each file} */
    static PngChunk end() {
        return new PngChunk(PngChunks.LAST, 1).finished();
    }

    void putInt(int data) {
        put(data >>> 24, data >>> 16, data >>> 8, data);
    }

    /** Appends all output of a compressor. */
    void putAll(Deflater deflater, int flush) {
        int room;
        int some;
        do {
            makeRoom();
            room = bytes.length - SUM - end;
            some = deflater.deflate(bytes, end, room, flush);
            end += some;
        } while (some == room);                               // there may be more
    }

    private void makeRoom() {
        if (end + SUM >= bytes.length) {
            bytes = Arrays.copyOf(bytes, 2 * bytes.length);
        }
    }

    /** Sets length and checksum; nothing may be appended afterwards. */
    PngChunk finished() {
        CRC32 crc = new CRC32();
        ByteBuffer.wrap(bytes).putInt(end - HEAD);
        crc.update(bytes, HEAD - SUM, end - (HEAD - SUM));    // of name and data
        bytes = Arrays.copyOf(bytes, end + SUM);
        ByteBuffer.wrap(bytes, end, SUM).putInt((int) crc.getValue());
        return this;
    }

    /** {@return a copy of the data} */
    byte[] data() {
        return Arrays.copyOfRange(bytes, HEAD, end);
    }

    void writeTo(OutputStream out) throws IOException {
        out.write(bytes);
    }
}
