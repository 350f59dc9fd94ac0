package simpleray.render;

import simpleray.image.Picture;
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
     * @param colour gets the colour, linear: the mean of the points that count
     * @return the share of the points that count, from 0 to 1: {@link Tracer#trace}
     */
    double pixel(int x, int y, Colour colour);

    /**
     * Returns the points of a pixel whose colours {@link #pixel} adds.
     *
     * @param x the column, 0 at the left
     * @param y the row, 0 at the top
     * @return two numbers for each point, in the order of addition: pixels from the left edge and from the top edge
     */
    double[] points(int x, int y);

    /**
     * Makes the mean of a sum.
     *
     * @param sum the sum of the colours of the points that count; becomes their mean
     * @param count how many these are; if none, the sum is black and stays so
     * @param points how many points there are
     * @return the share of the points that count
     */
    static double mean(Colour sum, int count, int points) {
        if (count > 0) {
            sum.scale(1.0 / count);
        }
        return (double) count / points;
    }

    /**
     * Stores a pixel in a row of a picture.
     *
     * @param colour its colour
     * @param alpha its alpha
     * @param row the row
     * @param at where in it the pixel begins
     * @param channels the numbers of a pixel; alpha is the fourth if there are four
     */
    static void store(Colour colour, double alpha, double[] row, int at, int channels) {
        row[at] = colour.r;
        row[at + 1] = colour.g;
        row[at + 2] = colour.b;
        if (channels == Picture.RGBA) {
            row[at + Picture.RGB] = alpha;
        }
    }
}
