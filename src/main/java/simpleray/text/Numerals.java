package simpleray.text;

/**
 * Reads numbers as they mostly are, from the bytes in a {@link Window} and without making anything of them in between.
 * <em>Mutable,</em> for one thread.
 */
final class Numerals {
    /** What {@link #readInteger} returns when there is none that it knows. */
    static final long NO_INTEGER = Long.MIN_VALUE;

    private static final int LONG_DIGITS = 18;
    private static final int UNSIGNED_LONG_DIGITS = 19;
    private static final int MOST_EXPONENT = 9999;

    private final Window window;
    private int end;

    /** Creates a reader of the numbers in a window. */
    Numerals(Window window) {
        this.window = window;
    }

    /** {@return the index behind the number just read} */
    int end() {
        return end;
    }

    /** {@return the double that stands next in the window; NaN if it is for {@link Numbers#parseDouble} to say what stands there} */
    double readDouble() {
        byte[] bytes = window.bytes;                          // behind them is a 0, and no number goes on
        int begin = window.at;
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
        double magnitude = count > 0 && count <= UNSIGNED_LONG_DIGITS && isWhole() ? Decimal.toDouble(digits, power)
            : unusual(begin, digits, count, power);
        return negative ? -magnitude : magnitude;
    }

    /** Goes on behind the digits: there is an exponent, or there are many zeros before the others; NaN if it is none of that. */
    private double unusual(int begin, long digits, int count, int power) {
        int significant = count > UNSIGNED_LONG_DIGITS ? count - zeros(begin, end) : count;
        boolean exponent = count > 0 && (window.bytes[end] == 'e' || window.bytes[end] == 'E');
        int sum = exponent ? power + readExponent(end + 1) : power;
        return count > 0 && significant <= UNSIGNED_LONG_DIGITS && isWhole() ? Decimal.toDouble(digits, sum) : Double.NaN;
    }

    /** Moves the end behind an exponent's digits; if there are none, or too many, it stays where no number ends. */
    private int readExponent(int from) {
        byte[] bytes = window.bytes;
        int i = from;
        boolean negative = bytes[i] == '-';
        if (negative || bytes[i] == '+') {
            i++;
        }
        int exponent = 0;
        int begin = i;
        while (isDigit(bytes[i]) && exponent < MOST_EXPONENT) {
            exponent = 10 * exponent + bytes[i++] - '0';
        }
        end = i > begin ? i : end;
        return negative ? -exponent : exponent;
    }

    /** {@return how many zeros a number begins with} */
    private int zeros(int begin, int until) {
        int zeros = 0;
        for (int i = begin; i < until && (window.bytes[i] == '0' || window.bytes[i] == '.'); i++) {
            zeros += window.bytes[i] == '0' ? 1 : 0;
        }
        return zeros;
    }

    /** {@return the integer of up to 18 digits that stands next in the window; {@link #NO_INTEGER} if there is none} */
    long readInteger() {
        byte[] bytes = window.bytes;
        int begin = window.at;
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
        if (i == begin || i - begin > LONG_DIGITS || !isWhole()) {
            return NO_INTEGER;
        }
        return negative ? -value : value;
    }

    private static boolean isDigit(byte b) {
        return b >= '0' && b <= '9';
    }

    /** {@return whether the word is known to end here} */
    private boolean isWhole() {
        return Window.isBlank(window.bytes[end]) || window.bytes[end] == Words.COMMENT;
    }
}
