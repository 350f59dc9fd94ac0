package simpleray.scene;

import java.nio.file.Path;
import simpleray.accel.Bvh;
import simpleray.accel.Pool;
import simpleray.accel.PrimitiveBounds;

/**
 * Triangles and their bounding volume hierarchy, shared by meshes of one file. <em>Constant</em>; the tree is built when it is first
 * needed. Any thread may call.
 */
final class TriangleMesh {
    final Triangles triangles;
    /** The OBJ; null for none. */
    final Path path;
    /** The box around all: xmin, ymin, zmin, xmax, ymax, zmax; all 0 without triangles. */
    final double[] box;
    private volatile Tree tree;

    TriangleMesh(Triangles triangles) {
        this(triangles, null);
    }

    TriangleMesh(Triangles triangles, Path path) {
        this.triangles = triangles;
        this.path = path;
        box = triangles.count() == 0 ? new double[6] : triangles.bounds();
    }

    /**
     * The bounding volume hierarchy.
     *
     * @param bvh the tree; null without triangles
     * @param order the triangles in the order of the leaves
     * @param corners the indices of their corners' coordinates in the same order: three times the vertices' numbers
     */
    record Tree(Bvh bvh, int[] order, int[] corners) {
    }

    Tree tree() {
        Tree known = tree;
        return known == null ? tree(1) : known;
    }

    /** {@return the tree, which the given number of threads builds if it is missing} */
    synchronized Tree tree(int threads) {
        if (tree == null) {
            try (Pool pool = new Pool(threads)) {
                tree = build(pool);
            }
        }
        return tree;
    }

    private Tree build(Pool pool) {
        int[] order = new int[triangles.count()];
        for (int i = 0; i < order.length; i++) {
            order[i] = i;
        }
        Bvh bvh = null;
        if (order.length > 0) {
            bvh = Bvh.of(new PrimitiveBounds(order, new PrimitiveBounds.Source() {
                @Override
                public void bounds(int i, double[] box) {
                    triangles.bounds(i, box);
                }
            }, pool), pool);
        }
        int[] corners = new int[3 * order.length];
        for (int i = 0; i < order.length; i++) {
            for (int corner = 0; corner < 3; corner++) {
                corners[3 * i + corner] = 3 * triangles.corners()[3 * order[i] + corner];
            }
        }
        return new Tree(bvh, order, corners);
    }
}
