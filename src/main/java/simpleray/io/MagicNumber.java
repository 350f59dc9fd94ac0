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
        KINDS.put("\u00FF\u00FE", "UTF-16");
        KINDS.put("\u00FE\u00FF", "UTF-16");
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
        boolean wide = head.length >= 4 && (head[0] == 0) != (head[1] == 0) && (head[0] == 0) == (head[2] == 0);
        return wide && (head[1] == 0) == (head[3] == 0) ? "UTF-16" : null;
    }
}
