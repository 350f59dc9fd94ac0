package simpleray.cli;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import simpleray.text.NumberParser;

/**
 * Frames of a film, in their order. <em>Constant.</em>
 *
 * @param ranges ranges that neither overlap nor touch, one or more
 */
record FrameRanges(List<Range> ranges) {
    private static final int MAX_FRAME = 999_999;

    /** From one frame to another. */
    record Range(int first, int last) {
        int count() {
            return last - first + 1;
        }

        @Override
        public String toString() {
            return first + "-" + last;
        }
    }

    /** {@return all frames of a film} */
    static FrameRanges all(int count) {
        return new FrameRanges(List.of(new Range(0, count - 1)));
    }

    /**
     * Reads {@code 0-99,120}.
     *
     * @throws IllegalArgumentException if it cannot be read; the message says what was expected, and what was found
     */
    static FrameRanges parse(String text) {
        List<Range> asked = new ArrayList<>();
        for (String word : text.split(",", -1)) {
            int dash = word.indexOf('-');
            Long first = number(dash < 0 ? word : word.substring(0, dash));
            Long last = dash < 0 ? first : number(word.substring(dash + 1));
            if (first == null || last == null || first > last) {
                throw new IllegalArgumentException("expected frames such as 0-99,120, found '" + text + "'");
            }
            asked.add(new Range(first.intValue(), last.intValue()));
        }
        asked.sort(Comparator.comparingInt(Range::first));
        List<Range> joined = new ArrayList<>();
        for (Range range : asked) {
            Range before = joined.isEmpty() ? null : joined.get(joined.size() - 1);
            if (before != null && range.first <= before.last + 1) {
                joined.set(joined.size() - 1, new Range(before.first, Math.max(before.last, range.last)));
            } else {
                joined.add(range);
            }
        }
        return new FrameRanges(List.copyOf(joined));
    }

    private static Long number(String word) {
        return NumberParser.parseInteger(word, 0, MAX_FRAME);
    }

    /** {@return the number of frames} */
    int count() {
        return ranges.stream().mapToInt(Range::count).sum();
    }

    /** {@return the frame with so many before it} */
    int frame(int before) {
        int left = before;
        for (Range range : ranges) {
            if (left < range.count()) {
                return range.first + left;
            }
            left -= range.count();
        }
        throw new IndexOutOfBoundsException(before);
    }

    /** {@return the first frame} */
    int first() {
        return ranges.get(0).first;
    }

    /** {@return the last frame} */
    int last() {
        return ranges.get(ranges.size() - 1).last;
    }

    /** {@return the ranges, such as {@code 0-99,120-120}} */
    @Override
    public String toString() {
        return ranges.stream().map(Range::toString).collect(Collectors.joining(","));
    }
}
