package simpleray.text;

/**
 * A number too long for the memory, which is given character by character and becomes a short one of the same value. <em>Mutable.</em>
 *
 * <p>No double, and no point half-way between two, has more than 767 significant digits. Of the digits after the first thousand it matters
 * only whether one is not 0.
 */
final class LongNumber {
    private static final int MAX_DIGITS = 1000;
    /** No {@code long} has more. */
    private static final int LONG_DIGITS = 19;
    /** Larger than all exponents that make a difference. */
    private static final long MAX_EXPONENT = 100_000;
    private static final long MAX_WRITTEN = Long.MAX_VALUE / 100;

    private final StringBuilder digits = new StringBuilder();
    private boolean negative;
    private boolean more;            // a digit other than 0 follows those that are kept
    private boolean some;            // there is a digit where one is needed
    private long scale;              // the power of ten by which the digits are multiplied
    private long exponent;
    private boolean negativeExponent;
    private Part part = Part.START;

    private enum Part { START, WHOLE, FRACTION, EXPONENT_START, EXPONENT, WRONG }

    /** Appends a character of the word. */
    void add(char c) {
        if (c >= '0' && c <= '9') {
            digit(c);
        } else if ((c == '-' || c == '+') && part == Part.START) {
            negative = c == '-';
            part = Part.WHOLE;
        } else if (c == '.' && (part == Part.START || part == Part.WHOLE)) {
            part = Part.FRACTION;
        } else if ((c == 'e' || c == 'E') && some && (part == Part.WHOLE || part == Part.FRACTION)) {
            part = Part.EXPONENT_START;
            some = false;
        } else if ((c == '-' || c == '+') && part == Part.EXPONENT_START) {
            negativeExponent = c == '-';
            part = Part.EXPONENT;
        } else {
            part = Part.WRONG;
        }
    }

    /** {@return whether it is no number, whatever follows} */
    boolean isWrong() {
        return part == Part.WRONG;
    }

    /** {@return whether it is no {@code long}, whatever follows} */
    boolean isNoLong() {
        return part != Part.START && part != Part.WHOLE || digits.length() + scale > LONG_DIGITS;
    }

    private void digit(char c) {
        some = true;
        if (part == Part.EXPONENT_START || part == Part.EXPONENT) {
            part = Part.EXPONENT;
            exponent = Math.min(MAX_WRITTEN, 10 * exponent + c - '0');
            return;
        }
        if (part == Part.START) {
            part = Part.WHOLE;
        }
        boolean kept = digits.length() < MAX_DIGITS && (c != '0' || !digits.isEmpty());
        if (kept) {
            digits.append(c);
        } else {
            more |= c != '0';
        }
        if (part == Part.FRACTION && (kept || digits.isEmpty())) {
            scale--;
        } else if (part == Part.WHOLE && !kept && !digits.isEmpty()) {
            scale++;
        }
    }

    /** {@return a number of the same value, an integer if this is one, of at most about a thousand characters; "" if this is no number} */
    @Override
    public String toString() {
        if (!some || part == Part.WRONG) {
            return "";
        }
        String shown = (negative ? "-" : "") + (digits.isEmpty() ? "0" : digits);
        if (part == Part.WHOLE && scale == 0) {
            return shown;
        }
        // one more digit stands for all that were dropped
        long power = scale + (negativeExponent ? -exponent : exponent) - (more ? 1 : 0);
        return shown + (more ? "1" : "") + 'e' + Math.max(-MAX_EXPONENT, Math.min(MAX_EXPONENT, power));
    }
}
