package simpleray.accel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class UniformGridTest {
    private static final long SEED = 1986;

    private static UniformGrid grid(PrimitiveBounds bounds, boolean anyway, int threads) {
        try (Pool pool = new Pool(threads)) {
            UniformGrid grid = UniformGrid.of(bounds, anyway, pool);
            return grid == null ? null : grid.fill();
        }
    }

    /** {@return a point as a box} */
    private static double[] point(double x, double y, double z) {
        return new double[] {x, y, z, x, y, z};
    }

    /** {@return the eight corners of a cube, the last first} */
    private static double[][] corners() {
        double[][] points = new double[8][];
        for (int i = 0; i < 8; i++) {
            points[7 - i] = point((i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2) * 2 - 1);
        }
        return points;
    }

    /** Four cells an object are 32, and the cube root of that is 3.2. */
    @Test
    void eightCornersOfACubeLieInTheCornersOfTwentySevenCells() {
        PrimitiveBounds bounds = Boxes.bounds(corners());
        UniformGrid grid = grid(bounds, false, 1);

        assertThat(grid.cells).containsExactly(3, 3, 3);
        assertThat(grid.half).containsExactly(1, 1, 1);
        assertThat(grid.size[0]).isEqualTo(2 / 3.0);
        assertThat(grid.primitives).isEqualTo(8);
        assertThat(bounds.ids()).as("in the order of the cells").containsExactly(7, 6, 5, 4, 3, 2, 1, 0);
        int[] filled = {0, 2, 6, 8, 18, 20, 24, 26};
        for (int cell = 0; cell < 27; cell++) {
            int place = Arrays.binarySearch(filled, cell);
            int[] list = Arrays.copyOfRange(grid.places, grid.starts[cell], grid.starts[cell + 1]);
            assertThat(list).as("cell " + cell).containsExactly(place < 0 ? new int[0] : new int[] {place});
        }
    }

    @Test
    void aLargeBoxIsListedInEachCellThatItTouches() {
        double[][] boxes = Arrays.copyOf(corners(), 9);
        boxes[8] = new double[] {-1, -1, -1, 1, 1, -1};       // the floor
        PrimitiveBounds bounds = Boxes.bounds(boxes);
        UniformGrid grid = grid(bounds, false, 1);

        int floor = 0;
        while (bounds.ids()[floor] != 8) {
            floor++;
        }
        for (int cell = 0; cell < grid.starts.length - 1; cell++) {
            int[] list = Arrays.copyOfRange(grid.places, grid.starts[cell], grid.starts[cell + 1]);
            if (cell < grid.cells[0] * grid.cells[1]) {
                assertThat(list).contains(floor);
            } else {
                assertThat(list).doesNotContain(floor);
            }
        }
    }

    @Test
    void flatScenesHaveOneLayerOfCells() {
        Random random = new Random(SEED);
        double[][] boxes = new double[1000][];
        Arrays.setAll(boxes, i -> point(random.nextDouble(), 5, random.nextDouble()));
        UniformGrid grid = grid(Boxes.bounds(boxes), false, 1);

        assertThat(grid.cells[1]).isEqualTo(1);
        assertThat(grid.cells[0]).isGreaterThan(20);
        assertThat(grid.half[1]).isEqualTo(1e-4);
    }

    @Test
    void noSideHasMoreThan1024Cells() {
        double[][] boxes = new double[2000][];
        Arrays.setAll(boxes, i -> point(i, 0, 0));
        UniformGrid grid = grid(Boxes.bounds(boxes), false, 1);

        assertThat(grid.cells).containsExactly(1024, 1, 1);
    }

    /** A hundred in one place, and one that is far from there. */
    @Test
    void unevenlySpreadBoxesMakeNoGridUnlessItIsForced() {
        double[][] boxes = new double[101][];
        Arrays.fill(boxes, point(0, 0, 0));
        boxes[100] = point(9, 9, 9);

        assertThat(grid(Boxes.bounds(boxes), false, 1)).isNull();
        assertThat(grid(Boxes.bounds(boxes), true, 1)).isNotNull();
    }

    @Test
    void boxesThatSpanManyCellsMakeNoGrid() {
        assertThat(grid(Boxes.bounds(lattice(0.1)), false, 1)).isNotNull();
        for (int axis = 0; axis < 3; axis++) {
            double[][] rods = lattice(0.1);
            for (double[] box : rods) {                      // through twenty cells, and so thick that there are three or more abreast
                box[axis + 3] += 9;
                box[(axis + 1) % 3 + 3] += 1;
            }
            assertThat(grid(Boxes.bounds(rods), false, 1)).as("axis " + axis).isNull();
        }
    }

    /** {@return a thousand cubes at the places 0 to 9 along each axis} */
    private static double[][] lattice(double size) {
        double[][] boxes = new double[1000][];
        Arrays.setAll(boxes, i -> new double[] {i % 10, i / 10 % 10, i / 100, i % 10 + size, i / 10 % 10 + size, i / 100 + size});
        return boxes;
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 5})
    void severalThreadsMakeTheSameGrid(int threads) {
        double[][] boxes = Boxes.random(new Random(SEED), 100_000, 0.01);
        PrimitiveBounds one = Boxes.bounds(boxes);
        PrimitiveBounds several = Boxes.bounds(boxes);
        UniformGrid ofOne = grid(one, true, 1);
        UniformGrid ofSeveral = grid(several, true, threads);

        assertThat(Arrays.equals(several.ids(), one.ids())).isTrue();
        assertThat(Arrays.equals(ofSeveral.starts, ofOne.starts)).isTrue();
        assertThat(Arrays.equals(ofSeveral.places, ofOne.places)).isTrue();
    }

    @Test
    void everyBoxIsListedInTheCellOfEachOfItsCorners() {
        PrimitiveBounds bounds = Boxes.bounds(Boxes.random(new Random(SEED), 300, 1));
        UniformGrid grid = grid(bounds, true, 1);
        for (int i = 0; i < bounds.count(); i++) {
            for (int corner = 0; corner < 8; corner++) {
                int cell = 0;
                for (int axis = 2; axis >= 0; axis--) {
                    double along = bounds.sides[6 * i + axis + ((corner >> axis & 1) == 0 ? 0 : 3)];
                    cell = cell * grid.cells[axis] + grid.cell(axis, along);
                }
                assertThat(Arrays.copyOfRange(grid.places, grid.starts[cell], grid.starts[cell + 1])).contains(i);
            }
        }
    }

    @Test
    void coordinatesOutsideTheGridBelongToItsOuterCells() {
        UniformGrid grid = grid(Boxes.bounds(corners()), false, 1);

        assertThat(grid.cell(0, -7)).isZero();
        assertThat(grid.cell(1, -0.34)).isZero();
        assertThat(grid.cell(1, 0.3)).isEqualTo(1);
        assertThat(grid.cell(2, 0.34)).isEqualTo(2);
        assertThat(grid.cell(2, 7)).isEqualTo(2);
    }
}
