package simpleray.scene;

import java.util.Arrays;

/** Counts of rays and of the work to trace them. <em>Mutable</em>: while rays are traced, one thread's own. */
public final class RayStats {
    /** Rays from the eye. */
    public long primary;
    /** Mirror rays. */
    public long reflected;
    /** Rays that went on through a surface. */
    public long refracted;
    /** Rays towards lights. */
    public long shadow;
    /** How often an object was asked whether a ray hits it; a mesh counts as one. */
    public long tests;
    /** Cells of a grid, or nodes of a tree, that rays came to. */
    public long steps;
    /** How many rays there were after no reflection or refraction, after one, and so on; shadow rays apart. */
    public long[] depths = new long[1];

    /** Creates counts of nothing. */
    public RayStats() {
    }

    /** {@return the number of all rays} */
    public long rays() {
        return primary + reflected + refracted + shadow;
    }

    /**
     * Counts a ray that is no shadow ray.
     *
     * @param level how many reflections and refractions led to it
     */
    public void ray(int level) {
        if (level >= depths.length) {
            depths = Arrays.copyOf(depths, level + 1);
        }
        depths[level]++;
    }

    /**
     * Adds what another thread did.
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
