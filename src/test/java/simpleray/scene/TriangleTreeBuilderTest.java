package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The boxes of a tree, held against boxes and costs that are found anew from its triangles. */
class TriangleTreeBuilderTest {
    private static final long SEED = 2007;
    private static final int SLICES = 16;
    private static final int MOST_IN_LEAF = 6;
    private static final double VISIT = 1.2;
    private static final Offset<Double> ROUNDING = within(1e-9);

    private Triangles triangles;
    private TriangleTreeBuilder tree;
    private int deepest;

    private void build(double... vertices) {
        triangles = new Triangles(vertices, IntStream.range(0, vertices.length / 3).toArray(), new double[0], null);
        tree = new TriangleTreeBuilder(triangles);
    }

    /** {@return the vertices of small triangles at these places along an axis, and of none elsewhere} */
    private static double[] along(int axis, double... places) {
        double[] v = new double[9 * places.length];
        for (int i = 0; i < places.length; i++) {
            v[9 * i + 3 + (axis + 1) % 3] = 1;
            v[9 * i + 6 + (axis + 2) % 3] = 1;
            for (int corner = 0; corner < 3; corner++) {
                v[9 * i + 3 * corner + axis] += places[i];
            }
        }
        return v;
    }

    private static double[] soup(Random random, int count, double size) {
        double[] v = new double[9 * count];
        for (int i = 0; i < v.length; i++) {
            v[i] = i % 9 < 3 ? random.nextGaussian() * (1 + i % 3) : v[i - i % 9 + i % 3] + random.nextGaussian() * size;
        }
        return v;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.3, 2})
    void eachBoxIsCutWhereThatIsCheapestOrNotAtAll(double size) {
        Random random = new Random(SEED);
        for (int count : new int[] {2, 3, 5, 6, 7, 20, 100}) {
            for (int i = 0; i < 20; i++) {
                build(soup(random, count, size));
                assertThat(checked(0, 0)).as("seed " + SEED).isEqualTo(count);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void twoHeapsFarApartComeIntoTwoBoxes(int axis) {
        build(along(axis, 100, 1, 101, 0, 102, 2, 100.5));

        int child = tree.first()[0];
        assertThat(Arrays.copyOf(tree.order, 3)).containsExactlyInAnyOrder(1, 3, 5);
        assertThat(box(child)[axis + 3]).isEqualTo(2);
        assertThat(box(child + 1)[axis]).isEqualTo(100);
        assertThat(checked(child, 1)).isEqualTo(3);
        assertThat(checked(child + 1, 1)).isEqualTo(4);
    }

    @Test
    void oneTriangleIsOneBox() {
        build(1, 2, 3, -1, 5, 3, 0, 0, 0);

        assertThat(tree.counts()).containsExactly(1);
        assertThat(tree.boxes()).containsExactly(-1, 0, 0, 1, 5, 3);
    }

    @Test
    void ofNoTriangleThereIsNoBox() {
        build();

        assertThat(tree.boxes()).isEmpty();
        assertThat(tree.first()).isEmpty();
        assertThat(tree.counts()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 6, 7, 13, 100})
    void trianglesInOnePlaceAreHalvedUntilTheyAreFew(int count) {
        build(along(0, new double[count]));

        assertThat(checked(0, 0)).isEqualTo(count);
        assertThat(deepest).isEqualTo(count > 96 ? 5 : count > 12 ? 2 : count > 6 ? 1 : 0);
    }

    /** Checks a node and all below it; returns the number of its triangles. */
    private int checked(int node, int depth) {
        deepest = Math.max(deepest, depth);
        int count = tree.counts()[node];
        int first = tree.first()[node];
        if (count > 0) {
            int[] held = Arrays.copyOfRange(tree.order, first, first + count);
            assertThat(box(node)).containsExactly(around(held));
            assertThat(count).isLessThanOrEqualTo(MOST_IN_LEAF);
            assertThat((double) count).as("the cost of a leaf").isLessThanOrEqualTo(cheapestCut(held) + 1e-9);
            return count;
        }
        int one = checked(first, depth + 1);
        int other = checked(first + 1, depth + 1);
        int from = leftmost(first);
        int[] held = Arrays.copyOfRange(tree.order, from, from + one + other);
        assertThat(box(node)).containsExactly(around(held));
        if (cheapestCut(held) < Double.POSITIVE_INFINITY) {
            double cost = VISIT + (one * area(box(first)) + other * area(box(first + 1))) / area(box(node));
            assertThat(cost).as("the cost of a cut").isEqualTo(cheapestCut(held), ROUNDING);
            assertThat(held.length > MOST_IN_LEAF || held.length > cost - 1e-9).as("a cut where a leaf is dearer").isTrue();
        }
        return one + other;
    }

    private int leftmost(int node) {
        return tree.counts()[node] > 0 ? tree.first()[node] : leftmost(tree.first()[node]);
    }

    private double[] box(int node) {
        return Arrays.copyOfRange(tree.boxes(), 6 * node, 6 * node + 6);
    }

    /** {@return what a cut between two of the slices along an axis costs at least, as the surface area heuristic has it} */
    private double cheapestCut(int[] held) {
        double least = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            int a = axis;
            double low = Arrays.stream(held).mapToDouble(i -> centre(i, a)).min().orElseThrow();
            double high = Arrays.stream(held).mapToDouble(i -> centre(i, a)).max().orElseThrow();
            for (int slice = 1; slice < SLICES && high > low; slice++) {
                int s = slice;
                int[] below = Arrays.stream(held).filter(i -> (centre(i, a) - low) / (high - low) * SLICES < s).toArray();
                int[] above = Arrays.stream(held).filter(i -> (centre(i, a) - low) / (high - low) * SLICES >= s).toArray();
                least = Math.min(least, below.length * area(around(below)) + above.length * area(around(above)));
            }
        }
        return VISIT + least / area(around(held));
    }

    /** {@return twice the middle of a triangle's box} */
    private double centre(int triangle, int axis) {
        double[] box = around(triangle);
        return box[axis] + box[axis + 3];
    }

    private double[] around(int... held) {
        double[] box = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            int a = axis;
            box[axis] = Arrays.stream(held).flatMap(i -> IntStream.range(3 * i, 3 * i + 3))
                .mapToDouble(v -> triangles.vertices()[3 * v + a]).min().orElseThrow();
            box[axis + 3] = Arrays.stream(held).flatMap(i -> IntStream.range(3 * i, 3 * i + 3))
                .mapToDouble(v -> triangles.vertices()[3 * v + a]).max().orElseThrow();
        }
        return box;
    }

    private static double area(double[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return x * y + y * z + z * x;
    }
}
