package simpleray.film;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The name of the pictures of a film, with a place for the frame's number: {@code %d}, or {@code %04d} for four digits at least; {@code %%}
 * is a per cent sign. <em>Constant.</em>
 */
public final class FramePattern {
    /** No number has more digits, so that the name stays one that a file can have. */
    private static final int MAX_DIGITS = 20;
    private static final Pattern PLACE = Pattern.compile("%(?:%|(?:0(\\d{1,2}))?d)");

    private final String text;

    /**
     * Takes a pattern.
     *
     * @param text the name
     * @throws IllegalArgumentException if it does not have one place for a number; the message says so
     */
    public FramePattern(String text) {
        this.text = text;
        int places = 0;
        int end = 0;
        Matcher place = PLACE.matcher(text);
        for (int at = text.indexOf('%'); at >= 0; at = text.indexOf('%', end)) {
            if (!place.find(at) || place.start() != at || place.group(1) != null && Integer.parseInt(place.group(1)) > MAX_DIGITS) {
                throw fault("has a % that stands for no number");
            }
            places += place.group().equals("%%") ? 0 : 1;
            end = place.end();
        }
        if (places != 1) {
            throw fault("has " + (places == 0 ? "no place" : places + " places") + " for the frame's number");
        }
    }

    private IllegalArgumentException fault(String what) {
        return new IllegalArgumentException("the output " + text + ' ' + what
            + ": expected one such as film.%04d.png (%% is a per cent sign), or a .gif, .apng, .mp4 or .webm");
    }

    /**
     * Returns the name of a frame's picture.
     *
     * @param frame its number, 0 or more
     * @return the name
     */
    public String name(int frame) {
        return PLACE.matcher(text).replaceAll(place -> {
            String name = place.group().equals("%%") ? "%" : String.format(Locale.ROOT, place.group(), frame);
            return Matcher.quoteReplacement(name);
        });
    }

    @Override
    public String toString() {
        return text;
    }
}
