package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where a ray enters the box of a tree's node. */
class TriangleBoxTest {
    private static final long SEED = 20130711;
    /** More than the box is padded by and what is rounded, less than anything that could be seen. */
    private static final double ROUNDINGS = 1e-9;
    /** Its box goes from 1, 2, 3 to 2, 4, 6. */
    private static final double[] CORNERS = {1, 2, 6, 2, 2, 3, 1, 4, 3};

    private final TriangleTree tree = new TriangleTree(new Triangles(CORNERS, new int[] {0, 1, 2}, new double[0], null));

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
        "0, 3, 9,  1, 0, 0,  Infinity",
        "0, 5, 4,  1, 0, 0,  Infinity",
        "0, 1, 4,  1, 0, 0,  Infinity",
        "9, 3, 4,  0, 0, 1,  Infinity",
    })
    void aRayEntersItOrMissesIt(double x, double y, double z, double dx, double dy, double dz, double entry) {
        assertThat(entered(x, y, z, dx, dy, dz)).isBetween(entry - ROUNDINGS, entry);
    }

    /** Along a side, an edge or through a corner it is not missed. */
    @ParameterizedTest
    @CsvSource({
        "0, 2, 4,  1, 0, 0,  1",
        "0, 4, 6,  1, 0, -0.0,  1",
        "0, 2, 3,  1, -0.0, 0,  1",
        "2, 0, 3,  0, 1, 0,  2",
        "1, 9, 6,  -0.0, -1, 0,  5",
        "2, 4, 0,  0, 0, 1,  3",
        "0, 1, 2,  1, 1, 1,  1",
        "0, 5, 5,  1, -1, 1,  1",
        "0, 6, 7,  1, -2, -1,  1",
    })
    void itsSidesBelongToIt(double x, double y, double z, double dx, double dy, double dz, double entry) {
        assertThat(entered(x, y, z, dx, dy, dz)).isBetween(entry - ROUNDINGS, entry);
    }

    /** However the ray goes: the stretches between the box's three pairs of sides overlap, or it is missed. */
    @Test
    void theLastOfThreeSidesIsWhereItIsEntered() {
        double[] low = {1, 2, 3};
        double[] high = {2, 4, 6};
        Random random = new Random(SEED);
        int hits = 0;
        for (int i = 0; i < 5000; i++) {
            double[] from = random.doubles(3, -4, 10).toArray();
            double[] by = new double[3];
            double near = 0;
            double far = Double.POSITIVE_INFINITY;
            for (int axis = 0; axis < 3; axis++) {
                by[axis] = low[axis] + (high[axis] - low[axis]) * (2 * random.nextDouble() - 0.5) - from[axis];
                double one = (low[axis] - from[axis]) / by[axis];
                double other = (high[axis] - from[axis]) / by[axis];
                near = Math.max(near, Math.min(one, other));
                far = Math.min(far, Math.max(one, other));
            }
            if (Math.abs(near - far) < ROUNDINGS) {
                continue;                                     // too close to tell
            }

            double entry = entered(from[0], from[1], from[2], by[0], by[1], by[2]);

            if (near > far) {
                assertThat(entry).as("ray %d misses", i).isInfinite();
            } else {
                assertThat(entry).as("ray %d", i).isBetween(near - ROUNDINGS, near);
                hits++;
            }
        }
        assertThat(hits).as("enough of them hit").isBetween(1000, 4000);
    }

    /** What is behind the box's far side by less than a few roundings is not missed: padding makes up for those. */
    @Test
    void theBoxIsALittleLargerThanTheTriangle() {
        double[] box = tree.box();
        for (int axis = 0; axis < 3; axis++) {
            assertThat(box[axis]).isBetween((axis + 1) * (1 - 1e-13), Math.nextDown(axis + 1.0));
            double high = new double[] {2, 4, 6}[axis];
            assertThat(box[axis + 3]).isBetween(Math.nextUp(high), high * (1 + 1e-13));
        }
    }

    /** {@return where a ray from x, y, z in direction dx, dy, dz enters the box} */
    private double entered(double x, double y, double z, double dx, double dy, double dz) {
        TriangleProbe probe = new TriangleProbe();
        probe.start(x, y, z, dx, dy, dz);
        return tree.enter(0, probe);
    }
}
