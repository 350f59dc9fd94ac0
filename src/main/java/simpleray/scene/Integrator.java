package simpleray.scene;

import simpleray.math.Colour;
import simpleray.math.Ray;

/** Computes the colours that rays see. <em>Mutable</em>: one thread's own. */
@FunctionalInterface
public interface Integrator {
    /**
     * Traces a ray from the eye.
     *
     * @param ray the ray, of unit direction
     * @param colour gets the colour, linear and not clamped; the background if nothing is hit
     * @param depth how many reflections and refractions may follow, 0 or more
     * @return whether an object is hit
     */
    boolean trace(Ray ray, Colour colour, int depth);
}
