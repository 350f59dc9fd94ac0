package simpleray.film;

import java.util.BitSet;
import simpleray.scene.Film;
import simpleray.text.NumberParser;

/** Frames by their numbers, such as {@code 0-99,120}. */
public final class FrameList {
    private FrameList() {
    }

    /**
     * Reads a list of frames.
     *
     * @param text numbers, and ranges of a first and a last one, between commas
     * @param wanted what messages call them
     * @return the numbers
     * @throws IllegalArgumentException if it is no such list; the message says what was expected, and what was found
     */
    public static BitSet parse(String text, String wanted) {
        BitSet frames = new BitSet();
        for (String part : text.split(",", -1)) {
            int dash = part.indexOf('-');
            Long first = number(dash < 0 ? part : part.substring(0, dash));
            Long last = dash < 0 ? first : number(part.substring(dash + 1));
            if (first == null || last == null || first > last) {
                throw new IllegalArgumentException("expected " + wanted + " such as 0-99,120, found '" + text + "'");
            }
            frames.set(first.intValue(), last.intValue() + 1);
        }
        return frames;
    }

    private static Long number(String text) {
        return NumberParser.parseInteger(text, 0, Film.MAX_FRAMES - 1);
    }
}
