package simpleray.accel;

/**
 * A bounding volume hierarchy in one flat array, two children a node (Kay and Kajiya, "Ray Tracing Complex Scenes", 1986). <em>Constant.</em>
 *
 * <p>A node is 16 floats, a line of most caches: the low sides of both children's boxes along x, their high sides, the same along y and z;
 * then the two children as the bits of integers. A child is the index of a node's first number, or a leaf: the complement of (its first
 * primitive times 16 plus the number of its primitives). The root is at index 0. An absent child is 0, with an empty box.
 */
public final class Bvh {
    /** Floats of a node. */
    static final int NODE = 16;
    /** The offset of the children in a node. */
    static final int CHILDREN = 12;
    /** The number of low bits of a leaf that hold its number of primitives. */
    static final int COUNT_BITS = 4;
    static final int COUNT_MASK = (1 << COUNT_BITS) - 1;
    /** The greatest depth of the tree. */
    static final int MAX_DEPTH = 96;

    /** The nodes. */
    final float[] nodes;
    /** The number of primitives. */
    final int count;
    /** The middle of all boxes, the origin of their coordinates. */
    final double[] middle;
    /** The unit of all coordinates. */
    final double extent;

    private Bvh(PrimitiveBounds bounds, float[] nodes) {
        this.nodes = nodes;
        count = bounds.count();
        middle = bounds.middle;
        extent = bounds.extent;
    }

    /**
     * Builds a tree.
     *
     * @param bounds the boxes of its primitives, which are reordered as the leaves have them
     * @param pool the threads to build it
     * @return the tree
     */
    public static Bvh of(PrimitiveBounds bounds, Pool pool) {
        return new Bvh(bounds, BvhBuilder.build(bounds, pool));
    }
}
