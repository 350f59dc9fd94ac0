package simpleray.cli;

import java.util.Arrays;
import java.util.Locale;
import simpleray.film.FrameRate;
import simpleray.math.Point;
import simpleray.render.Region;
import simpleray.scene.Film;
import simpleray.text.NumberParser;

/** The values of options. What cannot be read is an IllegalArgumentException that says what was expected, and what was found. */
final class Values {
    private static final double FARTHEST = 1e100;

    private Values() {
    }

    /** Reads {@code 120,80}. */
    static ExplainCommand.Pixel pixel(String value) {
        int comma = value.indexOf(',');
        Long x = comma < 0 ? null : NumberParser.parseInteger(value.substring(0, comma), 0, Integer.MAX_VALUE);
        Long y = comma < 0 ? null : NumberParser.parseInteger(value.substring(comma + 1), 0, Integer.MAX_VALUE);
        if (x == null || y == null) {
            throw expected("two integers from 0 such as 120,80", value);
        }
        return new ExplainCommand.Pixel(x.intValue(), y.intValue());
    }

    /** Reads {@code 4,2.5,-1}. */
    static Point point(String value) {
        String[] words = value.split(",", -1);
        double[] n = new double[3];
        for (int i = 0; i < n.length; i++) {
            n[i] = words.length == n.length ? NumberParser.parseDouble(words[i]) : Double.NaN;
            if (!(Math.abs(n[i]) <= FARTHEST)) {
                throw expected("three numbers such as 4,2.5,-1", value);
            }
        }
        return new Point(n[0], n[1], n[2]);
    }

    /** Reads {@code 100,50,64,48}. */
    static Region region(String value) {
        String[] words = value.split(",", -1);
        int[] n = new int[4];
        for (int i = 0; i < n.length; i++) {
            Long number = words.length == n.length ? NumberParser.parseInteger(words[i], Integer.MIN_VALUE, Integer.MAX_VALUE) : null;
            if (number == null) {
                throw expected("four whole numbers such as 100,50,64,48", value);
            }
            n[i] = number.intValue();
        }
        return new Region(n[0], n[1], n[2], n[3]);
    }

    /** Reads {@code 25}, {@code 29.97} or {@code 30000/1001}. */
    static FrameRate rate(String value) {
        int slash = value.indexOf('/');
        double over = slash < 0 ? 1 : NumberParser.parseDouble(value.substring(slash + 1));
        double rate = NumberParser.parseDouble(slash < 0 ? value : value.substring(0, slash)) / over;
        if (!(rate > 0 && rate <= Film.MAX_RATE)) {
            throw expected("frames a second above 0 and at most 1000, such as 25 or 30000/1001", value);
        }
        return new FrameRate(rate);
    }

    /** Reads one of these, whatever its case. */
    static <T> T constant(T[] all, String value) {
        for (T one : all) {
            if (one.toString().equals(value.toLowerCase(Locale.ROOT))) {
                return one;
            }
        }
        throw expected("one of " + Arrays.toString(all), value);
    }

    private static IllegalArgumentException expected(String wanted, String found) {
        return new IllegalArgumentException("expected " + wanted + ", found '" + found + "'");
    }
}
