package simpleray.accel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares the boxes and splits of a tree with those computed from its primitives. */
class BvhBuilderTest {
    private static final long SEED = 2007;
    private static final int BINS = 16;
    private static final int FEW = 64;
    private static final int FEW_BINS = 8;
    private static final int MAX_LEAF = 8;
    private static final double VISIT = 1;
    /** The builder computes costs in floats, and adds them in another order. */
    private static final Offset<Double> ROUNDING = within(1e-4);

    private PrimitiveBounds bounds;
    private Bvh bvh;
    private int deepest;

    private void build(int threads, double[][] boxes) {
        try (Pool pool = new Pool(threads)) {
            bounds = Boxes.bounds(boxes, pool);
            bvh = Bvh.of(bounds, pool);
        }
        deepest = 0;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.3, 2})
    void eachNodeIsSplitAtTheLowestCostOrIsALeaf(double size) {
        Random random = new Random(SEED);
        for (int count : new int[] {2, 3, 5, 8, 9, 20, 100}) {
            for (int i = 0; i < 20; i++) {
                build(1, Boxes.random(random, count, size));

                assertThat(checked()).as("seed " + SEED).isEqualTo(count);
                assertThat(bounds.ids()).containsExactlyInAnyOrder(IntStream.range(0, count).toArray());
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void twoClustersFarApartBecomeTwoChildren(int axis) {
        double[] places = {100, 1, 101, 0, 102, 2, 100.5};
        build(1, IntStream.range(0, places.length).mapToObj(i -> cubeAt(axis, places[i])).toArray(double[][]::new));

        assertThat(Arrays.copyOf(bounds.ids(), 3)).containsExactlyInAnyOrder(1, 3, 5);
        assertThat(first(child(0, 0))).isZero();
        assertThat(first(child(0, 1))).isEqualTo(3);
        checked();
    }

    @Test
    void onePrimitiveIsALeafOfTheRoot() {
        build(1, new double[][] {{-1, 0, 0, 1, 5, 3}});

        assertThat(bvh.nodes).hasSize(Bvh.NODE);
        assertThat(bvh.count).isEqualTo(1);
        assertThat(child(0, 0)).isEqualTo(~1);
        assertThat(child(0, 1)).isZero();
        assertThat(box(0, 0)).containsExactly(Arrays.copyOf(bounds.sides, 6));
        assertThat(box(0, 1)).containsExactly(Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY,
            Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 8, 9, 17, 100})
    void boxesInOnePlaceAreHalvedDownToSmallLeaves(int count) {
        double[][] boxes = new double[count][];
        Arrays.fill(boxes, cubeAt(0, 3));
        build(1, boxes);

        assertThat(checked()).isEqualTo(count);
        assertThat(deepest).isEqualTo(count > 64 ? 4 : count > 16 ? 2 : 1);
    }

    /** Boxes of one middle, each half as large as the one before. */
    @Test
    void nestedBoxesAreHalved() {
        double[][] boxes = new double[500][];
        for (int i = 0; i < boxes.length; i++) {
            double half = Math.scalb(1.0, -i);
            boxes[i] = new double[] {-half, -half, -half, half, half, half};
        }
        build(1, boxes);

        assertThat(checked()).isEqualTo(500);
        assertThat(deepest).isLessThanOrEqualTo(Bvh.MAX_DEPTH);
    }

    /** Each box is as far from the next as all those after it are from each other, so that each split separates few. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-30, 1e30})
    void boxesAtExponentialDistancesMakeATreeOfBoundedDepth(double scale) {
        double[][] boxes = new double[2000][];
        for (int i = 0; i < boxes.length; i++) {
            double at = scale * Math.scalb(1.0, -i / 20);
            boxes[i] = new double[] {at, at, 0, at * 1.5, at * 1.5, 0};
        }
        build(1, boxes);

        assertThat(checked()).isEqualTo(2000);
        assertThat(deepest).isLessThanOrEqualTo(Bvh.MAX_DEPTH);
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void aMillionEqualBoxesMakeATreeOfBoundedDepth(int threads) {
        double[][] boxes = new double[1_000_000][];
        Arrays.fill(boxes, cubeAt(1, -7));
        build(threads, boxes);

        assertThat(count(0, 1)).isEqualTo(1_000_000);
        assertThat(deepest).isEqualTo(17);                    // 2^17 leaves of 8 at most
    }

    @Test
    void theTreeIsTheSameOnOneThreadAndOnSeveral() {
        double[][] boxes = Boxes.random(new Random(SEED), 100_000, 0.05);
        build(1, boxes);
        float[] nodes = bvh.nodes;
        int[] ids = bounds.ids();
        build(4, boxes);

        assertThat(Arrays.equals(bits(bvh.nodes), bits(nodes))).as("the same nodes").isTrue();
        assertThat(Arrays.equals(bounds.ids(), ids)).as("the same order").isTrue();
        assertThat(count(0, 1)).isEqualTo(100_000);
        checkBoxes(0);
    }

    private static int[] bits(float[] numbers) {
        int[] bits = new int[numbers.length];
        for (int i = 0; i < bits.length; i++) {
            bits[i] = Float.floatToRawIntBits(numbers[i]);
        }
        return bits;
    }

    /** {@return a unit cube at the origin, moved along an axis} */
    private static double[] cubeAt(int axis, double place) {
        double[] box = {0, 0, 0, 1, 1, 1};
        box[axis] += place;
        box[axis + 3] += place;
        return box;
    }

    private int child(int node, int which) {
        return Float.floatToRawIntBits(bvh.nodes[node + Bvh.CHILDREN + which]);
    }

    private float[] box(int node, int which) {
        float[] box = new float[6];
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = bvh.nodes[node + 4 * axis + which];
            box[axis + 3] = bvh.nodes[node + 4 * axis + 2 + which];
        }
        return box;
    }

    /** {@return the first primitive below a child} */
    private int first(int child) {
        return child < 0 ? ~child >> Bvh.COUNT_BITS : first(child(child, 0));
    }

    /** {@return how many primitives are below a node}, noting how deep it goes. */
    private int count(int node, int depth) {
        deepest = Math.max(deepest, depth);
        int count = 0;
        for (int i = 0; i < 2; i++) {
            int child = child(node, i);
            count += child > 0 ? count(child, depth + 1) : child == 0 ? 0 : ~child & Bvh.COUNT_MASK;
        }
        return count;
    }

    /** Checks that the boxes of a node and of all below it are those around their primitives; returns where these end. */
    private int checkBoxes(int node) {
        int end = 0;
        for (int i = 0; i < 2; i++) {
            int child = child(node, i);
            int first = first(child);
            end = child > 0 ? checkBoxes(child) : first + (~child & Bvh.COUNT_MASK);
            assertThat(Arrays.equals(box(node, i), around(first, end))).as("node %d, child %d", node, i).isTrue();
        }
        return end;
    }

    /** Checks the root and all below it; returns the number of primitives. */
    private int checked() {
        int only = child(0, 1) == 0 ? child(0, 0) : 0;
        if (only != 0) {
            deepest = 1;
            return checkedLeaf(only, box(0, 0));
        }
        return checked(0, 1);
    }

    private int checkedLeaf(int leaf, float[] box) {
        int first = ~leaf >> Bvh.COUNT_BITS;
        int count = ~leaf & Bvh.COUNT_MASK;
        assertThat(box).containsExactly(around(first, first + count));
        assertThat(count).isBetween(1, MAX_LEAF);
        assertThat((double) count).as("the cost of a leaf").isLessThanOrEqualTo(cheapestCut(first, first + count) + ROUNDING.value);
        return count;
    }

    private int checked(int node, int depth) {
        deepest = Math.max(deepest, depth);
        int[] counts = new int[2];
        for (int i = 0; i < 2; i++) {
            int child = child(node, i);
            counts[i] = child < 0 ? checkedLeaf(child, box(node, i)) : checked(child, depth + 1);
        }
        int first = first(child(node, 0));
        int middle = first + counts[0];
        int end = middle + counts[1];
        assertThat(first(child(node, 1))).isEqualTo(middle);
        assertThat(box(node, 0)).containsExactly(around(first, middle));
        assertThat(box(node, 1)).containsExactly(around(middle, end));
        double least = cheapestCut(first, end);
        if (least < Double.POSITIVE_INFINITY && depth < 60) {
            double cost = VISIT + (counts[0] * area(box(node, 0)) + counts[1] * area(box(node, 1))) / area(around(first, end));
            assertThat(cost).as("the cost of a cut").isEqualTo(least, ROUNDING);
            assertThat(end - first > MAX_LEAF || end - first > cost - ROUNDING.value).as("a cut where a leaf is dearer").isTrue();
        }
        return end - first;
    }

    /** {@return the lowest cost, by the surface area heuristic, of a split between two bins along the longest axis} */
    private double cheapestCut(int first, int end) {
        double least = Double.POSITIVE_INFINITY;
        int axis = 0;
        for (int other = 1; other < 3; other++) {
            axis = width(first, end, other) > width(first, end, axis) ? other : axis;
        }
        float low = Float.POSITIVE_INFINITY;
        for (int i = first; i < end; i++) {
            low = Math.min(low, middle(i, axis));
        }
        int bins = end - first < FEW ? FEW_BINS : BINS;
        float width = width(first, end, axis);
        for (int cut = 1; cut < bins && width > 0; cut++) {
            int[] counts = new int[2];
            float[][] boxes = {null, null};
            for (int i = first; i < end; i++) {
                int side = (middle(i, axis) - low) * (bins / width * 0.9999f) < cut ? 0 : 1;
                counts[side]++;
                boxes[side] = union(boxes[side], around(i, i + 1));
            }
            if (counts[0] > 0 && counts[1] > 0) {
                least = Math.min(least, counts[0] * area(boxes[0]) + counts[1] * area(boxes[1]));
            }
        }
        return VISIT + least / area(around(first, end));
    }

    private float width(int first, int end, int axis) {
        float low = Float.POSITIVE_INFINITY;
        float high = Float.NEGATIVE_INFINITY;
        for (int i = first; i < end; i++) {
            low = Math.min(low, middle(i, axis));
            high = Math.max(high, middle(i, axis));
        }
        return high - low;
    }

    /** {@return twice the middle of a box} */
    private float middle(int i, int axis) {
        return bounds.sides[6 * i + axis] + bounds.sides[6 * i + axis + 3];
    }

    private float[] around(int first, int end) {
        float[] box = null;
        for (int i = first; i < end; i++) {
            box = union(box, Arrays.copyOfRange(bounds.sides, 6 * i, 6 * i + 6));
        }
        return box;
    }

    private static float[] union(float[] box, float[] other) {
        if (box == null) {
            return other;
        }
        float[] both = new float[6];
        for (int axis = 0; axis < 3; axis++) {
            both[axis] = Math.min(box[axis], other[axis]);
            both[axis + 3] = Math.max(box[axis + 3], other[axis + 3]);
        }
        return both;
    }

    private static double area(float[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return x * y + y * z + z * x;
    }
}
