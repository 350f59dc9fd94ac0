package simpleray.rays;

import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Camera;

/**
 * Where a camera's picture shows a point: the inverse of {@link Camera#through(double, double)}, for any camera whose rays go from one eye
 * through a flat window. <em>Constant.</em>
 */
public final class Projection {
    private final Camera camera;
    private final Vector first;                               // from the eye to three corners of the window, up to one factor
    private final Vector right;
    private final Vector below;

    /**
     * Creates a projection.
     *
     * @param camera the camera
     */
    public Projection(Camera camera) {
        this.camera = camera;
        int w = camera.width();
        int h = camera.height();
        Vector a = camera.through(0, 0).direction;
        Vector b = camera.through(w, 0).direction;
        Vector c = camera.through(0, h).direction;
        // the fourth corner is right + below - first: how the ray through it is made of the others tells their lengths
        double[] share = coordinates(camera.through(w, h).direction, a, b, c);
        first = Vector.scale(a, -share[0]);
        right = Vector.scale(b, share[1]);
        below = Vector.scale(c, share[2]);
    }

    /**
     * Projects a point.
     *
     * @param p the point
     * @return pixels from the left and from the top edge; outside the picture if it lies beside; null if it is not before the eye
     */
    public double[] of(Point p) {
        double[] share = coordinates(Vector.subtract(p, camera.eye()), first, right, below);
        double sum = share[0] + share[1] + share[2];
        return sum > 0 ? new double[] {camera.width() * share[1] / sum, camera.height() * share[2] / sum} : null;
    }

    /** {@return a vector as a sum of three others, by Cramer's rule} */
    private static double[] coordinates(Vector v, Vector a, Vector b, Vector c) {
        Vector bc = Vector.cross(b, c);
        double all = a.dot(bc);
        return new double[] {v.dot(bc) / all, v.dot(Vector.cross(c, a)) / all, v.dot(Vector.cross(a, b)) / all};
    }
}
