package simpleray.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

class PngFilterTest {
    private static final long SEED = 1996;
    private static final byte[] NOTHING_ABOVE = new byte[9];

    @Test
    void aRowOfSmallNumbersStaysAsItIs() {
        // the sum of none, 3, is less than those of the differences
        assertThat(PngFilter.best(bytes(1, 0, 0, 0, 1, 0, 1, 0, 0), NOTHING_ABOVE))
            .containsExactly(0, 1, 0, 0, 0, 1, 0, 1, 0, 0);
    }

    @Test
    void aRowOfOneColourIsPredictedFromItsLeft() {
        assertThat(PngFilter.best(bytes(90, 80, 70, 90, 80, 70, 90, 80, 70), NOTHING_ABOVE))
            .containsExactly(1, 90, 80, 70, 0, 0, 0, 0, 0, 0);
    }

    @Test
    void aRowLikeTheOneAboveIsPredictedFromIt() {
        byte[] row = bytes(200, 10, 90, 3, 250, 77, 128, 0, 255);
        assertThat(PngFilter.best(row, row)).containsExactly(2, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    }

    @Test
    void aRowOfMeansIsPredictedFromTheMeanOfLeftAndAbove() {
        // 0 and 100: 50; 50 and 201: 125, rounded down; 125 and 255: 190
        assertThat(PngFilter.best(bytes(50, 50, 50, 125, 125, 125, 190, 190, 190), bytes(100, 100, 100, 201, 201, 201, 255, 255, 255)))
            .containsExactly(3, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    }

    @Test
    void anEdgeIsPredictedByPaeth() {
        // nearest to left + above - above left: 0+10-0 is above, 10+10-10 any of them (190 more is -66), 200+10-10 is left
        assertThat(PngFilter.best(bytes(10, 10, 10, 200, 200, 200, 200, 200, 200), bytes(10, 10, 10, 10, 10, 10, 10, 10, 10)))
            .containsExactly(4, 0, 0, 0, -66, -66, -66, 0, 0, 0);
    }

    @Test
    void whateverIsChosenTheRowComesBack() {
        Random random = new Random(SEED);
        boolean[] chosen = new boolean[5];
        for (int i = 0; i < 20_000; i++) {
            byte[] row = new byte[9];
            byte[] above = new byte[9];
            int amplitude = 1 + random.nextInt(128);
            for (int k = 0; k < row.length; k++) {
                above[k] = (byte) ((k < 3 ? 128 : above[k - 3]) + random.nextInt(amplitude));
                row[k] = (byte) (above[k] + random.nextInt(amplitude));
            }
            byte[] filtered = PngFilter.best(row, above);
            chosen[filtered[0]] = true;
            assertThat(unfiltered(filtered, above)).as("seed " + SEED + ", sample " + i).isEqualTo(row);
        }
        assertThat(chosen).as("filters chosen, seed " + SEED).containsExactly(true, true, true, true, true);
    }

    /** Undoes a filter as the PNG specification has it, section 9.2. */
    private static byte[] unfiltered(byte[] filtered, byte[] above) {
        byte[] row = new byte[above.length];
        for (int i = 0; i < row.length; i++) {
            int a = i < 3 ? 0 : row[i - 3] & 0xFF;
            int b = above[i] & 0xFF;
            int c = i < 3 ? 0 : above[i - 3] & 0xFF;
            int p = a + b - c;
            int nearest = Math.min(Math.abs(p - a), Math.min(Math.abs(p - b), Math.abs(p - c)));
            int paeth = nearest == Math.abs(p - a) ? a : nearest == Math.abs(p - b) ? b : c;
            int[] predictions = {0, a, b, (a + b) / 2, paeth};
            row[i] = (byte) (filtered[i + 1] + predictions[filtered[0]]);
        }
        return row;
    }

    private static byte[] bytes(int... values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            bytes[i] = (byte) values[i];
        }
        return bytes;
    }
}
