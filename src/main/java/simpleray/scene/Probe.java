package simpleray.scene;

import simpleray.math.Colour;
import simpleray.math.Ray;

/** Answers what a ray hits and what stands between a point and a light. <em>Mutable</em>: one thread's own. */
public interface Probe {
    /** No object. */
    int NONE = -1;

    /**
     * Finds the nearest hit, of two at the same t the object listed first.
     *
     * @param ray the ray, of unit direction
     * @param level how many reflections and refractions led to it: 0 for a ray from the eye
     * @param refracted whether it went on through a surface
     * @return the object's place in the scene, from 0; {@link #NONE} if nothing is hit
     */
    int nearest(Ray ray, int level, boolean refracted);

    /** {@return t of the hit that was found last} */
    double distance();

    /**
     * Dims light on its way to a point: multiplies it by the Kt of each object between, which is black for most.
     *
     * @param light the light, which is changed
     * @param towards the ray from the point to the light, of unit direction
     * @param distance how far the light is; infinite for a directional one
     * @param number the light's place in the scene, from 0
     */
    void dim(Colour light, Ray towards, double distance, int number);

    /**
     * Finds what stands between a point and a light.
     *
     * @param towards the ray from the point to the light, of unit direction
     * @param distance how far the light is; infinite for a directional one
     * @param number the light's place in the scene, from 0
     * @return the objects' places, in the order of the scene, up to the one that lets nothing more through
     */
    int[] between(Ray towards, double distance, int number);

    /**
     * Makes a probe that asks all objects in turn.
     *
     * @param scene the scene, which must not change meanwhile
     * @return the probe
     */
    static Probe of(Scene scene) {
        return new PlainProbe(scene);
    }
}
