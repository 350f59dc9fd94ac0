package simpleray.image;

import java.nio.charset.StandardCharsets;

/**
 * A text that a picture's file carries. <em>Constant.</em>
 *
 * @param keyword its name: 1 to 79 printable ASCII characters
 * @param text the text, UTF-8; referenced, and not to be changed
 */
public record PictureText(String keyword, byte[] text) {
    /** The longest text that is read or written: libpng refuses chunks of 8 MB, and other programs texts of more than 1 MB when decompressed. */
    public static final int LONGEST = 4 << 20;

    /**
     * Creates a text of characters.
     *
     * @param keyword its name
     * @param text the text
     */
    public PictureText(String keyword, String text) {
        this(keyword, text.getBytes(StandardCharsets.UTF_8));
    }

    /** {@return the text's characters} */
    public String string() {
        return new String(text, StandardCharsets.UTF_8);
    }
}
