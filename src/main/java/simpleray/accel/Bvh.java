package simpleray.accel;

import java.util.ArrayList;
import java.util.List;

/**
 * A bounding volume hierarchy, four children a node (Dammertz, Hanika and Keller, "Shallow Bounding Volume Hierarchies for Fast SIMD Ray
 * Tracing of Incoherent Rays", 2008), in flat arrays. <em>Constant.</em>
 */
final class Bvh implements Structure {
    /** Children of a node. */
    static final int WIDTH = 4;
    /** The most boxes within boxes. */
    static final int DEPTH = 100;
    /** A child that is a leaf is ~(its first object << COUNT_BITS | how many there are). */
    static final int COUNT_BITS = 4;
    static final int COUNT_MASK = (1 << COUNT_BITS) - 1;
    /** Numbers of a node: the low x of its children's boxes, then their low y, z, high x, y, z. */
    static final int STRIDE = Boxes.SIDES * WIDTH;

    private static final int MOST_IN_LEAF = 8;
    /** From here on a tree gets no deeper than halving makes it. */
    private static final int EVEN_DEPTH = 60;
    /** So many boxes are worth a task of their own. */
    private static final int TASK = 4096;

    /** The children's boxes, {@link #STRIDE} numbers a node, the root first; an absent child's is empty. */
    final float[] sides;
    /** The children of each node: a node, or the complement of a leaf. */
    final int[] children;

    final Boxes boxes;
    private int used;

    private Bvh(Boxes boxes, Node root, int nodes) {
        this.boxes = boxes;
        sides = new float[STRIDE * nodes];
        children = new int[WIDTH * nodes];
        flatten(root);
    }

    /**
     * Builds a tree.
     *
     * @param boxes the boxes, one or more; brought into the order in which the leaves have them
     * @param pool who may work on it
     */
    static Bvh build(Boxes boxes, Pool pool) {
        Node root = pool.run(new NodeTask(pool, new Span(boxes, 0, boxes.count()), 0));
        return new Bvh(boxes, root, root.count());
    }

    @Override
    public Walk walk(Finder finder) {
        return new BvhWalk(this, finder);
    }

    private int flatten(Node node) {
        int place = used++;
        System.arraycopy(node.sides, 0, sides, STRIDE * place, STRIDE);
        for (int i = 0; i < WIDTH; i++) {
            children[WIDTH * place + i] = node.nodes[i] == null ? node.leaves[i] : flatten(node.nodes[i]);
        }
        return place;
    }

    /** A node while the tree is built. */
    private static final class Node {
        final float[] sides = new float[STRIDE];
        final Node[] nodes = new Node[WIDTH];
        final int[] leaves = new int[WIDTH];

        int count() {
            int count = 1;
            for (Node node : nodes) {
                count += node == null ? 0 : node.count();
            }
            return count;
        }
    }

    /** Builds the node of a span. */
    private static final class NodeTask extends Pool.Task<Node> {
        private static final long serialVersionUID = 1L;
        private final transient Span span;
        private final int depth;

        NodeTask(Pool pool, Span span, int depth) {
            super(pool);
            this.span = span;
            this.depth = depth;
        }

        @Override
        Node find() {
            Node node = new Node();
            List<Span> spans = spans();
            NodeTask[] forked = new NodeTask[WIDTH];
            for (int i = 0; i < WIDTH; i++) {
                if (i >= spans.size()) {
                    for (int side = 0; side < Boxes.SIDES; side++) {
                        node.sides[side * WIDTH + i] = side < 3 ? Float.POSITIVE_INFINITY : Float.NEGATIVE_INFINITY;
                    }
                    continue;
                }
                Span part = spans.get(i);
                for (int side = 0; side < Boxes.SIDES; side++) {
                    node.sides[side * WIDTH + i] = part.bounds[side];
                }
                if (leaf(part)) {
                    node.leaves[i] = ~(part.first << COUNT_BITS | part.count());
                } else {
                    NodeTask task = new NodeTask(pool, part, depth + 1);
                    if (part.count() >= TASK) {
                        forked[i] = task;
                        task.fork();
                    } else {
                        node.nodes[i] = task.find();
                    }
                }
            }
            for (int i = WIDTH - 1; i >= 0; i--) {
                if (forked[i] != null) {
                    node.nodes[i] = forked[i].join();
                }
            }
            return node;
        }

        private final List<Span> whole = new ArrayList<>(WIDTH);   // those that better stay together

        private boolean leaf(Span part) {
            return part.count() <= 2 || whole.contains(part);
        }

        /** Parts the span, its largest part first, until there are as many as a node has children. */
        private List<Span> spans() {
            List<Span> spans = new ArrayList<>(WIDTH);
            spans.add(span);
            while (spans.size() < WIDTH) {
                int largest = -1;
                for (int i = 0; i < spans.size(); i++) {
                    if (!leaf(spans.get(i)) && (largest < 0 || spans.get(i).area() > spans.get(largest).area())) {
                        largest = i;
                    }
                }
                if (largest < 0) {
                    break;
                }
                Span[] parts = spans.get(largest).parts(depth >= EVEN_DEPTH, MOST_IN_LEAF);
                if (parts == null) {
                    whole.add(spans.get(largest));
                } else {
                    spans.set(largest, parts[0]);
                    spans.add(largest + 1, parts[1]);
                }
            }
            return spans;
        }
    }
}
