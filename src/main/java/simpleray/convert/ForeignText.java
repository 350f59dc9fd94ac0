package simpleray.convert;

import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import simpleray.io.MagicNumber;
import simpleray.text.BadNumber;
import simpleray.text.Diagnostic;
import simpleray.text.NumberParser;
import simpleray.text.SceneFormatException;

/**
 * The words of a file of another program, UTF-8: what stands between white space and commas. {@code #} begins a comment that ends with its
 * line; lines end with LF, CR LF or CR. <em>Mutable,</em> for one thread.
 */
final class ForeignText {
    /** The largest number: our shapes take no larger one. */
    static final double MAX_NUMBER = 1e100;
    private static final int MAX_WARNINGS = 1000;
    /** As much of a long line stands in a message on both sides of the place. */
    private static final int CONTEXT = 512;
    private static final char BYTE_ORDER_MARK = '\uFEFF';
    private static final char COMMA = ',';

    private final String file;
    private final String text;
    private final List<Diagnostic> warnings = new ArrayList<>();
    private int warned;
    private int line = 1;
    private int lineStart;
    private int at;
    private Place last = new Place(1, 0, 0);                  // of the word that was taken last
    private String word = "";

    /**
     * A place in the text.
     *
     * @param line the line, from 1
     * @param start the index of the line's first character
     * @param at the index of the place
     */
    record Place(int line, int start, int at) {
    }

    /**
     * Reads a file.
     *
     * @param in the file, not closed here
     * @param file its name for messages
     * @throws SceneFormatException if the file is no text, by its first bytes
     * @throws IOException if it cannot be read
     */
    ForeignText(InputStream in, String file) throws IOException {
        PushbackInputStream begun = new PushbackInputStream(in, MagicNumber.LENGTH);
        String kind = MagicNumber.nameOf(begun);
        if (kind != null) {
            throw new SceneFormatException(List.of(new Diagnostic(file, 1, 1, true, "expected text in UTF-8, found " + kind, null)), false);
        }
        this.file = file;
        String all = new String(begun.readAllBytes(), StandardCharsets.UTF_8);
        text = !all.isEmpty() && all.charAt(0) == BYTE_ORDER_MARK ? all.substring(1) : all;
    }

    /** {@return the file's name for messages} */
    String file() {
        return file;
    }

    /** Moves to the next word, on this line or a later one. {@return false at the end of the file} */
    boolean next() {
        while (isLineEnd() && at < text.length()) {
            at += text.startsWith("\r\n", at) ? 2 : 1;
            line++;
            lineStart = at;
        }
        return at < text.length();
    }

    /** Moves to the next word of this line. {@return whether there is none} */
    boolean isLineEnd() {
        while (at < text.length() && !isBreak(text.charAt(at)) && (isBlank(text.charAt(at)) || text.charAt(at) == '#')) {
            at = text.charAt(at) == '#' ? endOfLine(at) : at + 1;
        }
        return at == text.length() || isBreak(text.charAt(at));
    }

    /** {@return the place of the next word of this line, or of the line's end} */
    Place here() {
        isLineEnd();
        return new Place(line, lineStart, at);
    }

    /** {@return whether a word is the next of this line} */
    boolean isNext(String wanted) {
        last = here();
        return text.startsWith(wanted, at) && isEnd(at + wanted.length());     // a word may be as long as its file
    }

    /** Takes the next word of this line, up to white space. {@return the word, empty at the end of the line} */
    String takeWord() {
        return take(false);
    }

    private boolean isEnd(int place) {
        return place >= text.length() || isBlank(text.charAt(place)) || text.charAt(place) == '#';
    }

    private String take(boolean untilComma) {
        last = here();
        while (!isEnd(at) && !(untilComma && text.charAt(at) == COMMA)) {
            at++;
        }
        word = text.substring(last.at, at);
        return word;
    }

    /** Takes what is left of this line. {@return it without a comment, and without blanks around it; empty if there is nothing} */
    String takeLine() {
        last = here();
        int end = endOfLine(at);
        int comment = text.indexOf('#', at);
        word = text.substring(at, comment >= 0 && comment < end ? comment : end).strip();
        at = end;
        return word;
    }

    /** {@return whether the next word of this line is one of three numbers that commas part} */
    boolean isTripleNext() {
        Place before = here();
        take(true);
        isLineEnd();
        boolean triple = at < text.length() && text.charAt(at) == COMMA;
        at = before.at;
        return triple;
    }

    /** Takes a number of this line. */
    double takeNumber(String what) throws SceneFormatException {
        takeWord();
        return number(what);
    }

    /** Takes a number of this line that is in a range. */
    double takeNumber(String what, double min, double max) throws SceneFormatException {
        double number = takeNumber(what);
        if (number < min || number > max) {
            throw expected(what);
        }
        return number;
    }

    /** Takes an integer of this line that is in a range. */
    int takeInteger(String what, int min, int max) throws SceneFormatException {
        Long number = NumberParser.parseInteger(takeWord(), min, max);
        if (number == null) {
            throw expected(what);
        }
        return number.intValue();
    }

    /** Takes three numbers of this line that are in a range, with commas between them, about which may be blanks. */
    double[] takeTriple(String what, double min, double max, String... names) throws SceneFormatException {
        double[] triple = new double[names.length];
        for (int i = 0; i < triple.length; i++) {
            take(true);
            triple[i] = number(what + ' ' + names[i]);
            if (triple[i] < min || triple[i] > max) {
                throw expected(what + ' ' + names[i]);
            }
            if (i + 1 < triple.length) {
                isLineEnd();
                if (at == text.length() || text.charAt(at) != COMMA) {
                    takeWord();
                    throw expected("a comma and " + what + ' ' + names[i + 1]);
                }
                at++;
            }
        }
        if (at < text.length() && text.charAt(at) == COMMA) {
            takeWord();
            throw expected("a blank after " + what + ' ' + names[names.length - 1]);
        }
        return triple;
    }

    private double number(String what) throws SceneFormatException {
        double number = NumberParser.parseDouble(word);
        if (!(Math.abs(number) <= MAX_NUMBER)) {
            throw expected(what);
        }
        return number;
    }

    /** {@return the error that the word that was taken last is not what was expected} */
    SceneFormatException expected(String wanted) {
        String rest = last.at == text.length() ? "the end of the file" : "the end of the line";
        boolean large = Math.abs(NumberParser.parseDouble(word)) > MAX_NUMBER;
        boolean comma = word.isEmpty() && text.startsWith(",", last.at);
        return error(last, wanted, comma ? "','" : word.isEmpty() ? rest : BadNumber.describe(word) + (large ? " (beyond 1e100)" : ""));
    }

    /** {@return the error that something else was expected at a place} */
    SceneFormatException error(Place place, String wanted, String found) {
        return error(place, "expected " + wanted + ", found " + found);
    }

    /** {@return an error at a place} */
    SceneFormatException error(Place place, String message) {
        return new SceneFormatException(List.of(diagnostic(place, true, message)), false);
    }

    /** Notes what is changed or left out, and why. */
    void warn(Place place, String message) {
        if (warned++ < MAX_WARNINGS) {
            warnings.add(diagnostic(place, false, message));
        }
    }

    /** {@return the warnings in the order they were noted: the first thousand, and then how many more there are} */
    List<Diagnostic> warnings() {
        List<Diagnostic> all = new ArrayList<>(warnings);
        if (warned > MAX_WARNINGS) {
            all.add(new Diagnostic(file, line, 1, false, warned - MAX_WARNINGS + " more warnings of these kinds", null));
        }
        return all;
    }

    private Diagnostic diagnostic(Place place, boolean error, String message) {
        int from = Math.max(place.start, place.at - CONTEXT);
        from += from > place.start && Character.isLowSurrogate(text.charAt(from)) ? 1 : 0;
        int to = Math.min(endOfLine(place.at), place.at + CONTEXT);
        int begins = text.codePointCount(place.start, from) + 1;
        int column = begins + text.codePointCount(from, place.at);
        return new Diagnostic(file, place.line, column, error, message, text.substring(from, to), begins);
    }

    private int endOfLine(int from) {
        int end = from;
        while (end < text.length() && !isBreak(text.charAt(end))) {
            end++;
        }
        return end;
    }

    private static boolean isBreak(char c) {
        return c == '\n' || c == '\r';
    }

    private static boolean isBlank(char c) {
        return Character.isWhitespace(c) || Character.isSpaceChar(c);
    }
}
