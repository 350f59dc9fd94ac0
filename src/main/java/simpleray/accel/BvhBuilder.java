package simpleray.accel;

import java.util.Arrays;
import java.util.function.Supplier;

/**
 * Builds a tree of boxes from the top. A box is split where the surface area heuristic gives the lowest cost among a few places along its longest
 * axis (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007). Large subtrees are built in parallel. A node's index follows
 * from the number of primitives before it, so the threads need no synchronisation. <em>Mutable</em>, used once.
 */
final class BvhBuilder {
    private static final int BINS = 16;
    /** Ranges of no more primitives use fewer bins. */
    private static final int FEW = 64;
    private static final int FEW_BINS = 8;
    /** The most primitives of a leaf. */
    private static final int MAX_LEAF = 8;
    /** The cost of visiting a node, relative to the test of a primitive. */
    private static final float VISIT = 1;
    /** Middles that are no farther apart count as equal. */
    private static final float MIN_WIDTH = 1e-30f;
    /** From this depth on, ranges are halved. */
    private static final int HALVING_DEPTH = 60;
    /** The fewest primitives for which a task of their own pays. */
    private static final int TASK = 8192;
    /** Floats of a range: the box around its boxes, and the box around their middles, doubled. */
    private static final int RANGE = 2 * PrimitiveBounds.SIDES;
    private static final float[] EMPTY = {Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY,
        Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY};

    private final PrimitiveBounds bounds;
    private final float[] sides;
    private final float[] nodes;                              // with gaps where leaves have several primitives
    private int used;

    private BvhBuilder(PrimitiveBounds bounds) {
        this.bounds = bounds;
        sides = bounds.sides;
        nodes = new float[Bvh.NODE * Math.max(1, bounds.count() - 1)];
    }

    static float[] build(PrimitiveBounds bounds, Pool pool) {
        BvhBuilder builder = new BvhBuilder(bounds);
        Subtree all = builder.new Subtree(pool);
        all.measure(bounds.count());
        all.build(0, 0, bounds.count(), 0);
        float[] packed = new float[builder.used(0)];
        builder.used = 0;
        builder.pack(0, packed);
        return packed;
    }

    /** {@return the number of floats of the nodes from this one down} */
    private int used(int node) {
        int sum = Bvh.NODE;
        for (int i = 0; i < 2; i++) {
            int child = Float.floatToRawIntBits(nodes[node + Bvh.CHILDREN + i]);
            sum += child > 0 ? used(child) : 0;
        }
        return sum;
    }

    /** Copies the nodes from this one down, without gaps. {@return the new index of this one} */
    private int pack(int node, float[] packed) {
        int place = used;
        used += Bvh.NODE;
        System.arraycopy(nodes, node, packed, place, Bvh.NODE);
        for (int i = 0; i < 2; i++) {
            int child = Float.floatToRawIntBits(nodes[node + Bvh.CHILDREN + i]);
            if (child > 0) {
                packed[place + Bvh.CHILDREN + i] = Float.intBitsToFloat(pack(child, packed));
            }
        }
        return place;
    }

    /** Enlarges a box to contain another. Comparisons are mostly predicted right, and then faster than {@link Math#min}. */
    private static void grow(float[] box, int at, float[] by, int from) {
        if (by[from] < box[at]) {
            box[at] = by[from];
        }
        if (by[from + 1] < box[at + 1]) {
            box[at + 1] = by[from + 1];
        }
        if (by[from + 2] < box[at + 2]) {
            box[at + 2] = by[from + 2];
        }
        if (by[from + 3] > box[at + 3]) {
            box[at + 3] = by[from + 3];
        }
        if (by[from + 4] > box[at + 4]) {
            box[at + 4] = by[from + 4];
        }
        if (by[from + 5] > box[at + 5]) {
            box[at + 5] = by[from + 5];
        }
    }

    /** {@return half the surface area of a box} */
    private static float area(float[] box, int at) {
        float x = box[at + 3] - box[at];
        float y = box[at + 4] - box[at + 1];
        float z = box[at + 5] - box[at + 2];
        return x * y + y * z + z * x;
    }

    /** The working data of a thread that builds a subtree. */
    private final class Subtree {
        final Pool pool;
        /** The ranges of each node on the way down and of its sibling. */
        private final float[] ranges = new float[2 * RANGE * (Bvh.MAX_DEPTH + 1)];
        private final float[] bins = new float[BINS * PrimitiveBounds.SIDES];
        private final int[] counts = new int[BINS];
        private final float[] highCosts = new float[BINS];
        private final float[] box = new float[PrimitiveBounds.SIDES];
        private int current;                                  // the offset of the range being split
        private int bestAxis;
        private int bestBin;
        private int binCount;

        Subtree(Pool pool) {
            this.pool = pool;
        }

        /** Computes the range of all primitives. */
        void measure(int count) {
            clear(0);
            for (int i = 0; i < count; i++) {
                grow(0, i);
            }
        }

        private void clear(int range) {
            System.arraycopy(EMPTY, 0, ranges, range, PrimitiveBounds.SIDES);
            System.arraycopy(EMPTY, 0, ranges, range + PrimitiveBounds.SIDES, PrimitiveBounds.SIDES);
        }

        /** Enlarges a range to contain a primitive. */
        private void grow(int range, int primitive) {
            int at = PrimitiveBounds.SIDES * primitive;
            float[] r = ranges;
            BvhBuilder.grow(r, range, sides, at);
            for (int axis = 0; axis < 3; axis++) {
                float middle = sides[at + axis] + sides[at + axis + 3];
                if (middle < r[range + 6 + axis]) {
                    r[range + 6 + axis] = middle;
                }
                if (middle > r[range + 9 + axis]) {
                    r[range + 9 + axis] = middle;
                }
            }
        }

        /** Builds a node of the primitives from first to before end, whose range is the first of this depth. */
        void build(int node, int first, int end, int depth) {
            current = 2 * RANGE * depth;
            int middle = split(first, end, depth);
            if (middle == first) {                            // the root is a leaf
                leaf(node, 0, current, first, end);
                System.arraycopy(EMPTY, 0, ranges, current + RANGE, PrimitiveBounds.SIDES);
                box(node, 1, current + RANGE);
                return;
            }
            inner(node, first, middle, end, depth);
        }

        /** Builds a node whose primitives are split, with the ranges of both parts at the next depth. */
        private void inner(int node, int first, int middle, int end, int depth) {
            int left = 2 * RANGE * (depth + 1);
            Pool.Task<Subtree> task = null;
            if (middle - first >= TASK && end - middle >= TASK) {
                Subtree other = new Subtree(pool);
                System.arraycopy(ranges, left + RANGE, other.ranges, left, RANGE);
                int place = node + Bvh.NODE * (middle - first);
                box(node, 1, left + RANGE);
                child(node, 1, place);
                task = pool.begin(new Supplier<>() {
                    @Override
                    public Subtree get() {
                        other.build(place, middle, end, depth + 1);
                        return other;
                    }
                });
            }
            part(node, 0, node + Bvh.NODE, first, middle, depth + 1);
            if (task == null) {
                part(node, 1, node + Bvh.NODE * (middle - first), middle, end, depth + 1);
            } else {
                pool.await(task);
            }
        }

        /** Builds a child at this index, or makes it a leaf. */
        private void part(int node, int child, int place, int first, int end, int depth) {
            int range = 2 * RANGE * depth + RANGE * child;
            current = range;
            int middle = split(first, end, depth);
            if (middle == first) {
                leaf(node, child, range, first, end);
            } else {
                box(node, child, range);
                child(node, child, place);
                inner(place, first, middle, end, depth);
            }
        }

        private void leaf(int node, int child, int range, int first, int end) {
            box(node, child, range);
            child(node, child, ~(first << Bvh.COUNT_BITS | end - first));
        }

        private void child(int node, int child, int what) {
            nodes[node + Bvh.CHILDREN + child] = Float.intBitsToFloat(what);
        }

        private void box(int node, int child, int range) {
            for (int axis = 0; axis < 3; axis++) {
                nodes[node + 4 * axis + child] = ranges[range + axis];
                nodes[node + 4 * axis + 2 + child] = ranges[range + axis + 3];
            }
        }

        /** Splits the current range in two. {@return the start of the second part; the first primitive if a leaf is cheaper} */
        private int split(int first, int end, int depth) {
            int count = end - first;
            if (count == 1) {
                return first;
            }
            float cost = depth < HALVING_DEPTH ? find(first, end) : Float.POSITIVE_INFINITY;
            float area = area(ranges, current);
            if (count <= MAX_LEAF && !(cost + VISIT * area < count * area)) {
                return first;
            }
            int low = 2 * RANGE * (depth + 1);
            clear(low);
            clear(low + RANGE);
            return cost < Float.POSITIVE_INFINITY ? part(first, end, low) : halve(first, end, low);
        }

        private int halve(int first, int end, int low) {
            int middle = (first + end) >>> 1;
            for (int i = first; i < end; i++) {
                grow(i < middle ? low : low + RANGE, i);
            }
            return middle;
        }

        /** Moves the primitives of the bins before the best split to the front, and computes both ranges. */
        private int part(int first, int end, int low) {
            float from = ranges[current + 6 + bestAxis];
            float scale = scale();
            int i = first;
            int last = end - 1;
            while (i <= last) {
                int at = PrimitiveBounds.SIDES * i + bestAxis;
                if ((int) ((sides[at] + sides[at + 3] - from) * scale) < bestBin) {
                    grow(low, i++);
                } else {
                    grow(low + RANGE, i);
                    bounds.swap(i, last--);
                }
            }
            return i;
        }

        /** Finds the best split along the axis on which the middles are farthest apart. {@return its cost; infinite if there is none} */
        private float find(int first, int end) {
            bestAxis = 0;
            for (int axis = 1; axis < 3; axis++) {
                bestAxis = width(axis) > width(bestAxis) ? axis : bestAxis;
            }
            if (!(width(bestAxis) > MIN_WIDTH)) {
                return Float.POSITIVE_INFINITY;
            }
            binCount = end - first < FEW ? FEW_BINS : BINS;
            fill(first, end);
            bestBin = cheapest();
            return highCosts[bestBin];
        }

        /** {@return the extent of the middles along an axis, doubled} */
        private float width(int axis) {
            return ranges[current + 9 + axis] - ranges[current + 6 + axis];
        }

        /** {@return the number of bins per unit of length} */
        private float scale() {
            return binCount / width(bestAxis) * 0.9999f;
        }

        /** Sorts the primitives into bins by their middles. */
        private void fill(int first, int end) {
            Arrays.fill(counts, 0);
            for (int bin = 0; bin < binCount; bin++) {
                System.arraycopy(EMPTY, 0, bins, PrimitiveBounds.SIDES * bin, PrimitiveBounds.SIDES);
            }
            float[] s = sides;
            int axis = bestAxis;
            float from = ranges[current + 6 + axis];
            float scale = scale();
            for (int i = first; i < end; i++) {
                int at = PrimitiveBounds.SIDES * i;
                put((int) ((s[at + axis] + s[at + axis + 3] - from) * scale), at);
            }
        }

        private void put(int bin, int at) {
            counts[bin]++;
            BvhBuilder.grow(bins, PrimitiveBounds.SIDES * bin, sides, at);
        }

        /** Finds the bin before which to split; its cost, areas times numbers of primitives, is then in highCosts. */
        private int cheapest() {
            System.arraycopy(EMPTY, 0, box, 0, PrimitiveBounds.SIDES);
            int count = 0;
            for (int bin = binCount - 1; bin > 0; bin--) {
                count += counts[bin];
                BvhBuilder.grow(box, 0, bins, PrimitiveBounds.SIDES * bin);
                highCosts[bin] = count == 0 ? Float.POSITIVE_INFINITY : count * area(box, 0);
            }
            System.arraycopy(EMPTY, 0, box, 0, PrimitiveBounds.SIDES);
            count = 0;
            int best = 1;
            for (int bin = 1; bin < binCount; bin++) {
                count += counts[bin - 1];
                BvhBuilder.grow(box, 0, bins, PrimitiveBounds.SIDES * (bin - 1));
                highCosts[bin] += count == 0 ? Float.POSITIVE_INFINITY : count * area(box, 0);
                best = highCosts[bin] < highCosts[best] ? bin : best;
            }
            return best;
        }
    }
}
