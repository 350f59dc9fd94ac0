package simpleray.accel;

/**
 * The boxes of primitives, as floats from -1 to 1: relative to the middle of all of them, in units of their largest extent from there. Each box is
 * larger than its primitive by more than all rounding errors on a ray's way to it, in float or double (Ize, "Robust BVH Ray
 * Traversal", JCGT 2(2), 2013). <em>Mutable</em>: building a tree or a grid changes their order.
 */
public final class PrimitiveBounds {
    /** Floats of a box: its low corner x, y, z, then its high corner. */
    static final int SIDES = 6;
    /** The padding of a box, as a share of the half extent of all of them. */
    static final double PAD = 0x1p-20;
    /** The least padding of a box, as a share of their distance from the origin, where numbers are coarse. */
    private static final double FAR_PAD = 0x1p-40;

    private static final int DONE = -1;
    private static final double[] EMPTY = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
    /** The largest distance of a ray's origin from the middle, in extents; beyond it, rounding errors exceed the padding. */
    static final double MAX_DISTANCE = 1e6;

    /** The middle of all boxes. */
    final double[] middle = new double[3];
    /** The largest coordinate relative to the middle, which is 1 in the boxes; above 0. */
    final double extent;
    /** The boxes, six numbers each. */
    final float[] sides;
    /** The primitive of each box. */
    final int[] ids;

    /** The source of the boxes. Several threads may call at once. */
    public interface Source {
        /**
         * Computes the box of a primitive.
         *
         * @param i the primitive
         * @param box gets xmin, ymin, zmin, xmax, ymax, zmax
         */
        void bounds(int i, double[] box);
    }

    /**
     * Makes boxes.
     *
     * @param ids the primitives, one or more; kept
     * @param source gives the box of each
     * @param pool the threads to make them
     */
    public PrimitiveBounds(int[] ids, Source source, Pool pool) {
        this.ids = ids;
        sides = new float[SIDES * ids.length];
        double[] all = EMPTY.clone();
        pool.ranges(ids.length, new Pool.Work() {
            @Override
            public void on(int from, int to) {
                widen(all, source, from, to);
            }
        });
        double half = Double.MIN_NORMAL;
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
                enclose(source, pad, from, to);
            }
        });
    }

    private void widen(double[] all, Source source, int from, int to) {
        double[] own = EMPTY.clone();
        double[] box = new double[SIDES];
        for (int i = from; i < to; i++) {
            source.bounds(ids[i], box);
            for (int axis = 0; axis < 3; axis++) {
                own[axis] = Math.min(own[axis], box[axis]);
                own[axis + 3] = Math.max(own[axis + 3], box[axis + 3]);
            }
        }
        synchronized (all) {
            for (int axis = 0; axis < 3; axis++) {
                all[axis] = Math.min(all[axis], own[axis]);
                all[axis + 3] = Math.max(all[axis + 3], own[axis + 3]);
            }
        }
    }

    private void enclose(Source source, double pad, int from, int to) {
        double[] box = new double[SIDES];
        for (int i = from; i < to; i++) {
            source.bounds(ids[i], box);
            for (int axis = 0; axis < 3; axis++) {
                sides[SIDES * i + axis] = (float) ((box[axis] - middle[axis] - pad) / extent);
                sides[SIDES * i + axis + 3] = (float) ((box[axis + 3] - middle[axis] + pad) / extent);
            }
        }
    }

    /** {@return the largest distance from the middle at which a ray may start} */
    public double reach() {
        return MAX_DISTANCE * extent;
    }

    /** {@return the number of boxes} */
    public int count() {
        return ids.length;
    }

    /** {@return the primitives, in the order of the boxes} */
    public int[] ids() {
        return ids;
    }

    /** Reorders the boxes cycle by cycle. The order gives the old index of each box, and is overwritten. */
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
        int a = SIDES * i;
        int b = SIDES * j;
        for (int k = 0; k < SIDES; k++) {
            float side = sides[a + k];
            sides[a + k] = sides[b + k];
            sides[b + k] = side;
        }
    }
}
