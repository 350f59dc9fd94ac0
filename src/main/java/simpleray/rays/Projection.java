package simpleray.rays;

import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Camera;

/**
 * Where a camera's picture shows a point: the inverse of {@link Camera#through(double, double)}, for any camera whose rays go from one eye
 * through a flat window, or are parallel. <em>Constant.</em>
 */
public final class Projection {
    private final Camera camera;
    private final boolean parallel;
    private final Point origin;                               // of all rays; of parallel ones, that of the first corner
    private final Vector first;                               // from the eye to a corner of the window; or the direction of parallel rays
    private final Vector right;                               // likewise to the corner on its right; or from corner to corner
    private final Vector below;                               // likewise to the corner below it; all three up to one factor

    /**
     * Creates a projection.
     *
     * @param camera the camera
     */
    public Projection(Camera camera) {
        this.camera = camera;
        int w = camera.width();
        int h = camera.height();
        origin = camera.through(0, 0).origin;
        parallel = camera.eye() == null;
        if (parallel) {
            first = camera.through(0, 0).direction;
            right = Vector.subtract(camera.through(w, 0).origin, origin);
            below = Vector.subtract(camera.through(0, h).origin, origin);
            return;
        }
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
        double[] share = coordinates(Vector.subtract(p, origin), first, right, below);
        double sum = parallel ? 1 : share[0] + share[1] + share[2];
        boolean before = parallel ? share[0] >= 0 : sum > 0;
        return before ? new double[] {camera.width() * share[1] / sum, camera.height() * share[2] / sum} : null;
    }

    /** {@return a vector as a sum of three others, by Cramer's rule} */
    private static double[] coordinates(Vector v, Vector a, Vector b, Vector c) {
        Vector bc = Vector.cross(b, c);
        double all = a.dot(bc);
        return new double[] {v.dot(bc) / all, v.dot(Vector.cross(c, a)) / all, v.dot(Vector.cross(a, b)) / all};
    }
}
