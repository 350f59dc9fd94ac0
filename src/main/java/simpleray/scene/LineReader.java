package simpleray.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import simpleray.text.Problem;
import simpleray.text.SceneFormatException;

/**
 * Reads the lines of an OBJ file, each together with those that it continues by a {@code \} at its end, and without comments.
 * <em>Mutable,</em> for one thread.
 *
 * <p>The file is UTF-8, and stays bytes: what is no UTF-8 is the character U+FFFD in messages. The bytes of the latest line stay in the
 * buffer as they are in the file until the next is read, so that a message can show them. Most lines are parsed where they stand. Of a line
 * with a comment, a continuation or characters beyond ASCII a copy is made, in which spaces stand for comments, continuations and
 * Unicode's blanks: each byte of the copy is as far from its beginning as in the file.
 */
final class LineReader {
    /** A line, with those that it continues: far more than a polygon needs, far less than fills the memory. */
    private static final int MAX_CHARACTERS = 1 << 20;
    /** UTF-8 takes three bytes at most for a {@code char}, and so does a continuation: the backslash, CR and LF. */
    private static final int MAX_BYTES = 3 * MAX_CHARACTERS;
    /** So much of a line that is too long is shown. */
    private static final int SHOWN = 512;
    private static final int BLOCK = 1 << 16;
    private static final byte[] BYTE_ORDER_MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};
    private static final byte COMMENT = '#';
    private static final byte CONTINUED = '\\';
    /** ASCII but for line breaks, comments, continuations, and the 0 that stands behind the buffer's last byte. */
    private static final boolean[] PLAIN = new boolean[1 << Byte.SIZE];

    static {
        Arrays.fill(PLAIN, 1, 1 << (Byte.SIZE - 1), true);
        for (byte b : new byte[] {'\n', '\r', COMMENT, CONTINUED}) {
            PLAIN[b] = false;
        }
    }

    /** Holds the line: the buffer, or the copy. */
    byte[] bytes;
    /** The line's first byte. */
    int begin;
    /** The place behind the line's last byte that is not blank; no word goes on there. */
    int end;

    private final InputStream in;
    private final String file;
    private byte[] buffer = new byte[BLOCK + 1];
    private byte[] copy = new byte[BLOCK];
    private int filled;                                      // where the buffer's bytes end: a 0 stands there
    private int start;                                       // of the latest line in the buffer
    private int next;                                        // the first byte that has not been read
    private int firstNumber;                                 // of the latest line, from 1
    private int number;                                      // of the last of those that it continues
    private int characters;                                  // of the latest line so far, as UTF-16

    /**
     * Creates a reader of a file's lines.
     *
     * @param in the file, not closed here
     * @param file what messages call it
     */
    LineReader(InputStream in, String file) {
        this.in = in;
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

    /** Reads a line that is no plain one, or not in the buffer as a whole. */
    private void readUnusual() throws IOException {
        next = start;
        characters = 0;
        int from = 0;                                         // counted from the start, as fill() moves it
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

    /** Moves to the next line break, or to the file's end; returns whether all before it is plain. */
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

    /** Passes over a line break if there is one: LF, CR LF or CR. */
    private void skipLineBreak() throws IOException {
        if (next < filled && buffer[next++] == '\r' && (next < filled || fill()) && buffer[next] == '\n') {
            next++;
        }
    }

    private SceneFormatException tooLong() {
        int from = lineStart(next);
        String text = decode(buffer, from, Math.min(next, from + 4 * SHOWN));
        return new SceneFormatException(List.of(new Problem(file, number, 1, true, "expected a line of at most " + MAX_CHARACTERS
            + " characters, found a longer one", text.substring(0, Math.min(text.length(), SHOWN)))), false);
    }

    /**
     * Copies a piece of the line, without its comment, and finds where the line ends if this is its last piece.
     *
     * @param from the piece's first byte, counted from the line's start
     * @param to the place behind its last
     * @return whether the line goes on behind it; then the backslash is a space
     */
    private boolean copy(int from, int to) {
        if (to + 2 >= copy.length) {                          // there may follow a line break, or a 0
            copy = Arrays.copyOf(copy, 2 * to + 2);
        }
        System.arraycopy(buffer, start + from, copy, from, to - from);
        int i = from;
        while (i < to && copy[i] != COMMENT) {
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

    /** Makes spaces of a Unicode character if it is blank; returns how many bytes are done. No blank has more than three. */
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

    /** Reads on. The latest line stays in the buffer, though it may be moved. Returns false at the end of the file. */
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

    /** {@return the text of some of the line's bytes} */
    String text(int from, int to) {
        return decode(bytes, from, to);
    }

    private static String decode(byte[] bytes, int from, int to) {
        return new String(bytes, from, to - from, StandardCharsets.UTF_8);
    }

    /** {@return the error that something else is expected at a place of the line} */
    SceneFormatException error(int at, String wanted, String found) {
        return error(problem(start + at - begin, true, "expected " + wanted + ", found " + found));
    }

    private static SceneFormatException error(Problem problem) {
        return new SceneFormatException(List.of(problem), false);
    }

    /** {@return the error that something is missing at the end of the file, behind the last character of its last line} */
    SceneFormatException missing(String wanted) {
        int place = next;
        place -= place > start && buffer[place - 1] == '\n' ? 1 : 0;
        place -= place > start && buffer[place - 1] == '\r' ? 1 : 0;
        return error(problem(place, true, "expected " + wanted + ", found the end of the file"));
    }

    /** {@return a warning at the beginning of the line} */
    Problem warning(String message) {
        return problem(start, false, message);
    }

    /** {@return what is to be told of a place in the buffer, in the latest line} */
    private Problem problem(int place, boolean error, String message) {
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
        return new Problem(file, line, before.codePointCount(0, before.length()) + 1, error, message, decode(buffer, from, to));
    }

    /** {@return where the line of the file begins in which a place is} */
    private int lineStart(int place) {
        int from = place;
        while (from > start && buffer[from - 1] != '\n' && buffer[from - 1] != '\r') {
            from--;
        }
        return from;
    }
}
