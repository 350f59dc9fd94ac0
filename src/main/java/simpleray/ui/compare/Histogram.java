package simpleray.ui.compare;

/** How often each light occurs in a picture, for each channel. <em>Mutable</em> until it is whole. */
final class Histogram {
    /** The bins between 0 and 1. */
    static final int BINS = 256;
    /** Red, green and blue. */
    static final int CHANNELS = 3;

    private final long[][] counts = new long[CHANNELS][BINS];
    private final long[] below = new long[CHANNELS];
    private final long[] above = new long[CHANNELS];
    private final double[] sum = new double[CHANNELS];
    private final double[] least = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    private final double[] most = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
    private long pixels;
    private long clippedAbove;
    private long clippedBelow;

    /** Counts a pixel. 1 itself is in the last bin; NaN counts as below 0, since it is shown black. */
    void add(double red, double green, double blue) {
        add(0, red);
        add(1, green);
        add(2, blue);
        int flags = Clipped.flags(red, green, blue);
        clippedAbove += (flags & Clipped.ABOVE) != 0 ? 1 : 0;
        clippedBelow += (flags & Clipped.BELOW) != 0 ? 1 : 0;
        pixels++;
    }

    private void add(int channel, double light) {
        if (light > 1) {
            above[channel]++;
        } else if (light >= 0) {
            counts[channel][Math.min((int) (light * BINS), BINS - 1)]++;
        } else {
            below[channel]++;
        }
        sum[channel] += light;
        least[channel] = Math.min(least[channel], light);
        most[channel] = Math.max(most[channel], light);
    }

    /** {@return how many pixels have a light of bin / BINS to (bin + 1) / BINS} */
    long count(int channel, int bin) {
        return counts[channel][bin];
    }

    /** {@return how many pixels are below 0 in a channel} */
    long below(int channel) {
        return below[channel];
    }

    /** {@return how many pixels are above 1 in a channel} */
    long above(int channel) {
        return above[channel];
    }

    /** {@return the highest of all counts} */
    long highest() {
        long highest = 0;
        for (int c = 0; c < CHANNELS; c++) {
            highest = Math.max(highest, Math.max(below[c], above[c]));
            for (long count : counts[c]) {
                highest = Math.max(highest, count);
            }
        }
        return highest;
    }

    /** {@return the least light of a channel} */
    double least(int channel) {
        return least[channel];
    }

    /** {@return the most light of a channel} */
    double most(int channel) {
        return most[channel];
    }

    /** {@return the mean light of a channel} */
    double mean(int channel) {
        return sum[channel] / pixels;
    }

    /** {@return how many pixels are counted} */
    long pixels() {
        return pixels;
    }

    /** {@return how many pixels are above 1 in any channel} */
    long clippedAbove() {
        return clippedAbove;
    }

    /** {@return how many pixels are below 0 in any channel} */
    long clippedBelow() {
        return clippedBelow;
    }
}
