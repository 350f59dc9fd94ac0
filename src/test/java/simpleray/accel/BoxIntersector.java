package simpleray.accel;

/**
 * Intersects a ray with boxes: it hits a box where it enters, or at its origin if that is inside; of two at the same t, that with the lower number.
 * Records which boxes a traversal tests.
 */
final class BoxIntersector implements PrimitiveIntersector {
    /** No box. */
    static final int NONE = Integer.MAX_VALUE;

    /** t of the nearest hit so far. */
    double t;
    /** The box of the nearest hit; {@link #NONE} if there is none. */
    int id = NONE;
    /** The number of boxes that were tested. */
    long tests;

    private final double[][] boxes;
    private final int[] ids;
    private double[] ray;

    /** Creates an intersector for boxes in the order of ids. */
    BoxIntersector(double[][] boxes, int[] ids) {
        this.boxes = boxes;
        this.ids = ids;
    }

    /** Starts with a ray, its origin and its direction; hits beyond a limit do not count. */
    void start(double[] newRay, double limit) {
        ray = newRay;
        t = limit;
        id = NONE;
    }

    /** Finds the nearest hit by testing each box. */
    void closestOfAll() {
        closest(null, 0, boxes.length);
    }

    @Override
    public double closest(int[] list, int first, int end) {
        for (int k = first; k < end; k++) {
            closest(ids[list == null ? k : list[k]]);
        }
        return t;
    }

    private void closest(int box) {
        tests++;
        double found = Boxes.entry(boxes[box], ray);
        if (found >= 0 && (found < t || found == t && box < id)) {
            t = found;
            id = box;
        }
    }

    @Override
    public boolean occluded(int[] list, int first, int end) {
        for (int k = first; k < end; k++) {
            if (occluded(ids[list == null ? k : list[k]])) {
                return true;
            }
        }
        return false;
    }

    private boolean occluded(int box) {
        tests++;
        double found = Boxes.entry(boxes[box], ray);
        return found >= 0 && found < t;
    }
}
