package simpleray.scene;

/**
 * A ray that looks for the nearest of many triangles. <em>Mutable</em>, for one thread; used again for the next ray, so that a ray costs no
 * memory.
 *
 * <p>Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: space is sheared so that the ray goes along an axis,
 * and what is left is where the origin lies among the triangle's edges in the plane. For triangles with a common edge the same numbers are
 * compared, and rounding never turns the sign of a difference of products (at most it makes it 0, which counts as inside): no ray goes
 * through between them.
 */
final class TriangleProbe {
    /** The nodes that a walk through a tree has still to visit, and where the ray enters them. */
    final int[] stack = new int[TriangleTree.MOST_DEPTH + 1];
    final double[] entry = new double[TriangleTree.MOST_DEPTH + 1];

    /** The ray's origin and direction. */
    double ox;
    double oy;
    double oz;
    double dx;
    double dy;
    double dz;
    /** The reciprocals of the direction's components, infinite of a 0. */
    double ix;
    double iy;
    double iz;
    /** Where among the six sides of a box is the one that the ray meets first, along each axis: 0 or 3, 1 or 4, 2 or 5. */
    int nx;
    int ny;
    int nz;

    /** t of the nearest hit so far, infinite if there is none. */
    double t;
    /** The triangle that is hit there; -1 if none is. Of two at the same t it is the one with the lower number. */
    int triangle;
    /** The weights of its three corners at the hit; their sum is not 1. */
    final double[] weights = new double[3];

    private int kx;
    private int ky;
    private int kz;
    private double okx;
    private double oky;
    private double okz;
    private double shearX;
    private double shearY;
    private double dkz;

    /** Begins anew with a ray that has hit nothing yet; its direction is not zero. */
    void start(double originX, double originY, double originZ, double directionX, double directionY, double directionZ) {
        ox = originX;
        oy = originY;
        oz = originZ;
        dx = directionX;
        dy = directionY;
        dz = directionZ;
        ix = 1 / dx;
        iy = 1 / dy;
        iz = 1 / dz;
        nx = ix < 0 ? 3 : 0;
        ny = iy < 0 ? 4 : 1;
        nz = iz < 0 ? 5 : 2;
        t = Double.POSITIVE_INFINITY;
        triangle = -1;
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

    /**
     * Tries a triangle: if it is hit nearer than all before, it is the one.
     *
     * @param v the coordinates of all vertices
     * @param a where in the array the first corner begins
     * @param b the second
     * @param c the third
     * @param number the triangle's number
     */
    void look(double[] v, int a, int b, int c, int number) {
        double az = v[a + kz] - okz;
        double bz = v[b + kz] - okz;
        double cz = v[c + kz] - okz;
        double ax = v[a + kx] - okx - shearX * az;
        double ay = v[a + ky] - oky - shearY * az;
        double bx = v[b + kx] - okx - shearX * bz;
        double by = v[b + ky] - oky - shearY * bz;
        double cx = v[c + kx] - okx - shearX * cz;
        double cy = v[c + ky] - oky - shearY * cz;
        double wa = cx * by - cy * bx;
        double wb = ax * cy - ay * cx;
        double wc = bx * ay - by * ax;
        if ((wa < 0 || wb < 0 || wc < 0) && (wa > 0 || wb > 0 || wc > 0)) {
            return;
        }
        double found = (az + (wb * (bz - az) + wc * (cz - az)) / (wa + wb + wc)) / dkz;   // NaN if the ray lies in the plane
        if (found > Object.THRESHOLD && (found < t || found == t && number < triangle)) {
            t = found;
            triangle = number;
            weights[0] = wa;
            weights[1] = wb;
            weights[2] = wc;
        }
    }
}
