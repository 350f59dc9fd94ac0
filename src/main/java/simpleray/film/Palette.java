package simpleray.film;

import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The at most 256 colours that stand for all colours of a film. A film of no more colours keeps them. Of more, a histogram is cut into boxes:
 * again and again that of the largest variance, across the channel of the largest, at the mean. Each box becomes its mean (Heckbert, "Color image
 * quantization for frame buffer display", 1982; Wan, Wong and Prusinkiewicz, "An algorithm for multidimensional data clustering", 1988).
 * A pixel that is more than half transparent has a colour of its own, that is none. <em>Mutable,</em> for one thread.
 */
final class Palette {
    private static final int COLOURS = 256;
    private static final int OPAQUE = 0xFF000000;
    /** The least alpha of a pixel that is shown opaque. */
    private static final int MIN_ALPHA = 0x80;
    private static final int LEVELS = 0xFF;
    /** Bits of a channel in the histogram. */
    private static final int BITS = 6;
    private static final int SIDE = 1 << BITS;
    private static final int CHANNELS = 3;
    private static final byte UNKNOWN = 0;

    private final int[] exact = new int[COLOURS + 1];         // in order
    private int exactCount;                                   // more than COLOURS: there are too many
    private final long[] histogram = new long[SIDE * SIDE * SIDE];
    private boolean transparent;                              // some pixel is
    private int[] colours;                                    // of the palette, once it is made, without that of transparent pixels
    private boolean keepsAll;                                 // no colours are put together
    private final short[] nearest = new short[histogram.length];   // 1 more than the index; 0 if it is not known yet

    /** A part of the histogram: its cells, and their weight, mean and the variance along its widest channel. */
    private final class Box {
        final int[] cells;
        final double[] mean = new double[CHANNELS];
        int channel;
        double variance = -1;                                 // times the weight

        Box(int[] cells) {
            this.cells = cells;
            double weight = 0;
            double[] squares = new double[CHANNELS];
            for (int cell : cells) {
                double n = histogram[cell];
                weight += n;
                for (int c = 0; c < CHANNELS; c++) {
                    double level = level(cell, c);
                    mean[c] += n * level;
                    squares[c] += n * level * level;
                }
            }
            for (int c = 0; c < CHANNELS; c++) {
                mean[c] /= weight;
                double spread = squares[c] - weight * mean[c] * mean[c];
                if (spread > variance) {
                    variance = spread;
                    channel = c;
                }
            }
            if (cells.length == 1) {
                variance = -1;                                // it cannot be cut, whatever rounding says
            }
        }

        int[] part(boolean upper) {
            return Arrays.stream(cells).filter(cell -> level(cell, channel) > mean[channel] == upper).toArray();
        }

        int rgb() {
            return OPAQUE | (int) Math.round(mean[0]) << 16 | (int) Math.round(mean[1]) << 8 | (int) Math.round(mean[2]);
        }
    }

    /** Counts the colours of a frame. */
    void count(int[] pixels) {
        int last = 0;
        for (int pixel : pixels) {
            if (isTransparent(pixel)) {
                transparent = true;
                continue;
            }
            int rgb = pixel | OPAQUE;
            histogram[cell(rgb)]++;
            if (rgb != last && exactCount <= COLOURS) {
                keep(rgb);
            }
            last = rgb;
        }
    }

    private void keep(int rgb) {
        int at = Arrays.binarySearch(exact, 0, exactCount, rgb);
        if (at < 0) {
            int place = -at - 1;
            if (exactCount < exact.length) {
                System.arraycopy(exact, place, exact, place + 1, Math.min(exactCount, exact.length - 1) - place);
                exact[place] = rgb;
            }
            exactCount++;
        }
    }

    private static boolean isTransparent(int pixel) {
        return pixel >>> 24 < MIN_ALPHA;
    }

    /** Makes the palette of all colours that were counted. {@return it} */
    IndexColorModel make() {
        int most = transparent ? COLOURS - 1 : COLOURS;
        keepsAll = exactCount <= most;
        colours = keepsAll ? Arrays.copyOf(exact, exactCount) : cut(most);
        int[] all = transparent ? Arrays.copyOf(colours, colours.length + 1) : colours;
        return new IndexColorModel(Byte.SIZE, all.length, all, 0, false, transparent ? colours.length : -1, DataBuffer.TYPE_BYTE);
    }

    private int[] cut(int most) {
        int[] all = new int[histogram.length];
        int count = 0;
        for (int cell = 0; cell < histogram.length; cell++) {
            if (histogram[cell] > 0) {
                all[count++] = cell;
            }
        }
        List<Box> boxes = new ArrayList<>(List.of(new Box(Arrays.copyOf(all, count))));
        while (boxes.size() < Math.min(most, count)) {
            int widest = 0;
            for (int i = 1; i < boxes.size(); i++) {
                widest = boxes.get(i).variance > boxes.get(widest).variance ? i : widest;
            }
            Box box = boxes.get(widest);
            boxes.set(widest, new Box(box.part(false)));
            boxes.add(new Box(box.part(true)));
        }
        return boxes.stream().mapToInt(Box::rgb).toArray();
    }

    /** {@return the index of the palette's colour that is nearest to a colour} */
    int index(int pixel) {
        if (isTransparent(pixel)) {
            return colours.length;
        }
        int rgb = pixel | OPAQUE;
        if (keepsAll) {
            return Arrays.binarySearch(colours, rgb);
        }
        int cell = cell(rgb);
        if (nearest[cell] == UNKNOWN) {
            nearest[cell] = (short) (1 + nearest(cell));
        }
        return nearest[cell] - 1;
    }

    private int nearest(int cell) {
        int best = 0;
        int least = Integer.MAX_VALUE;
        for (int i = 0; i < colours.length; i++) {
            int sum = 0;
            for (int c = 0; c < CHANNELS; c++) {
                int difference = (colours[i] >> 16 - 8 * c & LEVELS) - level(cell, c);
                sum += difference * difference;
            }
            if (sum < least) {
                least = sum;
                best = i;
            }
        }
        return best;
    }

    private static int cell(int rgb) {
        int unused = Byte.SIZE - BITS;
        return (rgb >> 16 + unused & SIDE - 1) << 2 * BITS | (rgb >> 8 + unused & SIDE - 1) << BITS | rgb >> unused & SIDE - 1;
    }

    /** {@return the level, 0 to 255, of a channel of a cell} */
    private static int level(int cell, int channel) {
        return (cell >> (2 - channel) * BITS & SIDE - 1) * LEVELS / (SIDE - 1);
    }
}
