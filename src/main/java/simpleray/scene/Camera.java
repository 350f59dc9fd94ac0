package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Ray;

/** A viewer: makes the rays through a picture. Any thread may call once it is set up. */
public interface Camera {
    /** {@return the width of the picture in pixels} */
    int width();

    /** {@return the height of the picture in pixels} */
    int height();

    /** {@return a new point, the origin of all its rays; null if they are parallel, and each has its own} */
    Point eye();

    /**
     * Returns the ray through a point of the picture.
     *
     * @param px pixels from the left edge: the centre of the left column is at 0.5
     * @param py pixels from the top edge: the centre of the top row is at 0.5
     * @return a new ray of unit direction
     */
    default Ray through(double px, double py) {
        Ray ray = new Ray();
        through(px, py, ray);
        return ray;
    }

    /**
     * Computes the ray through a point of the picture.
     *
     * @param px pixels from the left edge: the centre of the left column is at 0.5
     * @param py pixels from the top edge: the centre of the top row is at 0.5
     * @param ray gets the ray; its direction is of unit length
     */
    void through(double px, double py, Ray ray);
}
