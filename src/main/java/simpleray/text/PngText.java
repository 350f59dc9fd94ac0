package simpleray.text;

import java.nio.charset.StandardCharsets;

/**
 * A text that a PNG file carries in a chunk iTXt. <em>Constant.</em>
 *
 * @param keyword what it is: 1 to 79 printable ASCII characters
 * @param text the text, UTF-8; referenced, and not to be changed
 */
public record PngText(String keyword, byte[] text) {
    /** The name of the chunk. */
    public static final String CHUNK = "iTXt";
    /** The longest text that is read or written: libpng refuses chunks of 8 MB, and others texts that unpack to more than one. */
    public static final int LONGEST = 4 << 20;

    /**
     * Creates a text of characters.
     *
     * @param keyword what it is
     * @param text the text
     */
    public PngText(String keyword, String text) {
        this(keyword, text.getBytes(StandardCharsets.UTF_8));
    }

    /** {@return the text's characters} */
    public String string() {
        return new String(text, StandardCharsets.UTF_8);
    }
}
