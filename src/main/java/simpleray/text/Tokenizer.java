package simpleray.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Set;

/**
 * The words of a scene file, one after another: white space and comments are passed over, headings reported. <em>Mutable</em>, for
 * one thread. Text is UTF-8, a byte order mark is passed over; a line ends with LF, CR LF or CR.
 */
final class Tokenizer {
    /** Begins a comment. */
    static final char COMMENT = '#';

    private static final char QUOTE = '"';
    /** No longer in UTF-8 is any white space than these are. */
    private static final int LONGEST_BLANK = 3;
    private static final int LONGEST_CHARACTER = 4;

    private final InputStream in;
    private final Diagnostics problems;
    private final Mark last = new Mark();
    private final Mark group = new Mark();                    // the first word taken since the group began
    private final Mark here = new Mark();
    private final InputBuffer window;
    private final Numerals numerals = new Numerals();
    private boolean begun;
    private boolean grouped;
    private boolean first;           // the last word is the first on its line
    private boolean half;            // of the next character, one char was taken already

    /**
     * Creates the words of a stream.
     *
     * @param in the stream, not read before {@link #skip}
     * @param size how many bytes of it to keep in memory
     * @param problems told of each heading as it is skipped
     */
    Tokenizer(InputStream in, int size, Diagnostics problems) {
        this.in = in;
        this.problems = problems;
        window = new InputBuffer(in, size, last, group, here);
    }

    /**
     * Moves to the next word.
     *
     * @param keywords words that begin no heading here; null when nothing is a heading here
     * @return false at the end of the file
     * @throws IOException if the stream cannot be read
     */
    boolean skip(Set<String> keywords) throws IOException {
        while (true) {
            if (window.toNumber()) {
                return true;
            }
            if (window.at == window.filled) {
                if (!begun) {
                    window.begin();
                    begun = true;
                } else if (!window.fill()) {
                    return false;
                }
                continue;
            }
            byte b = window.bytes[window.at];
            if (b == '\r') {
                window.nextLine();
            } else if (b == COMMENT) {
                window.skipLine();
            } else {
                if (b < 0) {
                    window.ahead(LONGEST_BLANK);
                }
                int blank = blank(window.at);
                if (blank > 0) {
                    window.at += blank;
                } else if (isWord(keywords)) {
                    return true;
                }
            }
        }
    }

    /** {@return whether a word begins here and no heading} A heading is passed over. */
    private boolean isWord(Set<String> keywords) throws IOException {
        if (last.line == window.line || keywords == null || !isHeading(keywords)) {
            return true;
        }
        window.mark(here);
        here.end = window.skipLine();
        if (problems.hasRoom()) {
            Place place = window.place(here);
            problems.skipped(place, place.word(here.end - here.start).strip());
        }
        return false;
    }

    /** A line that begins with a letter is a heading, but for keywords and for numbers that are none (spec of the format). */
    private boolean isHeading(Set<String> keywords) throws IOException {
        if (!beginsWithLetter()) {
            return false;
        }
        String word = peek();
        return !keywords.contains(word) && !begins(word, "nan") && !begins(word, "infinity");
    }

    private boolean beginsWithLetter() throws IOException {
        if (window.bytes[window.at] < 0) {
            window.ahead(LONGEST_CHARACTER);
        }
        return Character.isLetter(text(window.at, Math.min(window.filled, window.at + LONGEST_CHARACTER)).codePointAt(0));
    }

    /** {@return whether the word is the name, in any case, alone or before something that is no letter} */
    private static boolean begins(String word, String name) {
        return word.toLowerCase(Locale.ROOT).startsWith(name)
            && (word.length() == name.length() || !Character.isLetter(word.codePointAt(name.length())));
    }

    /** {@return whether one of these comes next: words that begin with letters} To be called where {@link #skip} has returned true. */
    boolean isNext(Set<String> keywords) throws IOException {
        return Character.isLetter(window.bytes[window.at]) && keywords.contains(peek());
    }

    /** {@return the next word, or as much of it as fits into memory} */
    private String peek() throws IOException {
        int end = wordEnd();                                  // moves window.at
        return text(window.at, end);
    }

    /** Takes the next number if it is one of the usual form, and there are none but the usual blanks before it; else returns NaN. */
    double takeDouble() throws IOException {
        window.toNumber();                                    // or to what the next line says is none
        double value = numerals.readDouble(window.bytes, window.at);
        if (!Double.isNaN(value)) {
            mark();
            taken(numerals.end());
        }
        return value;
    }

    /** Takes the next integer likewise, one of up to 18 digits; else returns {@link Numerals#NO_INTEGER}. */
    long takeInteger() throws IOException {
        window.toNumber();
        long value = numerals.readInteger(window.bytes, window.at);
        if (value != Numerals.NO_INTEGER) {
            mark();
            taken(numerals.end());
        }
        return value;
    }

    /** {@return the next word; of a very long one, another that means the same} To be called where {@link #skip} has returned true. */
    String take() throws IOException {
        mark();
        int end = wordEnd();
        if (end == window.filled && !window.isEnded()) {
            LongNumber number = new LongNumber();
            while (window.ahead(LONGEST_BLANK) && !isEnd(window.at)) {
                number.add((char) (window.bytes[window.at++] & 0xFF));
                if (number.isWrong()) {
                    window.at = window.wordEnd(window.at);   // a gigabyte of it may follow
                }
            }
            taken(window.at);
            return number.toString();
        }
        String word = text(window.at, end);
        taken(end);
        return word;
    }

    /** {@return the next character, half of it if it is one of two chars} To be called where {@link #skip} has returned true. */
    char takeChar() throws IOException {
        first = last.line != window.line;
        window.mark(last);
        last.end = window.offset(wordEnd());
        window.ahead(LONGEST_CHARACTER);
        int end = Math.min(window.filled, window.at + LONGEST_CHARACTER);
        String text = text(window.at, end);
        int length = Character.charCount(text.codePointAt(0));
        if (length > 1 && !half) {
            half = true;
            return text.charAt(0);
        }
        half = false;
        String behind = text.substring(length);
        do {
            window.at++;
        } while (!text(window.at, end).equals(behind));
        return text.charAt(length - 1);
    }

    /** Begins a group: the words taken from here on. */
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

    /** Marks the next word as the last, without taking it; to be called where {@link #skip} has returned true. */
    void markNext() throws IOException {
        mark();
        last.end = window.offset(wordEnd());
    }

    /** {@return the place of the word taken last} */
    Place last() {
        return window.place(last);
    }

    /** {@return the piece of the file that is the word taken last} */
    SourceSpan lastSpan() {
        return new SourceSpan(last.start, last.end);
    }

    /** {@return the word taken last, as much of it as messages show} */
    String lastWord() {
        return last().word(last.end - last.start);
    }

    /** {@return the place where the group begins} */
    Place group() {
        return window.place(group);
    }

    /** {@return what was taken since the group began, if it is on one line, else its first word; as much of it as messages show} */
    String groupWords() {
        return group().word((group.line == last.line ? last : group).end - group.start);
    }

    /** {@return the place that was reached} */
    Place here() {
        window.mark(here);
        return window.place(here);
    }

    void close() throws IOException {
        in.close();
    }

    private void mark() {
        first = last.line != window.line;
        window.mark(last);
        if (!grouped) {
            group.copy(last);
            grouped = true;
        }
    }

    /** Notes that the word just marked is taken, and ends here. */
    private void taken(int end) {
        window.at = end;
        half = false;
        last.end = window.offset(end);
        if (group.start == last.start) {
            group.end = last.end;
        }
    }

    /**
     * Finds where the word ends that begins here, which may read on and so move the window. Between double quotes it may hold white
     * space and {@code #}.
     *
     * @return the index behind it; the window's end, and that is not the file's, if the word is longer than the window
     */
    private int wordEnd() throws IOException {
        int length = window.bytes[window.at] == QUOTE ? quotedLength() : 0;
        while (true) {
            int i = window.at + length;
            while (i < window.filled && !isEnd(i) && isSure(i)) {
                i++;
            }
            if (i < window.filled ? isSure(i) : window.isEnded()) {
                return i;
            }
            length = i - window.at;
            if (!window.fill() && !window.isEnded()) {
                return window.filled;
            }
        }
    }

    /** {@return whether {@link #isEnd} knows all the bytes it may need} */
    private boolean isSure(int index) {
        return window.bytes[index] >= 0 || window.filled - index >= LONGEST_BLANK || window.isEnded();
    }

    /** {@return how far the closing quote is from the quote here; 0 if none closes on the line, or within the window} */
    private int quotedLength() throws IOException {
        int length = 1;
        while (window.at + length < window.filled || window.fill()) {
            byte b = window.bytes[window.at + length];
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

    private boolean isEnd(int index) {
        return window.bytes[index] == COMMENT || blank(index) > 0;
    }

    /** {@return how many bytes long the white space is that stands here, line breaks too; 0 if none does} */
    private int blank(int index) {
        byte[] bytes = window.bytes;
        byte b = bytes[index];
        if (b >= 0) {
            return InputBuffer.isBlank(b) ? 1 : 0;
        }
        int length = b == (byte) 0xC2 ? 2 : LONGEST_BLANK;
        boolean possible = (b == (byte) 0xC2 || b >= (byte) 0xE1 && b <= (byte) 0xE3) && index + length <= window.filled;
        if (!possible) {
            return 0;
        }
        char c = text(index, index + length).charAt(0);
        return Character.isWhitespace(c) || Character.isSpaceChar(c) ? length : 0;
    }

    private String text(int from, int to) {
        return new String(window.bytes, from, to - from, StandardCharsets.UTF_8);
    }
}
