package simpleray.cli;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.stream.Collectors;
import simpleray.film.FrameList;

/**
 * Frames of a film, in their order. <em>Constant.</em>
 *
 * @param ranges ranges that neither overlap nor touch, one or more
 */
record FrameRanges(List<Range> ranges) {
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
        BitSet frames = FrameList.parse(text, "frames");
        List<Range> ranges = new ArrayList<>();
        for (int first = frames.nextSetBit(0); first >= 0; first = frames.nextSetBit(ranges.get(ranges.size() - 1).last + 1)) {
            ranges.add(new Range(first, frames.nextClearBit(first) - 1));
        }
        return new FrameRanges(List.copyOf(ranges));
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
