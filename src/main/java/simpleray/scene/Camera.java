package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Ray;

/** A viewer: makes the rays that go through a picture. Any thread may ask once it is set up. */
public interface Camera {
    /** {@return the width of the picture in pixels} */
    int width();

    /** {@return the height of the picture in pixels} */
    int height();

    /** {@return the point from which all its rays start; a new one} */
    Point eye();

    /**
     * Finds the ray through a point of the picture.
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
     * Finds the ray through a point of the picture.
     *
     * @param px pixels from the left edge: the centre of the left column is at 0.5
     * @param py pixels from the top edge: the centre of the top row is at 0.5
     * @param ray gets the ray; its direction is of unit length
     */
    void through(double px, double py, Ray ray);
}
