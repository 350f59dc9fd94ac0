package simpleray.scene;

import simpleray.math.Vector;

/**
 * A surface at a point of it. <em>Constant.</em>
 *
 * @param outward the unit normal of the true shape, outward; it decides whether a ray enters or leaves
 * @param shading the unit normal by which it is lit and by which rays bend; differs where vertex normals make facets look round
 */
record Surface(Vector outward, Vector shading) {
    /** {@return the shading normal, turned to the side from which a ray of that direction comes} */
    Vector towards(Vector direction) {
        return shading.dot(direction) > 0 ? Vector.negate(shading) : new Vector(shading);
    }

    /** {@return whether a ray of that direction enters here, and does not leave} */
    boolean isEnteredBy(Vector direction) {
        return outward.dot(direction) < 0;
    }
}
