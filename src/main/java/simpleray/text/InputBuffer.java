package simpleray.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * The piece of a scene file that is in memory. It moves on through the file and keeps the line it is in, of a long line the last
 * {@link #KEPT} bytes. <em>Mutable,</em> for one thread.
 *
 * <p>The file is UTF-8, and stays bytes: only what a message shows is ever decoded. What is no UTF-8 is then the character U+FFFD.
 */
final class InputBuffer {
    /** So much of a line is shown on either side of a place: more than {@link Diagnostic} shows, whatever the characters. */
    static final int CONTEXT = 512;
    /** So much of a line stays in the window behind {@link #at}. */
    static final int KEPT = 4 * CONTEXT;
    /** White space among the first characters, a bit each. */
    private static final long BLANKS = 1L << '\t' | 1L << '\n' | 1L << 0x0B | 1L << '\f' | 1L << '\r' | 0xFL << 0x1C | 1L << ' ';
    /** So many bytes are enough for most files. */
    private static final int FIRST_SIZE = 1 << 13;
    private static final byte[] BYTE_ORDER_MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};

    /** The bytes; those from 0 to {@link #filled} are of the file, and the one there is 0, with which nothing goes on. */
    byte[] bytes;
    /** The next byte to look at. */
    int at;
    /** Where the bytes end. */
    int filled;
    /** The line that {@link #at} is in, from 1. */
    int line = 1;

    private final InputStream in;
    private final int size;
    private final Mark[] marks;
    private long base;               // the offset in the file of the byte at 0
    private long lineStart;          // the offset of the line's first byte that is in the window
    private int lineColumn = 1;      // and its column
    private boolean ended;
    private IOException failure;     // met where it could not be thrown

    /**
     * Opens a window at a stream's beginning.
     *
     * @param in the stream, read but not closed here
     * @param size how many bytes to keep in memory, at least two times {@link #KEPT}
     * @param marks the marks whose places must be known even when the window has moved on
     */
    InputBuffer(InputStream in, int size, Mark... marks) {
        this.in = in;
        this.marks = marks;
        this.size = size;
        bytes = new byte[Math.min(size, FIRST_SIZE) + 1];
    }

    /** Reads the first bytes and passes over a byte order mark. */
    void begin() throws IOException {
        if (ahead(1) && bytes[0] == BYTE_ORDER_MARK[0] && ahead(BYTE_ORDER_MARK.length)
            && Arrays.equals(bytes, 0, Math.min(filled, BYTE_ORDER_MARK.length), BYTE_ORDER_MARK, 0, BYTE_ORDER_MARK.length)) {
            at = BYTE_ORDER_MARK.length;
            lineStart = at;
        }
    }

    /** {@return whether a byte is white space, a line break too, all by itself} */
    static boolean isBlank(byte b) {
        return b >= 0 && b <= ' ' && (BLANKS >>> b & 1) != 0;
    }

    /** {@return the offset in the file of a byte of the window} */
    long offset(int index) {
        return base + index;
    }

    /** {@return whether the file has no more bytes than the window} */
    boolean isEnded() {
        return ended;
    }

    /** Tries to have this many bytes from {@link #at} on in the window; returns whether there is one. */
    boolean ahead(int n) throws IOException {
        while (filled - at < n && fill()) {
            continue;
        }
        return at < filled;
    }

    /** Reads on, which moves the window and {@link #at} with it; returns false if the file ends or the window is full. */
    boolean fill() throws IOException {
        if (failure != null) {
            throw failure;
        }
        if (filled > bytes.length / 2) {
            bytes = bytes.length <= size ? Arrays.copyOf(bytes, size + 1) : bytes;
            drop();
        }
        int read = 0;
        int room = bytes.length - 1 - filled;
        while (!ended && read == 0 && room > 0) {
            read = in.read(bytes, filled, room);
            ended = read < 0;
        }
        filled += Math.max(0, read);
        bytes[filled] = 0;
        return read > 0;
    }

    /** Drops what is not kept. */
    private void drop() {
        int start = (int) (lineStart - base);
        int from = Math.max(start, boundary(at - KEPT));
        if (from == 0) {
            return;
        }
        boolean cut = from > start;
        for (Mark mark : marks) {
            if (mark.line > 0 && mark.place == null && mark.start - (cut ? CONTEXT : 0) < base + from) {
                mark.place = seen(mark);
            }
        }
        if (cut) {
            lineColumn += characters(start, from);
            lineStart = base + from;
            for (Mark mark : marks) {
                mark.lineStart = lineStart;                  // of no meaning for those that have their places
                mark.lineColumn = lineColumn;
            }
        }
        System.arraycopy(bytes, from, bytes, 0, filled - from);
        base += from;
        at -= from;
        filled -= from;
        bytes[filled] = 0;                                    // also if the next bytes cannot be read
    }

    /** Passes over the line break that is next: LF, CR LF or CR. */
    void nextLine() throws IOException {
        if (bytes[at++] == '\r' && ahead(1) && bytes[at] == '\n') {
            at++;
        }
        line++;
        lineStart = base + at;
        lineColumn = 1;
    }

    /**
     * Passes over spaces and line feeds as long as there are some in the window.
     *
     * @return whether a character is next with which numbers begin, and no heading does: a digit, a sign or the like
     */
    boolean toNumber() throws IOException {
        while (true) {
            byte b = bytes[at];                               // behind the last one is a 0
            if (b == '\n') {
                nextLine();
            } else if (b == ' ') {
                at++;
            } else {
                return b >= '+' && b <= '9';
            }
        }
    }

    /** Passes over what is left of a line, up to its line break, and is not blank; returns the offset behind the last byte that is none. */
    long skipLine() throws IOException {
        long end = 0;
        do {
            int from = at;
            at = lineEnd(from);
            int i = at;
            while (i > from && isBlank(bytes[i - 1])) {
                i--;
            }
            end = i > from ? base + i : end;
        } while (at == filled && fill());
        return end;
    }

    /** {@return the next line break's index, or the end of the window} */
    private int lineEnd(int from) {
        int i = from;
        while (i < filled && bytes[i] != '\n' && bytes[i] != '\r') {
            i++;
        }
        return i;
    }

    /** Marks the byte that is next. */
    void mark(Mark m) {
        m.line = line;
        m.lineStart = lineStart;
        m.lineColumn = lineColumn;
        m.start = base + at;
        m.end = m.start;
        m.place = null;
    }

    /** {@return where a mark is} Should the file be unreadable from here on, the text ends here, and the next reading fails. */
    Place place(Mark m) {
        try {
            while (m.place == null && filled - (m.start - base) <= CONTEXT && lineEnd((int) (m.start - base)) == filled && fill()) {
                continue;
            }
        } catch (IOException e) {
            failure = e;
        }
        return m.place == null ? seen(m) : m.place;
    }

    private Place seen(Mark m) {
        int start = (int) (m.start - base);
        int first = (int) (m.lineStart - base);
        int from = Math.max(first, boundary(start - CONTEXT));
        int end = lineEnd(start);
        int to = end - start > CONTEXT ? boundary(start + CONTEXT) : end;
        int begins = m.lineColumn + characters(first, from);
        return new Place(m.line, begins + characters(from, start), begins, Arrays.copyOfRange(bytes, from, to), start - from);
    }

    private int characters(int from, int to) {
        String text = new String(bytes, from, to - from, StandardCharsets.UTF_8);
        return text.codePointCount(0, text.length());
    }

    /** {@return the beginning of the character here} No character has more than four bytes, all but the first between 80 and BF. */
    private int boundary(int index) {
        for (int i = index; i >= Math.max(0, index - 3); i--) {
            if ((bytes[i] & 0xC0) != 0x80) {
                return i;
            }
        }
        return Math.max(0, index);
    }

    /** {@return the index of the next byte that may end a word, or of the end of the window} */
    int wordEnd(int from) {
        int i = from;
        while (i < filled && bytes[i] >= 0 && bytes[i] != Tokenizer.COMMENT && !isBlank(bytes[i])) {
            i++;
        }
        return i;
    }
}
