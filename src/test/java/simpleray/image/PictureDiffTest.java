package simpleray.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Figures that follow from arithmetic. */
class PictureDiffTest {
    private static final double SMALL = 1e-12;

    private static byte[] row(int... levels) {
        byte[] row = new byte[levels.length];
        for (int i = 0; i < row.length; i++) {
            row[i] = (byte) levels[i];
        }
        return row;
    }

    private static byte[] plain(int width, int level) {
        byte[] row = new byte[3 * width];
        Arrays.fill(row, (byte) level);
        return row;
    }

    @Test
    void equalPicturesAreTheSameInEveryFigure() {
        PictureDiff same = new PictureDiff(40, 30, Picture.RGB);
        Random random = new Random(1);
        for (int y = 0; y < 30; y++) {
            byte[] row = new byte[120];
            random.nextBytes(row);
            assertThat(same.row(row, row.clone())).containsOnly(0);
        }

        assertThat(same.maximum()).isZero();
        assertThat(same.rmse()).isZero();
        assertThat(same.psnr()).isInfinite().isPositive();
        assertThat(same.ssim()).isEqualTo(1);
        assertThat(same.beyond(1)).isZero();
    }

    @Test
    void thePlainFiguresAreThoseOfAllLevels() {
        PictureDiff diff = new PictureDiff(2, 2, Picture.RGB);

        // differences 1, 0, 0 and 0, 2, 0; then 0, 0, 0 and 3, 4, 255
        assertThat(diff.row(row(10, 20, 30, 40, 50, 60), row(11, 20, 30, 40, 48, 60))).containsExactly(1, 2);
        assertThat(diff.row(row(0, 0, 0, 3, 4, 255), row(0, 0, 0, 0, 0, 0))).containsExactly(0, 255);

        assertThat(diff.maximum()).isEqualTo(255);
        assertThat(diff.beyond(1)).isEqualTo(2);
        assertThat(diff.pixels()).isEqualTo(4);
        double mean = (1 + 4 + 9 + 16 + 65025) / 12.0;
        assertThat(diff.rmse()).isEqualTo(Math.sqrt(mean), within(SMALL));
        assertThat(diff.psnr()).isEqualTo(10 * Math.log10(65025 / mean), within(SMALL));
    }

    @Test
    void pixelsThatAllDifferByTenHave28Decibels() {
        PictureDiff diff = new PictureDiff(1, 1, Picture.RGB);
        diff.row(plain(1, 100), plain(1, 110));

        assertThat(diff.rmse()).isEqualTo(10);
        assertThat(diff.psnr()).isEqualTo(28.13080360867, within(1e-10));   // 20 log 25.5
    }

    /** Without structure only the means count: (2ab + C1) / (a² + b² + C1), C1 = 2.55² = 6.5025. */
    @Test
    void theSimilarityOfTwoGreysIsThatOfTheirMeans() {
        for (int[] size : new int[][] {{1, 1}, {5, 20}, {20, 5}, {11, 11}, {31, 17}}) {
            PictureDiff diff = new PictureDiff(size[0], size[1], Picture.RGB);
            for (int y = 0; y < size[1]; y++) {
                diff.row(plain(size[0], 100), plain(size[0], 200));
            }
            assertThat(diff.ssim()).as(size[0] + "x" + size[1])
                .isEqualTo((2 * 100 * 200 + 6.5025) / (100 * 100 + 200 * 200 + 6.5025), within(1e-9));
        }
    }

    /**
     * Two pixels side by side weigh a half each. 0, 200 and 0, 100 have the means 100 and 50, the variances 10000 and 2500, the covariance
     * 5000; C2 = 7.65² = 58.5225.
     */
    @Test
    void theSimilarityOfTwoPixelsFollowsFromTheFormula() {
        PictureDiff diff = new PictureDiff(2, 1, Picture.RGB);
        diff.row(row(0, 0, 0, 200, 200, 200), row(0, 0, 0, 100, 100, 100));

        assertThat(diff.ssim()).isEqualTo((2 * 100 * 50 + 6.5025) * (2 * 5000 + 58.5225)
            / ((100 * 100 + 50 * 50 + 6.5025) * (10000 + 2500 + 58.5225)), within(1e-9));
    }

    /** In 12 x 11 pixels there are two windows, whose mean it is; by the formula of the paper, weight by weight. */
    @Test
    void theSimilarityIsTheMeanOverAllWindows() {
        byte[][] one = new byte[11][36];
        byte[][] other = new byte[11][36];
        Random random = new Random(2);
        PictureDiff diff = new PictureDiff(12, 11, Picture.RGB);
        for (int y = 0; y < 11; y++) {
            random.nextBytes(one[y]);
            random.nextBytes(other[y]);
            diff.row(one[y], other[y]);
        }

        assertThat(diff.ssim()).isEqualTo((window(one, other, 0) + window(one, other, 1)) / 2, within(1e-9));
    }

    private static double window(byte[][] one, byte[][] other, int from) {
        double weights = 0;
        double[] sums = new double[5];
        for (int y = 0; y < 11; y++) {
            for (int x = 0; x < 11; x++) {
                double weight = Math.exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / (2 * 1.5 * 1.5));
                double a = luma(one[y], from + x);
                double b = luma(other[y], from + x);
                weights += weight;
                double[] of = {a, b, a * a, b * b, a * b};
                for (int i = 0; i < 5; i++) {
                    sums[i] += weight * of[i];
                }
            }
        }
        double a = sums[0] / weights;
        double b = sums[1] / weights;
        return (2 * a * b + 6.5025) * (2 * (sums[4] / weights - a * b) + 58.5225)
            / ((a * a + b * b + 6.5025) * (sums[2] / weights - a * a + sums[3] / weights - b * b + 58.5225));
    }

    private static double luma(byte[] row, int x) {
        return 0.299 * (row[3 * x] & 0xFF) + 0.587 * (row[3 * x + 1] & 0xFF) + 0.114 * (row[3 * x + 2] & 0xFF);
    }
}
