package simpleray.text;

/**
 * One error or warning at a place of a scene file. <em>Constant.</em>
 *
 * @param file the file as the user named it, {@code <stdin>} for standard input
 * @param line the line, counted from 1
 * @param column the character in the line at which the word begins, counted from 1 (a tab is one character)
 * @param error true for an error, false for a warning
 * @param message what was expected and what was found
 * @param source the line's text, without its line break; of a long line a piece about the column; null if it is not known
 * @param begins the column at which the source begins: 1 unless the line is long
 */
public record Diagnostic(String file, int line, int column, boolean error, String message, String source, int begins) {
    /** The longest piece of a source line that is shown. */
    private static final int SHOWN = 160;
    private static final int LONGEST_WORD = 60;
    private static final String CUT = "...";
    /** A row of replacement characters that is not worth showing. */
    private static final String BINARY = "\uFFFD".repeat(8);

    /**
     * Creates an error or warning with its whole line.
     *
     * @param file the file as the user named it
     * @param line the line, counted from 1
     * @param column the character in the line, counted from 1
     * @param error true for an error, false for a warning
     * @param message what was expected and what was found
     * @param source the line's text, without its line break; null if it is not known
     */
    public Diagnostic(String file, int line, int column, boolean error, String message, String source) {
        this(file, line, column, error, message, source, 1);
    }

    /** {@return the first line of the report: {@code FILE:LINE:COLUMN: error: expected WHAT, found WHAT}} */
    public String headline() {
        return printable(file) + ':' + line + ':' + column + (error ? ": error: " : ": warning: ") + message;
    }

    /** {@return the headline, under it the source line if it is known and a text, under that a caret at the column; no line break at the end} */
    @Override
    public String toString() {
        int at = source == null ? 0 : source.offsetByCodePoints(0, Math.min(column - begins, source.codePointCount(0, source.length())));
        if (source == null || isBinary(source.substring(at))) {
            return headline();
        }
        int from = source.length() <= SHOWN ? 0 : Math.max(0, at - SHOWN / 2);
        int to = Math.min(source.length(), from + SHOWN);
        if (from > 0 && Character.isLowSurrogate(source.charAt(from))) {
            from--;
        }
        if (to < source.length() && Character.isLowSurrogate(source.charAt(to))) {
            to--;
        }
        String head = from > 0 ? CUT : "";
        String tail = to < source.length() ? CUT : "";
        StringBuilder caret = new StringBuilder(" ".repeat(head.length()));
        // a tab above is a tab below, so that the caret stands under its word however wide tabs are
        source.substring(from, at).codePoints().forEach(c -> caret.append(c == '\t' ? '\t' : ' '));
        String shown = printable(source.substring(from, to));
        int row = shown.indexOf(BINARY, at - from);
        shown = row < 0 ? shown + tail : shown.substring(0, row) + CUT;
        return headline() + '\n' + head + shown + '\n' + caret + '^';
    }

    /**
     * Quotes a word for a message.
     *
     * @param word the word
     * @return the word in quotes, cut when it is long, without control characters
     */
    public static String quoted(String word) {
        int length = word.codePointCount(0, word.length());
        String shown = length <= LONGEST_WORD ? word : word.substring(0, word.offsetByCodePoints(0, LONGEST_WORD)) + CUT;
        return '\'' + printable(shown) + '\'';
    }

    /** {@return whether a text begins with a row of characters that cannot be shown} */
    static boolean isBinary(String text) {
        return text.length() >= BINARY.length() && printable(text.substring(0, BINARY.length())).equals(BINARY);
    }

    /** {@return whether a character is invisible and changes how others are shown} */
    static boolean isHidden(int c) {
        int type = Character.getType(c);
        return type == Character.FORMAT || type == Character.LINE_SEPARATOR || type == Character.PARAGRAPH_SEPARATOR;
    }

    /**
     * Makes a text safe for a terminal.
     *
     * @param text the text
     * @return the text with every control character but the tab, and every invisible one, replaced
     */
    public static String printable(String text) {
        StringBuilder shown = new StringBuilder(text.length());
        for (int i = 0; i < text.length(); i = text.offsetByCodePoints(i, 1)) {
            int c = text.codePointAt(i);
            shown.appendCodePoint(c != '\t' && (Character.isISOControl(c) || isHidden(c)) ? '\uFFFD' : c);
        }
        return shown.toString();
    }
}
