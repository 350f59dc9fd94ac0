package simpleray.image;

import java.util.Arrays;

/** Measures how two pictures of one size differ, row by row. <em>Mutable,</em> for one thread. */
public final class PictureDiff {
    private static final int LEVEL = 255;

    private final Similarity similarity;
    private final int width;
    private final int channels;
    private final long pixels;
    private final long[] counts = new long[LEVEL + 1];        // of pixels with each difference
    private double squares;

    /**
     * Begins a comparison.
     *
     * @param width the width of both in pixels
     * @param height the height of both in pixels
     * @param channels the numbers of a pixel that are compared: {@link Picture#RGBA} if a picture has alpha, {@link Picture#RGB} if none has
     */
    public PictureDiff(int width, int height, int channels) {
        this.width = width;
        this.channels = channels;
        similarity = new Similarity(width, height);
        pixels = (long) width * height;
    }

    /**
     * Adds the next row of both pictures.
     *
     * @param one red, green and blue of each pixel of one picture, and its alpha if there is any; without, it is opaque
     * @param other those of the other
     * @return for each pixel the largest of its differences
     */
    public int[] row(byte[] one, byte[] other) {
        int[] differences = new int[width];
        for (int x = 0; x < width; x++) {
            int largest = 0;
            for (int c = 0; c < channels; c++) {
                int by = Math.abs(level(one, x, c) - level(other, x, c));
                squares += by * by;
                largest = Math.max(largest, by);
            }
            differences[x] = largest;
            counts[largest]++;
        }
        similarity.row(one, other);
        return differences;
    }

    private int level(byte[] row, int x, int channel) {
        int pixel = row.length / width;
        return channel < pixel ? row[pixel * x + channel] & LEVEL : LEVEL;
    }

    /** {@return the largest difference of a level} */
    public int maximum() {
        int maximum = LEVEL;
        while (maximum > 0 && counts[maximum] == 0) {
            maximum--;
        }
        return maximum;
    }

    /**
     * Counts pixels.
     *
     * @param levels 0 to 255
     * @return the number of pixels with a level that differs by more
     */
    public long beyond(int levels) {
        return Arrays.stream(counts, levels + 1, counts.length).sum();
    }

    /** {@return the number of pixels of each picture} */
    public long pixels() {
        return pixels;
    }

    /** {@return the root mean square error of all levels, RMSE} */
    public double rmse() {
        return Math.sqrt(squares / ((double) channels * pixels));
    }

    /** {@return the peak signal-to-noise ratio, PSNR, in decibels; infinite for equal pictures} */
    public double psnr() {
        return 20 * Math.log10(LEVEL / rmse());
    }

    /**
     * {@return the structural similarity of their luma, on black where they are transparent: 1 for equal pictures} Wang et al., 2004, with the
     * Gaussian window of 11 x 11.
     */
    public double ssim() {
        return similarity.value();
    }
}
