package simpleray.text;

/**
 * Reads numbers as they mostly are from the bytes of a text, without making anything of them in between. <em>Mutable,</em> for one thread.
 *
 * <p>A number is known to end at a blank or a comment. Behind the last byte of the text stands one that is in no number, a 0 for instance.
 */
public final class Numerals {
    /** What {@link #readInteger} returns when there is none that it knows. */
    static final long NO_INTEGER = Long.MIN_VALUE;

    private static final int LONG_DIGITS = 18;
    private static final int UNSIGNED_LONG_DIGITS = 19;
    private static final int MAX_EXPONENT = 9999;

    private int end;

    /** Creates a reader of numbers. */
    public Numerals() {
    }

    /** {@return the index behind the number just read} */
    public int end() {
        return end;
    }

    /**
     * Reads a double.
     *
     * @param bytes the text
     * @param at where the number begins
     * @return the number, the nearest double; NaN if it is for {@link Numbers#parseDouble} to say what stands there
     */
    public double readDouble(byte[] bytes, int at) {
        int begin = at;
        boolean negative = bytes[begin] == '-';
        if (negative) {
            begin++;
        }
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
        double magnitude = count > 0 && count <= UNSIGNED_LONG_DIGITS && isWhole(bytes) ? Decimal.toDouble(digits, power)
            : unusual(bytes, begin, digits, count, power);
        return negative ? -magnitude : magnitude;
    }

    /** Goes on behind the digits: there is an exponent, or there are many zeros before the others; NaN if it is none of that. */
    private double unusual(byte[] bytes, int begin, long digits, int count, int power) {
        int significant = count > UNSIGNED_LONG_DIGITS ? count - zeros(bytes, begin, end) : count;
        boolean exponent = count > 0 && (bytes[end] == 'e' || bytes[end] == 'E');
        int sum = exponent ? power + readExponent(bytes, end + 1) : power;
        return count > 0 && significant <= UNSIGNED_LONG_DIGITS && isWhole(bytes) ? Decimal.toDouble(digits, sum) : Double.NaN;
    }

    /** Moves the end behind an exponent's digits; if there are none, or too many, it stays where no number ends. */
    private int readExponent(byte[] bytes, int from) {
        int i = from;
        boolean negative = bytes[i] == '-';
        if (negative || bytes[i] == '+') {
            i++;
        }
        int exponent = 0;
        int begin = i;
        while (isDigit(bytes[i]) && exponent < MAX_EXPONENT) {
            exponent = 10 * exponent + bytes[i++] - '0';
        }
        end = i > begin ? i : end;
        return negative ? -exponent : exponent;
    }

    /** {@return how many zeros a number begins with} */
    private static int zeros(byte[] bytes, int begin, int until) {
        int zeros = 0;
        for (int i = begin; i < until && (bytes[i] == '0' || bytes[i] == '.'); i++) {
            zeros += bytes[i] == '0' ? 1 : 0;
        }
        return zeros;
    }

    /** {@return the integer of up to 18 digits that begins there; {@link #NO_INTEGER} if there is none} */
    long readInteger(byte[] bytes, int at) {
        int begin = at;
        boolean negative = bytes[begin] == '-';
        if (negative) {
            begin++;
        }
        long value = 0;
        int i = begin;
        while (isDigit(bytes[i])) {
            value = 10 * value + bytes[i++] - '0';
        }
        end = i;
        if (i == begin || i - begin > LONG_DIGITS || !isWhole(bytes)) {
            return NO_INTEGER;
        }
        return negative ? -value : value;
    }

    private static boolean isDigit(byte b) {
        return b >= '0' && b <= '9';
    }

    /** {@return whether the word is known to end here} */
    private boolean isWhole(byte[] bytes) {
        return InputBuffer.isBlank(bytes[end]) || bytes[end] == Tokenizer.COMMENT;
    }
}
