package simpleray.accel;

/**
 * The directions from a point as a cube about it, each face cut into cells: columns along its first axis, rows along its second.
 * <em>Constant.</em>
 *
 * @param side how many cells there are along an edge
 * @param half half of it
 */
record Cube(int side, double half) {
    /** How many faces there are; face 2 a looks along axis a, and face 2 a + 1 the other way. */
    static final int FACES = 6;

    Cube(int side) {
        this(side, 0.5 * side);
    }

    /** {@return how many cells there are} */
    int cells() {
        return FACES * side * side;
    }

    /** {@return the first axis of a face's own} */
    static int across(int face) {
        return face < 2 ? 1 : 0;
    }

    /** {@return the second axis of a face's own} */
    static int along(int face) {
        return face < 4 ? 2 : 1;
    }

    /** {@return the column or row of a slope, from -1 to 1} */
    int column(double slope) {
        return Math.max(0, Math.min(side - 1, (int) ((slope + 1) * half)));
    }

    /** {@return the slope where a column or row begins} */
    double slope(int column) {
        return 2.0 * column / side - 1;
    }

    /** {@return the cell of a direction, whose length is 1, or not so small that its reciprocal is infinite} */
    int cell(double dx, double dy, double dz) {
        double ax = Math.abs(dx);
        double ay = Math.abs(dy);
        double az = Math.abs(dz);
        int face;
        double across;
        double along;
        double by;
        if (az >= ax && az >= ay) {
            face = dz >= 0 ? 4 : 5;
            by = az;
            across = dx;
            along = dy;
        } else if (ay >= ax) {
            face = dy >= 0 ? 2 : 3;
            by = ay;
            across = dx;
            along = dz;
        } else {
            face = dx >= 0 ? 0 : 1;
            by = ax;
            across = dy;
            along = dz;
        }
        double share = half / by;
        int row = Math.min(side - 1, (int) (along * share + half) & Integer.MAX_VALUE);   // some cell, whatever the direction
        int column = Math.min(side - 1, (int) (across * share + half) & Integer.MAX_VALUE);
        return (face * side + row) * side + column;
    }
}
