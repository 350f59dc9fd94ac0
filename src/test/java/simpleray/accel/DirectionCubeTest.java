package simpleray.accel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DirectionCubeTest {
    private static final long SEED = 1986;
    private static final Offset<Double> ROUNDING = within(1e-9);

    private final double[] slopes = new double[4];

    private static DirectionCube whole(double cells) {
        DirectionCube cube = new DirectionCube();
        for (int face = 0; face < DirectionCube.FACES; face++) {
            cube.open(face, new double[] {-1, 1, -1, 1});
        }
        cube.divide(cells);
        return cube;
    }

    @Test
    void aFaceHasTheTwoAxesAcrossItsOwn() {
        for (int face = 0; face < DirectionCube.FACES; face++) {
            assertThat(Set.of(face / 2, DirectionCube.across(face), DirectionCube.along(face))).containsExactlyInAnyOrder(0, 1, 2);
        }
    }

    /** A box from 2 to 4 along the face's axis. */
    @ParameterizedTest
    @CsvSource({"0, 1, 0, 0.5", "-1, 1, -0.5, 0.5", "1, 1, 0.25, 0.5", "-1, -1, -0.5, -0.25", "-8, 8, -1, 1", "3, 9, 0.75, 1", "-4, -3, -1, -0.75"})
    void aBoxIsVisibleBetweenTheSlopesOfItsCorners(double from, double to, double lowest, double highest) {
        double[] box = {2, from, -1, 4, to, 2};
        assertThat(DirectionCube.sees(box, 0, slopes)).isTrue();
        assertThat(slopes).containsExactly(new double[] {lowest, highest, -0.5, 1}, ROUNDING);
        assertThat(DirectionCube.sees(new double[] {-4, from, -1, -2, to, 2}, 1, slopes)).isTrue();
        assertThat(slopes).containsExactly(new double[] {lowest, highest, -0.5, 1}, ROUNDING);
        assertThat(DirectionCube.sees(new double[] {from, 2, -1, to, 4, 2}, 2, slopes)).isTrue();
        assertThat(slopes).containsExactly(new double[] {lowest, highest, -0.5, 1}, ROUNDING);
        assertThat(DirectionCube.sees(new double[] {from, -1, 2, to, 2, 4}, 4, slopes)).isTrue();
        assertThat(slopes).containsExactly(new double[] {lowest, highest, -0.5, 1}, ROUNDING);
    }

    @Test
    void aBoxIsNotVisibleThroughOtherFaces() {
        double[] box = {2, -1, -1, 4, 1, 1};
        for (int face = 1; face < DirectionCube.FACES; face++) {
            assertThat(DirectionCube.sees(box, face, slopes)).as("face " + face).isFalse();
        }
        assertThat(DirectionCube.sees(new double[] {2, 5, 0, 4, 6, 1}, 0, slopes)).as("too far across").isFalse();
        assertThat(DirectionCube.sees(new double[] {2, 0, -6, 4, 1, -5}, 0, slopes)).as("too far along").isFalse();
    }

    @Test
    void fromInsideABoxIsVisibleEverywhere() {
        for (int face = 0; face < DirectionCube.FACES; face++) {
            assertThat(DirectionCube.sees(new double[] {-1, -2, -3, 3, 2, 1}, face, slopes)).isTrue();
            assertThat(slopes).containsExactly(-1, 1, -1, 1);
        }
    }

    /** The point lies in the plane of the side x = 0, beside the box or on it. */
    @Test
    void fromThePlaneOfASideABoxIsVisibleOnBothSidesOfTheEdge() {
        assertThat(DirectionCube.sees(new double[] {0, 1, 0, 2, 3, 0}, 0, slopes)).isTrue();
        assertThat(slopes).containsExactly(new double[] {0.5, 1, 0, 0}, ROUNDING);
        assertThat(DirectionCube.sees(new double[] {0, -1, 0, 2, 1, 0}, 0, slopes)).isTrue();
        assertThat(slopes).containsExactly(new double[] {-1, 1, 0, 0}, ROUNDING);
        assertThat(DirectionCube.sees(new double[] {-2, 0, 0, 0, 1, 0}, 0, slopes)).as("behind").isFalse();
    }

    @Test
    void withoutWindowsAllDirectionsBelongToTheOutsideCell() {
        DirectionCube cube = new DirectionCube();
        cube.divide(100);

        assertThat(cube.cells()).isZero();
        assertThat(cube.cell(1, 0, 0)).isZero();
    }

    /** Six faces of 2 × 2 make 24; 2400 cells are 10 to a slope of 1. */
    @Test
    void aWholeCubeHasSixEqualFaces() {
        DirectionCube cube = whole(2400);

        assertThat(cube.cells()).isEqualTo(6 * 21 * 21);
        assertThat(cube.cell(1, -0.99, -0.99)).isZero();
        assertThat(cube.cell(1, -0.85, -0.99)).isEqualTo(1);
        assertThat(cube.cell(1, -0.99, -0.85)).isEqualTo(21);
        assertThat(cube.cell(-2, -1.98, -1.98)).isEqualTo(441);
        assertThat(cube.cell(-0.99, 1, -0.99)).isEqualTo(2 * 441);
        assertThat(cube.cell(-0.99, -1, -0.99)).isEqualTo(3 * 441);
        assertThat(cube.cell(-0.99, -0.99, 1)).isEqualTo(4 * 441);
        assertThat(cube.cell(-0.99, -0.85, 1)).isEqualTo(4 * 441 + 21);
        assertThat(cube.cell(-0.99, -0.99, -1)).isEqualTo(5 * 441);
    }

    @Test
    void theCellOfADirectionIsThatOfItsSlopes() {
        DirectionCube cube = whole(5000);
        Random random = new Random(SEED);
        Set<Integer> cells = new HashSet<>();
        for (int i = 0; i < 10_000; i++) {
            double[] d = random.doubles(3, -1, 1).toArray();
            int axis = Math.abs(d[0]) > Math.abs(d[1]) ? Math.abs(d[0]) > Math.abs(d[2]) ? 0 : 2 : Math.abs(d[1]) > Math.abs(d[2]) ? 1 : 2;
            int face = 2 * axis + (d[axis] > 0 ? 0 : 1);
            double across = d[DirectionCube.across(face)] / Math.abs(d[axis]);
            double along = d[DirectionCube.along(face)] / Math.abs(d[axis]);

            int cell = cube.cell(d[0], d[1], d[2]);

            assertThat(cell).isBetween(cube.cell(face, cube.row(face, along - 1e-12)) + cube.column(face, across - 1e-12),
                cube.cell(face, cube.row(face, along + 1e-12)) + cube.column(face, across + 1e-12));
            cells.add(cell);
        }
        assertThat(cells.size()).isGreaterThan(3000);
    }

    @Test
    void directionsBesideAWindowBelongToTheOutsideCell() {
        DirectionCube cube = new DirectionCube();
        cube.open(4, new double[] {-0.5, 0.5, 0.25, 0.75});
        cube.divide(200);                                     // 20 to a slope of 1

        assertThat(cube.cells()).isEqualTo(21 * 11);
        assertThat(cube.cell(-0.49, 0.26, 1)).isZero();
        assertThat(cube.cell(0.49, 0.74, 1)).isEqualTo(9 * 21 + 19);
        for (double[] beside : new double[][] {{-0.6, 0.5}, {0.6, 0.5}, {0, 0.19}, {0, 0.9}}) {
            assertThat(cube.cell(beside[0], beside[1], 1)).isEqualTo(cube.cells());
            assertThat(cube.cell(beside[0], beside[1], -1)).isEqualTo(cube.cells());
        }
        assertThat(cube.column(4, -7)).isZero();
        assertThat(cube.column(4, 7)).isEqualTo(20);
        assertThat(cube.row(4, -7)).isZero();
        assertThat(cube.row(4, 7)).isEqualTo(10);
    }
}
