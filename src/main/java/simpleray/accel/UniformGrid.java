package simpleray.accel;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Cells of one size, each with a list of the primitives in it (Fujimoto, Tanaka and Iwata, "ARTS: Accelerated Ray-Tracing System", 1986). The
 * fastest structure for primitives that are spread evenly, and of no use for others. <em>Constant.</em>
 */
public final class UniformGrid {
    /** Cells per primitive. */
    private static final double CELLS_PER_OBJECT = 4;
    private static final int MAX_CELLS_PER_SIDE = 1024;
    /** An axis along which all objects together are thinner than this share of the longest counts as that thick. */
    private static final double MIN_THICKNESS = 1e-4;
    private static final long LISTED_PER_OBJECT = 24;
    private static final long LISTED_ANYWAY = 1 << 12;
    /** The largest mean number of objects with their middles in the cell of an object, itself included. */
    private static final double MAX_IN_CELL = 4;

    /** The middle of all boxes. */
    final double[] middle;
    /** The unit of all lengths. */
    final double extent;
    /** The number of primitives. */
    final int primitives;
    /** The number of cells along each axis. */
    final int[] cells = new int[3];
    /** Half the size of the grid along each axis, about the middle of the bounds. */
    final double[] half = new double[3];
    /** The size of a cell along each axis. */
    final double[] size = new double[3];
    /** The start of each cell's list in {@link #places}, x first, and the end of the last one. */
    int[] starts;
    /** The lists. */
    int[] places;

    private PrimitiveBounds bounds;                           // until the lists are made
    private final int[] from = new int[3];
    private final int[] to = new int[3];

    private UniformGrid(PrimitiveBounds bounds) {
        this.bounds = bounds;
        middle = bounds.middle;
        extent = bounds.extent;
        primitives = bounds.count();
    }

    /**
     * Starts a grid; {@link #fill} completes it.
     *
     * @param bounds the boxes, which are reordered so that neighbours are near each other
     * @param anyway whether to build a grid even if it is of no use
     * @param pool the threads to build it
     * @return the grid; null if the boxes are not spread evenly, so that a grid is of no use
     */
    public static UniformGrid of(PrimitiveBounds bounds, boolean anyway, Pool pool) {
        UniformGrid grid = new UniformGrid(bounds);
        grid.lay();
        return grid.sort(anyway, pool) ? grid : null;
    }

    private void lay() {
        Arrays.fill(half, MIN_THICKNESS);
        for (int i = 0; i < bounds.sides.length; i++) {
            int axis = i % 3;
            half[axis] = Math.max(half[axis], Math.abs(bounds.sides[i]));
        }
        double volume = 8 * half[0] * half[1] * half[2];
        double wanted = Math.cbrt(volume / (CELLS_PER_OBJECT * bounds.count()));
        for (int axis = 0; axis < 3; axis++) {
            cells[axis] = (int) Math.max(1, Math.min(MAX_CELLS_PER_SIDE, Math.rint(2 * half[axis] / wanted)));
            size[axis] = 2 * half[axis] / cells[axis];
        }
    }

    /** {@return this grid, with its lists} */
    public UniformGrid fill() {
        int n = bounds.count();
        starts = new int[count() + 1];
        for (int i = 0; i < n; i++) {
            visit(i);
        }
        int sum = 0;
        for (int cell = 0; cell < starts.length; cell++) {
            sum += starts[cell];
            starts[cell] = sum;
        }
        places = new int[sum];
        for (int i = n - 1; i >= 0; i--) {
            visit(i);
        }
        bounds = null;                                        // no longer needed
        return this;
    }

    private int count() {
        return cells[0] * cells[1] * cells[2];
    }

    /** Sorts the bounds by the cells of their middles. {@return false, with nothing sorted, if a grid is of no use} */
    private boolean sort(boolean anyway, Pool pool) {
        int n = bounds.count();
        int[] cell = new int[n];
        AtomicLong listed = new AtomicLong();
        pool.ranges(n, new Pool.Work() {
            @Override
            public void on(int from, int to) {
                listed.addAndGet(find(cell, from, to));
            }
        });
        int[] ends = new int[count() + 1];
        for (int i = 0; i < n; i++) {
            ends[cell[i] + 1]++;
        }
        double crowd = 0;
        for (int i = 1; i < ends.length; i++) {
            crowd += (double) ends[i] * ends[i];
            ends[i] += ends[i - 1];
        }
        if (!anyway && (listed.get() > LISTED_PER_OBJECT * n + LISTED_ANYWAY || crowd > MAX_IN_CELL * n)) {
            return false;
        }
        int[] order = new int[n];
        for (int i = 0; i < n; i++) {
            order[ends[cell[i]]++] = i;
        }
        bounds.reorder(order);
        return true;
    }

    /** Finds the cells of the middles of some bounds. {@return the number of list entries they would need} */
    private long find(int[] cell, int from, int to) {
        long listed = 0;
        for (int i = from; i < to; i++) {
            long covered = 1;
            for (int axis = 2; axis >= 0; axis--) {
                int at = PrimitiveBounds.SIDES * i + axis;
                cell[i] = cell[i] * cells[axis] + cell(axis, (bounds.sides[at] + bounds.sides[at + 3]) / 2);
                covered *= cell(axis, bounds.sides[at + 3]) - cell(axis, bounds.sides[at]) + 1;
            }
            listed += covered;
        }
        return listed;
    }

    /** {@return the column, row or layer of a coordinate} */
    int cell(int axis, double along) {
        return Math.max(0, Math.min(cells[axis] - 1, (int) ((along + half[axis]) / size[axis])));
    }

    /** Counts a primitive in the cells that it may touch, or lists it there from the end of each list, once there are lists. */
    private void visit(int i) {
        float[] s = bounds.sides;
        int at = PrimitiveBounds.SIDES * i;
        for (int axis = 0; axis < 3; axis++) {
            from[axis] = cell(axis, s[at + axis]);
            to[axis] = cell(axis, s[at + axis + 3]);
        }
        for (int z = from[2]; z <= to[2]; z++) {
            for (int y = from[1]; y <= to[1]; y++) {
                int row = (z * cells[1] + y) * cells[0];
                for (int x = from[0]; x <= to[0]; x++) {
                    if (places == null) {
                        starts[row + x]++;
                    } else {
                        places[--starts[row + x]] = i;
                    }
                }
            }
        }
    }
}
