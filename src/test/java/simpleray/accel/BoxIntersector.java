package simpleray.accel;

/**
 * A ray among boxes: it hits one where it enters, or where it starts if that is inside; of two at the same t the one with the lower number.
 * Knows which boxes it was shown.
 */
final class BoxIntersector implements PrimitiveIntersector {
    /** No box. */
    static final int NONE = Integer.MAX_VALUE;

    /** t of the nearest hit so far. */
    double t;
    /** The box that is hit there; {@link #NONE} if none is. */
    int id = NONE;
    /** How many boxes it was shown. */
    long tests;

    private final double[][] boxes;
    private final int[] ids;
    private double[] ray;

    /** Creates one for boxes that stand in the order of ids. */
    BoxIntersector(double[][] boxes, int[] ids) {
        this.boxes = boxes;
        this.ids = ids;
    }

    /** Begins with a ray, its origin and its direction; what is farther than a limit is no hit. */
    void start(double[] newRay, double limit) {
        ray = newRay;
        t = limit;
        id = NONE;
    }

    /** Finds by a look at each box what {@link #closest} is to find. */
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
