package simpleray.accel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simpleray.Sample;

class ShaftTest {
    private static final double[] ABOVE = {-1, 5, -1, 2, 0, 0, 0, 0, 2};

    private final int[] list = new int[64];
    private final Shaft shaft = new Shaft(list);

    /** {@return the boxes' numbers in the shaft from a point to a parallelogram: its corner, an edge and the other} */
    private int[] in(double[][] boxes, double x, double y, double z, double... p) {
        PrimitiveBounds bounds = Boxes.bounds(boxes);
        try (Pool pool = new Pool(1)) {
            Bvh bvh = Bvh.of(bounds, pool);
            shaft.set(0, x, y, z);
            shaft.set(1, p[0], p[1], p[2]);
            shaft.set(2, p[0] + p[3], p[1] + p[4], p[2] + p[5]);
            shaft.set(3, p[0] + p[3] + p[6], p[1] + p[4] + p[7], p[2] + p[5] + p[8]);
            shaft.set(4, p[0] + p[6], p[1] + p[7], p[2] + p[8]);
            int count = shaft.primitives(bvh);
            return count == Shaft.NO_LIST ? null : IntStream.range(0, count).map(i -> bounds.ids()[list[i]]).sorted().toArray();
        }
    }

    private static double[] cube(double x, double y, double z) {
        return new double[] {x - 0.1, y - 0.1, z - 0.1, x + 0.1, y + 0.1, z + 0.1};
    }

    /** Boxes that lie close together share a leaf of the tree, and are listed together; a box alone is not. */
    @Test
    void whatLiesBetweenIsListedAndWhatLiesBesideAboveOrBelowIsNot() {
        // from (0,0,0) to the square from -1 to 1 at y = 5: at height 2.5 the shaft reaches from -0.5 to 0.5
        double[][] boxes = {cube(0, 2.5, 0), cube(0.55, 2.5, 0), cube(-0.55, 2.5, -0.55), cube(0.65, 2.5, 0), cube(-0.65, 2.5, 0),
            cube(0, 2.5, 0.65), cube(0, 2.5, -0.65), cube(0, 5.05, 0), cube(0, 5.2, 0), cube(0, -0.05, 0), cube(0, -0.2, 0),
            cube(0.9, 4.9, 0.9), cube(9, 9, 9)};
        assertThat(in(boxes, 0, 0, 0, ABOVE)).contains(0, 1, 2, 7, 9, 11).doesNotContain(12);
        int[] alone = {0, 1, 2, 7, 9, 11};
        for (int i = 0; i < boxes.length - 1; i++) {
            int it = i;
            int[] found = in(new double[][] {boxes[i], cube(90, 90, 90)}, 0, 0, 0, ABOVE);
            assertThat(found.length == 0).as("box " + i).isEqualTo(IntStream.of(alone).noneMatch(k -> k == it));
        }
    }

    @Test
    void theOrderOfTheCornersDoesNotMatter() {
        double[][] boxes = {cube(0.55, 2.5, 0), cube(0, 2.5, 0.65), cube(90, 90, 90)};
        assertThat(in(boxes, 0, 0, 0, ABOVE)).contains(0);
        assertThat(in(boxes, 0, 0, 0, 1, 5, 1, 0, 0, -2, -2, 0, 0)).contains(0);
        assertThat(in(new double[][] {cube(0, 2.5, 0.65), cube(90, 90, 90)}, 0, 0, 0, 1, 5, 1, 0, 0, -2, -2, 0, 0)).isEmpty();
    }

    @Test
    void theListIsGivenUpIfItIsTooLong() {
        double[][] boxes = new double[65][];
        for (int i = 0; i < boxes.length; i++) {
            boxes[i] = cube(0, 0.5 + i / 20.0, 0);
        }
        assertThat(in(boxes, 0, 0, 0, ABOVE)).isNull();
        boxes[64] = cube(90, 90, 90);
        assertThat(in(boxes, 0, 0, 0, ABOVE)).hasSize(64);
    }

    @Test
    void fromTooFarAwayThereIsNoList() {
        double[][] boxes = {cube(0, 2.5, 0), cube(1, 2.5, 0)};
        assertThat(in(boxes, 0, 0, 1e5, ABOVE)).isNotNull();
        assertThat(in(boxes, 0, 0, 1e7, ABOVE)).isNull();
        assertThat(in(boxes, Double.NaN, 0, 0, ABOVE)).isNull();
        assertThat(in(boxes, 0, 0, 0, 0, 1e7, 0, 1, 0, 0, 0, 0, 1)).isNull();
    }

    /** No box that a ray enters on its way to any place of the parallelogram is missed, in any position and at any scale. */
    @Test
    void noBoxOnTheWayIsMissed() {
        Random random = new Random(1991);
        int found = 0;
        for (int i = 0; i < Sample.size(2000, 400); i++) {
            double[][] boxes = Boxes.random(random, 1 + random.nextInt(60), 0.5);
            double[] p = new double[9];
            for (int k = 0; k < 9; k++) {
                p[k] = random.nextInt(5) == 0 ? 0 : random.nextGaussian() * (k < 3 ? 4 : 2);
            }
            double[] from = {random.nextGaussian() * 4, random.nextGaussian() * 4, i % 3 == 0 ? p[2] : random.nextGaussian() * 4};
            if (i % 5 == 0) {                                 // in the very plane, or at a corner
                System.arraycopy(p, 0, from, 0, 3);
            }
            int[] in = in(boxes, from[0], from[1], from[2], p);
            for (int k = 0; in != null && k < 30; k++) {
                double u = k < 4 ? k & 1 : random.nextDouble();
                double v = k < 4 ? k >> 1 : random.nextDouble();
                double[] ray = {from[0], from[1], from[2], p[0] + u * p[3] + v * p[6] - from[0], p[1] + u * p[4] + v * p[7] - from[1],
                    p[2] + u * p[5] + v * p[8] - from[2]};
                for (int b = 0; b < boxes.length; b++) {
                    int box = b;
                    double t = Boxes.entry(boxes[b], ray);
                    if (t >= 0 && t <= 1) {
                        found++;
                        assertThat(IntStream.of(in).anyMatch(id -> id == box)).as("scene %d, box %d", i, b).isTrue();
                    }
                }
            }
        }
        assertThat(found).isGreaterThan(100);
    }
}
