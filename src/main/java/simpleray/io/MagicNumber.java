package simpleray.io;

import java.io.IOException;
import java.io.PushbackInputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/** Tells by its first bytes what a file is that is no text in UTF-8. */
public final class MagicNumber {
    /** The most bytes that it looks at. */
    public static final int LENGTH = 512;

    /** As many as the longest key has. */
    private static final int MIN_LENGTH = 18;
    private static final char ANY = '?';
    private static final Map<String, String> KINDS = new LinkedHashMap<>();   // the first bytes, one char each; the longer ones first
    private static final String UTF_16 = "UTF-16";
    private static final String TAR = "ustar";
    private static final int TAR_AT = 257;
    /** A text has fewer control characters: at most 7, or one in 32. */
    private static final int MIN_CONTROLS = 8;
    private static final int CONTROL_SHARE = 32;

    static {
        KINDS.put("\0\0\0\0", "NUL bytes");
        KINDS.put("\0\0\u00FE\u00FF", "UTF-32");
        KINDS.put("\u00FF\u00FE\0\0", "UTF-32");
        KINDS.put("PK\3\4", "a ZIP file");
        KINDS.put("\u001F\u008B", "a gzip file");
        KINDS.put("BZh", "a bzip2 file");
        KINDS.put("\u00FD7zXZ", "an XZ file");
        KINDS.put("7z\u00BC\u00AF", "a 7z file");
        KINDS.put("(\u00B5/\u00FD", "a Zstandard file");
        KINDS.put("Rar!\u001A\7", "a RAR file");
        KINDS.put("\u0089PNG\r\n\u001A\n", "a PNG image");
        KINDS.put("\u00FF\u00D8\u00FF", "a JPEG image");
        KINDS.put("GIF8", "a GIF image");
        KINDS.put("II*\0", "a TIFF image");
        KINDS.put("MM\0*", "a TIFF image");
        KINDS.put("RIFF????WEBP", "a WebP image");
        KINDS.put("BM????\0\0\0\0", "a BMP image");
        KINDS.put("\0\0\0?ftyp", "an MP4, HEIC or AVIF file");
        KINDS.put("%PDF", "a PDF file");
        KINDS.put("\u00D0\u00CF\u0011\u00E0", "an Office file");
        KINDS.put("glTF?\0\0\0", "a glTF model");
        KINDS.put("Kaydara FBX Binary", "an FBX model");
        KINDS.put("BLENDER-v", "a Blender file");
        KINDS.put("BLENDER_v", "a Blender file");
        KINDS.put("\u00CA\u00FE\u00BA\u00BE", "a Java class file");
        KINDS.put("\u007FELF", "a program");
        KINDS.put("MZ?\0", "a program");
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
        byte[] head = new byte[LENGTH];
        int length = 0;
        int read = 1;
        while (read > 0 && length < MIN_LENGTH) {             // a pipe may have no more for now
            read = in.read(head, length, LENGTH - length);
            length += Math.max(0, read);
        }
        in.unread(head, 0, length);
        String begin = new String(head, 0, length, StandardCharsets.ISO_8859_1);
        for (Map.Entry<String, String> kind : KINDS.entrySet()) {
            if (begins(begin, kind.getKey())) {
                return kind.getValue();
            }
        }
        return begin.startsWith(TAR, TAR_AT) ? "a tar file" : isUtf16(begin) ? UTF_16 : binaryKind(begin);
    }

    private static boolean begins(String file, String key) {
        int i = 0;
        while (i < key.length() && i < file.length() && (key.charAt(i) == file.charAt(i) || key.charAt(i) == ANY)) {
            i++;
        }
        return i == key.length();
    }

    /** {@return whether a file begins like a text in UTF-16: with a byte order mark, or two characters of ASCII} */
    private static boolean isUtf16(String file) {
        if (file.length() < 2) {
            return false;
        }
        boolean high = file.charAt(0) == 0;
        boolean low = file.charAt(1) == 0;
        return file.startsWith("\u00FE\u00FF") || file.startsWith("\u00FF\u00FE")
            || file.length() >= 4 && high != low && high == (file.charAt(2) == 0) && low == (file.charAt(3) == 0);
    }

    /** {@return what a file is that has many control characters; null if it has few} White space, backspace and escape do not count. */
    private static String binaryKind(String file) {
        int controls = 0;
        int[] nuls = new int[2];                              // at even indices, and at odd ones
        for (int i = 0; i < file.length(); i++) {
            char c = file.charAt(i);
            controls += c < '\b' || c > '\r' && c < '\u001B' || c == '\u007F' ? 1 : 0;
            nuls[i % 2] += c == 0 ? 1 : 0;
        }
        if (controls < MIN_CONTROLS || controls < file.length() / CONTROL_SHARE) {
            return null;
        }
        boolean wide = Math.min(nuls[0], nuls[1]) == 0 && 2 * Math.max(nuls[0], nuls[1]) >= controls;
        return wide ? UTF_16 : "binary data";
    }
}
