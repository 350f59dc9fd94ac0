package simpleray.scene;

import simpleray.math.Colour;
import simpleray.math.Ray;

/**
 * Answers the two questions that ray tracing asks of a scene: what a ray hits first, and whether the way to a light is free (Embree's
 * <em>intersect</em> and <em>occluded</em>). All implementations give the same answers, to the last bit. <em>Mutable</em>: one thread's own.
 */
public interface Intersector {
    /**
     * Finds the nearest hit, of two at the same t the object listed first.
     *
     * @param ray the ray, of unit direction
     * @param hit gets it
     * @return whether something is hit
     */
    boolean intersect(Ray ray, Hit hit);

    /**
     * Dims light on its way to a point: multiplies it by the Kt of each object between, in the order of the scene, until nothing is left.
     *
     * @param ray the ray from the point towards the light, of unit direction
     * @param distance where the light is, in lengths of the ray's direction; infinite for a directional one
     * @param light the light's place in the scene, from 0
     * @param left the light, which is changed
     * @return whether nothing is left of it
     */
    boolean occluded(Ray ray, double distance, int light, Colour left);
}
