package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** How far points are from a triangle, and which normals it has. */
class TrianglesTest {
    private static final double ROUNDING = 1e-12;

    /** (0,0), (4,0) and (0,4) at z = 0, turned about so that each axis is once the one across. */
    private static Triangles across(int axis) {
        double[] v = new double[9];
        v[3 + (axis + 1) % 3] = 4;
        v[6 + (axis + 2) % 3] = 4;
        return new Triangles(v, new int[] {0, 1, 2}, new double[0], null);
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 3, 9", "1, 1, -3, 9", "0, 0, 0, 0", "2, 2, 5, 25", "1, -2, 0, 4", "-2, 1, 0, 4", "1, -2, 2, 8", "4, 2, 0, 2",
        "-3, -4, 0, 25", "7, -4, 0, 25", "-4, 7, 0, 25", "-3, -4, 12, 169", "4, 4, 1, 9"})
    void theDistanceIsThatOfTheNearestPointOfFaceEdgeOrCorner(double x, double y, double z, double squared) {
        for (int axis = 0; axis < 3; axis++) {
            double[] p = new double[3];
            p[(axis + 1) % 3] = x;
            p[(axis + 2) % 3] = y;
            p[axis] = z;
            assertThat(across(axis).squaredDistance(0, p)).as("across axis " + axis).isEqualTo(squared, within(ROUNDING));
        }
    }

    @Test
    void theDistanceDoesNotDependOnWhereTheTriangleLies() {
        double[] v = {10, 20, 30, 14, 20, 30, 10, 24, 30};
        Triangles moved = new Triangles(v, new int[] {0, 1, 2}, new double[0], null);

        assertThat(moved.squaredDistance(0, new double[] {11, 21, 33})).isEqualTo(9, within(ROUNDING));
        assertThat(moved.squaredDistance(0, new double[] {7, 16, 42})).isEqualTo(169, within(ROUNDING));
    }

    /** x + y + z = 3 between the axes: its middle is (1,1,1), and (2,2,2) is the square root of 3 above it. */
    @Test
    void aSlantedTriangleIsAsFarAsItsPlane() {
        Triangles slanted = new Triangles(new double[] {3, 0, 0, 0, 3, 0, 0, 0, 3}, new int[] {0, 1, 2}, new double[0], null);

        assertThat(slanted.squaredDistance(0, new double[] {2, 2, 2})).isEqualTo(3, within(ROUNDING));
        assertThat(slanted.squaredDistance(0, new double[] {0, 0, 0})).isEqualTo(3, within(ROUNDING));
        assertThat(slanted.squaredDistance(0, new double[] {3, 3, 0})).as("to (1.5,1.5,0)").isEqualTo(4.5, within(ROUNDING));
    }

    @Test
    void theSecondTriangleIsNotTheFirst() {
        Triangles two = new Triangles(new double[] {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 8, 4, 0, 8, 0, 4, 8}, new int[] {0, 1, 2, 3, 4, 5},
            new double[0], null);

        assertThat(two.squaredDistance(0, new double[] {1, 1, 3})).isEqualTo(9, within(ROUNDING));
        assertThat(two.squaredDistance(1, new double[] {1, 1, 3})).isEqualTo(25, within(ROUNDING));
    }

    @Test
    void aTriangleOfWhichAllCornersAreInLineHasNoNormal() {
        double[] out = new double[3];

        assertThat(Triangles.cross(new double[] {0, 0, 0, 1, 2, 3, 2, 4, 6}, 0, 3, 6, out)).isFalse();
        assertThat(Triangles.cross(new double[] {0, 0, 0, 0, 1, 0, 0, 0, 1}, 0, 3, 6, out)).isTrue();
        assertThat(out).containsExactly(1, 0, 0);
        assertThat(Triangles.cross(new double[] {0, 0, 0, 0, 0, 1, 1, 0, 0}, 0, 3, 6, out)).isTrue();
        assertThat(out).containsExactly(0, 1, 0);
        assertThat(Triangles.cross(new double[] {5, 6, 7, 6, 6, 7, 5, 7, 7}, 0, 3, 6, out)).isTrue();
        assertThat(out).containsExactly(0, 0, 1);
    }

    @Test
    void normalsAreMixedByTheirWeightsWhateverTheirSum() {
        Triangles smooth = new Triangles(new double[9], new int[] {0, 1, 2}, new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, new int[] {2, 0, 1});
        double[] out = new double[3];

        assertThat(smooth.interpolate(0, new double[] {2, 1, 1}, out)).isTrue();
        assertThat(out).containsExactly(0.25, 0.25, 0.5);
        assertThat(smooth.interpolate(0, new double[] {0, -3, -1}, out)).isTrue();
        assertThat(out).containsExactly(0.75, 0.25, 0);
    }

    @Test
    void normalsThatCancelAreNone() {
        Triangles opposite = new Triangles(new double[9], new int[] {0, 1, 2}, new double[] {0.6, 0, 0.8, -0.6, 0, -0.8, 0, 0, 0},
            new int[] {0, 1, 2});

        assertThat(opposite.interpolate(0, new double[] {1, 1, 5}, new double[3])).isFalse();
        assertThat(opposite.interpolate(0, new double[] {2, 1, 5}, new double[3])).isTrue();
    }
}
