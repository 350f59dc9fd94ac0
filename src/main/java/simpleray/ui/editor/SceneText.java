package simpleray.ui.editor;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * A scene file's text as an editor has it, its lines separated by LF, with the encoding, the byte order mark and the line ends
 * to write it as it was. <em>Constant.</em>
 *
 * @param text the text
 * @param charset UTF-8, or ISO 8859-1 if the file is no UTF-8: that keeps any bytes as they are
 * @param marked whether a byte order mark comes first
 * @param ends the end of each line, LF, CR LF or CR, but for the last line
 */
record SceneText(String text, Charset charset, boolean marked, List<String> ends) {
    private static final char MARK = '\uFEFF';
    private static final String LF = "\n";

    /** {@return the text of a file} */
    static SceneText of(byte[] bytes) {
        String all;
        Charset charset = StandardCharsets.UTF_8;
        try {
            all = charset.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
        } catch (CharacterCodingException e) {
            charset = StandardCharsets.ISO_8859_1;
            all = new String(bytes, charset);
        }
        boolean marked = !all.isEmpty() && all.charAt(0) == MARK;
        List<String> ends = new ArrayList<>();
        StringBuilder text = new StringBuilder(all.length());
        for (int i = marked ? 1 : 0; i < all.length(); i++) {
            char c = all.charAt(i);
            if (c == '\r' && i + 1 < all.length() && all.charAt(i + 1) == '\n') {
                ends.add("\r\n");
                i++;
            } else if (c == '\r' || c == '\n') {
                ends.add(c == '\r' ? "\r" : LF);
            } else {
                text.append(c);
                continue;
            }
            text.append('\n');
        }
        return new SceneText(text.toString(), charset, marked, List.copyOf(ends));
    }

    /**
     * Makes a file of an edited text. Lines above and below the changes keep their ends; new ones get that of the first line.
     *
     * @param edited the text
     * @return the file's bytes
     * @throws CharacterCodingException if the encoding has no such characters
     */
    byte[] bytes(String edited) throws CharacterCodingException {
        String[] before = text.split(LF, -1);
        String[] after = edited.replace("\r\n", LF).replace('\r', '\n').split(LF, -1);
        int same = 0;
        int least = Math.min(before.length, after.length);
        while (same < least && before[same].equals(after[same])) {
            same++;
        }
        int below = 0;
        while (below < least - same && before[before.length - 1 - below].equals(after[after.length - 1 - below])) {
            below++;
        }
        StringBuilder file = new StringBuilder(edited.length() + 1);
        if (marked) {
            file.append(MARK);
        }
        for (int i = 0; i < after.length; i++) {
            file.append(after[i]);
            if (i < after.length - 1) {
                int known = i < same ? i : i >= after.length - below ? i - after.length + before.length : -1;
                file.append(known >= 0 && known < ends.size() ? ends.get(known) : ends.isEmpty() ? LF : ends.get(0));
            }
        }
        ByteBuffer encoded = charset.newEncoder().encode(CharBuffer.wrap(file));
        byte[] bytes = new byte[encoded.remaining()];
        encoded.get(bytes);
        return bytes;
    }
}
