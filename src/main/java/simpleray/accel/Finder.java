package simpleray.accel;

import java.util.Arrays;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Plane;
import simpleray.scene.RayStats;
import simpleray.scene.Sphere;

/** Finds what rays hit first, and what stands between a point and a light. <em>Mutable</em>: one thread's own. */
final class Finder {
    /** No object. */
    static final int NONE = -1;

    /** Where the nearest hit is. */
    double t;
    /** Which object is hit there, a place in {@link Primitives}, or {@link #NONE}. */
    int hit;
    /** The objects between the point and the light that let light through, in no order, and how many they are. */
    int[] dimming = new int[16];
    int dimmers;

    private int hitOrder;                                     // its place in the scene
    private long[] noted;                                     // for which shadow each object was noted last
    private long shadows;

    final RayStats stats;
    private final Engine engine;
    final Primitives all;
    private final Walk walk;
    private final int[] lastBlockers;                         // of the bounded objects, for each light
    private final FewBuffer[] rows;                           // for each light that needs it: all, what was in its way of late first

    Finder(Engine engine, RayStats stats) {
        this.engine = engine;
        this.stats = stats;
        all = engine.primitives;
        walk = engine.structure == null ? null : engine.structure.walk(this);
        lastBlockers = new int[engine.lights.length];
        Arrays.fill(lastBlockers, NONE);
        rows = new FewBuffer[engine.lights.length];
    }

    /**
     * Finds the nearest hit, of two at the same t the object that is listed first in the scene. One loop for lists by direction and for objects
     * in a row, in a method too long to become part of others: what is compiled once is compiled soon.
     */
    boolean nearest(Ray ray, boolean fromEye) {
        FewBuffer few = engine.everywhere;
        int start = 0;
        if (fromEye && engine.eyeFew != null) {
            few = engine.eyeFew;
            start = few.start(ray.direction.x, ray.direction.y, ray.direction.z);
        }
        double[] n = few.numbers;
        double best = Double.POSITIVE_INFINITY;               // in locals, which the machine keeps at hand
        int bestPlace = NONE;
        int bestOrder = Integer.MAX_VALUE;
        int k = start;
        for (; n[k] <= best; k += FewBuffer.ENTRY) {          // where one is farther, so are the rest; not a number ends the list
            double at = intersect(n, k, ray);
            int order = (int) n[k + FewBuffer.ORDER];
            if (isBefore(at, order, best, bestOrder)) {
                best = at;
                bestPlace = (int) n[k + FewBuffer.PLACE];
                bestOrder = order;
            }
        }
        stats.tests += (k - start) / FewBuffer.ENTRY;
        t = best;
        hit = bestPlace;
        hitOrder = bestOrder;
        if (!few.whole && all.bounded > 0) {
            nearestBounded(ray, fromEye);
        }
        return hit != NONE;
    }

    /** {@return t of the hit of a ray on the object of an entry of a {@link FewBuffer}, or a miss} */
    private double intersect(double[] n, int k, Ray ray) {
        Point o = ray.origin;
        Vector d = ray.direction;
        double kind = n[k + FewBuffer.KIND];
        if (kind == Primitives.SPHERE) {
            return Sphere.hit(o.x - n[k + 1], o.y - n[k + 2], o.z - n[k + 3], d.x, d.y, d.z, n[k + 4]);
        }
        if (kind == Primitives.PLANE) {
            return Plane.hit(n[k + 4] - (n[k + 1] * o.x + n[k + 2] * o.y + n[k + 3] * o.z),
                n[k + 1] * d.x + n[k + 2] * d.y + n[k + 3] * d.z);
        }
        return all.objects[(int) n[k + FewBuffer.PLACE]].intersect(ray);
    }

    private void nearestBounded(Ray ray, boolean fromEye) {
        if (fromEye && engine.eyeBuffer != null) {
            nearestOf(engine.eyeBuffer, ray);
        } else if (walk != null && walk.canFollow(ray)) {
            walk.nearest(ray);
        } else {
            nearestOfRange(ray, 0, all.bounded);
        }
    }

    void nearestOfRange(Ray ray, int first, int end) {
        for (int i = first; i < end; i++) {
            double at = all.intersectBounded(i, ray);
            if (isBefore(at, all.order[i], t, hitOrder)) {
                t = at;
                hit = i;
                hitOrder = all.order[i];
            }
        }
        stats.tests += end - first;
    }

    /** Asks the objects of a list. */
    void nearestOfList(Ray ray, int[] places, int first, int end) {
        double best = t;
        int bestPlace = hit;
        int bestOrder = hitOrder;
        for (int i = first; i < end; i++) {
            int place = places[i];
            double at = all.intersectBounded(place, ray);
            if (isBefore(at, all.order[place], best, bestOrder)) {
                best = at;
                bestPlace = place;
                bestOrder = all.order[place];
            }
        }
        t = best;
        hit = bestPlace;
        hitOrder = bestOrder;
        stats.tests += end - first;
    }

    /** Asks the objects that lie in a direction from the eye, until the rest is farther away than the nearest hit. */
    private void nearestOf(DirectionBuffer buffer, Ray ray) {
        double best = t;
        int bestPlace = hit;
        int bestOrder = hitOrder;
        int cell = buffer.cube.cell(ray.direction.x, ray.direction.y, ray.direction.z);
        int first = buffer.starts[cell];
        int end = buffer.starts[cell + 1];
        int i = first;
        for (; i < end && buffer.near[buffer.places[i]] <= best; i++) {
            int place = buffer.places[i];
            double at = all.intersectBounded(place, ray);
            if (isBefore(at, all.order[place], best, bestOrder)) {
                best = at;
                bestPlace = place;
                bestOrder = all.order[place];
            }
        }
        t = best;
        hit = bestPlace;
        hitOrder = bestOrder;
        stats.tests += i - first;
    }

    /**
     * {@return whether a hit, not a miss, is nearer than the nearest one, or as near and of an object that is listed earlier} Bits of numbers that
     * are 0 or more are in their order, and those of a miss, without a sign, beyond them all. So this is one question: of several, some might be
     * answered for the first time long after the machine has compiled them.
     */
    private static boolean isBefore(double at, int order, double nearest, int nearestOrder) {
        int listedEarlier = order - nearestOrder >>> Integer.SIZE - 1;
        return Double.doubleToRawLongBits(at) + Long.MIN_VALUE < Double.doubleToRawLongBits(nearest) + listedEarlier + Long.MIN_VALUE;
    }

    /**
     * Tells whether anything opaque stands between a point and a light, and notes what dims it.
     *
     * @param ray from the point towards the light
     * @param distance how far the light is, infinite for a directional one
     * @param light which light it is
     */
    boolean isBlocked(Ray ray, double distance, int light) {
        dimmers = 0;
        shadows++;
        if (walk != null && lastBlocks(ray, distance, light)) {
            return true;
        }
        FewBuffer few = null;
        int start = 0;
        if (engine.directions[light] == null) {               // where the point is as the light sees it
            few = engine.lightFew[light];
        }
        boolean inRow = few == null || distance > few.reach;
        if (inRow) {
            few = rows[light];
            if (few == null) {
                few = engine.everywhere.copy();
                rows[light] = few;
            }
        } else {
            start = few.start(-ray.direction.x, -ray.direction.y, -ray.direction.z);
        }
        double[] n = few.numbers;
        int blocker = NONE;
        int last = start;
        int k = start;
        for (; n[k] <= distance && blocker == NONE; k += FewBuffer.ENTRY) {
            double at = intersect(n, k, ray);
            if (isWithin(at, distance) && (all.opaque || blocks((int) n[k + FewBuffer.PLACE]))) {
                blocker = (int) n[k + FewBuffer.PLACE];
                last = k;
            }
        }
        stats.tests += (k - start) / FewBuffer.ENTRY;
        if (inRow && few.isDue()) {
            few.exchange(last, start);                        // to be asked first from now on
        }
        if (!few.whole && blocker == NONE && all.bounded > 0) {
            blocker = boundedBlocker(ray, distance, light);
            lastBlockers[light] = blocker == NONE ? lastBlockers[light] : blocker;
        }
        return blocker != NONE;
    }

    private boolean lastBlocks(Ray ray, double distance, int light) {
        int last = lastBlockers[light];
        if (last == NONE) {
            return false;
        }
        stats.tests++;
        return isWithin(all.intersectBounded(last, ray), distance);
    }

    private int boundedBlocker(Ray ray, double distance, int light) {
        if (engine.lightBuffers[light] != null && distance <= all.reach) {
            return blockerOf(engine.lightBuffers[light], ray, distance);
        }
        return walk != null && walk.canFollow(ray) ? walk.blocker(ray, distance) : blockerOfRange(ray, distance, 0, all.bounded);
    }

    /** {@return whether a hit, not a miss, is nearer than a distance} Likewise one question. */
    private static boolean isWithin(double at, double distance) {
        return Double.doubleToRawLongBits(at) + Long.MIN_VALUE < Double.doubleToRawLongBits(distance) + Long.MIN_VALUE;
    }

    /** {@return whether an object that is in the way is opaque}; notes it if it is not, however often it is met */
    private boolean blocks(int place) {
        if (all.opaque || all.materials[place].transmission.isBlack()) {
            return true;
        }
        if (noted == null) {
            noted = new long[all.count()];
        }
        if (noted[place] != shadows) {
            noted[place] = shadows;
            if (dimmers == dimming.length) {
                dimming = Arrays.copyOf(dimming, 2 * dimmers);
            }
            dimming[dimmers++] = place;
        }
        return false;
    }

    /** {@return an opaque object of a range that is in the way; notes what dims} */
    int blockerOfRange(Ray ray, double distance, int first, int end) {
        for (int i = first; i < end; i++) {
            double at = all.intersectBounded(i, ray);
            if (isWithin(at, distance) && blocks(i)) {
                stats.tests += i - first + 1;
                return i;
            }
        }
        stats.tests += end - first;
        return NONE;
    }

    /** {@return an opaque object of a list that is in the way; notes what dims} */
    int blockerOfList(Ray ray, double distance, int[] places, int first, int end) {
        for (int i = first; i < end; i++) {
            double at = all.intersectBounded(places[i], ray);
            if (isWithin(at, distance) && blocks(places[i])) {
                stats.tests += i - first + 1;
                return places[i];
            }
        }
        stats.tests += end - first;
        return NONE;
    }

    /** {@return an opaque object in the way to a light, asking those that are as near to it as the ray's origin; notes what dims} */
    private int blockerOf(DirectionBuffer buffer, Ray ray, double distance) {
        int cell = buffer.cube.cell(-ray.direction.x, -ray.direction.y, -ray.direction.z);
        int first = buffer.starts[cell];
        int end = first;
        for (int last = buffer.starts[cell + 1]; end < last && buffer.near[buffer.places[end]] <= distance; end++) {
            double at = all.intersectBounded(buffer.places[end], ray);
            if (isWithin(at, distance) && blocks(buffer.places[end])) {
                stats.tests += end - first + 1;
                return buffer.places[end];
            }
        }
        stats.tests += end - first;
        return NONE;
    }
}
