package simpleray.text;

import java.util.Locale;
import java.util.regex.Pattern;

/** Describes, for a message, a word that was found in place of a number: the word, and why it is none where that is easily overlooked. */
public final class BadNumber {
    private static final Pattern NOT_FINITE = Pattern.compile("[-+]?(nan|inf|infinity|1\\.#(ind|inf|[qs]nan)[0-9]*)");
    private static final Pattern HEXADECIMAL = Pattern.compile("[-+]?0x[0-9a-f.p+-]*");
    private static final Pattern SUFFIXED = Pattern.compile("[-+]?[0-9.]+(e[-+]?[0-9]+)?[dfl]");
    private static final Pattern NO_INTEGER = Pattern.compile("[-+]?[0-9]*[.,eE][-+0-9.,eE]*");
    private static final Pattern MANY = Pattern.compile("[-+0-9.eE]+(,[-+0-9.eE]+){2,}");
    /** Minus signs that a word processor puts in place of a hyphen. */
    private static final String DASHES = "\u2010\u2011\u2012\u2013\u2014\u2212\uFF0D";
    private static final String NOT_DECODED = "\uFFFD";

    private BadNumber() {
    }

    /**
     * Describes a word.
     *
     * @param word the word
     * @return the word in quotes and, unless it is a number or nothing like one, why it is none; what it is if it is no text
     */
    public static String describe(String word) {
        if (Diagnostic.isBinary(word)) {
            return word.charAt(0) == 0 ? "NUL bytes" : "bytes that are no text in UTF-8";
        }
        String why = Double.isNaN(NumberParser.parseDouble(word)) ? why(word) : null;
        return Diagnostic.quoted(word) + (why == null ? "" : " (" + why + ')');
    }

    /** Describes a word that is no integer in a range. */
    static String describeInteger(String word, long min, long max) {
        double value = NumberParser.parseDouble(word);
        if (NO_INTEGER.matcher(word).matches()) {
            return Diagnostic.quoted(word) + " (an integer has only digits)";
        }
        if (Double.isNaN(value)) {
            return describe(word);
        }
        boolean named = max < Integer.MAX_VALUE;              // what was expected names a narrower range
        String beyond = value < min / 2.0 + max / 2.0 ? " (less than " + min + ')' : " (more than " + max + ')';
        return Diagnostic.quoted(word) + (named ? "" : beyond);
    }

    private static String why(String word) {
        String lower = word.toLowerCase(Locale.ROOT);
        if (word.startsWith(NOT_DECODED + NOT_DECODED)) {
            return "not UTF-8; is the file UTF-16, or no text?";
        }
        if (word.indexOf('\0') >= 0) {
            return "with NUL bytes; is the file UTF-16, or no text?";
        }
        if (word.contains(NOT_DECODED)) {
            return "not UTF-8";
        }
        int hidden = word.codePoints().filter(c -> Diagnostic.isHidden(c) || Character.isISOControl(c)).findFirst().orElse(0);
        if (hidden > 0) {
            return String.format(Locale.ROOT, "with the invisible character U+%04X", hidden);
        }
        if (NOT_FINITE.matcher(lower).matches()) {
            return "numbers must be finite";
        }
        if (HEXADECIMAL.matcher(lower).matches()) {
            return "numbers are decimal";
        }
        if (word.codePoints().anyMatch(c -> c > '9' && Character.isDigit(c) || DASHES.indexOf(c) >= 0)) {
            return "numbers are written with 0 to 9, + and -";
        }
        if (MANY.matcher(word).matches()) {
            return "values are separated by blanks";
        }
        if (!Double.isNaN(NumberParser.parseDouble(word.replace(',', '.')))) {
            return "a decimal point is a '.'";
        }
        if (SUFFIXED.matcher(lower).matches()) {
            return "a number ends with a digit";
        }
        return Double.isInfinite(NumberParser.parse(word)) ? "beyond 1.8e308, the largest number" : null;
    }
}
