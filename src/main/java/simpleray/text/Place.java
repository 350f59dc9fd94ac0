package simpleray.text;

import java.nio.charset.StandardCharsets;

/**
 * A place in a scene file, with as much of its line as messages show. <em>Constant.</em>
 *
 * @param line the line, from 1
 * @param column the column, from 1; a character is one column
 * @param begins the column at which the text begins: 1 unless the line is long
 * @param text the line's UTF-8 on both sides of the place: all of it, or where it is cut {@link InputBuffer#CONTEXT} bytes
 * @param at where in the text the place is
 */
record Place(int line, int column, int begins, byte[] text, int at) {
    /** {@return the line, or the piece of it that is known} */
    String source() {
        return new String(text, StandardCharsets.UTF_8);
    }

    /** {@return what stands here, this many bytes of it, or as many as are known} */
    String word(long length) {
        return new String(text, at, (int) Math.min(length, text.length - at), StandardCharsets.UTF_8);
    }
}
