package simpleray.accel;

/**
 * The convex hull of a point and a parallelogram, in which all rays between them run; finds the primitives in it (Haines and Wallace,
 * "Shaft Culling for Efficient Ray-Traced Radiosity", 1991). <em>Mutable</em>: one thread's own.
 */
public final class Shaft {
    /** The result for a shaft of too many primitives, or from too far away. */
    public static final int NO_LIST = -1;
    private static final int CORNERS = 4;

    private final int[] list;
    private int listed;
    private final int[] stack = new int[Bvh.MAX_DEPTH];
    /** The point and the corners, in the tree's coordinates. */
    private final double[][] points = new double[CORNERS + 1][3];
    private final double[] low = new double[3];
    private final double[] high = new double[3];
    /** Of each plane through the point and two corners its normal, and the farthest that the shaft reaches along it. */
    private final double[][] sides = new double[CORNERS][4];

    /**
     * Creates an empty shaft.
     *
     * @param list gets the primitives of each shaft
     */
    public Shaft(int[] list) {
        this.list = list;
    }

    /**
     * Sets a corner.
     *
     * @param i 0 for the point; 1 to 4 for the corners of the parallelogram in turn
     * @param x its place
     * @param y its place
     * @param z its place
     */
    public void set(int i, double x, double y, double z) {
        points[i][0] = x;
        points[i][1] = y;
        points[i][2] = z;
    }

    /**
     * Lists the primitives that a ray in the shaft may hit, and perhaps some more. A box is larger than its primitive by more than the
     * rounding errors here.
     *
     * @param bvh the tree
     * @return their number; {@link #NO_LIST} if they are more than the list can hold, or it cannot be told which they are
     */
    public int primitives(Bvh bvh) {
        listed = 0;
        return enter(bvh) && traverse(bvh.nodes) ? listed : NO_LIST;
    }

    private boolean enter(Bvh bvh) {
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Double.POSITIVE_INFINITY;
            high[axis] = Double.NEGATIVE_INFINITY;
            for (double[] point : points) {
                point[axis] = (point[axis] - bvh.middle[axis]) / bvh.extent;
                if (!(Math.abs(point[axis]) <= PrimitiveBounds.MAX_DISTANCE)) {
                    return false;
                }
                low[axis] = Math.min(low[axis], point[axis]);
                high[axis] = Math.max(high[axis], point[axis]);
            }
        }
        for (int i = 0; i < CORNERS; i++) {
            setSide(sides[i], points[0], points[i + 1], points[(i + 1) % CORNERS + 1]);
        }
        return true;
    }

    /** Computes a plane of the shaft. It holds whatever the rounding errors of its normal: the reach is taken along the very normal. */
    private void setSide(double[] side, double[] from, double[] one, double[] other) {
        double ux = one[0] - from[0];
        double uy = one[1] - from[1];
        double uz = one[2] - from[2];
        double vx = other[0] - from[0];
        double vy = other[1] - from[1];
        double vz = other[2] - from[2];
        side[0] = uy * vz - uz * vy;
        side[1] = uz * vx - ux * vz;
        side[2] = ux * vy - uy * vx;
        double middle = 0;
        for (int axis = 0; axis < 3; axis++) {                // outward: away from the middle of the corners
            middle += side[axis] * ((points[1][axis] + points[3][axis]) / 2 - from[axis]);
        }
        if (middle > 0) {
            for (int axis = 0; axis < 3; axis++) {
                side[axis] = -side[axis];
            }
        }
        side[3] = Double.NEGATIVE_INFINITY;
        for (double[] point : points) {
            side[3] = Math.max(side[3], side[0] * point[0] + side[1] * point[1] + side[2] * point[2]);
        }
    }

    private boolean traverse(float[] n) {
        int top = 0;
        int node = 0;
        while (true) {
            for (int i = 0; i < 2; i++) {
                int child = Float.floatToRawIntBits(n[node + Bvh.CHILDREN + i]);
                if (child != 0 && meets(n, node + i)) {
                    if (child > 0) {
                        stack[top++] = child;
                    } else if (!add(~child >> Bvh.COUNT_BITS, ~child & Bvh.COUNT_MASK)) {
                        return false;
                    }
                }
            }
            if (top == 0) {
                return true;
            }
            node = stack[--top];
        }
    }

    private boolean add(int first, int count) {
        if (listed + count > list.length) {
            return false;
        }
        for (int i = 0; i < count; i++) {
            list[listed++] = first + i;
        }
        return true;
    }

    /** {@return whether the shaft may meet a box} It begins here; a side of it is every fourth number. */
    private boolean meets(float[] n, int box) {
        for (int axis = 0; axis < 3; axis++) {
            if (n[box + 4 * axis] > high[axis] || n[box + 4 * axis + 2] < low[axis]) {
                return false;
            }
        }
        for (double[] side : sides) {
            double nearest = side[0] * n[side[0] > 0 ? box : box + 2] + side[1] * n[side[1] > 0 ? box + 4 : box + 6]
                + side[2] * n[side[2] > 0 ? box + 8 : box + 10];
            if (nearest > side[3]) {
                return false;
            }
        }
        return true;
    }
}
