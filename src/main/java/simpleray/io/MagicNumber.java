package simpleray.io;

import java.io.IOException;
import java.io.PushbackInputStream;
import java.util.LinkedHashMap;
import java.util.Map;

/** Tells by its first bytes what a file is that is no text in UTF-8. */
public final class MagicNumber {
    /** The number of bytes that it looks at. */
    public static final int LENGTH = 8;

    private static final Map<String, String> KINDS = new LinkedHashMap<>();   // the first bytes, one char each; the longer ones first

    static {
        KINDS.put("\0\0\0\0", "NUL bytes");
        KINDS.put("\0\0\u00FE\u00FF", "UTF-32");
        KINDS.put("\u00FF\u00FE\0\0", "UTF-32");
        KINDS.put("PK\3\4", "a ZIP file");
        KINDS.put("\u001F\u008B", "a gzip file");
        KINDS.put("BZh", "a bzip2 file");
        KINDS.put("\u00FD7zXZ", "an XZ file");
        KINDS.put("7z\u00BC\u00AF", "a 7z file");
        KINDS.put("\u00FF\u00D8\u00FF", "a JPEG image");
        KINDS.put("GIF8", "a GIF image");
        KINDS.put("II*\0", "a TIFF image");
        KINDS.put("MM\0*", "a TIFF image");
        KINDS.put("%PDF", "a PDF file");
        KINDS.put("\u007FELF", "a program");
    }

    private MagicNumber() {
    }

    /**
     * Finds what a file is.
     *
     * @param in the file, with room to push back {@link #LENGTH} bytes; is left where it is
     * @return words for a message, such as {@code a ZIP file}; null if it may be a text
     * @throws IOException if it cannot be read
     */
    public static String nameOf(PushbackInputStream in) throws IOException {
        byte[] head = in.readNBytes(LENGTH);
        in.unread(head);
        StringBuilder begin = new StringBuilder();
        for (byte b : head) {
            begin.append((char) (b & 0xFF));
        }
        for (Map.Entry<String, String> kind : KINDS.entrySet()) {
            if (begin.indexOf(kind.getKey()) == 0) {
                return kind.getValue();
            }
        }
        return isUtf16(head, 0, head.length) ? "UTF-16" : null;
    }

    /**
     * Tells a text in UTF-16 by its first bytes: a byte order mark, or letters of two bytes.
     *
     * @param bytes the bytes
     * @param from where the text begins
     * @param to where the bytes end that are known
     * @return whether it is one
     */
    public static boolean isUtf16(byte[] bytes, int from, int to) {
        if (to - from < 2) {
            return false;
        }
        int mark = (bytes[from] & 0xFF) << Byte.SIZE | bytes[from + 1] & 0xFF;
        boolean high = bytes[from] == 0;
        boolean low = bytes[from + 1] == 0;
        return mark == 0xFEFF || mark == 0xFFFE
            || to - from >= 4 && high != low && high == (bytes[from + 2] == 0) && low == (bytes[from + 3] == 0);
    }
}
