package simpleray.accel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class BvhTraversalTest extends TraversalTest {
    private static final long SEED = 2013;
    /** From x = 1, y = 2, z = 3 to 2, 4, 6. */
    private static final double[] BOX = {1, 2, 3, 2, 4, 6};

    private Bvh bvh;
    private BvhTraversal traversal;

    BvhTraversalTest() {
        super(SEED);
    }

    @Override
    void build(PrimitiveBounds bounds, Pool pool) {
        bvh = Bvh.of(bounds, pool);
        traversal = new BvhTraversal(walked);
    }

    @Override
    void traverseClosest(double[] ray, double limit) {
        traversal.closest(bvh, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5], limit);
    }

    @Override
    boolean traverseOccluded(double[] ray, double distance) {
        return traversal.occluded(bvh, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5], distance);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-300, 1e-30, 1e-3, 1e3, 1e30, 1e300})
    void theLengthOfTheDirectionDoesNotMatter(double length) {
        Random random = new Random(SEED);
        build(Boxes.withTwins(random, 200, 0.5));
        int hits = 0;
        for (int i = 0; i < 1000; i++) {
            hits += compared(Boxes.scaled(Boxes.ray(random, boxes), length), "seed " + SEED + ", ray " + i) ? 1 : 0;
        }
        assertThat(hits).isGreaterThan(300);
    }

    @ParameterizedTest
    @CsvSource({"1e-30, 0", "1e30, 0", "1, 1e6", "1e-3, 1e5", "1e-100, 1e-95"})
    void theScaleAndTheDistanceFromTheOriginDoNotMatter(double scale, double away) {
        Random random = new Random(SEED);
        double[][] unit = Boxes.withTwins(random, 200, 0.5);
        double[][] moved = new double[unit.length][6];
        for (int i = 0; i < unit.length; i++) {
            for (int k = 0; k < 6; k++) {
                moved[i][k] = unit[i][k] * scale + away;
            }
        }
        build(moved);
        int hits = 0;
        for (int i = 0; i < 2000; i++) {
            double[] ray = Boxes.ray(random, unit);
            for (int axis = 0; axis < 3; axis++) {
                ray[axis] = ray[axis] * scale + away;
                ray[axis + 3] *= scale;
            }
            hits += compared(ray, "seed " + SEED + ", ray " + i) ? 1 : 0;
        }
        assertThat(hits).isGreaterThan(500);
    }

    /** Components of a direction that are as little as 1e-300 of another. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-18, 1e-21, 1e-40, 1e-310, Double.MIN_VALUE})
    void tinyComponentsOfADirectionDoNoHarm(double tiny) {
        build(BOX, new double[] {-4, -4, -4, -3, -3, -3});
        for (double sign : new double[] {1, -1}) {
            assertThat(compared(new double[] {1.5, 3, 0, sign * tiny, -sign * tiny, 1}, "inside")).isTrue();
            assertThat(compared(new double[] {2, 4, 0, -tiny, -tiny, 1}, "along an edge")).isTrue();
            assertThat(compared(new double[] {2.1, 4, 0, sign * tiny, 0, 1}, "beside")).isFalse();
        }
    }

    @ParameterizedTest
    @CsvSource({
        "0, 3, 4,  1, 0, 0,  1",
        "3, 3, 4, -1, 0, 0,  1",
        "3, 3, 4,  1, 0, 0,  Infinity",
        "1.5, 0, 4,  0, 0.5, 0,  4",
        "1.5, 8, 4,  0, -2, 0,  2",
        "1.5, 0, 4,  0, -1, 0,  Infinity",
        "1.5, 3, 0,  0, 0, 1,  3",
        "1.5, 3, 9,  0, 0, -1,  3",
        "1.5, 3, 0,  0, 0, -1,  Infinity",
        "1.5, 3, 4,  1, 2, 3,  0",
        "1, 2, 3,  -1, -1, -1,  0",
        "2, 3, 5,  1, 0, 0,  0",
        "0, 2, 4,  1, 0, 0,  1",
        "0, 4, 6,  1, 0, -0.0,  1",
        "2, 4, 0,  0, 0, 1,  3",
        "0, 1, 2,  1, 1, 1,  1",
        "0, 6, 7,  1, -2, -1,  1",
        "0, 3, 9,  1, 0, 0,  Infinity",
        "0, 5, 4,  1, 0, 0,  Infinity",
        "9, 3, 4,  0, 0, 1,  Infinity",
    })
    void aRayEntersABoxOrMissesIt(double x, double y, double z, double dx, double dy, double dz, double entry) {
        build(BOX, new double[] {-9, -9, -9, -8, -8, -8});
        closest(new double[] {x, y, z, dx, dy, dz}, INFINITY);

        assertThat(walked.t).isEqualTo(entry);
        assertThat(walked.id).isEqualTo(entry < INFINITY ? 0 : BoxIntersector.NONE);
    }

    @Test
    void twoBoxesInOnePlaceAreBothTested() {
        build(BOX, BOX.clone(), BOX.clone());
        closest(new double[] {0, 3, 4, 1, 0, 0}, INFINITY);

        assertThat(walked.tests).isEqualTo(3);
        assertThat(walked.id).isZero();
    }

    /** A hit at the limit itself counts: its object may come earlier in the scene. */
    @Test
    void primitivesBeyondTheLimitAreNotTested() {
        build(BOX, new double[] {-9, 3, 4, -8, 5, 6});
        double[] ray = {0, 3, 4, 1, 0, 0};

        closest(ray, 1);
        assertThat(walked.id).isZero();
        assertThat(occluded(ray, 1)).isFalse();
        assertThat(occluded(ray, 1.001)).isTrue();
        walked.tests = 0;
        closest(ray, 0.99);
        assertThat(walked.tests).isZero();
        assertThat(occluded(ray, 0.99)).isFalse();
        assertThat(walked.tests).isZero();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e5, 1e7, 1e9, 1e15})
    void aRayFromFarAwayHitsOrMisses(double far) {
        build(BOX, new double[] {-2, -4, -6, -1, -2, -3});
        assertThat(compared(new double[] {-far, 3, 4, 1, 0, 0}, "towards the box")).isTrue();
        for (double[] ray : new double[][] {{-far, 3, 4, -1, 0, 0}, {-far, 3, 40_000 + far / 1e5, 1, 0, 0}}) {
            long steps = traversal.steps;
            walked.tests = 0;
            assertThat(compared(ray, "away or past")).isFalse();
            assertThat(walked.tests).as("nothing is tested for it").isZero();
            assertThat(traversal.steps).as("it has no way in the tree").isEqualTo(steps);
        }
    }

    /** A ray with NaN hits nothing, and does no harm. */
    @Test
    void aRayWithoutNumbersTestsAll() {
        build(BOX, new double[] {-9, -9, -9, -8, -8, -8});
        closest(new double[] {Double.NaN, 3, 4, 1, 0, 0}, INFINITY);

        assertThat(walked.tests).isEqualTo(2);
    }

    @Test
    void mostBoxesAreNotTested() {
        Random random = new Random(SEED);
        build(Boxes.random(random, 4000, 0.1));
        for (int i = 0; i < 1000; i++) {
            double[] ray = {20, 0, 0, -20 + random.nextGaussian(), random.nextGaussian() * 2, random.nextGaussian() * 3};
            closest(ray, INFINITY);
        }

        assertThat(walked.tests / 1000).as("boxes a ray").isLessThan(20);
        assertThat(traversal.steps / 1000).as("nodes a ray").isBetween(5L, 60L);
    }

    /** Records the leaves that are tested, and hits nothing. */
    private static final class Leaves implements PrimitiveIntersector {
        final List<Integer> shown = new ArrayList<>();
        boolean all;
        double t;

        @Override
        public double closest(int[] list, int first, int end) {
            shown.add(first);
            all |= end - first > Bvh.COUNT_MASK;
            return t;
        }

        @Override
        public boolean occluded(int[] list, int first, int end) {
            shown.add(first);
            all |= end - first > Bvh.COUNT_MASK;
            return false;
        }
    }

    /** Leaves that the ray enters only beyond the limit are not tested; leaves that it barely misses may be. */
    @Test
    void theTestedLeavesAreThoseThatTheRayEntersBeforeTheLimit() {
        Random random = new Random(SEED);
        build(Boxes.random(random, 400, 0.3));
        Leaves leaves = new Leaves();
        traversal = new BvhTraversal(leaves);
        int shown = 0;
        for (int i = 0; i < 3000; i++) {
            double[] ray = Boxes.ray(random, boxes);
            double limit = i % 3 == 0 ? INFINITY : random.nextDouble();
            Set<Integer> all = leavesEntered(ray, limit, -1e-5);
            Set<Integer> almost = leavesEntered(ray, limit, 1e-5);
            for (boolean shadow : new boolean[] {false, true}) {
                leaves.shown.clear();
                leaves.all = false;
                leaves.t = limit;
                long steps = traversal.steps;
                if (shadow) {
                    traversal.occluded(bvh, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5], limit);
                } else {
                    traversal.closest(bvh, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5], limit);
                }
                if (!leaves.all) {                            // from farther away all are tested at once
                    assertThat(leaves.shown).as("seed " + SEED + ", ray " + i).doesNotHaveDuplicates().containsAll(all).isSubsetOf(almost);
                    assertThat(traversal.steps - steps).isBetween(all.isEmpty() ? 0L : nodesEntered(0, ray, limit, -1e-5),
                        (long) nodesEntered(0, ray, limit, 1e-5));
                }
                shown += leaves.shown.size();
            }
        }
        assertThat(shown).isGreaterThan(2500);
    }

    /** {@return the first primitives of the leaves whose boxes a ray enters, made larger by a share of the extent} */
    private Set<Integer> leavesEntered(double[] ray, double limit, double larger) {
        Set<Integer> leaves = new HashSet<>();
        for (int node = 0; node < bvh.nodes.length; node += Bvh.NODE) {
            for (int i = 0; i < 2; i++) {
                int child = Float.floatToRawIntBits(bvh.nodes[node + Bvh.CHILDREN + i]);
                if (child < 0 && enters(node, i, ray, limit, larger)) {
                    leaves.add(~child >> Bvh.COUNT_BITS);
                }
            }
        }
        return leaves;
    }

    /** {@return the number of nodes from this one down whose boxes a ray enters} */
    private int nodesEntered(int node, double[] ray, double limit, double larger) {
        int count = 1;
        for (int i = 0; i < 2; i++) {
            int child = Float.floatToRawIntBits(bvh.nodes[node + Bvh.CHILDREN + i]);
            count += child > 0 && enters(node, i, ray, limit, larger) ? nodesEntered(child, ray, limit, larger) : 0;
        }
        return count;
    }

    private boolean enters(int node, int child, double[] ray, double limit, double larger) {
        double[] box = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = bvh.middle[axis] + bvh.extent * (bvh.nodes[node + 4 * axis + child] - larger);
            box[axis + 3] = bvh.middle[axis] + bvh.extent * (bvh.nodes[node + 4 * axis + 2 + child] + larger);
        }
        double entry = Boxes.entry(box, ray);
        double fastest = Math.max(Math.abs(ray[3]), Math.max(Math.abs(ray[4]), Math.abs(ray[5])));
        return entry >= 0 && entry <= limit * (1 + larger) + larger * bvh.extent / fastest;
    }

    /** Of two leaves far apart, eight boxes in each. */
    @Test
    void theNearerChildIsTestedFirstAndTheOtherOnlyIfItIsNearEnough() {
        double[][] heaps = new double[16][];
        for (int i = 0; i < 16; i++) {
            heaps[i] = new double[] {i < 8 ? 0 : 100, 0, 0, i < 8 ? 1 : 101, 1, 1};
        }
        build(heaps);
        Leaves leaves = new Leaves();
        traversal = new BvhTraversal(leaves);
        for (boolean fromLeft : new boolean[] {true, false}) {
            for (double t : new double[] {INFINITY, 50}) {
                leaves.shown.clear();
                leaves.t = t;
                traversal.closest(bvh, fromLeft ? -10 : 111, 0.5, 0.5, fromLeft ? 1 : -1, 0, 0, INFINITY);
                int near = fromLeft ? 0 : 8;
                assertThat(leaves.shown).containsExactly(t == 50 ? new Integer[] {near} : new Integer[] {near, 8 - near});
            }
            leaves.shown.clear();
            traversal.occluded(bvh, fromLeft ? -10 : 111, 0.5, 0.5, fromLeft ? 1 : -1, 0, 0, INFINITY);
            assertThat(leaves.shown).containsExactly(fromLeft ? 0 : 8, fromLeft ? 8 : 0);
        }
    }
}
