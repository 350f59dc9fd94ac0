package simpleray.accel;

import simpleray.math.Bounds;
import simpleray.scene.Object;
import simpleray.scene.Sphere;

/**
 * The boxes of bounded objects, as floats about the middle of them all, each a little larger than its object: by more than all rounding of
 * a ray's way to it, in float or double, can amount to. <em>Mutable</em>: whoever builds a tree of them changes their order.
 */
final class Boxes {
    /** Numbers a box: its low corner x, y, z, then its high one. */
    static final int SIDES = 6;
    /** By what share of the half extent of all of them a box is larger. */
    private static final double PAD = 0x1p-20;
    /** By what share of their distance from the origin, where numbers are coarse. */
    private static final double FAR_PAD = 0x1p-40;

    private static final int DONE = -1;
    private static final double[] EMPTY = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
    /** How many extents from the middle a ray may start. */
    private static final double FARTHEST = 1e6;

    /** The middle of all boxes. */
    final double[] middle = new double[3];
    /** The largest coordinate about the middle; above 0. */
    final double extent;
    /** The boxes, six numbers each. */
    final float[] sides;
    /** Which object each is of. */
    final int[] ids;
    /** Which of them are of spheres. */
    final boolean[] round;

    /**
     * Makes the boxes of objects.
     *
     * @param objects all objects of a scene
     * @param ids the places of those that get boxes, whose bounds are finite; kept
     * @param pool who may work on it
     */
    Boxes(Object[] objects, int[] ids, Pool pool) {
        this.ids = ids;
        sides = new float[SIDES * ids.length];
        round = new boolean[ids.length];
        double[] all = EMPTY.clone();
        pool.ranges(ids.length, new Pool.Work() {
            @Override
            public void on(int from, int to) {
                widen(all, objects, from, to);
            }
        });
        double half = Float.MIN_NORMAL;
        double far = 0;
        for (int axis = 0; axis < 3; axis++) {
            middle[axis] = (all[axis] + all[axis + 3]) / 2;
            half = Math.max(half, (all[axis + 3] - all[axis]) / 2);
            far = Math.max(far, Math.abs(middle[axis]));
        }
        double pad = Math.max(half * PAD, far * FAR_PAD);
        extent = half + pad;
        pool.ranges(ids.length, new Pool.Work() {
            @Override
            public void on(int from, int to) {
                enclose(objects, pad, from, to);
            }
        });
    }

    private void widen(double[] all, Object[] objects, int from, int to) {
        double[] own = EMPTY.clone();
        for (int i = from; i < to; i++) {
            Bounds b = objects[ids[i]].bounds();              // which no memory is spent on, unless they are kept
            own[0] = Math.min(own[0], b.xmin());
            own[1] = Math.min(own[1], b.ymin());
            own[2] = Math.min(own[2], b.zmin());
            own[3] = Math.max(own[3], b.xmax());
            own[4] = Math.max(own[4], b.ymax());
            own[5] = Math.max(own[5], b.zmax());
        }
        synchronized (all) {
            for (int axis = 0; axis < 3; axis++) {
                all[axis] = Math.min(all[axis], own[axis]);
                all[axis + 3] = Math.max(all[axis + 3], own[axis + 3]);
            }
        }
    }

    private void enclose(Object[] objects, double pad, int from, int to) {
        for (int i = from; i < to; i++) {
            Object object = objects[ids[i]];
            round[i] = object instanceof Sphere;
            Bounds b = object.bounds();
            int at = SIDES * i;
            sides[at] = (float) (b.xmin() - middle[0] - pad);
            sides[at + 1] = (float) (b.ymin() - middle[1] - pad);
            sides[at + 2] = (float) (b.zmin() - middle[2] - pad);
            sides[at + 3] = (float) (b.xmax() - middle[0] + pad);
            sides[at + 4] = (float) (b.ymax() - middle[1] + pad);
            sides[at + 5] = (float) (b.zmax() - middle[2] + pad);
        }
    }

    /** {@return a length that is more than all rounding of a ray's way} */
    double slack() {
        return extent * PAD;
    }

    /** {@return how far from the middle a ray may start; from farther away rounding would not let it find its way} */
    double reach() {
        return FARTHEST * extent;
    }

    /** {@return how many there are} */
    int count() {
        return ids.length;
    }

    /** Brings the boxes into an order, given as where each comes from, which is used up: round after round, as each makes room for the next. */
    void reorder(int[] order) {
        for (int i = 0; i < order.length; i++) {
            int at = i;
            while (order[at] >= 0) {
                int from = order[at];
                order[at] = DONE;
                if (from != i) {
                    swap(at, from);
                }
                at = from;
            }
        }
    }

    /** Swaps two boxes. */
    void swap(int i, int j) {
        int id = ids[i];
        ids[i] = ids[j];
        ids[j] = id;
        boolean ball = round[i];
        round[i] = round[j];
        round[j] = ball;
        int a = SIDES * i;
        int b = SIDES * j;
        for (int k = 0; k < SIDES; k++) {
            float side = sides[a + k];
            sides[a + k] = sides[b + k];
            sides[b + k] = side;
        }
    }
}
