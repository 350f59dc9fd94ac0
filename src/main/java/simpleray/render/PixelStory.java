package simpleray.render;

import java.util.List;
import simpleray.math.Colour;
import simpleray.scene.RayTree;

/**
 * Why a pixel has its colour. <em>Constant</em>; nothing in it is to be changed.
 *
 * @param x the column, 0 at the left
 * @param y the row, 0 at the top
 * @param width how many columns there are
 * @param height how many rows there are
 * @param stage which picture it belongs to
 * @param mean whether the pixel is the mean of its samples, added in their order; if not, it is its only one
 * @param samples its samples, one or more
 * @param colour its colour, linear
 */
public record PixelStory(int x, int y, int width, int height, Stage stage, boolean mean, List<Sample> samples, Colour colour) {
    /**
     * The ray through a point of the pixel.
     *
     * @param px pixels from the left edge
     * @param py pixels from the top edge
     * @param clamped whether the colour was brought into 0 to 1, as it is where a pixel has several points
     * @param colour the colour that counts: what the ray sees, or in a view what that shows
     * @param tree the ray's tree; in a view that of the finished picture
     */
    public record Sample(double px, double py, boolean clamped, Colour colour, RayTree tree) {
    }
}
