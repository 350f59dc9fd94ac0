package simpleray.scene;

import simpleray.math.Colour;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Hears what a {@link WhittedIntegrator} finds, while it finds it. What is handed over changes afterwards, and is not to be changed. */
public interface Recorder {
    /**
     * A ray begins: from the eye, or from the surface that was hit last.
     *
     * @param ray the ray
     * @param depth how many reflections and refractions may follow
     * @param level how many led to it
     */
    default void begin(Ray ray, int depth, int level) {
    }

    /**
     * The ray hits a surface.
     *
     * @param ray the ray
     * @param at the surface
     */
    default void hit(Ray ray, Interaction at) {
    }

    /**
     * A light was looked at.
     *
     * @param number its place in the scene, from 0
     * @param seen where it is, and whether the surface faces it
     * @param arriving what of its colour reaches the surface
     * @param halfway the unit vector H halfway between L and the way back along the ray
     * @param cosine N·H, which counts as 0 if it is below
     * @param diffuse what the surface scatters of it; black if that is not asked for
     * @param specular its highlight; black if that is not asked for
     */
    default void light(int number, VisibilityTester seen, Colour arriving, Vector halfway, double cosine, Colour diffuse,
            Colour specular) {
    }

    /**
     * All lights were looked at.
     *
     * @param ambient the ambient term; black if that is not asked for
     * @param diffuse the sum of the diffuse terms
     * @param specular the sum of the specular ones
     */
    default void lit(Colour ambient, Colour diffuse, Colour specular) {
    }

    /**
     * The ray that goes on from the surface was followed to its end, and adds something.
     *
     * @param share how much of what it sees counts
     * @param added that share of it
     * @param refracted whether it went on through the surface
     */
    default void followed(Colour share, Colour added, boolean refracted) {
    }

    /**
     * The latest ray that has not ended ends.
     *
     * @param colour what it sees
     */
    default void end(Colour colour) {
    }
}
