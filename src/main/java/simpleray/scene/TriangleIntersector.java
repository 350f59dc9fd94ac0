package simpleray.scene;

import simpleray.accel.Bvh;
import simpleray.accel.BvhTraversal;
import simpleray.accel.PrimitiveIntersector;

/**
 * Finds the nearest of many triangles along a ray. <em>Mutable</em>: one thread's own, reused for the next ray.
 *
 * <p>Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: space is sheared so that the ray runs along an axis,
 * and the test becomes whether the origin is inside the triangle's edges in the plane. Triangles with a common edge compare the same
 * numbers, and rounding never flips the sign of a difference of products. At most it makes the difference 0; then it is computed exactly, and
 * an exact 0 counts as inside. So no ray passes between two triangles, and none hits a triangle far from it.
 */
final class TriangleIntersector implements PrimitiveIntersector {
    /** No triangle. */
    static final int NONE = Integer.MAX_VALUE;

    /** The mesh for which it is prepared; null for a new ray. */
    Mesh mesh;
    /** t of the nearest hit so far; the limit of the search if there is none. */
    double t;
    /** The triangle of that hit; {@link #NONE} if there is none. Of two at the same t, it is the one with the lower number. */
    int triangle;
    /** The weights of its three corners at the hit; their sum is not 1. */
    double weightA;
    double weightB;
    double weightC;

    /** Working space for the normal at the hit. */
    final double[] normal = new double[3];

    private final BvhTraversal traversal = new BvhTraversal(this);
    private TriangleMesh all;
    private double[] vertices;
    private int[] corners;                                    // of the tree's leaves
    private int[] order;
    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;
    // the axis of the ray's largest component, and the two others
    private int kx;
    private int ky;
    private int kz;
    private double okx;
    private double oky;
    private double okz;
    private double shearX;
    private double shearY;
    private double dkz;
    // the result of the latest test
    private double a;
    private double b;
    private double c;

    /** Prepares a ray, whose direction is not zero. */
    void start(TriangleMesh triangles, double originX, double originY, double originZ, double directionX, double directionY,
            double directionZ) {
        all = triangles;
        vertices = triangles.triangles.vertices();
        ox = originX;
        oy = originY;
        oz = originZ;
        dx = directionX;
        dy = directionY;
        dz = directionZ;
        double ax = Math.abs(dx);
        double ay = Math.abs(dy);
        double az = Math.abs(dz);
        kz = ax > ay ? ax > az ? 0 : 2 : ay > az ? 1 : 2;
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        okx = component(kx, ox, oy, oz);
        oky = component(ky, ox, oy, oz);
        okz = component(kz, ox, oy, oz);
        dkz = component(kz, dx, dy, dz);
        shearX = component(kx, dx, dy, dz) / dkz;
        shearY = component(ky, dx, dy, dz) / dkz;
    }

    private static double component(int axis, double x, double y, double z) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    /** Finds the nearest triangle. {@return whether there is one within a limit} */
    boolean closest(double limit) {
        TriangleMesh.Tree tree = all.tree();
        corners = tree.corners();
        order = tree.order();
        t = limit;
        triangle = NONE;
        if (tree.bvh() != null) {
            traversal.closest(tree.bvh(), ox, oy, oz, dx, dy, dz, limit);
        }
        return triangle != NONE;
    }

    /** {@return whether there is a triangle before some distance} */
    boolean occluded(double distance) {
        TriangleMesh.Tree tree = all.tree();
        corners = tree.corners();
        t = distance;
        return tree.bvh() != null && traversal.occluded(tree.bvh(), ox, oy, oz, dx, dy, dz, distance);
    }

    /** {@return which of the mesh's materials the ray meets before some distance, up to one that stops light} */
    boolean[] crossed(double distance) {
        MaterialCollector met = new MaterialCollector(distance);
        Bvh bvh = all.tree().bvh();
        if (bvh != null) {
            new BvhTraversal(met).occluded(bvh, ox, oy, oz, dx, dy, dz, distance);
        }
        return met.met;
    }

    /** Notes the materials of all triangles that the ray hits. Another class, so that rays through meshes of one material pay nothing for it. */
    private final class MaterialCollector implements PrimitiveIntersector {
        final boolean[] met = new boolean[mesh.materials().count()];
        private final int[] leaves = all.tree().order();
        private final double distance;

        MaterialCollector(double distance) {
            this.distance = distance;
        }

        @Override
        public double closest(int[] list, int first, int end) {
            throw new UnsupportedOperationException();
        }

        @Override
        public boolean occluded(int[] list, int first, int end) {
            for (int i = first; i < end; i++) {
                double found = test(leaves[i]);
                if (found > 0 && found < distance) {
                    met[mesh.materials().number(leaves[i])] = true;
                    if (mesh.material(leaves[i]).transmission.isBlack()) {
                        return true;
                    }
                }
            }
            return false;
        }
    }

    @Override
    public double closest(int[] list, int first, int end) {
        for (int i = first; i < end; i++) {
            double found = test(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
            if (found > 0 && (found < t || found == t && order[i] < triangle)) {
                t = found;
                triangle = order[i];
                weightA = a;
                weightB = b;
                weightC = c;
            }
        }
        return t;
    }

    @Override
    public boolean occluded(int[] list, int first, int end) {
        for (int i = first; i < end; i++) {
            double found = test(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
            if (found > 0 && found < t) {
                return true;
            }
        }
        return false;
    }

    /** {@return t of the ray's hit on a triangle, or a miss} The weights are those of this hit. */
    double test(int number) {
        int[] own = all.triangles.corners();
        double found = test(3 * own[3 * number], 3 * own[3 * number + 1], 3 * own[3 * number + 2]);
        weightA = a;
        weightB = b;
        weightC = c;
        return found;
    }

    /** {@return t of the ray's hit on the triangle whose corners' coordinates start at these indices, or a miss} */
    private double test(int p, int q, int r) {
        double[] v = vertices;
        double az = v[p + kz] - okz;
        double bz = v[q + kz] - okz;
        double cz = v[r + kz] - okz;
        double ax = v[p + kx] - okx - shearX * az;
        double ay = v[p + ky] - oky - shearY * az;
        double bx = v[q + kx] - okx - shearX * bz;
        double by = v[q + ky] - oky - shearY * bz;
        double cx = v[r + kx] - okx - shearX * cz;
        double cy = v[r + ky] - oky - shearY * cz;
        double wa = cx * by - cy * bx;
        double wb = ax * cy - ay * cx;
        double wc = bx * ay - by * ax;
        if (wa == 0 || wb == 0 || wc == 0) {                  // perhaps only by rounding: edge-on, it may be far from the ray
            wa = Triangle.edge(cx, cy, bx, by);
            wb = Triangle.edge(ax, ay, cx, cy);
            wc = Triangle.edge(bx, by, ax, ay);
        }
        if ((wa < 0 || wb < 0 || wc < 0) && (wa > 0 || wb > 0 || wc > 0)) {
            return Object.MISS;
        }
        a = wa;
        b = wb;
        c = wc;
        double found = (az + (wb * (bz - az) + wc * (cz - az)) / (wa + wb + wc)) / dkz;   // NaN if the ray lies in the plane
        return found > Object.THRESHOLD && found < Double.POSITIVE_INFINITY ? found : Object.MISS;
    }
}
