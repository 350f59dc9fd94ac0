package simpleray.accel;

import java.util.Arrays;

/**
 * For each direction from a point, lists the primitives that lie there, the nearest first. The buffer of the eye serves primary rays (Weghorst,
 * Hooper and Greenberg, "Improved Computational Methods for Ray Tracing", 1984), that of a light its shadow rays (Haines and Greenberg,
 * "The Light Buffer", 1986). <em>Constant.</em>
 */
public final class LightBuffer {
    /** The number of primitives in the sample that estimates the length of the lists. */
    private static final int SAMPLE = 4096;
    /** Cells per primitive, the fewest and the most cells; list entries per primitive, and the number that is always allowed. */
    private static final double CELLS_PER_PRIMITIVE = 1;
    private static final int MIN_CELLS = 6000;
    private static final int MAX_CELLS = 6 << 20;
    private static final long LISTED_PER_PRIMITIVE = 6;
    private static final long LISTED_ANYWAY = 1 << 18;
    /** Longer lists are no faster than a tree, since they fit into no cache. */
    private static final long MAX_LISTED = 1 << 22;
    /**
     * The longest lists, as the mean over all primitives of the list in which they stand: a ray walks them to their end. Of twelve scenes those with
     * up to 58 were rendered faster with lists, by a third at 58, and those with 104 or more without, four times faster at 400.
     */
    private static final int MAX_CROWD = 80;
    /** The largest distance of the point from the middle, in extents. */
    private static final double MAX_DISTANCE = 1e4;
    /** The number of primitives, mostly neighbours, whose common box is seen where a rough answer is enough. */
    private static final int NEIGHBOURS = 16;

    private final DirectionCube cube;
    /** The start of each cell's list, and the end of the last one. */
    private final int[] starts;
    /** The lists: of each primitive its number, and the bits of a lower bound of its distance. */
    private final int[] lists;
    /** The largest distance from which a ray to the point may start; beyond it, rounding lets the ray hit primitives of other cells. */
    private final double reach;

    private LightBuffer(DirectionCube cube, int[] starts, int[] lists, double reach) {
        this.cube = cube;
        this.starts = starts;
        this.lists = lists;
        this.reach = reach;
    }

    /**
     * Returns the cell of a direction from the point. Its list ends where that of the next cell begins.
     *
     * @param dx the direction, of unit length
     * @param dy the direction
     * @param dz the direction
     * @return the cell
     */
    public int cell(double dx, double dy, double dz) {
        return cube.cell(dx, dy, dz);
    }

    /**
     * Returns the start of a list.
     *
     * @param cell the cell
     * @return the index of its first primitive
     */
    public int start(int cell) {
        return starts[cell];
    }

    /**
     * Finds a primitive.
     *
     * @param i its place in the lists
     * @return the primitive, as the boxes were numbered
     */
    public int primitive(int i) {
        return lists[2 * i];
    }

    /**
     * Returns a lower bound of the distance of a primitive.
     *
     * @param i its index in the lists
     * @return its distance from the point, or a little less
     */
    public double near(int i) {
        return Float.intBitsToFloat(lists[2 * i + 1]);
    }

    /** {@return the largest distance from which a ray to the point may start} */
    public double reach() {
        return reach;
    }

    /**
     * Makes the buffer of a point.
     *
     * @param bounds the boxes of the primitives
     * @param x the point
     * @param y the point
     * @param z the point
     * @return the buffer; null if its lists would be too long or too crowded, or the point is too far away
     */
    public static LightBuffer of(PrimitiveBounds bounds, double x, double y, double z) {
        double[] point = {(x - bounds.middle[0]) / bounds.extent, (y - bounds.middle[1]) / bounds.extent,
            (z - bounds.middle[2]) / bounds.extent};
        double far = Math.max(Math.abs(point[0]), Math.max(Math.abs(point[1]), Math.abs(point[2])));
        return far <= MAX_DISTANCE ? new Builder(bounds, point).build() : null;
    }

    /** Makes the lists. */
    private static final class Builder {
        private static final int WINDOW = 4;                  // numbers

        private final PrimitiveBounds bounds;
        private final double[] point;
        private final DirectionCube cube = new DirectionCube();
        private final double[] box = new double[PrimitiveBounds.SIDES];
        private final double[] slopes = new double[4];
        private final int[] windows = new int[WINDOW * DirectionCube.FACES];   // of a primitive
        private int[] starts;
        private int[] lists;
        private int near;

        Builder(PrimitiveBounds bounds, double[] point) {
            this.bounds = bounds;
            this.point = point;
        }

        LightBuffer build() {
            int n = bounds.count();
            long most = Math.min(LISTED_PER_PRIMITIVE * n + LISTED_ANYWAY, MAX_LISTED);
            openWindows();
            if (!divide(n, most)) {
                return null;
            }
            starts = new int[cube.cells() + 2];
            long[] nearest = new long[n];                     // distances are not negative, so their bits have their order
            long listed = 0;
            for (int i = 0; i < n && listed <= 2 * most; i++) {
                listed += count(i);
                nearest[i] = (long) Float.floatToRawIntBits((float) (distance(box) * bounds.extent * (1 - 0x1p-20))) << Integer.SIZE | i;
            }
            if (listed > 2 * most) {                          // the sample was wrong
                return null;
            }
            int sum = 0;                                      // turns counts into ends of lists
            double squares = 0;
            for (int cell = 0; cell < starts.length; cell++) {
                squares += (double) starts[cell] * starts[cell];
                sum += starts[cell];
                starts[cell] = sum;
            }
            if (squares > (double) MAX_CROWD * sum) {
                return null;
            }
            lists = new int[2 * sum];
            Arrays.sort(nearest);
            for (int k = n - 1; k >= 0; k--) {                // each list is filled from its end
                near = (int) (nearest[k] >> Integer.SIZE);
                list((int) nearest[k]);
            }
            return new LightBuffer(cube, starts, lists, bounds.reach());
        }

        /** Makes windows for all boxes, of neighbours at once. */
        private void openWindows() {
            for (int first = 0; first < bounds.count(); first += NEIGHBOURS) {
                see(first, Math.min(first + NEIGHBOURS, bounds.count()));
                for (int face = 0; face < DirectionCube.FACES; face++) {
                    if (DirectionCube.sees(box, face, slopes)) {
                        cube.open(face, slopes);
                    }
                }
            }
        }

        /** Divides the cube into so few cells that lists are short, as a sample estimates. {@return whether they are} */
        private boolean divide(int n, long most) {
            int step = 1 + n / SAMPLE;
            for (double cells = Math.min(MAX_CELLS, MIN_CELLS + CELLS_PER_PRIMITIVE * n); cells >= MIN_CELLS; cells /= 2) {
                cube.divide(cells);
                long listed = 0;
                for (int i = 0; i < n; i += step) {
                    listed += cells(i);
                }
                if (listed * step <= most) {
                    return true;
                }
            }
            return false;
        }

        /** Finds the box around some primitives as seen from the point. */
        private void see(int first, int end) {
            float[] s = bounds.sides;
            for (int axis = 0; axis < 3; axis++) {
                float low = Float.POSITIVE_INFINITY;
                float high = Float.NEGATIVE_INFINITY;
                for (int at = PrimitiveBounds.SIDES * first + axis; at < PrimitiveBounds.SIDES * end; at += PrimitiveBounds.SIDES) {
                    low = Math.min(low, s[at]);
                    high = Math.max(high, s[at + 3]);
                }
                box[axis] = low - point[axis];
                box[axis + 3] = high - point[axis];
            }
        }

        private static double distance(double[] box) {
            double square = 0;
            for (int axis = 0; axis < 3; axis++) {
                double outside = Math.max(0, Math.max(box[axis], -box[axis + 3]));
                square += outside * outside;
            }
            return Math.sqrt(square);
        }

        /**
         * Finds the cells where a primitive may be visible: of each face the first one, how many are beside and below it, and how far it is to
         * the row below. {@return the end of these windows} What is done with the cells has a method each: HotSpot compiles for what a method
         * did first, and interprets it when it does something else.
         */
        private int find(int i) {
            see(i, i + 1);
            int end = 0;
            for (int face = 0; face < DirectionCube.FACES; face++) {
                if (DirectionCube.sees(box, face, slopes)) {
                    int column = cube.column(face, slopes[0]);
                    int row = cube.row(face, slopes[2]);
                    windows[end] = cube.cell(face, row) + column;
                    windows[end + 1] = cube.column(face, slopes[1]) + 1 - column;
                    windows[end + 2] = cube.row(face, slopes[3]) + 1 - row;
                    windows[end + 3] = cube.cell(face, 1) - cube.cell(face, 0);
                    end += WINDOW;
                }
            }
            return end;
        }

        /** {@return in how many cells a primitive may be visible} */
        private long cells(int i) {
            int end = find(i);
            long cells = 0;
            for (int at = 0; at < end; at += WINDOW) {
                cells += (long) windows[at + 1] * windows[at + 2];
            }
            return cells;
        }

        /** Counts a primitive in its cells. {@return their number} */
        private long count(int i) {
            int end = find(i);
            long cells = 0;
            for (int at = 0; at < end; at += WINDOW) {
                int from = windows[at];
                for (int row = 0; row < windows[at + 2]; row++) {
                    for (int k = from; k < from + windows[at + 1]; k++) {
                        starts[k]++;
                        cells++;
                    }
                    from += windows[at + 3];
                }
            }
            return cells;
        }

        /** Lists a primitive in its cells, from the end of each list. */
        private void list(int i) {
            int end = find(i);
            for (int at = 0; at < end; at += WINDOW) {
                int from = windows[at];
                for (int row = 0; row < windows[at + 2]; row++) {
                    for (int k = from; k < from + windows[at + 1]; k++) {
                        int place = 2 * --starts[k];
                        lists[place] = i;
                        lists[place + 1] = near;
                    }
                    from += windows[at + 3];
                }
            }
        }
    }
}
