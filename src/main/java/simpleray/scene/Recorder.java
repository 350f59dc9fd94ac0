package simpleray.scene;

import simpleray.math.Colour;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Is told of the steps of a {@link WhittedIntegrator}. Must copy the arguments, which are reused, and must not change them. */
public interface Recorder {
    /**
     * A ray starts, from the eye or from the last hit surface.
     *
     * @param ray the ray
     * @param depth the number of reflections and refractions that may follow
     * @param level the number of those before it
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
     * The contribution of a light is computed, or that of a point of an area light, whose points come one after another.
     *
     * @param number the light's index in the scene
     * @param seen its direction and distance, and whether the surface faces it
     * @param arriving the part of its colour that reaches the surface
     * @param halfway the unit vector H halfway between L and the way back along the ray
     * @param cosine N·H; below 0 it counts as 0
     * @param diffuse its diffuse term; black if the picture does not show it
     * @param specular its specular term; black if the picture does not show it
     */
    default void light(int number, VisibilityTester seen, Colour arriving, Vector halfway, double cosine, Colour diffuse,
            Colour specular) {
    }

    /**
     * All points of an area light are computed.
     *
     * @param number the light's index in the scene
     * @param diffuse the sum of the diffuse terms of its points
     * @param specular the sum of the specular ones
     */
    default void points(int number, Colour diffuse, Colour specular) {
    }

    /**
     * All lights are computed.
     *
     * @param ambient the ambient term; black if the picture does not show it
     * @param diffuse the sum of the diffuse terms
     * @param specular the sum of the specular ones
     */
    default void lit(Colour ambient, Colour diffuse, Colour specular) {
    }

    /**
     * A ray that leaves the surface has ended, and contributes to the colour.
     *
     * @param share the factor of its colour
     * @param added its colour times this factor
     * @param refracted whether it is the refracted ray
     */
    default void followed(Colour share, Colour added, boolean refracted) {
    }

    /**
     * The innermost ray ends.
     *
     * @param colour its colour
     */
    default void end(Colour colour) {
    }
}
