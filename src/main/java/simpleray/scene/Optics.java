package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Vector;

/** Directions and origins of rays that leave a surface. */
public final class Optics {
    /** Up to this coordinate rounding errors are far below {@link Object#THRESHOLD}, at grazing angles too. */
    private static final double LARGE = 1e4;
    /** An upper bound of the rounding errors of a hit point, as a share of its coordinates. */
    static final double ROUNDINGS = 0x1p-48;
    /** Down to this cosine a shadow ray may slant against the surface that holds the lamp: its hit's error grows by 1 / cosine. */
    private static final double SLANTED = 0x1p-8;

    private Optics() {
    }

    /**
     * Computes the mirror direction R = D - 2 (D·N) N.
     *
     * @param mirror gets R; not one of the others
     * @param direction the direction of the ray
     * @param normal the unit normal
     */
    public static void mirror(Vector mirror, Vector direction, Vector normal) {
        Vector.scale(mirror, normal, -2 * direction.dot(normal));
        mirror.add(direction);
    }

    /**
     * Computes the direction of the refracted ray (Snell's law; Whitted 1980).
     *
     * @param bent gets the direction, of unit length; not one of the others
     * @param direction the direction of the ray, of unit length
     * @param normal the unit normal, on the side from which the ray comes
     * @param ratio the refractive index on the side it comes from, divided by that on the other side
     * @return false at total internal reflection, where there is none
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
     * Moves a hit point off its surface by more than its rounding error, so that rays that start there do not hit the surface they leave.
     * Up to coordinates of 10,000 the error is so far below {@link Object#THRESHOLD} that the point is not moved.
     *
     * @param point the point, which is changed
     * @param normal the surface's unit normal on the side from which the ray came
     * @param t the distance that the ray travelled
     * @return the distance by which the point was moved
     */
    public static double lift(Point point, Vector normal, double t) {
        boolean large = Math.abs(point.x) > LARGE || Math.abs(point.y) > LARGE || Math.abs(point.z) > LARGE || t > LARGE;
        return large ? liftLarge(point, normal, t) : 0;
    }

    /**
     * Computes by how much a shadow ray ends before the light, so that it misses the surface in which the light lies.
     *
     * @param point the origin of the ray
     * @param distance the distance of the light; infinite for a directional one
     * @return {@link Object#THRESHOLD}, or more where rounding errors are larger
     */
    public static double margin(Point point, double distance) {
        double error = error(point, distance);
        return error < Double.POSITIVE_INFINITY ? Math.max(Object.THRESHOLD, error / SLANTED) : 0;
    }

    private static double liftLarge(Point point, Vector normal, double t) {
        double height = error(point, t);
        if (!(height < Double.POSITIVE_INFINITY)) {
            return 0;
        }
        move(point, normal, height);
        return height;
    }

    /** {@return an upper bound of the rounding error of a hit point, to which the ray travelled the distance t} */
    static double error(Point point, double t) {
        return ROUNDINGS * Math.max(Math.max(Math.abs(point.x), Math.abs(point.y)), Math.max(Math.abs(point.z), t));
    }

    /** Moves a point along a unit normal. */
    static void move(Point point, Vector normal, double distance) {
        point.x += distance * normal.x;
        point.y += distance * normal.y;
        point.z += distance * normal.z;
    }

    /**
     * Moves a lifted hit point to the other side of its surface, at the same distance, for a refracted ray.
     *
     * @param point the point, which is changed
     * @param normal the normal along which it was lifted
     * @param height the distance by which it was lifted
     */
    public static void sink(Point point, Vector normal, double height) {
        if (height > 0) {
            move(point, normal, -2 * height);
        }
    }
}
