package simpleray.accel;

import java.util.Arrays;

/**
 * The directions from a point as a cube about it (Haines and Greenberg, "The Light Buffer", 1986; Arvo and Kirk, "Fast Ray Tracing by Ray
 * Classification", 1987). Each face has a window of square cells, columns along its first axis and rows along its second, that covers the
 * visible boxes. <em>Constant</em>, once its windows are set.
 */
final class DirectionCube {
    /** The number of faces; face 2 a looks along axis a, and face 2 a + 1 the other way. */
    static final int FACES = 6;
    /** The rounding error of slopes. */
    private static final double ROUNDING = 0x1p-30;

    /** The lowest and the highest slopes of each face's window, across and along. */
    private final double[] low = new double[2 * FACES];
    private final double[] high = new double[2 * FACES];
    /** Cells per slope of 1. */
    private double scale;
    private final int[] columns = new int[FACES];
    private final int[] rows = new int[FACES];
    /** The index of the first cell of each face. */
    private final int[] starts = new int[FACES + 1];

    DirectionCube() {
        Arrays.fill(low, 1);
        Arrays.fill(high, -1);
    }

    /** {@return the first axis within a face} */
    static int across(int face) {
        return face < 2 ? 1 : 0;
    }

    /** {@return the second axis within a face} */
    static int along(int face) {
        return face < 4 ? 2 : 1;
    }

    /**
     * Computes the range of slopes of a face within which a box may be visible.
     *
     * @param box the box, relative to the point
     * @param face the face
     * @param slopes gets the lowest and the highest slope across, then those along, from -1 to 1
     * @return whether the box may be visible there
     */
    static boolean sees(double[] box, int face, double[] slopes) {
        int axis = face >> 1;
        double nearest = (face & 1) == 0 ? box[axis] : -box[axis + 3];
        double farthest = (face & 1) == 0 ? box[axis + 3] : -box[axis];
        if (farthest <= 0) {
            return false;
        }
        nearest = Math.max(nearest, 0);                       // a quotient is then infinite, or 0/0
        return sees(box, across(face), nearest, farthest, slopes, 0) && sees(box, along(face), nearest, farthest, slopes, 2);
    }

    private static boolean sees(double[] box, int axis, double nearest, double farthest, double[] slopes, int at) {
        double from = box[axis];
        double to = box[axis + 3];
        if (from > farthest * (1 + 0x1p-20) || to < -farthest * (1 + 0x1p-20)) {
            return false;
        }
        double lowest = from < 0 ? from / nearest : from / farthest;
        double highest = to > 0 ? to / nearest : to / farthest;
        slopes[at] = lowest > -1 ? lowest - ROUNDING : -1;    // NaN: all
        slopes[at + 1] = highest < 1 ? highest + ROUNDING : 1;
        return true;
    }

    /** Enlarges the window of a face to include these slopes. */
    void open(int face, double[] slopes) {
        low[2 * face] = Math.min(low[2 * face], slopes[0]);
        high[2 * face] = Math.max(high[2 * face], slopes[1]);
        low[2 * face + 1] = Math.min(low[2 * face + 1], slopes[2]);
        high[2 * face + 1] = Math.max(high[2 * face + 1], slopes[3]);
    }

    /** Divides the windows anew into about this number of cells. */
    void divide(double cells) {
        double area = 0;
        for (int face = 0; face < FACES; face++) {
            area += Math.max(0, high[2 * face] - low[2 * face]) * Math.max(0, high[2 * face + 1] - low[2 * face + 1]);
        }
        scale = Math.sqrt(cells / Math.max(area, Double.MIN_NORMAL));
        for (int face = 0; face < FACES; face++) {
            if (high[2 * face] >= low[2 * face]) {
                columns[face] = 1 + (int) ((high[2 * face] - low[2 * face]) * scale);
                rows[face] = 1 + (int) ((high[2 * face + 1] - low[2 * face + 1]) * scale);
            }
            starts[face + 1] = starts[face] + columns[face] * rows[face];
        }
    }

    /** {@return the number of cells} The cell with this index, one more, stands for all directions outside the windows. */
    int cells() {
        return starts[FACES];
    }

    /** {@return the column of a slope, in the window} */
    int column(int face, double slope) {
        return Math.max(0, Math.min(columns[face] - 1, (int) ((slope - low[2 * face]) * scale)));
    }

    /** {@return the row of a slope, in the window} */
    int row(int face, double slope) {
        return Math.max(0, Math.min(rows[face] - 1, (int) ((slope - low[2 * face + 1]) * scale)));
    }

    /** {@return the first cell of a row} */
    int cell(int face, int row) {
        return starts[face] + row * columns[face];
    }

    /** {@return the cell of a direction} Its length is 1, or at least so large that its reciprocal is finite. */
    int cell(double dx, double dy, double dz) {
        double ax = Math.abs(dx);
        double ay = Math.abs(dy);
        double az = Math.abs(dz);
        int face;
        double across = dx;
        double along = dz;
        double by = ay;
        if (az >= ax && az >= ay) {
            face = dz >= 0 ? 4 : 5;
            by = az;
            along = dy;
        } else if (ay >= ax) {
            face = dy >= 0 ? 2 : 3;
        } else {
            face = dx >= 0 ? 0 : 1;
            by = ax;
            across = dy;
        }
        double share = 1 / by;
        int column = (int) ((across * share - low[2 * face]) * scale);
        int row = (int) ((along * share - low[2 * face + 1]) * scale);
        return column >= 0 && row >= 0 && column < columns[face] && row < rows[face] ? cell(face, row) + column : starts[FACES];
    }
}
