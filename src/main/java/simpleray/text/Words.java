package simpleray.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;

/**
 * The words of a scene file, one after another: white space and comments are passed over, headings reported. <em>Mutable</em>, for
 * one thread. Text is UTF-8, a byte order mark is passed over; a line ends with LF, CR LF or CR.
 */
final class Words {
    private static final int BUFFER = 1 << 16;
    private static final char COMMENT = '#';
    private static final char QUOTE = '"';
    private static final char BYTE_ORDER_MARK = '\uFEFF';

    private final Reader in;
    private final Consumer<Place> heading;
    private final char[] buffer = new char[BUFFER];
    private int filled;
    private int taken;

    private String line = "";
    private int lineNumber;
    private int at;                  // the next character of the line
    private boolean fresh;           // no word of this line was taken yet
    private boolean lineBreak;       // the line ended with a line break, not with the file
    private boolean ended;

    /**
     * Creates the words of a stream.
     *
     * @param in the stream, read but not closed here
     * @param heading told the place of each heading as it is skipped
     */
    Words(InputStream in, Consumer<Place> heading) {
        this.in = new InputStreamReader(in, StandardCharsets.UTF_8);
        this.heading = heading;
    }

    /** A place in the file; its column is counted only when it is asked for, for a line may be long. */
    record Place(int line, int at, String source, int end) {
        /** {@return the column, from 1; a character is one column} */
        int column() {
            return source.codePointCount(0, at) + 1;
        }

        /** {@return the word that stands here; empty at the end of the file} */
        String word() {
            return source.substring(at, end);
        }
    }

    /** {@return the place of the next word, or the place after the last character when {@link #skip} has just returned false} */
    Place place() {
        return new Place(lineNumber, at, line, wordEnd());
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
            while (at < line.length() && isBlank(line.charAt(at))) {
                at++;
            }
            if (at == line.length() || line.charAt(at) == COMMENT) {
                if (!nextLine()) {
                    return false;
                }
            } else if (fresh && keywords != null && isHeading(keywords)) {
                heading.accept(place());
                at = line.length();
            } else {
                return true;
            }
        }
    }

    /** {@return the next word, left in its place; to be called where {@link #skip} has just returned true} */
    String peek() {
        return line.substring(at, wordEnd());
    }

    /** {@return the next word; to be called where {@link #skip} has just returned true} */
    String take() {
        int from = at;
        at = wordEnd();
        fresh = false;
        return line.substring(from, at);
    }

    /** {@return the next character; to be called where {@link #skip} has just returned true} */
    char takeChar() {
        fresh = false;
        return line.charAt(at++);
    }

    void close() throws IOException {
        in.close();
    }

    /** A line that begins with a letter is a heading, but for keywords and for numbers that are none (spec of the format). */
    private boolean isHeading(Set<String> keywords) {
        if (!Character.isLetter(line.codePointAt(at))) {
            return false;
        }
        String word = peek();
        return !keywords.contains(word) && !begins(word, "nan") && !begins(word, "infinity");
    }

    /** {@return whether the word is the name, in any case, alone or before something that is no letter} */
    private static boolean begins(String word, String name) {
        return word.toLowerCase(Locale.ROOT).startsWith(name)
            && (word.length() == name.length() || !Character.isLetter(word.codePointAt(name.length())));
    }

    /** {@return where the word ends that begins here} Between double quotes it may hold white space and {@code #}. */
    private int wordEnd() {
        int end = at;
        if (end < line.length() && line.charAt(end) == QUOTE) {
            end = Math.max(end, line.indexOf(QUOTE, end + 1));
        }
        while (end < line.length() && !isBlank(line.charAt(end)) && line.charAt(end) != COMMENT) {
            end++;
        }
        return end;
    }

    private static boolean isBlank(char c) {
        return Character.isWhitespace(c) || Character.isSpaceChar(c);
    }

    private boolean nextLine() throws IOException {
        if (ended) {
            return false;
        }
        boolean first = lineNumber == 0;
        StringBuilder text = new StringBuilder();
        boolean broken = readLine(text);
        if (!broken && text.isEmpty() && !lineBreak && !first) {
            ended = true;
            at = line.length();
            return false;
        }
        if (first && !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK) {
            text.deleteCharAt(0);
        }
        lineNumber++;
        line = text.toString();
        at = 0;
        fresh = true;
        lineBreak = broken;
        return true;
    }

    /** Appends the next line to the text; returns whether a line break ended it. */
    private boolean readLine(StringBuilder text) throws IOException {
        while (true) {
            int from = taken;
            while (taken < filled && buffer[taken] != '\n' && buffer[taken] != '\r') {
                taken++;
            }
            text.append(buffer, from, taken - from);
            if (taken < filled) {
                if (buffer[taken++] == '\r' && fill() && buffer[taken] == '\n') {
                    taken++;
                }
                return true;
            }
            if (!fill()) {
                return false;
            }
        }
    }

    /** Makes sure that there is a character to take; false at the end of the stream. */
    private boolean fill() throws IOException {
        while (taken == filled) {
            filled = in.read(buffer, 0, BUFFER);
            taken = 0;
            if (filled < 0) {
                filled = 0;
                return false;
            }
        }
        return true;
    }
}
