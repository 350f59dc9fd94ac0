package simpleray.scene;

import simpleray.math.Vector;

/**
 * A surface at a point of it. <em>Constant.</em>
 *
 * @param outward the unit normal of the true shape, outward; it decides whether a ray enters or leaves
 * @param shading the unit normal by which it is lit and by which rays bend; differs where vertex normals make facets look round
 */
public record Surface(Vector outward, Vector shading) {
    /**
     * Turns the shading normal to the side from which a ray comes.
     *
     * @param direction the direction of the ray
     * @return a new vector
     */
    public Vector towards(Vector direction) {
        return shading.dot(direction) > 0 ? Vector.negate(shading) : new Vector(shading);
    }

    /**
     * Tells on which side a ray comes.
     *
     * @param direction the direction of the ray
     * @return whether it enters here, and does not leave
     */
    public boolean isEnteredBy(Vector direction) {
        return outward.dot(direction) < 0;
    }
}
