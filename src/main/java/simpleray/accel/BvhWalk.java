package simpleray.accel;

import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Follows rays through a {@link Bvh}. <em>Mutable</em>: one thread's own. */
final class BvhWalk extends Walk {
    /** A direction this small hardly moves. */
    private static final double TINY = 1e-20;
    /** How many half units in the last place the ends of a ray's stretch in a box may be off. */
    private static final int ULPS = 8;

    /** A leaf without objects. */
    private static final int NOTHING = ~0;
    private static final long MASK = 0xFFFFFFFFL;

    private final Bvh bvh;
    private final long[] stack = new long[(Bvh.WIDTH - 1) * Bvh.DEPTH + Bvh.WIDTH];

    // the ray, as the tree sees it
    private float ox;
    private float oy;
    private float oz;
    private float ix;
    private float iy;
    private float iz;
    private double offset;

    BvhWalk(Bvh bvh, Finder finder) {
        super(finder, bvh.boxes);
        this.bvh = bvh;
    }

    /** Brings a ray to the tree; false if it passes by. */
    private boolean enter(Ray ray) {
        Boxes boxes = bvh.boxes;
        Point o = ray.origin;
        Vector d = ray.direction;
        double x = o.x - boxes.middle[0];
        double y = o.y - boxes.middle[1];
        double z = o.z - boxes.middle[2];
        double far = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        offset = 0;
        if (!(far <= 4 * boxes.extent)) {
            double closest = -(x * d.x + y * d.y + z * d.z);  // the ray's direction is of unit length, as good as
            if (closest <= 0) {
                return false;
            }
            offset = Math.max(0, closest - 3 * boxes.extent); // boxes are within sqrt(3) of an extent from the middle
            x += offset * d.x;
            y += offset * d.y;
            z += offset * d.z;
            if (!(Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) <= 4 * boxes.extent)) {
                return false;
            }
        }
        ox = (float) x;
        oy = (float) y;
        oz = (float) z;
        ix = inverse(d.x);
        iy = inverse(d.y);
        iz = inverse(d.z);
        return true;
    }

    private static float inverse(double d) {
        return (float) (1 / (Math.abs(d) < TINY ? Math.copySign(TINY, d) : d));
    }

    private static int bits(float f) {
        return Float.floatToRawIntBits(f);
    }

    /** {@return the bits of a float not less than the way left to a hit} */
    private int reach(double limit) {
        return bits((float) ((limit - offset) * (1 + 0x1p-20) + bvh.boxes.slack()));
    }

    @Override
    void nearest(Ray ray) {
        if (enter(ray)) {
            follow(ray, finder.t, false);
        }
    }

    @Override
    int blocker(Ray ray, double distance) {
        return enter(ray) ? follow(ray, distance, true) : Finder.NONE;
    }

    /**
     * Goes from box to box, the nearest first (for a shadow in any order), until nothing is left that may be nearer, or something blocks.
     *
     * <p>Floats of 0 and more are in the order of their bits, and those below 0 are below all of them as integers are: integers it is that
     * are compared, for the machine finds the larger of two integers faster than that of two floats.
     */
    private int follow(Ray ray, double distance, boolean shadow) {
        float[] sides = bvh.sides;
        int[] children = bvh.children;
        long[] waiting = stack;
        float rx = ox;
        float ry = oy;
        float rz = oz;
        float jx = ix;
        float jy = iy;
        float jz = iz;
        int nearX = jx < 0 ? 3 * Bvh.WIDTH : 0;
        int nearY = jy < 0 ? 4 * Bvh.WIDTH : Bvh.WIDTH;
        int nearZ = jz < 0 ? 5 * Bvh.WIDTH : 2 * Bvh.WIDTH;
        int farX = 3 * Bvh.WIDTH - nearX;
        int farY = 5 * Bvh.WIDTH - nearY;
        int farZ = 7 * Bvh.WIDTH - nearZ;
        int reach = reach(distance);
        int top = 0;
        int next = 0;
        while (true) {
            int at = next * Bvh.STRIDE;
            int base = top;
            finder.stats.steps++;
            for (int c = 0; c < Bvh.WIDTH; c++) {
                int k = at + c;
                int near = Math.max(Math.max(bits((sides[k + nearX] - rx) * jx), bits((sides[k + nearY] - ry) * jy)),
                    Math.max(bits((sides[k + nearZ] - rz) * jz), 0));
                int far = Math.min(Math.min(bits((sides[k + farX] - rx) * jx), bits((sides[k + farY] - ry) * jy)),
                    Math.min(bits((sides[k + farZ] - rz) * jz), reach));
                if (near <= far + ULPS) {
                    long entry = (long) near << Integer.SIZE | children[next * Bvh.WIDTH + c] & MASK;
                    int place = top++;
                    while (!shadow && place > base && waiting[place - 1] < entry) {
                        waiting[place] = waiting[place - 1];
                        place--;
                    }
                    waiting[place] = entry;
                }
            }
            do {
                if (top == 0) {
                    return Finder.NONE;
                }
                long entry = waiting[--top];
                next = (int) entry;
                if (!shadow && (int) (entry >> Integer.SIZE) > reach + ULPS) {
                    next = NOTHING;
                }
                if (next >= 0) {
                    continue;
                }
                int first = ~next >> Bvh.COUNT_BITS;
                int end = first + (~next & Bvh.COUNT_MASK);
                if (shadow) {
                    int blocker = finder.blockerOfRange(ray, distance, first, end);
                    if (blocker != Finder.NONE) {
                        return blocker;
                    }
                } else {
                    finder.nearestOfRange(ray, first, end);
                    reach = reach(finder.t);
                }
            } while (next < 0);
        }
    }
}
