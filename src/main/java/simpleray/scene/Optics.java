package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Vector;

/** Where light goes on from a surface. */
public final class Optics {
    /** Up to here roundings of a coordinate are far below {@link Object#THRESHOLD}, also where they are seen at a grazing angle. */
    private static final double LARGE = 1e4;
    /** A share of a coordinate that is larger than its roundings on the way to a hit. */
    private static final double ROUNDINGS = 0x1p-48;

    private Optics() {
    }

    /**
     * Finds the mirror direction R = D - 2 (D·N) N.
     *
     * @param mirror gets it; not one of the others
     * @param direction the direction of the ray
     * @param normal the unit normal
     */
    public static void mirror(Vector mirror, Vector direction, Vector normal) {
        Vector.scale(mirror, normal, -2 * direction.dot(normal));
        mirror.add(direction);
    }

    /**
     * Finds the direction in which a ray goes on behind a surface (Snell's law; Whitted 1980).
     *
     * @param bent gets it, of unit length; not one of the others
     * @param direction the direction of the ray, of unit length
     * @param normal the unit normal, on the side from which the ray comes
     * @param ratio the refractive index of where it comes from, divided by that of where it goes
     * @return whether there is one; there is none at total internal reflection
     */
    public static boolean refract(Vector bent, Vector direction, Vector normal, double ratio) {
        double cos = -direction.dot(normal);
        double square = 1 - ratio * ratio * (1 - cos * cos);
        if (square < 0) {
            return false;
        }
        double across = ratio * cos - Math.sqrt(square);
        bent.set(normal.x * across + direction.x * ratio, normal.y * across + direction.y * ratio,
            normal.z * across + direction.z * ratio);
        return true;
    }

    /**
     * Moves a hit point off its surface by what roundings may have put it on the other side, lest rays that begin there hit the very
     * surface they leave. Up to coordinates of 10,000 that is so much less than {@link Object#THRESHOLD} that nothing is moved.
     *
     * @param point the point, which is changed
     * @param normal the surface's unit normal on the side from which the ray came
     * @param t how far the ray came
     * @return how far the point was moved
     */
    public static double lift(Point point, Vector normal, double t) {
        boolean large = Math.abs(point.x) > LARGE || Math.abs(point.y) > LARGE || Math.abs(point.z) > LARGE || t > LARGE;
        return large ? liftLarge(point, normal, t) : 0;
    }

    private static double liftLarge(Point point, Vector normal, double t) {
        double size = Math.max(Math.max(Math.abs(point.x), Math.abs(point.y)), Math.max(Math.abs(point.z), t));
        if (!(size < Double.POSITIVE_INFINITY)) {
            return 0;
        }
        double height = ROUNDINGS * size;
        point.x += height * normal.x;
        point.y += height * normal.y;
        point.z += height * normal.z;
        return height;
    }

    /**
     * Moves a lifted hit point as far to the other side of its surface, for a ray that goes on through it.
     *
     * @param point the point, which is changed
     * @param normal the normal along which it was lifted
     * @param height how far it was lifted
     */
    public static void sink(Point point, Vector normal, double height) {
        if (height > 0) {
            point.x -= 2 * height * normal.x;
            point.y -= 2 * height * normal.y;
            point.z -= 2 * height * normal.z;
        }
    }
}
