package simpleray.scene;

import java.util.Arrays;

/**
 * A tree of boxes around triangles, in flat arrays, that finds the nearest hit of a ray without a look at most of them. <em>Constant</em>
 * once it is built; any thread may look, each with its own probe.
 *
 * <p>No hit is lost by rounding: boxes are padded by more than a vertex can be off when it is moved to the ray, and the ray's stretch in a
 * box by more than its two ends can (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013).
 */
final class TriangleTree {
    /** The most boxes within boxes; see {@link TriangleTreeBuilder}. */
    static final int MOST_DEPTH = 100;
    /** A length's share that is larger than a few roundings. */
    private static final double ROUNDINGS = 0x1p-49;

    private static final double MISSED = Double.POSITIVE_INFINITY;

    final Triangles triangles;
    /** xmin, ymin, zmin, xmax, ymax, zmax of each node's box. */
    private final double[] boxes;
    /** Of a node with children the first of the two, which lie side by side; of a leaf the place of its first triangle. */
    private final int[] first;
    /** Of a leaf the number of triangles; 0 of a node with children. */
    private final int[] counts;
    /** The triangles in the order of the leaves. */
    private final int[] order;
    /** The places of their corners among the coordinates, in that order too: three times the vertices' numbers. */
    private final int[] corners;

    /** Builds the tree, in O(n log n). */
    TriangleTree(Triangles triangles) {
        this.triangles = triangles;
        TriangleTreeBuilder built = new TriangleTreeBuilder(triangles);
        boxes = built.boxes();
        first = built.first();
        counts = built.counts();
        order = built.order;
        corners = new int[3 * order.length];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = 3 * triangles.corners()[3 * order[i / 3] + i % 3];
        }
        double largest = 0;
        for (double coordinate : triangles.vertices()) {
            largest = Math.max(largest, Math.abs(coordinate));
        }
        double padding = largest * ROUNDINGS;
        for (int i = 0; i < boxes.length; i++) {
            boxes[i] += i % 6 < 3 ? -padding : padding;
        }
    }

    /** {@return the six sides of the box around all, padded: xmin, ymin, zmin, xmax, ymax, zmax; empty if there is no triangle} */
    double[] box() {
        return Arrays.copyOf(boxes, Math.min(boxes.length, 6));
    }

    /** Finds the nearest triangle that a probe hits, which has just been started. */
    void walk(TriangleProbe probe) {
        if (first.length == 0) {
            return;
        }
        int depth = 0;
        int node = 0;
        double entry = enter(0, probe);
        while (true) {
            if (entry <= probe.t && entry < MISSED) {
                if (counts[node] == 0) {
                    int child = first[node];
                    double one = enter(child, probe);
                    double other = enter(child + 1, probe);
                    int near = one <= other ? 0 : 1;
                    double far = Math.max(one, other);
                    if (far <= probe.t && far < MISSED) {
                        probe.stack[depth] = child + 1 - near;
                        probe.entry[depth++] = far;
                    }
                    node = child + near;
                    entry = Math.min(one, other);
                    continue;
                }
                int end = first[node] + counts[node];
                for (int i = first[node]; i < end; i++) {
                    probe.look(triangles.vertices(), corners[3 * i], corners[3 * i + 1], corners[3 * i + 2], order[i]);
                }
            }
            if (depth == 0) {
                return;
            }
            node = probe.stack[--depth];
            entry = probe.entry[depth];
        }
    }

    /** {@return a t not above that at which the ray enters the node's box; infinite if it misses the box} */
    double enter(int node, TriangleProbe probe) {
        int box = 6 * node;
        double near = 0;
        double far = MISSED;
        double ax = (boxes[box + probe.nx] - probe.ox) * probe.ix;   // NaN when the ray runs along this side: it bounds nothing then
        double ay = (boxes[box + probe.ny] - probe.oy) * probe.iy;
        double az = (boxes[box + probe.nz] - probe.oz) * probe.iz;
        near = ax > near ? ax : near;
        near = ay > near ? ay : near;
        near = az > near ? az : near;
        double bx = (boxes[box + 3 - probe.nx] - probe.ox) * probe.ix;
        double by = (boxes[box + 5 - probe.ny] - probe.oy) * probe.iy;
        double bz = (boxes[box + 7 - probe.nz] - probe.oz) * probe.iz;
        far = bx < far ? bx : far;
        far = by < far ? by : far;
        far = bz < far ? bz : far;
        near *= 1 - ROUNDINGS;
        return near <= far * (1 + ROUNDINGS) ? near : MISSED;
    }
}
