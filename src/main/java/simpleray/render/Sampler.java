package simpleray.render;

import simpleray.math.Colour;

/** Finds the colour of pixels from the colours of points in them. Any thread may call; a colour depends on nothing else. */
interface Sampler {
    /**
     * Finds the colour of a pixel.
     *
     * @param x the column, 0 at the left
     * @param y the row, 0 at the top
     * @param colour gets the colour, linear
     */
    void pixel(int x, int y, Colour colour);
}
