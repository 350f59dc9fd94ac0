package simpleray.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * The part of a scene file that is in memory. It moves on through the file and keeps the current line, of a long line the last
 * {@link #KEPT} bytes. <em>Mutable,</em> for one thread.
 *
 * <p>The file is UTF-8 and is kept as bytes; only what a message shows is decoded, with U+FFFD for invalid bytes.
 */
final class InputBuffer {
    /** The bytes of a line that a location has on either side: more than {@link Diagnostic} shows, whatever the characters. */
    static final int CONTEXT = 512;
    /** The bytes of a line that stay in the buffer before {@link #at}. */
    static final int KEPT = 4 * CONTEXT;
    /** White space among the first characters, one bit each. */
    private static final long BLANKS = 1L << '\t' | 1L << '\n' | 1L << 0x0B | 1L << '\f' | 1L << '\r' | 0xFL << 0x1C | 1L << ' ';
    /** Enough for most files. */
    private static final int FIRST_SIZE = 1 << 13;
    private static final byte[] BYTE_ORDER_MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};

    /** The bytes of the file from 0 to {@link #filled}, and a 0 after them, which continues no word. */
    byte[] bytes;
    /** The next byte to look at. */
    int at;
    /** The index after the last byte. */
    int filled;
    /** The line that {@link #at} is in, from 1. */
    int line = 1;

    private final InputStream in;
    private final int size;
    private final Mark[] marks;
    private long base;               // the offset in the file of the byte at 0
    private long lineStart;          // the offset of the line's first byte that is in the buffer
    private int lineColumn = 1;      // and its column
    private boolean ended;
    private IOException failure;     // is thrown by the next reading

    /**
     * Creates a buffer at the beginning of a stream.
     *
     * @param in the stream, read but not closed here
     * @param size how many bytes to keep in memory, at least two times {@link #KEPT}
     * @param marks the marks that are to be located even when the buffer has moved on
     */
    InputBuffer(InputStream in, int size, Mark... marks) {
        this.in = in;
        this.marks = marks;
        this.size = size;
        bytes = new byte[Math.min(size, FIRST_SIZE) + 1];
    }

    /** Skips a byte order mark. {@return whether one is here, at the beginning of the file} */
    boolean skipByteOrderMark() {
        int length = BYTE_ORDER_MARK.length;
        if (base + at > 0 || filled < length || !Arrays.equals(bytes, 0, length, BYTE_ORDER_MARK, 0, length)) {
            return false;
        }
        at = length;
        lineStart = length;
        return true;
    }

    /** {@return whether a byte is white space of ASCII, such as a line break} */
    static boolean isBlank(byte b) {
        return b >= 0 && b <= ' ' && (BLANKS >>> b & 1) != 0;
    }

    /** {@return the offset in the file of a byte of the buffer} */
    long offset(int index) {
        return base + index;
    }

    /** {@return whether the buffer has the last byte of the file} */
    boolean isEnded() {
        return ended;
    }

    /** Reads until there are n bytes from {@link #at} on, or the file ends. {@return whether there is one} */
    boolean require(int n) throws IOException {
        while (filled - at < n && fill()) {
            continue;
        }
        return at < filled;
    }

    /** Reads more bytes, which may move those that are kept, and {@link #at} with them. {@return false if the file ends or the buffer is full} */
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

    /** Drops the bytes that need not be kept. */
    private void drop() {
        int start = (int) (lineStart - base);
        int from = Math.max(start, characterStart(at - KEPT));
        if (from == 0) {
            return;
        }
        boolean cut = from > start;
        for (Mark mark : marks) {
            if (mark.line > 0 && mark.location == null && mark.start - (cut ? CONTEXT : 0) < base + from) {
                mark.location = known(mark);
            }
        }
        if (cut) {
            lineColumn += characters(start, from);
            lineStart = base + from;
            for (Mark mark : marks) {
                mark.lineStart = lineStart;                  // not used in those that have their location
                mark.lineColumn = lineColumn;
            }
        }
        System.arraycopy(bytes, from, bytes, 0, filled - from);
        base += from;
        at -= from;
        filled -= from;
        bytes[filled] = 0;                                    // even if the next bytes cannot be read
    }

    /** Skips the line break that is next: LF, CR LF or CR. */
    void skipLineBreak() throws IOException {
        if (bytes[at++] == '\r' && require(1) && bytes[at] == '\n') {
            at++;
        }
        line++;
        lineStart = base + at;
        lineColumn = 1;
    }

    /** Skips spaces and line feeds in the buffer. {@return whether a character is next that may begin a number, and no heading} */
    boolean skipToNumber() throws IOException {
        while (true) {
            byte b = bytes[at];                               // a 0 after the last one
            if (b == '\n') {
                skipLineBreak();
            } else if (b == ' ') {
                at++;
            } else {
                return b >= '+' && b <= '9';
            }
        }
    }

    /**
     * Skips the rest of the line, up to its line break.
     *
     * @param max the length after which it stops, soon
     * @return the offset after the last byte that is not blank
     */
    long skipLine(long max) throws IOException {
        long start = base + at;
        long end = 0;
        do {
            int from = at;
            at = lineEnd(from);
            int i = at;
            while (i > from && isBlank(bytes[i - 1])) {
                i--;
            }
            end = i > from ? base + i : end;
        } while (at == filled && base + at - start <= max && fill());
        return end;
    }

    /** {@return the index of the next line break, or the end of the buffer} */
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
        m.location = null;
    }

    /** {@return the location of a mark} If the file cannot be read from here on, the text ends here, and the next reading fails. */
    SourceLocation locate(Mark m) {
        try {
            while (m.location == null && filled - (m.start - base) <= CONTEXT && lineEnd((int) (m.start - base)) == filled && fill()) {
                continue;
            }
        } catch (IOException e) {
            failure = e;
        }
        return m.location == null ? known(m) : m.location;
    }

    /** {@return the location of a mark in the buffer, with the bytes that are there} */
    private SourceLocation known(Mark m) {
        int start = (int) (m.start - base);
        int first = (int) (m.lineStart - base);
        int from = Math.max(first, characterStart(start - CONTEXT));
        int end = lineEnd(start);
        int to = end - start > CONTEXT ? characterStart(start + CONTEXT) : end;
        int begins = m.lineColumn + characters(first, from);
        return new SourceLocation(m.line, begins + characters(from, start), begins, Arrays.copyOfRange(bytes, from, to), start - from);
    }

    private int characters(int from, int to) {
        String text = new String(bytes, from, to - from, StandardCharsets.UTF_8);
        return text.codePointCount(0, text.length());
    }

    /** {@return the first byte of the character here} No character has more than four bytes; all but the first are between 80 and BF. */
    private int characterStart(int index) {
        for (int i = index; i >= Math.max(0, index - 3); i--) {
            if ((bytes[i] & 0xC0) != 0x80) {
                return i;
            }
        }
        return Math.max(0, index);
    }

    /** {@return the index of the next byte that may end a word, or the end of the buffer} */
    int wordEnd(int from) {
        int i = from;
        while (i < filled && bytes[i] >= 0 && bytes[i] != Tokenizer.COMMENT && !isBlank(bytes[i])) {
            i++;
        }
        return i;
    }

    /** A word's place in the file: by offsets while it is in the buffer, and by its {@link SourceLocation} afterwards. <em>Mutable.</em> */
    static final class Mark {
        /** The line, from 1; 0 while nothing is marked. */
        int line;
        /** The offset of the line's first byte that is in the buffer. */
        long lineStart;
        /** That byte's column. */
        int lineColumn;
        /** The offset of the word's first byte. */
        long start;
        /** The offset after its last byte. */
        long end;
        /** The location, once the buffer has moved on; else null. */
        SourceLocation location;

        void copy(Mark m) {
            line = m.line;
            lineStart = m.lineStart;
            lineColumn = m.lineColumn;
            start = m.start;
            end = m.end;
            location = m.location;
        }
    }
}
