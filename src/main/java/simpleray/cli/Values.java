package simpleray.cli;

import java.util.Arrays;
import java.util.Locale;
import simpleray.math.Colour;
import simpleray.render.Region;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.SceneSettings.Window;
import simpleray.text.NumberParser;

/** The values of options. What cannot be read is an IllegalArgumentException that says what was expected, and what was found. */
final class Values {
    private Values() {
    }

    /** Reads {@code 640x480}. */
    static Resolution size(String value) {
        int x = Math.max(value.indexOf('x'), value.indexOf('X'));
        Long width = x < 0 ? null : NumberParser.parseInteger(value.substring(0, x), 1, SceneSettings.MAX_RESOLUTION);
        Long height = x < 0 ? null : NumberParser.parseInteger(value.substring(x + 1), 1, SceneSettings.MAX_RESOLUTION);
        if (width == null || height == null) {
            throw expected("WxH such as 640x480, 1 to " + SceneSettings.MAX_RESOLUTION + " each", value);
        }
        return new Resolution(width.intValue(), height.intValue());
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

    /** Reads a number as a scene file has it. */
    static double number(String value) {
        double number = NumberParser.parseDouble(value);
        if (Double.isNaN(number)) {
            throw expected("a number", value);
        }
        return number;
    }

    /** Reads {@code -2,2,-2,2}. */
    static Window window(String value) {
        double[] n = numbers(value, 4, "four numbers such as -2,2,-2,2");
        return new Window(n[0], n[1], n[2], n[3]);
    }

    /** Reads {@code 3,2,5,0,0,0,40}. */
    static Pose camera(String value) {
        double[] n = numbers(value, 7, "seven numbers such as 3,2,5,0,0,0,40");
        Pose pose = new Pose(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
        if (pose.fault() != null) {
            throw expected("a " + pose.fault(), value);
        }
        return pose;
    }

    /** Reads {@code 0.1,0.2,0.4}. */
    static Colour colour(String value) {
        double[] n = numbers(value, 3, "three numbers such as 0.1,0.2,0.4");
        if (n[0] < 0 || n[1] < 0 || n[2] < 0) {
            throw expected("numbers of 0 or more", value);
        }
        return new Colour(n[0], n[1], n[2]);
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

    /** Reads one of these, whatever its case. */
    static <T> T constant(T[] all, String value) {
        for (T one : all) {
            if (one.toString().equals(value.toLowerCase(Locale.ROOT))) {
                return one;
            }
        }
        throw expected("one of " + Arrays.toString(all), value);
    }

    private static double[] numbers(String value, int count, String wanted) {
        String[] words = value.split(",", -1);
        double[] numbers = new double[count];
        for (int i = 0; i < count; i++) {
            numbers[i] = words.length == count ? NumberParser.parseDouble(words[i]) : Double.NaN;
            if (Double.isNaN(numbers[i])) {
                throw expected(wanted, value);
            }
        }
        return numbers;
    }

    private static IllegalArgumentException expected(String wanted, String found) {
        return new IllegalArgumentException("expected " + wanted + ", found '" + found + "'");
    }
}
