package simpleray.text;

import java.math.BigInteger;
import java.nio.charset.StandardCharsets;

/**
 * Parses the numbers of scene files, OBJ files and the command line: decimals, plain or with an exponent, but no NaN, Infinity,
 * hexadecimal numbers or suffixes. <em>Mutable,</em> for one thread.
 *
 * <p>A number is the double nearest to it, of two the even one. Those of up to 19 digits and a common exponent are parsed from the bytes of
 * a file without creating an object; others by {@link Double#parseDouble}.
 */
public final class NumberParser {
    /** Returned by {@link #parseInteger(byte[], int)} if there is no integer of up to 18 digits. */
    static final long NO_INTEGER = Long.MIN_VALUE;

    /** So many digits always fit into a {@code long}, and one more into an unsigned one. */
    private static final int LONG_DIGITS = 18;
    private static final int MAX_DIGITS = LONG_DIGITS + 1;
    /** Large enough that every number but 0 is then too large or too small. */
    private static final int MAX_EXPONENT = 9999;
    private static final int FRACTION_BITS = 52;
    private static final int EXPONENT_BIAS = 1023;
    /** The powers of ten that are doubles. */
    private static final double[] POWERS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17,
        1e18, 1e19, 1e20, 1e21, 1e22};

    private int end;

    /** Creates a parser. */
    public NumberParser() {
    }

    /** {@return the index after the number that was parsed last} */
    public int end() {
        return end;
    }

    /**
     * Parses a word.
     *
     * @param word the word
     * @return the nearest double; NaN if it is no number, or too large for a double
     */
    public static double parseDouble(String word) {
        double value = parse(word);
        return Double.isInfinite(value) ? Double.NaN : value;
    }

    /**
     * Parses a word.
     *
     * @param word the word
     * @return the nearest float; NaN if it is no number, or too large for a float
     */
    public static float parseFloat(String word) {
        float value = Double.isNaN(parse(word)) ? Float.NaN : Float.parseFloat(word);
        return Float.isInfinite(value) ? Float.NaN : value;
    }

    /**
     * Parses a word as an integer.
     *
     * @param word the word
     * @param min the smallest integer allowed
     * @param max the largest integer allowed
     * @return the integer; null if it is none, or out of range
     */
    public static Long parseInteger(String word, long min, long max) {
        try {
            long value = Long.parseLong(word);
            boolean ascii = word.getBytes(StandardCharsets.UTF_8).length == word.length();     // parseLong takes the digits of any script
            return ascii && value >= min && value <= max ? value : null;
        } catch (NumberFormatException e) {
            return null;
        }
    }

    /** {@return the nearest double, infinite if the number is too large for one; NaN if the word is no number} */
    static double parse(String word) {
        byte[] bytes = (word + ' ').getBytes(StandardCharsets.UTF_8);
        NumberParser parser = new NumberParser();
        double value = parser.parseDouble(bytes, 0);
        return parser.end == bytes.length - 1 ? value : Double.NaN;
    }

    /**
     * Parses the number that begins at an index and ends at white space or a comment.
     *
     * @param bytes the text, and after it a 0
     * @param at the index of its first byte
     * @return the nearest double, infinite if the number is too large for one; NaN if there is no number, or the text ends with it
     */
    public double parseDouble(byte[] bytes, int at) {
        boolean negative = bytes[at] == '-';
        int begin = negative || bytes[at] == '+' ? at + 1 : at;
        long digits = 0;
        int i = begin;
        while (isDigit(bytes[i])) {
            digits = 10 * digits + bytes[i++] - '0';
        }
        int count = i - begin;
        int power = 0;
        if (bytes[i] == '.') {
            int point = ++i;
            while (isDigit(bytes[i])) {
                digits = 10 * digits + bytes[i++] - '0';
            }
            power = point - i;
            count -= power;
        }
        end = i;
        double magnitude = count > 0 && count <= MAX_DIGITS && isWordEnd(bytes[i]) ? nearest(digits, power)
            : parseUnusual(bytes, begin, digits, count, power);
        if (Double.isNaN(magnitude)) {
            boolean number = count > 0 && isWordEnd(bytes[end]);
            return number ? Double.parseDouble(new String(bytes, at, end - at, StandardCharsets.ISO_8859_1)) : Double.NaN;
        }
        return negative ? -magnitude : magnitude;
    }

    /** Goes on after the digits: there is an exponent, or there are many digits, or this is no number. */
    private double parseUnusual(byte[] bytes, int begin, long digits, int count, int power) {
        int significant = count > MAX_DIGITS ? count - leadingZeros(bytes, begin) : count;
        boolean exponent = count > 0 && (bytes[end] == 'e' || bytes[end] == 'E');
        int sum = exponent ? power + parseExponent(bytes, end + 1) : power;
        return count > 0 && significant <= MAX_DIGITS && isWordEnd(bytes[end]) ? nearest(digits, sum) : Double.NaN;
    }

    /** Moves the end behind an exponent's digits; if there are none, it stays at the letter, where no number ends. */
    private int parseExponent(byte[] bytes, int at) {
        boolean negative = bytes[at] == '-';
        int begin = negative || bytes[at] == '+' ? at + 1 : at;
        int exponent = 0;
        int i = begin;
        while (isDigit(bytes[i])) {
            exponent = Math.min(MAX_EXPONENT, 10 * exponent + bytes[i++] - '0');
        }
        end = i > begin ? i : end;
        return negative ? -exponent : exponent;
    }

    private static int leadingZeros(byte[] bytes, int begin) {
        int zeros = 0;
        for (int i = begin; bytes[i] == '0' || bytes[i] == '.'; i++) {
            zeros += bytes[i] == '0' ? 1 : 0;
        }
        return zeros;
    }

    /** {@return the integer of up to 18 digits that begins at an index and ends at white space or a comment; else {@link #NO_INTEGER}} */
    long parseInteger(byte[] bytes, int at) {
        boolean negative = bytes[at] == '-';
        int begin = negative ? at + 1 : at;
        long value = 0;
        int i = begin;
        while (isDigit(bytes[i])) {
            value = 10 * value + bytes[i++] - '0';
        }
        end = i;
        if (i == begin || i - begin > LONG_DIGITS || !isWordEnd(bytes[i])) {
            return NO_INTEGER;
        }
        return negative ? -value : value;
    }

    /** {@return whether a word that was read as 0 is another number} */
    static boolean isTiny(String word) {
        return isTiny(word.getBytes(StandardCharsets.UTF_8), 0, word.length());
    }

    /** {@return whether a number that was read as 0 is another} */
    static boolean isTiny(byte[] bytes, int from, int to) {
        for (int i = from; i < to && (bytes[i] | ' ') != 'e'; i++) {
            if (bytes[i] >= '1' && bytes[i] <= '9') {
                return true;
            }
        }
        return false;
    }

    private static boolean isDigit(byte b) {
        return b >= '0' && b <= '9';
    }

    private static boolean isWordEnd(byte b) {
        return InputBuffer.isBlank(b) || b == Tokenizer.COMMENT;
    }

    /**
     * Finds the double nearest to digits · 10^power.
     *
     * @param digits an unsigned integer
     * @param power the power of ten
     * @return the double; NaN where it takes more than 128 bits to tell
     */
    static double nearest(long digits, int power) {
        if (digits >>> (FRACTION_BITS + 1) == 0 && power >= 1 - POWERS.length && power < POWERS.length) {
            // both are doubles, and so the one rounding is that of the result (Clinger, "How to Read Floating Point Numbers
            // Accurately", 1990)
            return power < 0 ? digits / POWERS[-power] : digits * POWERS[power];
        }
        if (digits == 0) {
            return 0;
        }
        return power < -Fives.MAX || power > Fives.MAX ? Double.NaN : nearestProduct(digits, power);
    }

    /**
     * Multiplies by 128 bits of the power of five. These are cut off, so that the true product is up to two units of the last bit of
     * hi:lo above it: only where that might change the rounding is the result in doubt (an idea of Lemire, "Number Parsing at a Gigabyte
     * per Second", 2021).
     */
    private static double nearestProduct(long digits, int power) {
        int zeros = Long.numberOfLeadingZeros(digits);
        long w = digits << zeros;
        long high = Fives.HIGH[power + Fives.MAX];
        long low = w * high;
        long lo = low + multiplyHigh(w, Fives.LOW[power + Fives.MAX]);
        long hi = multiplyHigh(w, high) + (Long.compareUnsigned(lo, low) < 0 ? 1 : 0);

        int below = Long.SIZE - FRACTION_BITS - 1 - (hi < 0 ? 0 : 1);      // the bits of hi that are to be rounded away
        long half = 1L << (below - 1);
        long rest = hi & ((1L << below) - 1);
        if (rest == half && lo == 0 || rest == half - 1 && lo == -1) {
            return Double.NaN;
        }
        long mantissa = (hi >>> below) + (rest >= half ? 1 : 0);
        long exponent = (long) Fives.EXPONENT[power + Fives.MAX] + power + Long.SIZE - zeros + below + FRACTION_BITS + EXPONENT_BIAS;
        return Double.longBitsToDouble((exponent << FRACTION_BITS) + mantissa - (1L << FRACTION_BITS));
    }

    /** {@return the upper half of an unsigned product} */
    private static long multiplyHigh(long a, long b) {
        return Math.multiplyHigh(a, b) + ((a >> (Long.SIZE - 1)) & b) + ((b >> (Long.SIZE - 1)) & a);
    }

    /** The powers of five, 5^k = (HIGH + LOW / 2^64) · 2^EXPONENT at index k + MAX, cut off there; computed when first needed. */
    private static final class Fives {
        static final int MAX = 64;
        static final long[] HIGH = new long[2 * MAX + 1];
        static final long[] LOW = new long[2 * MAX + 1];
        static final int[] EXPONENT = new int[2 * MAX + 1];

        static {
            for (int k = -MAX; k <= MAX; k++) {
                BigInteger power = BigInteger.valueOf(5).pow(Math.abs(k));
                int exponent = (k < 0 ? 1 - power.bitLength() : power.bitLength()) - Long.SIZE;
                int shift = Long.SIZE - exponent;
                BigInteger bits = k < 0 ? BigInteger.ONE.shiftLeft(shift).divide(power) : power.shiftLeft(shift);
                HIGH[k + MAX] = bits.shiftRight(Long.SIZE).longValue();
                LOW[k + MAX] = bits.longValue();
                EXPONENT[k + MAX] = exponent;
            }
        }
    }
}
