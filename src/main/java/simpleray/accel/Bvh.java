package simpleray.accel;

/**
 * A bounding volume hierarchy in one flat array, two children a node (Kay and Kajiya, "Ray Tracing Complex Scenes", 1986). <em>Constant.</em>
 *
 * <p>A node is 16 floats, a line of most caches: the low sides of both children's boxes along x, their high sides, the same along y and z;
 * then the two children as the bits of integers. A child is the place of a node's first number, or a leaf: the complement of its first
 * primitive times 16 plus how many there are. The root stands at place 0. An absent child is 0, and its box empty.
 */
public final class Bvh {
    /** Numbers a node. */
    static final int NODE = 16;
    /** Where in a node the children are. */
    static final int CHILDREN = 12;
    /** The last bits of a leaf tell how many primitives it has. */
    static final int COUNT_BITS = 4;
    static final int COUNT_MASK = (1 << COUNT_BITS) - 1;
    /** The most boxes within boxes. */
    static final int MAX_DEPTH = 96;

    /** The nodes. */
    final float[] nodes;
    /** How many primitives there are. */
    final int count;
    /** The middle of all boxes, from which their coordinates are. */
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
     * @param bounds the boxes of its primitives, which are brought into the order in which the leaves have them
     * @param pool who may work on it
     * @return the tree
     */
    public static Bvh of(PrimitiveBounds bounds, Pool pool) {
        return new Bvh(bounds, BvhBuilder.build(bounds, pool));
    }
}
