package simpleray.scene;

import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;

/**
 * Answers the two queries of ray tracing: the nearest hit of a ray, and whether the way to a light is blocked (Embree's
 * <em>intersect</em> and <em>occluded</em>). All implementations give the same answers, to the last bit. <em>Mutable</em>: one thread's own.
 */
public interface Intersector {
    /**
     * Finds the nearest hit; of two at the same t, that of the object listed first.
     *
     * @param ray the ray, of unit direction
     * @param hit gets the hit
     * @return whether an object is hit
     */
    boolean intersect(Ray ray, Hit hit);

    /**
     * Dims light on its way to a point: multiplies it by the Kt of each object between, in the order of the scene, until nothing is left.
     *
     * @param ray the ray from the point towards the light, of unit direction
     * @param distance the distance of the light, in lengths of the ray's direction; infinite for a directional one
     * @param light the light's index in the scene
     * @param left the light's colour, which is dimmed
     * @return whether nothing is left of it
     */
    boolean occluded(Ray ray, double distance, int light, Colour left);

    /**
     * Announces that until {@link #leave} all calls of {@link #occluded} are for rays between one point and points of an area light. An
     * intersector may find what lies between once for all of them.
     *
     * @param from the point
     * @param light the light
     */
    default void approach(Point from, AreaLight light) {
    }

    /** Ends what {@link #approach} began. */
    default void leave() {
    }
}
