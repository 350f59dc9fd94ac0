package simpleray.scene;

import java.util.Arrays;

/** Counts of rays and of the work to trace them. <em>Mutable</em>: while rays are traced, one thread's own. */
public final class RayStats {
    /** Rays from the eye. */
    public long primary;
    /** Mirror rays. */
    public long reflected;
    /** Refracted rays. */
    public long refracted;
    /** Rays towards lights. */
    public long shadow;
    /** Tests of objects with rays; a mesh counts as one. */
    public long tests;
    /** Visited cells of a grid or nodes of a tree. */
    public long steps;
    /** The number of rays after no reflection or refraction, after one, and so on, without shadow rays. */
    public long[] depths = new long[1];

    /** Creates counts of 0. */
    public RayStats() {
    }

    /** {@return the number of all rays} */
    public long rays() {
        return primary + reflected + refracted + shadow;
    }

    /**
     * Counts a ray other than a shadow ray.
     *
     * @param level the number of reflections and refractions before it
     */
    public void ray(int level) {
        if (level >= depths.length) {
            depths = Arrays.copyOf(depths, level + 1);
        }
        depths[level]++;
    }

    /**
     * Adds the counts of another thread.
     *
     * @param other its counts
     */
    public void add(RayStats other) {
        primary += other.primary;
        reflected += other.reflected;
        refracted += other.refracted;
        shadow += other.shadow;
        tests += other.tests;
        steps += other.steps;
        depths = Arrays.copyOf(depths, Math.max(depths.length, other.depths.length));
        for (int i = 0; i < other.depths.length; i++) {
            depths[i] += other.depths[i];
        }
    }
}
