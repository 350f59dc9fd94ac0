package simpleray.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Set;
import simpleray.text.InputBuffer.Mark;

/**
 * Splits a scene file into words. White space and comments are skipped, and so are headings, with a warning. <em>Mutable</em>, for
 * one thread. Text is UTF-8, with or without a byte order mark; a line ends with LF, CR LF or CR.
 */
final class Tokenizer {
    /** Begins a comment. */
    static final char COMMENT = '#';

    private static final char QUOTE = '"';
    /** The most bytes of a white space character in UTF-8. */
    private static final int LONGEST_BLANK = 3;
    private static final int LONGEST_CHARACTER = 4;
    /** The length at which a heading, or a word that is no number, is not read to its end: the file is no scene. */
    private static final int MAX_LENGTH = 1 << 20;

    private final InputStream in;
    private final Diagnostics diagnostics;
    private final Mark last = new Mark();
    private final Mark group = new Mark();                    // the first word taken since the group began
    private final Mark here = new Mark();
    private final InputBuffer buffer;
    private final NumberParser numbers = new NumberParser();
    private long skipped;            // the bytes of all headings
    private boolean grouped;
    private boolean first;           // the last word is the first on its line
    private boolean cut;             // the last word was not read to its end
    private boolean half;            // the first char of the next character is taken already

    /**
     * Creates a tokenizer.
     *
     * @param in the stream, not read before {@link #skip}
     * @param size how many bytes of it to keep in memory
     * @param diagnostics gets a warning for each heading that is skipped
     */
    Tokenizer(InputStream in, int size, Diagnostics diagnostics) {
        this.in = in;
        this.diagnostics = diagnostics;
        buffer = new InputBuffer(in, size, last, group, here);
    }

    /**
     * Moves to the next word.
     *
     * @param keywords the words that begin no heading here; null where there are no headings
     * @return false at the end of the file
     * @throws IOException if the stream cannot be read, or a heading is too long
     */
    boolean skip(Set<String> keywords) throws IOException {
        while (!buffer.skipToNumber()) {
            byte b = buffer.bytes[buffer.at];
            if (buffer.at == buffer.filled) {
                if (!buffer.fill()) {
                    return false;
                }
            } else if (b == '\r') {
                buffer.skipLineBreak();
            } else if (b == COMMENT) {
                buffer.skipLine(Long.MAX_VALUE);
            } else {
                if (b < 0) {
                    buffer.require(LONGEST_BLANK);
                }
                int blank = blank(buffer.at);
                if (blank > 0) {
                    buffer.at += blank;
                } else if (!buffer.skipByteOrderMark() && !skipHeading(keywords)) {
                    return true;
                }
            }
        }
        return true;
    }

    /** Skips a heading. {@return whether one begins here} */
    private boolean skipHeading(Set<String> keywords) throws IOException {
        if (last.line == buffer.line || keywords == null || !isHeading(keywords)) {
            return false;
        }
        buffer.mark(here);
        here.end = buffer.skipLine(MAX_LENGTH);
        if (buffer.offset(buffer.at) - here.start > MAX_LENGTH) {
            throw diagnostics.stop(buffer.locate(here), "expected a heading of at most " + MAX_LENGTH + " bytes, found a longer one");
        }
        skipped += here.end - here.start;
        if (skipped > MAX_LENGTH) {
            throw diagnostics.stop(buffer.locate(here), "expected a scene, found more than " + MAX_LENGTH + " bytes of headings");
        }
        if (diagnostics.hasRoom()) {
            SourceLocation location = buffer.locate(here);
            diagnostics.skipped(location, location.text(here.end - here.start).strip(), keywords);
        }
        return true;
    }

    /** {@return whether a line that begins here is a heading} It begins with a letter, and with no keyword, NaN or Infinity. */
    private boolean isHeading(Set<String> keywords) throws IOException {
        if (!beginsWithLetter()) {
            return false;
        }
        String word = peek();
        return !keywords.contains(word) && !begins(word, "nan") && !begins(word, "infinity");
    }

    private boolean beginsWithLetter() throws IOException {
        if (buffer.bytes[buffer.at] < 0) {
            buffer.require(LONGEST_CHARACTER);
        }
        return Character.isLetter(text(buffer.at, Math.min(buffer.filled, buffer.at + LONGEST_CHARACTER)).codePointAt(0));
    }

    /** {@return whether the word is the name, in any case, alone or before something that is no letter} */
    private static boolean begins(String word, String name) {
        return word.toLowerCase(Locale.ROOT).startsWith(name)
            && (word.length() == name.length() || !Character.isLetter(word.codePointAt(name.length())));
    }

    /** {@return whether the next word is one of these, which begin with letters} To be called after {@link #skip} has returned true. */
    boolean isNext(Set<String> keywords) throws IOException {
        return Character.isLetter(buffer.bytes[buffer.at]) && keywords.contains(peek());
    }

    /** {@return the next word, or as much of it as fits into the buffer} */
    private String peek() throws IOException {
        int end = wordEnd();                                  // moves buffer.at
        return text(buffer.at, end);
    }

    /** Takes the next number, if only spaces and line feeds are before it. {@return NaN if it must be taken as a word} */
    double takeDouble() throws IOException {
        buffer.skipToNumber();
        double value = numbers.parseDouble(buffer.bytes, buffer.at);
        if (!Double.isFinite(value) || value == 0 && NumberParser.isTiny(buffer.bytes, buffer.at, numbers.end())) {
            return Double.NaN;
        }
        mark();
        taken(numbers.end());
        return value;
    }

    /** Takes the next integer likewise. {@return {@link NumberParser#NO_INTEGER} if it must be taken as a word} */
    long takeInteger() throws IOException {
        buffer.skipToNumber();
        long value = numbers.parseInteger(buffer.bytes, buffer.at);
        if (value != NumberParser.NO_INTEGER) {
            mark();
            taken(numbers.end());
        }
        return value;
    }

    /**
     * Takes the next word; to be called after {@link #skip} has returned true.
     *
     * @param integer whether it is to be an integer
     * @return the word; for one that does not fit into the buffer, a short word that is the same number, or none
     */
    String take(boolean integer) throws IOException {
        mark();
        int end = wordEnd();
        if (end < buffer.filled || buffer.isEnded()) {
            String word = text(buffer.at, end);
            taken(end);
            return word;
        }
        LongNumber number = new LongNumber();
        while (!cut && buffer.require(LONGEST_BLANK) && !isWordEnd(buffer.at)) {
            number.add((char) (buffer.bytes[buffer.at++] & 0xFF));
            if (integer ? number.isNoLong() : number.isWrong()) {
                buffer.at = buffer.wordEnd(buffer.at);
                cut = buffer.offset(buffer.at) - last.start > MAX_LENGTH;
            }
        }
        taken(buffer.at);
        return number.toString();
    }

    /** {@return whether the word taken last was too long to be read to its end, and is no number} Nothing can be read after it. */
    boolean isCut() {
        return cut;
    }

    /** {@return the next character, or half of one that is two chars} To be called after {@link #skip} has returned true. */
    char takeChar() throws IOException {
        first = last.line != buffer.line;
        buffer.mark(last);
        last.end = buffer.offset(wordEnd());
        buffer.require(LONGEST_CHARACTER);
        int end = Math.min(buffer.filled, buffer.at + LONGEST_CHARACTER);
        String text = text(buffer.at, end);
        int length = Character.charCount(text.codePointAt(0));
        if (length > 1 && !half) {
            half = true;
            return text.charAt(0);
        }
        half = false;
        String behind = text.substring(length);
        do {
            buffer.at++;
        } while (!text(buffer.at, end).equals(behind));
        return text.charAt(length - 1);
    }

    /** Begins a group of the words that are taken from here on. */
    void beginGroup() {
        grouped = false;
    }

    /** {@return the line of the word taken last} */
    int line() {
        return last.line;
    }

    /** {@return whether the word taken last is the first on its line} */
    boolean isFirstOnLine() {
        return first;
    }

    /** Marks the next word as the last without taking it; to be called after {@link #skip} has returned true. */
    void markNext() throws IOException {
        mark();
        last.end = buffer.offset(wordEnd());
    }

    /** {@return the location of the word taken last} */
    SourceLocation last() {
        return buffer.locate(last);
    }

    /** {@return the part of the file that is the word taken last} */
    SourceSpan lastSpan() {
        return new SourceSpan(last.start, last.end);
    }

    /** {@return the word taken last, as much of it as messages show} */
    String lastWord() {
        return last().text(last.end - last.start);
    }

    /** {@return the location where the group begins} */
    SourceLocation group() {
        return buffer.locate(group);
    }

    /** {@return the words of the group, if they are on one line, else the first one; as much of it as messages show} */
    String groupWords() {
        return group().text((group.line == last.line ? last : group).end - group.start);
    }

    /** {@return the location that was reached} */
    SourceLocation here() {
        buffer.mark(here);
        return buffer.locate(here);
    }

    void close() throws IOException {
        in.close();
    }

    private void mark() {
        first = last.line != buffer.line;
        buffer.mark(last);
        if (!grouped) {
            group.copy(last);
            grouped = true;
        }
    }

    /** Moves after the word just marked. */
    private void taken(int end) {
        buffer.at = end;
        half = false;
        last.end = buffer.offset(end);
        if (group.start == last.start) {
            group.end = last.end;
        }
    }

    /**
     * Finds the end of the word that begins here, which may read on and move the buffer. Between double quotes a word may contain white
     * space and {@code #}.
     *
     * @return the index after it; if the word does not fit into the buffer, the buffer's end, which is not the file's
     */
    private int wordEnd() throws IOException {
        int length = buffer.bytes[buffer.at] == QUOTE ? quotedLength() : 0;
        while (true) {
            int i = buffer.at + length;
            while (i < buffer.filled && !isWordEnd(i) && isKnown(i)) {
                i++;
            }
            if (i < buffer.filled ? isKnown(i) : buffer.isEnded()) {
                return i;
            }
            length = i - buffer.at;
            if (!buffer.fill() && !buffer.isEnded()) {
                return buffer.filled;
            }
        }
    }

    /** {@return whether the buffer has all the bytes that {@link #isWordEnd} looks at} */
    private boolean isKnown(int index) {
        return buffer.bytes[index] >= 0 || buffer.filled - index >= LONGEST_BLANK || buffer.isEnded();
    }

    /** {@return the distance from the quote here to the closing one; 0 if there is none on the line, or in the buffer} */
    private int quotedLength() throws IOException {
        int length = 1;
        while (buffer.at + length < buffer.filled || buffer.fill()) {
            byte b = buffer.bytes[buffer.at + length];
            if (b == QUOTE) {
                return length;
            }
            if (b == '\n' || b == '\r') {
                return 0;
            }
            length++;
        }
        return 0;
    }

    private boolean isWordEnd(int index) {
        return buffer.bytes[index] == COMMENT || blank(index) > 0;
    }

    /** {@return the number of bytes of the white space character here, such as a line break; 0 if there is none} */
    private int blank(int index) {
        byte[] bytes = buffer.bytes;
        byte b = bytes[index];
        if (b >= 0) {
            return InputBuffer.isBlank(b) ? 1 : 0;
        }
        int length = b == (byte) 0xC2 ? 2 : LONGEST_BLANK;
        boolean possible = (b == (byte) 0xC2 || b >= (byte) 0xE1 && b <= (byte) 0xE3) && index + length <= buffer.filled;
        if (!possible) {
            return 0;
        }
        char c = text(index, index + length).charAt(0);
        return Character.isWhitespace(c) || Character.isSpaceChar(c) ? length : 0;
    }

    private String text(int from, int to) {
        return new String(buffer.bytes, from, to - from, StandardCharsets.UTF_8);
    }
}
