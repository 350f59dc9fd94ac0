package simpleray.accel;

import java.util.Arrays;
import simpleray.math.Point;

/**
 * For each direction from a point, the objects that lie there, the nearest first: a cube about the point, its faces cut into cells, and for
 * each cell a list. Of an eye it finds what primary rays hit (Weghorst, Hooper and Greenberg, "Improved Computational Methods for Ray
 * Tracing", 1984), of a light what shadows it casts (Haines and Greenberg, "The Light Buffer", 1986). <em>Constant.</em>
 */
final class DirectionBuffer {
    private static final int LEAST_SIDE = 32;
    private static final int MOST_SIDE = 1024;
    private static final int SHORT = 16;
    private static final int SAMPLE = 16;
    /** Of so many objects a sample tells how long the lists would be. */
    private static final int MANY = 1 << 14;
    /** So many cells for each object, and at most so many objects in lists. */
    private static final double CELLS_AN_OBJECT = 1;
    private static final long LISTED_AN_OBJECT = 10;
    private static final long LISTED_ANYWAY = 1 << 18;
    /** Longer lists are no faster than a grid: they lie in no cache. */
    private static final long MOST_LISTED = 1 << 22;

    /** Where the list of each cell begins in {@link #places}, and at last where the last one ends. */
    final int[] starts;
    /** The lists. */
    final int[] places;
    /** How near each object is at least. */
    final float[] near;

    final Cube cube;

    private DirectionBuffer(Cube cube, int[] starts, int[] places, float[] near) {
        this.cube = cube;
        this.starts = starts;
        this.places = places;
        this.near = near;
    }

    /**
     * Makes the buffer of a point.
     *
     * @param boxes the boxes of the objects
     * @param point the point
     * @return the buffer; null if its lists would be long
     */
    static DirectionBuffer of(Boxes boxes, Point point) {
        double[] about = about(boxes, point);
        if (about == null) {
            return null;
        }
        double px = about[0];
        double py = about[1];
        double pz = about[2];
        int n = boxes.count();
        float[] near = new float[n];
        double[] box = new double[Boxes.SIDES];
        int side = (int) Math.max(LEAST_SIDE, Math.min(MOST_SIDE, Math.sqrt(CELLS_AN_OBJECT * n / Cube.FACES)));
        Cube cube = new Cube(side);
        int[] rectangle = new int[4];
        long most = Math.min(LISTED_AN_OBJECT * n + LISTED_ANYWAY, MOST_LISTED);
        long listed = 0;
        for (int i = 0; n >= MANY && i < n; i += SAMPLE) {    // so that it is known soon if they would be too long
            seen(boxes, i, px, py, pz, box);
            for (int face = 0; face < Cube.FACES; face++) {
                listed += covers(box, face, cube, rectangle) ? cells(rectangle) : 0;
            }
        }
        if (SAMPLE * listed > most + most / SAMPLE) {
            return null;
        }
        listed = 0;
        int[] starts = new int[cube.cells() + 1];
        for (int i = 0; i < n; i++) {
            seen(boxes, i, px, py, pz, box);
            near[i] = distance(box);
            for (int face = 0; face < Cube.FACES; face++) {
                if (covers(box, face, cube, rectangle)) {
                    for (int v = rectangle[2]; v <= rectangle[3]; v++) {
                        int row = (face * side + v) * side;
                        for (int u = rectangle[0]; u <= rectangle[1]; u++) {
                            starts[row + u]++;
                        }
                    }
                    listed += cells(rectangle);
                    if (listed > most) {
                        return null;
                    }
                }
            }
        }
        int sum = 0;                                          // from counts to where each list ends
        for (int cell = 0; cell < starts.length; cell++) {
            sum += starts[cell];
            starts[cell] = sum;
        }
        int[] places = new int[sum];
        for (int k = 0; k < n; k++) {                         // each list is filled from its end, so from what is mostly the farthest
            int i = pz > 0 ? k : n - 1 - k;
            seen(boxes, i, px, py, pz, box);
            for (int face = 0; face < Cube.FACES; face++) {
                if (covers(box, face, cube, rectangle)) {
                    for (int v = rectangle[2]; v <= rectangle[3]; v++) {
                        int row = (face * side + v) * side;
                        for (int u = rectangle[0]; u <= rectangle[1]; u++) {
                            places[--starts[row + u]] = i;
                        }
                    }
                }
            }
        }
        sort(starts, places, near);
        return new DirectionBuffer(cube, starts, places, near);
    }

    private static long cells(int[] rectangle) {
        return (rectangle[1] - rectangle[0] + 1L) * (rectangle[3] - rectangle[2] + 1L);
    }

    /** Brings each list into the order of distances; the bits of those, which are not negative, have that order, too. */
    private static void sort(int[] starts, int[] places, float[] near) {
        long[] keys = new long[SHORT];
        for (int cell = 0; cell < starts.length - 1; cell++) {
            int first = starts[cell];
            int count = starts[cell + 1] - first;
            if (count > 1) {
                keys = count > keys.length ? new long[2 * count] : keys;
                for (int i = 0; i < count; i++) {
                    int place = places[first + i];
                    keys[i] = (long) Float.floatToRawIntBits(near[place]) << Integer.SIZE | place;
                }
                Arrays.sort(keys, 0, count);
                for (int i = 0; i < count; i++) {
                    places[first + i] = (int) keys[i];
                }
            }
        }
    }

    /** {@return the point about the middle of the boxes; null if roundings on its way could be larger than the boxes are padded for} */
    static double[] about(Boxes boxes, Point point) {
        double px = point.x - boxes.middle[0];
        double py = point.y - boxes.middle[1];
        double pz = point.z - boxes.middle[2];
        boolean close = Math.max(Math.abs(px), Math.max(Math.abs(py), Math.abs(pz))) <= 1e4 * boxes.extent;
        return close ? new double[] {px, py, pz} : null;
    }

    /** Finds the box of an object as seen from the point. */
    static void seen(Boxes boxes, int i, double px, double py, double pz, double[] box) {
        int at = Boxes.SIDES * i;
        float[] s = boxes.sides;
        box[0] = s[at] - px;
        box[1] = s[at + 1] - py;
        box[2] = s[at + 2] - pz;
        box[3] = s[at + 3] - px;
        box[4] = s[at + 4] - py;
        box[5] = s[at + 5] - pz;
    }

    /** {@return the distance of a box from the origin, or a little less} */
    static float distance(double[] box) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double outside = Math.max(0, Math.max(box[axis], -box[axis + 3]));
            square += outside * outside;
        }
        return (float) (Math.sqrt(square) * (1 - 0x1p-20));
    }

    /**
     * Finds the cells of a face that a box may cover, from the first to the last column and from the first to the last row.
     *
     * @return whether there are any
     */
    static boolean covers(double[] box, int face, Cube cube, int[] rectangle) {
        int axis = face >> 1;
        double low = box[axis];
        double high = box[axis + 3];
        double nearest = (face & 1) == 0 ? low : -high;
        double farthest = (face & 1) == 0 ? high : -low;
        if (farthest <= 0) {
            return false;
        }
        nearest = Math.max(nearest, 0);                       // then a quotient is infinite, or 0/0: as Cube.column takes it
        return covers(box, Cube.across(face), nearest, farthest, cube, rectangle, 0)
            && covers(box, Cube.along(face), nearest, farthest, cube, rectangle, 2);
    }

    private static boolean covers(double[] box, int axis, double nearest, double farthest, Cube cube, int[] rectangle, int at) {
        double low = box[axis];
        double high = box[axis + 3];
        if (low > farthest * (1 + 0x1p-20) || high < -farthest * (1 + 0x1p-20)) {
            return false;
        }
        double from = low < 0 ? low / nearest : low / farthest;
        double to = high > 0 ? high / nearest : high / farthest;
        rectangle[at] = cube.column(from - 0x1p-30);
        rectangle[at + 1] = cube.column(to + 0x1p-30);
        return true;
    }
}
