package simpleray.scene;

import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import simpleray.io.MagicNumber;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/**
 * Reads the lines of an OBJ or MTL file, each together with those that continue it after a {@code \} at its end, and without comments.
 * <em>Mutable,</em> for one thread.
 *
 * <p>The file is UTF-8 and is kept as bytes; invalid bytes are shown as U+FFFD in messages. The bytes of the current line stay in the
 * buffer unchanged until the next is read, so that a message can show them. Most lines are parsed in place. A line
 * with a comment, a continuation or characters beyond ASCII is copied, with spaces in place of comments, continuations and
 * Unicode's blanks, so that each byte of the copy has the same offset as in the file.
 */
final class LineReader {
    /** The most characters of a line with its continuations: far more than a polygon needs, far less than fills the memory. */
    private static final int MAX_CHARACTERS = 1 << 20;
    /** A {@code char} takes at most three bytes in UTF-8; so does a continuation: backslash, CR and LF. */
    private static final int MAX_BYTES = 3 * MAX_CHARACTERS;
    /** The number of characters shown of a line that is too long. */
    private static final int SHOWN = 512;
    private static final int BLOCK = 1 << 16;
    private static final byte[] BYTE_ORDER_MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};
    private static final byte COMMENT = '#';
    private static final byte CONTINUED = '\\';
    /** ASCII except line breaks, comments, continuations, and the 0 after the buffer's last byte. */
    private static final boolean[] PLAIN = new boolean[1 << Byte.SIZE];

    static {
        Arrays.fill(PLAIN, 1, 1 << (Byte.SIZE - 1), true);
        for (byte b : new byte[] {'\n', '\r', COMMENT, CONTINUED}) {
            PLAIN[b] = false;
        }
    }

    /** The array that contains the line: the buffer or the copy. */
    byte[] bytes;
    /** The index of the line's first byte. */
    int begin;
    /** The index after the line's last byte that is not blank. */
    int end;

    private final InputStream in;
    private final String file;
    private byte[] buffer = new byte[BLOCK + 1];
    private byte[] copy = new byte[BLOCK];
    private int filled;                                      // the end of the buffer's bytes, which a 0 follows
    private int start;                                       // of the current line in the buffer
    private int next;                                        // the first byte that has not been read
    private int firstNumber;                                 // of the current line, from 1
    private int number;                                      // of its last continuation
    private int characters;                                  // of the current line so far, as UTF-16

    /**
     * Creates a reader of a file's lines.
     *
     * @param in the file, not closed here
     * @param file its name for messages
     * @throws SceneFormatException if the file is no text, by its first bytes
     * @throws IOException if it cannot be read
     */
    LineReader(InputStream in, String file) throws IOException {
        PushbackInputStream begun = new PushbackInputStream(in, MagicNumber.LENGTH);
        String kind = MagicNumber.nameOf(begun);
        if (kind != null) {
            throw new SceneFormatException(List.of(new Diagnostic(file, 1, 1, true, "expected text in UTF-8, found " + kind, null)), false);
        }
        this.in = begun;
        this.file = file;
    }

    /**
     * Reads the next line.
     *
     * @return false at the end of the file
     * @throws SceneFormatException if the line is too long
     */
    boolean read() throws IOException {
        if (number == 0) {
            skipByteOrderMark();
        }
        if (next == filled && !fill()) {
            return false;
        }
        start = next;
        firstNumber = ++number;
        int i = start;
        while (PLAIN[buffer[i] & 0xFF]) {
            i++;
        }
        int lineBreak = buffer[i] == '\n' ? 1 : buffer[i] == '\r' && buffer[i + 1] == '\n' ? 2 : 0;
        if (lineBreak == 0 || i - start > MAX_CHARACTERS) {
            readUnusual();
            return true;
        }
        next = i + lineBreak;
        bytes = buffer;
        begin = start;
        end = trim(buffer, start, i);
        return true;
    }

    /** Reads a line that is not plain, or not completely in the buffer. */
    private void readUnusual() throws IOException {
        next = start;
        characters = 0;
        int from = 0;                                         // relative to start, since fill() moves the line
        boolean plain = findLineBreak();
        while (!plain && copy(from, next - start)) {
            int to = next - start;
            skipLineBreak();
            if (next == filled && !fill()) {
                break;
            }
            from = next - start;
            Arrays.fill(copy, to, from, (byte) ' ');
            number++;
            findLineBreak();
        }
        if (plain) {
            int length = next - start;
            skipLineBreak();
            bytes = buffer;
            begin = start;
            end = trim(buffer, start, start + length);
        } else {
            skipLineBreak();
            bytes = copy;
            begin = 0;
        }
    }

    /** Moves to the next line break or the end of the file. {@return whether all bytes before it are plain} */
    private boolean findLineBreak() throws IOException {
        boolean plain = true;
        while (buffer[next] != '\n' && buffer[next] != '\r') {
            if (next == filled) {
                if (!fill()) {
                    break;
                }
                continue;
            }
            byte b = buffer[next++];
            plain &= PLAIN[b & 0xFF] || b == 0;
            characters += (b & 0xC0) == 0x80 ? 0 : (b & 0xF0) == 0xF0 ? 2 : 1;
            if (characters > MAX_CHARACTERS || next - start > MAX_BYTES) {
                throw tooLong();
            }
        }
        return plain;
    }

    /** Skips a line break if there is one: LF, CR LF or CR. */
    private void skipLineBreak() throws IOException {
        if (next < filled && buffer[next++] == '\r' && (next < filled || fill()) && buffer[next] == '\n') {
            next++;
        }
    }

    private SceneFormatException tooLong() {
        int from = lineStart(next);
        String text = decode(buffer, from, Math.min(next, from + 4 * SHOWN));
        return new SceneFormatException(List.of(new Diagnostic(file, number, 1, true, "expected a line of at most " + MAX_CHARACTERS
            + " characters, found a longer one", text.substring(0, Math.min(text.length(), SHOWN)))), false);
    }

    /**
     * Copies a piece of the line without its comment, and finds the end of the line if this is its last piece.
     *
     * @param from the piece's first byte, relative to the line's start
     * @param to the index after its last byte
     * @return whether the line continues after it; then the backslash becomes a space
     */
    private boolean copy(int from, int to) {
        if (to + 2 >= copy.length) {                          // a line break or a 0 may follow
            copy = Arrays.copyOf(copy, 2 * to + 2);
        }
        System.arraycopy(buffer, start + from, copy, from, to - from);
        int i = from;
        while (i < to && (copy[i] != COMMENT || i > from && copy[i - 1] == '.')) {   // 1.#IND is how some write NaN
            i += copy[i] < 0 ? blank(i, to) : 1;
        }
        Arrays.fill(copy, i, to + 1, (byte) ' ');
        end = trim(copy, from, i);
        if (end == from || copy[end - 1] != CONTINUED) {
            return false;
        }
        copy[end - 1] = ' ';
        return true;
    }

    /** Replaces a blank Unicode character by spaces. {@return the number of bytes handled} No blank has more than three. */
    private int blank(int at, int to) {
        int length = (copy[at] & 0xE0) == 0xC0 ? 2 : 3;
        if (at + length > to) {
            return 1;
        }
        String text = decode(copy, at, at + length);
        if (text.length() != 1 || !Character.isWhitespace(text.charAt(0)) && !Character.isSpaceChar(text.charAt(0))) {
            return 1;
        }
        Arrays.fill(copy, at, at + length, (byte) ' ');
        return length;
    }

    private static int trim(byte[] bytes, int from, int to) {
        int end = to;
        while (end > from && isBlank(bytes[end - 1])) {
            end--;
        }
        return end;
    }

    /** {@return whether a byte of a line is white space} */
    static boolean isBlank(byte b) {
        return b == ' ' || b >= '\t' && b <= '\r' || b >= 0x1C && b <= 0x1F;
    }

    /** Reads more bytes. The current line stays in the buffer, but may be moved. {@return false at the end of the file} */
    private boolean fill() throws IOException {
        if (filled == buffer.length - 1) {
            if (start > buffer.length / 2) {
                System.arraycopy(buffer, start, buffer, 0, filled - start);
                filled -= start;
                next -= start;
                start = 0;
            } else {
                buffer = Arrays.copyOf(buffer, 2 * buffer.length);
            }
        }
        int read = in.read(buffer, filled, buffer.length - 1 - filled);
        filled += Math.max(0, read);
        buffer[filled] = 0;
        return read > 0;
    }

    private void skipByteOrderMark() throws IOException {
        int length = BYTE_ORDER_MARK.length;
        while (filled < length && fill()) {
            continue;
        }
        if (filled >= length && Arrays.equals(buffer, 0, length, BYTE_ORDER_MARK, 0, length)) {
            next = length;
            start = length;
        }
    }

    /** {@return the file's name for messages} */
    String file() {
        return file;
    }

    /** {@return the number of the line in the file, from 1} */
    int number() {
        return firstNumber;
    }

    /** {@return what stands from an index to the end of the line, without continuations: a name, to which blanks and {@code #} may belong} */
    String name(int at) {
        int from = start + at - begin;
        int to = from;
        while (to < next && buffer[to] != '\n' && buffer[to] != '\r') {
            to++;
        }
        String name = decode(buffer, from, to).strip();
        return isContinued() && name.endsWith("\\") ? name.substring(0, name.length() - 1).strip() : name;
    }

    /** {@return what stands from an index to the end of the line with its continuations: names, of which one may go on, too} */
    String names(int at) {
        return isContinued() ? text(at, end).strip() : name(at);
    }

    /** {@return whether the line has continuations} */
    boolean isContinued() {
        return number > firstNumber;
    }

    /** {@return a warning at the first continuation of the line that begins with one of these words; null if none does} */
    Diagnostic warningOfJoined(Set<String> keywords) {
        for (int i = start + 1; i < next; i++) {
            if ((buffer[i - 1] == '\n' || buffer[i - 1] == '\r') && buffer[i] != '\n') {
                int from = i;
                while (buffer[from] == ' ' || buffer[from] == '\t') {
                    from++;
                }
                int to = from;
                while (to < next && !isBlank(buffer[to])) {
                    to++;
                }
                if (keywords.contains(decode(buffer, from, to))) {
                    return problem(i, false, "");
                }
            }
        }
        return null;
    }

    /** {@return the text of some of the line's bytes} */
    String text(int from, int to) {
        return decode(bytes, from, to);
    }

    private static String decode(byte[] bytes, int from, int to) {
        return new String(bytes, from, to - from, StandardCharsets.UTF_8);
    }

    /** {@return the error that something else was expected at an index of the line} */
    SceneFormatException error(int at, String wanted, String found) {
        return error(problem(start + at - begin, true, "expected " + wanted + ", found " + found));
    }

    private static SceneFormatException error(Diagnostic problem) {
        return new SceneFormatException(List.of(problem), false);
    }

    /** {@return the error that something is missing after the last character of the file} */
    SceneFormatException missing(String wanted) {
        int place = next;
        place -= place > start && buffer[place - 1] == '\n' ? 1 : 0;
        place -= place > start && buffer[place - 1] == '\r' ? 1 : 0;
        return error(problem(place, true, "expected " + wanted + ", found the end of the file"));
    }

    /** {@return a warning at the start of the line} */
    Diagnostic warning(String message) {
        return problem(start, false, message);
    }

    /** {@return a problem at an index of the buffer, in the current line} */
    private Diagnostic problem(int place, boolean error, String message) {
        int line = Math.max(1, firstNumber);
        for (int i = start; i < place; i++) {
            line += buffer[i] == '\n' || buffer[i] == '\r' && buffer[i + 1] != '\n' ? 1 : 0;
        }
        int from = lineStart(place);
        int to = from;
        while (to < filled && buffer[to] != '\n' && buffer[to] != '\r') {
            to++;
        }
        String before = decode(buffer, from, place);
        return new Diagnostic(file, line, before.codePointCount(0, before.length()) + 1, error, message, decode(buffer, from, to));
    }

    /** {@return the start of the file's line that contains an index} */
    private int lineStart(int place) {
        int from = place;
        while (from > start && buffer[from - 1] != '\n' && buffer[from - 1] != '\r') {
            from--;
        }
        return from;
    }
}
