package simpleray.accel;

import simpleray.math.Ray;

/** Follows rays through a {@link Structure}. <em>Mutable</em>: one thread's own. */
abstract class Walk {
    /** Who knows the objects, the nearest hit so far, and what is in the way. */
    final Finder finder;
    private final Boxes boxes;

    Walk(Finder finder, Boxes boxes) {
        this.finder = finder;
        this.boxes = boxes;
    }

    /** {@return whether a ray starts so near that it can be followed; else all objects must be asked} */
    final boolean canFollow(Ray ray) {
        double[] middle = boxes.middle;
        return Math.max(Math.abs(ray.origin.x - middle[0]), Math.max(Math.abs(ray.origin.y - middle[1]),
            Math.abs(ray.origin.z - middle[2]))) <= boxes.reach();
    }

    /** Shows the finder all objects that may be hit no farther than its nearest hit. */
    abstract void nearest(Ray ray);

    /**
     * Shows the finder objects that may be hit before some distance, until one blocks the way.
     *
     * @return that one's place; {@link Finder#NONE} if none does
     */
    abstract int blocker(Ray ray, double distance);
}
