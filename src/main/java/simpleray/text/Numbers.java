package simpleray.text;

/**
 * What counts as a number, in a scene file and on the command line: decimals, plain or with an exponent; no NaN, Infinity, hex
 * floats or suffixes.
 */
public final class Numbers {
    private Numbers() {
    }

    /**
     * Reads a number.
     *
     * @param word the word
     * @return the finite double that it means, or NaN if it means none
     */
    public static double parseDouble(String word) {
        double value = isDecimal(word) ? Double.parseDouble(word) : Double.NaN;
        return Double.isInfinite(value) ? Double.NaN : value;
    }

    /**
     * Reads a number of single precision.
     *
     * @param word the word
     * @return the finite float nearest to what it means, or NaN if it means none
     */
    public static float parseFloat(String word) {
        float value = isDecimal(word) ? Float.parseFloat(word) : Float.NaN;
        return Float.isInfinite(value) ? Float.NaN : value;
    }

    /**
     * Reads an integer.
     *
     * @param word the word
     * @param least the smallest allowed
     * @param most the largest allowed
     * @return the integer that it means, or null if it means none in that range
     */
    public static Long parseInteger(String word, long least, long most) {
        if (digits(word, sign(word)) != word.length()) {
            return null;
        }
        try {
            long value = Long.parseLong(word);
            return value < least || value > most ? null : value;
        } catch (NumberFormatException e) {                   // no digit at all, or more than a long holds
            return null;
        }
    }

    /**
     * Writes a number.
     *
     * @param value the number, finite
     * @return the shortest decimal that reads back as the same number
     */
    public static String shortest(double value) {
        return ShortestDecimal.of(value);
    }

    /** {@return whether a number that reads as 0 means another} */
    static boolean isTiny(String number) {
        for (int i = 0; i < number.length() && (number.charAt(i) | ' ') != 'e'; i++) {
            if (number.charAt(i) >= '1' && number.charAt(i) <= '9') {
                return true;
            }
        }
        return false;
    }

    /** {@return whether a word is a decimal, whatever its size} */
    static boolean isDecimal(String word) {
        int start = sign(word);
        int whole = digits(word, start);
        int end = whole;
        boolean some = whole > start;
        if (end < word.length() && word.charAt(end) == '.') {
            end = digits(word, end + 1);
            some |= end > whole + 1;
        }
        if (some && end < word.length() && (word.charAt(end) == 'e' || word.charAt(end) == 'E')) {
            int exponent = end + 1 + sign(word.substring(end + 1));
            end = digits(word, exponent);
            some = end > exponent;
        }
        return some && end == word.length();
    }

    /** {@return 1 if the word begins with a sign, else 0} */
    private static int sign(String word) {
        return !word.isEmpty() && (word.charAt(0) == '-' || word.charAt(0) == '+') ? 1 : 0;
    }

    /** {@return where the run of digits 0 to 9 from this index ends} */
    private static int digits(String word, int from) {
        int end = from;
        while (end < word.length() && word.charAt(end) >= '0' && word.charAt(end) <= '9') {
            end++;
        }
        return end;
    }
}
