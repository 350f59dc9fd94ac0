package simpleray.image.png;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import simpleray.image.PictureText;

/** Reads the texts that a PNG file carries. */
public final class PngTextReader {
    /** The fields before a text in its chunk: a keyword, two numbers, a language and a translation. */
    private static final int HEAD = 1 << 10;

    private PngTextReader() {
    }

    /**
     * Reads a file to its end.
     *
     * @param chunks its chunks, from the first one
     * @return the texts of its chunks iTXt by their keywords, UTF-8; of two with one keyword the first
     * @throws PictureFormatException if the file is damaged, or a text is too long
     * @throws IOException if it cannot be read
     */
    public static Map<String, byte[]> read(PngChunks chunks) throws IOException {
        Map<String, byte[]> texts = new HashMap<>();
        for (String name = chunks.next(); name != null; name = chunks.next()) {
            if (name.equals(PngChunks.TEXT)) {
                read(chunks, chunks.rest(PictureText.LONGEST + HEAD), texts);
            }
        }
        return texts;
    }

    private static void read(PngChunks chunks, byte[] data, Map<String, byte[]> texts) throws IOException {
        int keyword = zero(chunks, data, 0);
        int flags = keyword + 1;
        int language = zero(chunks, data, flags + 2);
        int text = zero(chunks, data, language + 1) + 1;
        boolean packed = data[flags] != 0;
        if (data[flags] > 1 || data[flags] < 0 || packed && data[flags + 1] != 0) {
            throw damaged(chunks);
        }
        byte[] plain = Arrays.copyOfRange(data, text, data.length);
        texts.putIfAbsent(new String(data, 0, keyword, StandardCharsets.ISO_8859_1), packed ? unpacked(chunks, plain) : plain);
    }

    private static int zero(PngChunks chunks, byte[] data, int from) throws IOException {
        for (int i = from; i < data.length; i++) {
            if (data[i] == 0) {
                return i;
            }
        }
        throw damaged(chunks);
    }

    /** A few bytes can become gigabytes: nothing beyond the longest text is unpacked. */
    private static byte[] unpacked(PngChunks chunks, byte[] packed) throws IOException {
        Inflater inflater = new Inflater();
        try {
            inflater.setInput(packed);
            byte[] text = new byte[Math.min(PictureText.LONGEST + 1, 4 * packed.length + HEAD)];
            int at = 0;
            while (!inflater.finished()) {
                int some = inflater.inflate(text, at, text.length - at);
                at += some;
                if (at > PictureText.LONGEST) {
                    throw chunks.fault("carries a text that is too long: more than " + PictureText.LONGEST + " bytes");
                }
                if (at == text.length) {
                    text = Arrays.copyOf(text, Math.min(PictureText.LONGEST + 1, 2 * at));
                } else if (some == 0 && !inflater.finished()) {
                    throw damaged(chunks);
                }
            }
            return Arrays.copyOf(text, at);
        } catch (DataFormatException e) {
            throw (IOException) damaged(chunks).initCause(e);
        } finally {
            inflater.end();
        }
    }

    private static PictureFormatException damaged(PngChunks chunks) {
        return chunks.fault("carries a text that cannot be read");
    }
}
