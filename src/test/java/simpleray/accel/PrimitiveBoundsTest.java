package simpleray.accel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PrimitiveBoundsTest {
    private static final long SEED = 2013;

    @Test
    void theUnitIsTheLargestCoordinateAboutTheMiddle() {
        PrimitiveBounds bounds = Boxes.bounds(new double[] {0, 10, -1, 2, 11, 1}, new double[] {6, 12, 0, 8, 14, 0});

        assertThat(bounds.middle).containsExactly(4, 12, 0);
        assertThat(bounds.extent).isEqualTo(4 * (1 + PrimitiveBounds.PAD));
        assertThat(bounds.reach()).isEqualTo(1e6 * bounds.extent);
        assertThat(bounds.count()).isEqualTo(2);
        assertThat(bounds.ids()).containsExactly(0, 1);
    }

    @ParameterizedTest
    @CsvSource({"1, 0", "1, 1e3", "1, 1e9", "1e-30, 0", "1e30, 0", "1e-3, 1e5", "0, 0", "0, 5"})
    void eachBoxIsALittleLargerThanItsPrimitive(double scale, double away) {
        Random random = new Random(SEED);
        double[][] boxes = Boxes.random(random, 200, 1);
        for (double[] box : boxes) {
            for (int k = 0; k < 6; k++) {
                box[k] = box[k] * scale + away;
            }
        }
        PrimitiveBounds bounds = Boxes.bounds(boxes);

        double pad = Math.max(PrimitiveBounds.PAD, away * 0x1p-40 / bounds.extent);
        for (int i = 0; i < boxes.length; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double low = (boxes[i][axis] - bounds.middle[axis]) / bounds.extent;
                double high = (boxes[i][axis + 3] - bounds.middle[axis]) / bounds.extent;
                assertThat(low - bounds.sides[6 * i + axis]).isBetween(0.8 * pad, 1.2 * pad);
                assertThat(bounds.sides[6 * i + axis + 3] - high).isBetween(0.8 * pad, 1.2 * pad);
                assertThat(bounds.sides[6 * i + axis]).isGreaterThanOrEqualTo(-1);
                assertThat(bounds.sides[6 * i + axis + 3]).isLessThanOrEqualTo(1);
            }
        }
    }

    @Test
    void theExtentOfASinglePointIsNotZero() {
        PrimitiveBounds bounds = Boxes.bounds(new double[6]);

        assertThat(bounds.extent).isPositive();
        float pad = (float) (PrimitiveBounds.PAD / (1 + PrimitiveBounds.PAD));
        assertThat(bounds.sides).containsExactly(-pad, -pad, -pad, pad, pad, pad);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 5})
    void severalThreadsMakeTheSameBoxes(int threads) {
        double[][] boxes = Boxes.random(new Random(SEED), 200_000, 1);
        PrimitiveBounds one = Boxes.bounds(boxes);
        try (Pool pool = new Pool(threads)) {
            PrimitiveBounds several = Boxes.bounds(boxes, pool);

            assertThat(several.middle).containsExactly(one.middle);
            assertThat(several.extent).isEqualTo(one.extent);
            assertThat(Arrays.equals(several.sides, one.sides)).isTrue();
        }
    }

    @Test
    void onlyTheGivenPrimitivesCount() {
        double[][] boxes = {{0, 0, 0, 1, 1, 1}, {100, 100, 100, 101, 101, 101}, {2, 2, 2, 3, 3, 3}};
        try (Pool pool = new Pool(1)) {
            PrimitiveBounds bounds = new PrimitiveBounds(new int[] {2, 0}, (i, box) -> System.arraycopy(boxes[i], 0, box, 0, 6), pool);

            assertThat(bounds.middle).containsExactly(1.5, 1.5, 1.5);
            assertThat(bounds.sides[0]).as("that of 2 comes first").isPositive();
            assertThat(bounds.sides[6]).isNegative();
        }
    }

    @Test
    void swappedBoxesKeepTheirPrimitives() {
        PrimitiveBounds bounds = Boxes.bounds(new double[] {0, 0, 0, 1, 1, 1}, new double[] {2, 2, 2, 3, 3, 3});
        float[] first = Arrays.copyOf(bounds.sides, 6);
        bounds.swap(0, 1);

        assertThat(bounds.ids()).containsExactly(1, 0);
        assertThat(Arrays.copyOfRange(bounds.sides, 6, 12)).containsExactly(first);
        assertThat(bounds.sides[0]).isPositive();
    }

    @Test
    void reorderMovesEachBoxFromItsOldIndex() {
        double[][] boxes = new double[7][];
        for (int i = 0; i < boxes.length; i++) {
            boxes[i] = new double[] {i, 0, 0, i, 0, 0};
        }
        PrimitiveBounds bounds = Boxes.bounds(boxes);
        float[] sides = bounds.sides.clone();
        int[] order = {3, 1, 0, 2, 6, 4, 5};                  // a round of three, one that stays, and another of three
        bounds.reorder(order.clone());

        assertThat(bounds.ids()).containsExactly(order);
        for (int i = 0; i < order.length; i++) {
            assertThat(Arrays.copyOfRange(bounds.sides, 6 * i, 6 * i + 6))
                .containsExactly(Arrays.copyOfRange(sides, 6 * order[i], 6 * order[i] + 6));
        }
    }
}
