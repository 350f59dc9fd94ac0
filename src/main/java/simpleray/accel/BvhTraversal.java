package simpleray.accel;

/**
 * Traverses a {@link Bvh} along a ray, the nearer child first. <em>Mutable</em>: one thread's own.
 *
 * <p>No hit is lost by rounding: boxes are padded by more than the error of a primitive, and a ray's interval in a box by more than the error
 * of its two ends (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013). A ray from too far away for that tests all primitives.
 */
public final class BvhTraversal {
    /** A smaller component of a direction, relative to the largest, is replaced by this. */
    private static final double TINY = 1e-20;
    /** The error of the ends of a ray's interval in a box, in half units in the last place. */
    private static final int ULPS = 8;
    private static final long MASK = 0xFFFFFFFFL;

    /** The number of nodes visited. */
    public long steps;

    private final PrimitiveIntersector primitives;
    private final long[] stack = new long[Bvh.MAX_DEPTH];

    // the ray in the tree's coordinates
    private float ox;
    private float oy;
    private float oz;
    private float ix;
    private float iy;
    private float iz;
    private double offset;                                    // t of its origin
    private double speed;                                     // units of the tree per t

    /** How a ray is traversed. */
    private enum Way { MISSES, FOLLOWS, TESTS_ALL }

    /**
     * Creates a traversal.
     *
     * @param primitives tests the primitives
     */
    public BvhTraversal(PrimitiveIntersector primitives) {
        this.primitives = primitives;
    }

    /**
     * Tests all primitives that the ray may hit no farther than the nearest hit.
     *
     * @param bvh the tree
     * @param x the ray's origin
     * @param y its origin
     * @param z its origin
     * @param dx its direction, of any length but 0
     * @param dy its direction
     * @param dz its direction
     * @param limit t of the nearest hit found before; infinite if there is none
     */
    public void closest(Bvh bvh, double x, double y, double z, double dx, double dy, double dz, double limit) {
        Way way = enter(bvh, x, y, z, dx, dy, dz);
        if (way == Way.FOLLOWS) {
            closest(bvh.nodes, limit);
        } else if (way == Way.TESTS_ALL) {
            primitives.closest(null, 0, bvh.count);
        }
    }

    /**
     * Tests primitives that the ray may hit before some distance, until no light passes.
     *
     * @param bvh the tree
     * @param x the ray's origin
     * @param y its origin
     * @param z its origin
     * @param dx its direction, of any length but 0
     * @param dy its direction
     * @param dz its direction
     * @param distance the distance, in lengths of the direction
     * @return whether no light passes
     */
    public boolean occluded(Bvh bvh, double x, double y, double z, double dx, double dy, double dz, double distance) {
        Way way = enter(bvh, x, y, z, dx, dy, dz);
        return way == Way.FOLLOWS ? occluded(bvh.nodes, reach(distance)) : way == Way.TESTS_ALL && primitives.occluded(null, 0, bvh.count);
    }

    /** Transforms a ray to the tree's coordinates. */
    private Way enter(Bvh bvh, double fromX, double fromY, double fromZ, double dx, double dy, double dz) {
        double unit = 1 / bvh.extent;
        double x = (fromX - bvh.middle[0]) * unit;
        double y = (fromY - bvh.middle[1]) * unit;
        double z = (fromZ - bvh.middle[2]) * unit;
        double fastest = Math.max(Math.abs(dx), Math.max(Math.abs(dy), Math.abs(dz)));
        double share = 1 / fastest;
        double ux = dx * share;
        double uy = dy * share;
        double uz = dz * share;
        double far = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        offset = 0;
        speed = fastest * unit;
        if (!(far <= 4)) {
            double closest = -(x * ux + y * uy + z * uz) / (ux * ux + uy * uy + uz * uz);
            double moved = Math.max(0, closest - 2);          // all boxes are within sqrt(3) of the middle
            x += moved * ux;
            y += moved * uy;
            z += moved * uz;
            double near = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
            if (!(far <= PrimitiveBounds.MAX_DISTANCE)) {
                return near > 4 + 0x1p-40 * far ? Way.MISSES : Way.TESTS_ALL;   // all also for NaN
            }
            if (closest <= 0 || near > 4) {
                return Way.MISSES;
            }
            offset = moved / speed;
        }
        ox = (float) x;
        oy = (float) y;
        oz = (float) z;
        ix = inverse(ux);
        iy = inverse(uy);
        iz = inverse(uz);
        return Way.FOLLOWS;
    }

    private static float inverse(double d) {
        return (float) (1 / (Math.abs(d) < TINY ? Math.copySign(TINY, d) : d));
    }

    private static int bits(float f) {
        return Float.floatToRawIntBits(f);
    }

    /** {@return the bits of a float not less than the distance left to a hit} */
    private int reach(double limit) {
        return bits((float) ((limit - offset) * speed * (1 + 0x1p-20) + PrimitiveBounds.PAD));
    }

    /**
     * {@return the bits of the largest of three numbers and 0} Floats of 0 and more have the order of their bits, and those below 0 have bits
     * below all of them as integers. The machine finds the larger of two integers faster than that of two floats.
     */
    private static int entry(float x, float y, float z) {
        return Math.max(Math.max(bits(x), bits(y)), Math.max(bits(z), 0));
    }

    /** {@return the bits of the smallest of three numbers and a limit, rounded up a little} */
    private static int exit(float x, float y, float z, int limit) {
        return Math.min(Math.min(bits(x), bits(y)), Math.min(bits(z), limit)) + ULPS;
    }

    private void closest(float[] n, double limit) {
        long[] waiting = stack;
        float rx = ox;
        float ry = oy;
        float rz = oz;
        float jx = ix;
        float jy = iy;
        float jz = iz;
        int sx = jx < 0 ? 2 : 0;
        int sy = jy < 0 ? 6 : 4;
        int sz = jz < 0 ? 10 : 8;
        int reach = reach(limit);
        int top = 0;
        int node = 0;
        int visited = 0;
        while (true) {
            visited++;
            int fx = node + 2 - sx;
            int fy = node + 10 - sy;
            int fz = node + 18 - sz;
            int entry = entry((n[node + sx] - rx) * jx, (n[node + sy] - ry) * jy, (n[node + sz] - rz) * jz);
            int exit = exit((n[fx] - rx) * jx, (n[fy] - ry) * jy, (n[fz] - rz) * jz, reach);
            int entry1 = entry((n[node + sx + 1] - rx) * jx, (n[node + sy + 1] - ry) * jy, (n[node + sz + 1] - rz) * jz);
            int exit1 = exit((n[fx + 1] - rx) * jx, (n[fy + 1] - ry) * jy, (n[fz + 1] - rz) * jz, reach);
            int next = 0;
            if (entry <= exit) {
                next = bits(n[node + Bvh.CHILDREN]);
                if (entry1 <= exit1) {
                    int other = bits(n[node + Bvh.CHILDREN + 1]);
                    if (entry1 < entry) {
                        waiting[top++] = (long) entry << Integer.SIZE | next & MASK;
                        next = other;
                    } else {
                        waiting[top++] = (long) entry1 << Integer.SIZE | other & MASK;
                    }
                }
            } else if (entry1 <= exit1) {
                next = bits(n[node + Bvh.CHILDREN + 1]);
            }
            while (next <= 0) {
                if (next < 0) {
                    int first = ~next >> Bvh.COUNT_BITS;
                    reach = reach(primitives.closest(null, first, first + (~next & Bvh.COUNT_MASK)));
                }
                long entered;
                do {
                    if (top <= 0) {                           // == would let HotSpot assume that it never begins at 0
                        steps += visited;
                        return;
                    }
                    entered = waiting[--top];
                } while ((int) (entered >> Integer.SIZE) > reach + ULPS);
                next = (int) entered;
            }
            node = next;
        }
    }

    private boolean occluded(float[] n, int reach) {
        long[] waiting = stack;
        float rx = ox;
        float ry = oy;
        float rz = oz;
        float jx = ix;
        float jy = iy;
        float jz = iz;
        int sx = jx < 0 ? 2 : 0;
        int sy = jy < 0 ? 6 : 4;
        int sz = jz < 0 ? 10 : 8;
        int top = 0;
        int node = 0;
        int visited = 0;
        while (true) {
            visited++;
            int fx = node + 2 - sx;
            int fy = node + 10 - sy;
            int fz = node + 18 - sz;
            int entry = entry((n[node + sx] - rx) * jx, (n[node + sy] - ry) * jy, (n[node + sz] - rz) * jz);
            int exit = exit((n[fx] - rx) * jx, (n[fy] - ry) * jy, (n[fz] - rz) * jz, reach);
            int entry1 = entry((n[node + sx + 1] - rx) * jx, (n[node + sy + 1] - ry) * jy, (n[node + sz + 1] - rz) * jz);
            int exit1 = exit((n[fx + 1] - rx) * jx, (n[fy + 1] - ry) * jy, (n[fz + 1] - rz) * jz, reach);
            int next = 0;
            if (entry <= exit) {
                next = bits(n[node + Bvh.CHILDREN]);
                if (entry1 <= exit1) {
                    int other = bits(n[node + Bvh.CHILDREN + 1]);
                    waiting[top++] = entry1 < entry ? next : other;
                    next = entry1 < entry ? other : next;
                }
            } else if (entry1 <= exit1) {
                next = bits(n[node + Bvh.CHILDREN + 1]);
            }
            while (next <= 0) {
                if (next < 0) {
                    int first = ~next >> Bvh.COUNT_BITS;
                    if (primitives.occluded(null, first, first + (~next & Bvh.COUNT_MASK))) {
                        steps += visited;
                        return true;
                    }
                }
                if (top == 0) {
                    steps += visited;
                    return false;
                }
                next = (int) waiting[--top];
            }
            node = next;
        }
    }
}
