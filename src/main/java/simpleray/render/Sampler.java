package simpleray.render;

import simpleray.math.Colour;

/**
 * Computes the colour of a pixel from the colours of points in it, and from nothing else. <em>Mutable</em>: one thread's own.
 */
interface Sampler {
    /**
     * Computes the colour of a pixel. Fast if a thread asks for one row after another.
     *
     * @param x the column, 0 at the left
     * @param y the row, 0 at the top
     * @param colour gets the colour, linear
     */
    void pixel(int x, int y, Colour colour);

    /**
     * Returns the points of a pixel whose colours {@link #pixel} adds.
     *
     * @param x the column, 0 at the left
     * @param y the row, 0 at the top
     * @return two numbers for each point, in the order of addition: pixels from the left edge and from the top edge
     */
    double[] points(int x, int y);
}
