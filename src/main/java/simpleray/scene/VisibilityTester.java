package simpleray.scene;

import simpleray.math.Colour;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Decides whether light reaches a point, and how much of it: here alone. <em>Mutable</em>: one thread's own. */
public final class VisibilityTester {
    /** The unit vector towards the light, L. */
    public final Vector towards = new Vector();
    /** How far the light is; infinite for a directional one. */
    public double distance;
    /** The cosine N·L; of a light behind the surface 0 or less. */
    public double facing;

    /** Whether what is between stops light. */
    final boolean shadows;

    private final Intersector intersector;
    private final RayStats stats;
    private final Ray ray = new Ray(null, towards);

    /**
     * Creates a tester.
     *
     * @param intersector finds what is between
     * @param shadows whether what is between stops light
     * @param stats gets the number of shadow rays
     */
    public VisibilityTester(Intersector intersector, boolean shadows, RayStats stats) {
        this.intersector = intersector;
        this.shadows = shadows;
        this.stats = stats;
    }

    /**
     * Finds how much of a light reaches a surface.
     *
     * @param light the light
     * @param number its place in the scene, from 0
     * @param at the surface
     * @param arriving what the light gives off; gets what is left of it here, black if the surface is turned away
     * @return whether anything is
     */
    public boolean reaches(Light light, int number, Interaction at, Colour arriving) {
        distance = light.towards(at.point, towards);
        facing = at.normal.dot(towards);
        if (facing <= 0) {
            arriving.reset();
            return false;
        }
        if (!shadows) {
            return !arriving.isBlack();
        }
        stats.shadow++;
        ray.origin = at.point;
        return !intersector.occluded(ray, distance, number, arriving);
    }
}
