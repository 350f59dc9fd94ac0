package simpleray.text;

import java.nio.charset.StandardCharsets;

/**
 * A location in a scene file, with as much of its line as messages show. <em>Constant.</em>
 *
 * @param line the line, from 1
 * @param column the column, from 1; a character is one column
 * @param begins the column at which the text begins: 1 unless the line is long
 * @param text the UTF-8 of the line, or of a long line {@link InputBuffer#CONTEXT} bytes on both sides
 * @param at the index of the location in the text
 */
public record SourceLocation(int line, int column, int begins, byte[] text, int at) {
    /** {@return the line, or the known part of it} */
    String source() {
        return new String(text, StandardCharsets.UTF_8);
    }

    /** {@return the text that begins here, this many bytes of it or as many as are known} */
    String text(long length) {
        return new String(text, at, (int) Math.min(length, text.length - at), StandardCharsets.UTF_8);
    }
}
