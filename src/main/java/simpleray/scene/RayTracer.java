package simpleray.scene;

import simpleray.math.Colour;
import simpleray.math.Ray;

/** Finds the colours that rays see in a scene. {@link Scene} itself is the plain one; others find the same colours faster. */
@FunctionalInterface
public interface RayTracer {
    /**
     * Finds parts of the colour that a ray sees.
     *
     * @param ray the ray, of unit direction
     * @param colour gets the colour, linear and not clamped; the background if nothing is hit
     * @param depth how many reflections and refractions may follow, 0 or more
     * @param terms which parts are wanted
     * @return whether an object is hit
     */
    boolean intersect(Ray ray, Colour colour, int depth, Terms terms);
}
