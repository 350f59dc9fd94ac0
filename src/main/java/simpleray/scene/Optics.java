package simpleray.scene;

import simpleray.math.Vector;

/** Where light goes on from a surface. */
final class Optics {
    private Optics() {
    }

    /** Finds R = D - 2 (D·N) N. */
    static Vector mirrored(Vector direction, Vector normal) {
        Vector mirror = Vector.scale(normal, -2 * direction.dot(normal));
        mirror.add(direction);
        return mirror;
    }

    /**
     * Finds the direction in which a ray goes on behind a surface (Snell's law; Whitted 1980).
     *
     * @param ratio the refractive index of where it comes from, divided by that of where it goes
     * @return a new vector of unit length; null at total internal reflection
     */
    static Vector refracted(Vector direction, Vector normal, double ratio) {
        double cos = -direction.dot(normal);
        double square = 1 - ratio * ratio * (1 - cos * cos);
        if (square < 0) {
            return null;
        }
        Vector bent = Vector.scale(normal, ratio * cos - Math.sqrt(square));
        bent.add(Vector.scale(direction, ratio));
        return bent;
    }
}
