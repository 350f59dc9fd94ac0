package simpleray.image;

/**
 * The structural similarity of two pictures, SSIM (Wang, Bovik, Sheikh and Simoncelli, "Image quality assessment: from error visibility to
 * structural similarity", 2004): of their luma, on black where they are transparent, in windows of 11 x 11 pixels weighted by a Gaussian of
 * 1.5 pixels, K1 = 0.01, K2 = 0.03, its mean over all windows that lie within the picture. In a smaller picture the window is smaller, too.
 * <em>Mutable,</em> for one thread.
 */
final class Similarity {
    private static final int WINDOW = 11;
    private static final double SIGMA = 1.5;
    private static final double C1 = 0.01 * 255 * 0.01 * 255;
    private static final double C2 = 0.03 * 255 * 0.03 * 255;
    /** The means taken: of a, b, a², b² and ab. */
    private static final int MEANS = 5;

    private final double[] across;
    private final double[] down;
    private final int width;
    private final int windows;                                // side by side
    private final double[][] rows;                            // the means across of the latest rows, each at its number modulo the window's
    private int taken;
    private double sum;

    Similarity(int width, int height) {
        this.width = width;
        across = gaussian(Math.min(WINDOW, width));
        down = gaussian(Math.min(WINDOW, height));
        windows = width - across.length + 1;
        rows = new double[down.length][MEANS * windows];
    }

    private static double[] gaussian(int n) {
        double[] weights = new double[n];
        double all = 0;
        for (int i = 0; i < n; i++) {
            double d = i - (n - 1) / 2.0;
            weights[i] = Math.exp(-d * d / (2 * SIGMA * SIGMA));
            all += weights[i];
        }
        for (int i = 0; i < n; i++) {
            weights[i] /= all;
        }
        return weights;
    }

    /** Adds the next row of both pictures. */
    void row(byte[] one, byte[] other) {
        double[] a = luma(one);
        double[] b = luma(other);
        double[] means = rows[taken++ % down.length];
        for (int x = 0; x < windows; x++) {
            double ma = 0;
            double mb = 0;
            double maa = 0;
            double mbb = 0;
            double mab = 0;
            for (int i = 0; i < across.length; i++) {
                double wa = across[i] * a[x + i];
                double wb = across[i] * b[x + i];
                ma += wa;
                mb += wb;
                maa += wa * a[x + i];
                mbb += wb * b[x + i];
                mab += wa * b[x + i];
            }
            int at = MEANS * x;
            means[at] = ma;
            means[at + 1] = mb;
            means[at + 2] = maa;
            means[at + 3] = mbb;
            means[at + 4] = mab;
        }
        if (taken >= down.length) {
            for (int x = 0; x < windows; x++) {
                sum += window(MEANS * x);
            }
        }
    }

    /** {@return the luma of each pixel of a row, by ITU-R BT.601} */
    private double[] luma(byte[] row) {
        int pixel = row.length / width;
        double[] luma = new double[width];
        for (int x = 0, i = 0; x < width; x++, i += pixel) {
            luma[x] = 0.299 * (row[i] & 0xFF) + 0.587 * (row[i + 1] & 0xFF) + 0.114 * (row[i + 2] & 0xFF);
            if (pixel == Picture.RGBA) {
                luma[x] *= (row[i + Picture.RGB] & 0xFF) / 255.0;
            }
        }
        return luma;
    }

    private double window(int at) {
        double[] mean = new double[MEANS];
        for (int i = 0; i < down.length; i++) {
            double[] row = rows[(taken + i) % down.length];   // the oldest first
            for (int k = 0; k < MEANS; k++) {
                mean[k] += down[i] * row[at + k];
            }
        }
        double aa = mean[0] * mean[0];
        double bb = mean[1] * mean[1];
        double ab = mean[0] * mean[1];
        return (2 * ab + C1) * (2 * (mean[4] - ab) + C2) / ((aa + bb + C1) * (mean[2] - aa + (mean[3] - bb) + C2));
    }

    /** {@return the mean of all rows, to be called after the last: 1 for equal pictures, less for others} */
    double value() {
        return sum / ((double) windows * (taken - down.length + 1));
    }
}
