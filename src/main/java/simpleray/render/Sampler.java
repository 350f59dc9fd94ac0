package simpleray.render;

import simpleray.math.Colour;

/**
 * Finds the colour of pixels from the colours of points in them. A colour depends on nothing else. <em>Mutable</em>: one thread's
 * own.
 */
interface Sampler {
    /**
     * Finds the colour of a pixel. Quick where a thread asks for one row after another.
     *
     * @param x the column, 0 at the left
     * @param y the row, 0 at the top
     * @param colour gets the colour, linear
     */
    void pixel(int x, int y, Colour colour);

    /**
     * Finds the points of a pixel whose colours {@link #pixel} adds.
     *
     * @param x the column, 0 at the left
     * @param y the row, 0 at the top
     * @return two numbers for each point, in that order: pixels from the left edge and from the top edge
     */
    double[] points(int x, int y);
}
