package simpleray.image;

/** Measures how two pictures of one size differ, row by row. <em>Mutable,</em> for one thread. */
public final class PictureDiff {
    private static final int LEVEL = 255;

    private final Similarity similarity;
    private final long pixels;
    private int maximum;
    private long beyond;
    private double squares;

    /**
     * Begins a comparison.
     *
     * @param width the width of both in pixels
     * @param height the height of both in pixels
     */
    public PictureDiff(int width, int height) {
        similarity = new Similarity(width, height);
        pixels = (long) width * height;
    }

    /**
     * Adds the next row of both pictures.
     *
     * @param one red, green and blue of each pixel of one picture
     * @param other red, green and blue of each pixel of the other
     * @return for each pixel the largest of its three differences
     */
    public int[] row(byte[] one, byte[] other) {
        int[] differences = new int[one.length / 3];
        for (int x = 0; x < differences.length; x++) {
            int largest = 0;
            for (int i = 3 * x; i < 3 * x + 3; i++) {
                int by = Math.abs((one[i] & LEVEL) - (other[i] & LEVEL));
                squares += by * by;
                largest = Math.max(largest, by);
            }
            differences[x] = largest;
            maximum = Math.max(maximum, largest);
            beyond += largest > 1 ? 1 : 0;
        }
        similarity.row(one, other);
        return differences;
    }

    /** {@return the largest difference of a level} */
    public int maximum() {
        return maximum;
    }

    /** {@return the number of pixels with a level that differs by more than 1} */
    public long beyondOneLevel() {
        return beyond;
    }

    /** {@return the number of pixels of each picture} */
    public long pixels() {
        return pixels;
    }

    /** {@return the root mean square error of all levels, RMSE} */
    public double rmse() {
        return Math.sqrt(squares / (3.0 * pixels));
    }

    /** {@return the peak signal-to-noise ratio, PSNR, in decibels; infinite for equal pictures} */
    public double psnr() {
        return 20 * Math.log10(LEVEL / rmse());
    }

    /** {@return the structural similarity of their luma: 1 for equal pictures} Wang et al., 2004, with the Gaussian window of 11 x 11. */
    public double ssim() {
        return similarity.value();
    }
}
