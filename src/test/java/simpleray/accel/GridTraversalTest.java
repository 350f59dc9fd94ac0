package simpleray.accel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

class GridTraversalTest extends TraversalTest {
    private static final long SEED = 1987;

    private GridTraversal traversal;

    GridTraversalTest() {
        super(SEED);
    }

    @Override
    void build(PrimitiveBounds bounds, Pool pool) {
        traversal = new GridTraversal(UniformGrid.of(bounds, true, pool).fill(), walked);
    }

    @Override
    void traverseClosest(double[] ray, double limit) {
        traversal.closest(ray(ray), limit);
    }

    @Override
    boolean traverseOccluded(double[] ray, double distance) {
        return traversal.occluded(ray(ray), distance);
    }

    private static Ray ray(double[] numbers) {
        return new Ray(new Point(numbers[0], numbers[1], numbers[2]), new Vector(numbers[3], numbers[4], numbers[5]));
    }

    /** The eight corners of a cube of 27 cells: through its middle there are three, and nothing in them. */
    @ParameterizedTest
    @CsvSource({"-9, 0, 0, 1, 0, 0, 3", "0, 9, 0, 0, -1, 0, 3", "0, 0, -9, 0, 0, 1, 3", "0, 0, 0, 1, 0, 0, 2", "0, 0, 0, 0, 0, -1, 2",
        "-9, 9, 0, 1, -1, 0, 5", "-9, 1.1, 0, 1, 0, 0, 0", "0, -9, 0, 1, 0, 0, 0", "0, 0, 9, 0, 0, 1, 0", "-1.5, -1.25, 0, 1, 1, 0, 5",
        "-3, -2, 0, 1, 1, 0, 3", "0, -3, -2, 0, 1, 1, 3", "-2, 0, -3, 1, 0, 1, 3"})
    void aRayVisitsTheCellsOnItsWay(double x, double y, double z, double dx, double dy, double dz, int cells) {
        double[][] corners = new double[8][];
        for (int i = 0; i < 8; i++) {
            double[] at = {(i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2) * 2 - 1};
            corners[i] = new double[] {at[0], at[1], at[2], at[0], at[1], at[2]};
        }
        build(corners);
        closest(new double[] {x, y, z, dx, dy, dz}, INFINITY);

        assertThat(traversal.steps).isEqualTo(cells);
        assertThat(walked.id).isEqualTo(BoxIntersector.NONE);
    }

    @Test
    void noCellIsVisitedBehindTheNearestHitOrTheLimit() {
        double[][] row = new double[100][];
        for (int i = 0; i < 100; i++) {
            row[i] = new double[] {i, -0.1, -0.1, i + 0.2, 0.1, 0.1};
        }
        build(row);
        closest(new double[] {-9, 0, 0, 1, 0, 0}, INFINITY);
        assertThat(walked.t).isEqualTo(9);
        assertThat(walked.tests).isLessThanOrEqualTo(2);
        assertThat(traversal.steps).isLessThanOrEqualTo(2);

        walked.tests = 0;
        closest(new double[] {-9, 0, 0, 1, 0, 0}, 8.9);
        assertThat(walked.tests).isZero();
        assertThat(occluded(new double[] {0.5, 0, 0, 1, 0, 0}, 0.5)).isFalse();
        assertThat(occluded(new double[] {0.5, 0, 0, 1, 0, 0}, 0.51)).isTrue();
        assertThat(walked.tests).isLessThan(8);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-18, 1e-40, 1e-300, 1e-310, Double.MIN_VALUE})
    void tinyComponentsOfADirectionDoNoHarm(double tiny) {
        Random random = new Random(SEED);
        for (double scale : new double[] {1, 1e10}) {
            double[][] many = Boxes.random(random, 100, 0.5);
            for (double[] box : many) {
                for (int k = 0; k < 6; k++) {
                    box[k] *= scale;
                }
            }
            build(many);
            PrimitiveBounds bounds = Boxes.bounds(boxes);
            for (int i = 0; i < 300; i++) {
                double[] box = boxes[i % boxes.length];
                double sign = i % 2 == 0 ? 1 : -1;
                boolean middle = i % 3 == 0;
                double x = middle ? bounds.middle[0] : (box[0] + box[3]) / 2;
                boolean hit = compared(new double[] {x, (box[1] + box[4]) / 2, -20 * scale, sign * tiny, tiny, 1}, "ray " + i);
                assertThat(hit || middle).isTrue();
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e5, 1e7, 1e9, 1e15})
    void aRayFromFarAwayHitsOrMisses(double far) {
        build(new double[] {1, 2, 3, 2, 4, 6}, new double[] {-2, -4, -6, -1, -2, -3});
        assertThat(compared(new double[] {-far, 3, 4, 1, 0, 0}, "towards the box")).isTrue();
        assertThat(compared(new double[] {-far, 3, 4, -1, 0, 0}, "away from it")).isFalse();
        assertThat(compared(new double[] {-far, 3, 40_000, 1, 0, 0}, "past it")).isFalse();
    }

    /** The distance of a ray's origin is measured from the middle of the boxes, in extents. */
    @ParameterizedTest
    @CsvSource({"1e4, 0, 0, 1", "0, 1e4, 0, 1", "0, 0, 1e4, 1", "0, 0, 0, 1e-3", "0, 0, 0, 1e3"})
    void onlyARayFromMoreThanAMillionExtentsTestsAll(double x, double y, double z, double scale) {
        double size = x + y + z > 0 ? 1e-3 : scale;
        build(new double[] {x - size, y - size, z - size, x, y, z}, new double[] {x, y, z, x + size, y + size, z + size});
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                for (double extents : new double[] {0.9e6, 1.1e6}) {
                    double[] ray = {x, y, z, 0, 0, 0};
                    ray[axis] += side * extents * size;
                    ray[axis + 3] = -side;
                    long steps = traversal.steps;
                    assertThat(compared(ray, "axis " + axis)).isTrue();
                    if (extents < 1e6) {
                        assertThat(traversal.steps).isGreaterThan(steps);
                    } else {
                        assertThat(traversal.steps).isEqualTo(steps);
                    }
                }
            }
        }
    }
}
