package simpleray.scene;

import java.util.Arrays;

/**
 * Builds a tree of boxes around triangles, from the top: a box is cut where the surface area heuristic finds it cheapest among a few places
 * (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007), and at the middle triangle where it is deep.
 * <em>Mutable</em>, used once.
 */
final class TriangleTreeBuilder {
    private static final int BINS = 16;
    /** A leaf has no more triangles than these. */
    private static final int MOST_IN_LEAF = 6;
    /** What the visit of two boxes costs, a triangle's test being 1. */
    private static final double VISIT = 1.2;
    /** At this depth and below boxes are cut at the middle, so that no tree is deeper than this and 31 more. */
    private static final int DEEP = 64;
    private static final double[] EMPTY = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};

    /** The triangles in the order of the leaves. */
    final int[] order;
    /** The box of each triangle. */
    private final double[] sides;
    private double[] boxes;
    private int[] first;
    private int[] counts;
    private int nodes;

    private final int[] binCounts = new int[3 * BINS];
    private final double[] binBoxes = new double[3 * 6 * BINS];
    private final double[] rightCosts = new double[BINS];
    /** The box around the centres of a node's triangles, twice as large as it is. */
    private final double[] around = new double[6];

    TriangleTreeBuilder(Triangles triangles) {
        int n = triangles.count();
        order = new int[n];
        sides = new double[6 * n];
        for (int i = 0; i < n; i++) {
            order[i] = i;
            System.arraycopy(EMPTY, 0, sides, 6 * i, 6);
            for (int corner = 0; corner < 3; corner++) {
                int v = 3 * triangles.corners()[3 * i + corner];
                for (int axis = 0; axis < 3; axis++) {
                    double x = triangles.vertices()[v + axis];
                    sides[6 * i + axis] = Math.min(sides[6 * i + axis], x);
                    sides[6 * i + 3 + axis] = Math.max(sides[6 * i + 3 + axis], x);
                }
            }
        }
        boxes = new double[6 * Math.max(1, n)];
        first = new int[Math.max(1, n)];
        counts = new int[Math.max(1, n)];
        if (n > 0) {
            nodes = 1;
            build(0, 0, n, 0);
        }
    }

    double[] boxes() {
        return Arrays.copyOf(boxes, 6 * nodes);
    }

    int[] first() {
        return Arrays.copyOf(first, nodes);
    }

    int[] counts() {
        return Arrays.copyOf(counts, nodes);
    }

    /** Makes a node of the triangles at these places of the order. */
    private void build(int node, int from, int to, int depth) {
        System.arraycopy(EMPTY, 0, boxes, 6 * node, 6);
        System.arraycopy(EMPTY, 0, around, 0, 6);
        for (int i = from; i < to; i++) {
            grow(boxes, 6 * node, sides, 6 * order[i]);
            for (int axis = 0; axis < 3; axis++) {
                double centre = centre(order[i], axis);
                around[axis] = Math.min(around[axis], centre);
                around[axis + 3] = Math.max(around[axis + 3], centre);
            }
        }
        int cut = to - from == 1 ? from : cut(node, from, to, depth);
        if (cut == from) {
            first[node] = from;
            counts[node] = to - from;
            return;
        }
        int child = nodes;
        nodes += 2;
        if (nodes > first.length) {
            int room = (int) Math.min(Integer.MAX_VALUE / 6, nodes * 3L / 2);
            boxes = Arrays.copyOf(boxes, 6 * room);
            first = Arrays.copyOf(first, room);
            counts = Arrays.copyOf(counts, room);
        }
        first[node] = child;
        build(child, from, cut, depth + 1);
        build(child + 1, cut, to, depth + 1);
    }

    /** Parts the triangles at these places into two groups; returns where the second begins, or from if a leaf is cheaper. */
    private int cut(int node, int from, int to, int depth) {
        int n = to - from;
        int widest = 0;
        for (int axis = 1; axis < 3; axis++) {
            widest = around[axis + 3] - around[axis] > around[widest + 3] - around[widest] ? axis : widest;
        }
        double width = around[widest + 3] - around[widest];
        if (!(width > 0)) {                                   // all centres are one: no place is better than another
            return n <= MOST_IN_LEAF ? from : from + n / 2;
        }
        if (depth >= DEEP) {
            return n <= MOST_IN_LEAF ? from : middle(from, to, widest);
        }
        double cheapest = Double.POSITIVE_INFINITY;
        int bestAxis = -1;
        int bestBin = 0;
        fill(from, to);
        for (int axis = 0; axis < 3; axis++) {
            if (around[axis + 3] - around[axis] > 0) {
                int bin = cheapest(BINS * axis);
                if (rightCosts[bin] < cheapest) {
                    cheapest = rightCosts[bin];
                    bestAxis = axis;
                    bestBin = bin;
                }
            }
        }
        if (n <= MOST_IN_LEAF && n <= VISIT + cheapest / area(boxes, 6 * node)) {
            return from;
        }
        int cut = bestAxis < 0 ? from : part(from, to, bestAxis, bestBin);
        return cut > from && cut < to ? cut : middle(from, to, widest);
    }

    /** Puts the triangles into bins by their centres, along each axis. */
    private void fill(int from, int to) {
        for (int bin = 0; bin < 3 * BINS; bin++) {
            binCounts[bin] = 0;
            System.arraycopy(EMPTY, 0, binBoxes, 6 * bin, 6);
        }
        for (int i = from; i < to; i++) {
            for (int axis = 0; axis < 3; axis++) {
                int bin = BINS * axis + bin(order[i], axis);
                binCounts[bin]++;
                grow(binBoxes, 6 * bin, sides, 6 * order[i]);
            }
        }
    }

    /** Finds the bin of an axis before which to cut; its cost, areas times numbers of triangles, stands in rightCosts. */
    private int cheapest(int start) {
        double[] box = EMPTY.clone();
        int count = 0;
        for (int bin = BINS - 1; bin > 0; bin--) {
            count += binCounts[start + bin];
            grow(box, 0, binBoxes, 6 * (start + bin));
            rightCosts[bin] = count == 0 ? 0 : count * area(box, 0);
        }
        System.arraycopy(EMPTY, 0, box, 0, 6);
        count = 0;
        int best = 1;
        for (int bin = 1; bin < BINS; bin++) {
            count += binCounts[start + bin - 1];
            grow(box, 0, binBoxes, 6 * (start + bin - 1));
            rightCosts[bin] += count == 0 ? 0 : count * area(box, 0);
            best = rightCosts[bin] < rightCosts[best] ? bin : best;
        }
        return best;
    }

    /** Moves the triangles of the bins before this one to the front; returns where the others begin. */
    private int part(int from, int to, int axis, int bin) {
        int left = from;
        for (int i = from; i < to; i++) {
            if (bin(order[i], axis) < bin) {
                swap(left++, i);
            }
        }
        return left;
    }

    /** Sorts the triangles about the middle one along an axis (Hoare's selection); returns the middle. */
    private int middle(int from, int to, int axis) {
        int middle = (from + to) >>> 1;
        int low = from;
        int high = to - 1;
        while (low < high) {
            double pivot = centre(order[(low + high) >>> 1], axis);
            int i = low;
            int j = high;
            while (i <= j) {
                while (centre(order[i], axis) < pivot) {
                    i++;
                }
                while (centre(order[j], axis) > pivot) {
                    j--;
                }
                if (i <= j) {
                    swap(i++, j--);
                }
            }
            if (middle <= j) {
                high = j;
            } else if (middle >= i) {
                low = i;
            } else {
                break;
            }
        }
        return middle;
    }

    private void swap(int i, int j) {
        int kept = order[i];
        order[i] = order[j];
        order[j] = kept;
    }

    private int bin(int triangle, int axis) {
        double share = (centre(triangle, axis) - around[axis]) / (around[axis + 3] - around[axis]);
        return Math.min(BINS - 1, (int) (share * BINS));      // where all centres are one the share is NaN, and the bin 0
    }

    /** {@return twice the centre of a triangle's box along an axis} */
    private double centre(int triangle, int axis) {
        return sides[6 * triangle + axis] + sides[6 * triangle + 3 + axis];
    }

    private static void grow(double[] box, int at, double[] by, int from) {
        for (int axis = 0; axis < 3; axis++) {
            double low = by[from + axis];
            double high = by[from + 3 + axis];
            box[at + axis] = low < box[at + axis] ? low : box[at + axis];
            box[at + 3 + axis] = high > box[at + 3 + axis] ? high : box[at + 3 + axis];
        }
    }

    /** {@return half the surface of a box} */
    private static double area(double[] box, int at) {
        double x = box[at + 3] - box[at];
        double y = box[at + 4] - box[at + 1];
        double z = box[at + 5] - box[at + 2];
        return x * y + y * z + z * x;
    }
}
