package simpleray.render;

import java.util.List;
import java.util.OptionalDouble;
import simpleray.math.Colour;
import simpleray.scene.RayTree;

/**
 * The reasons for a pixel's colour. <em>Constant</em>; nothing in it may be changed.
 *
 * @param x the column, 0 at the left
 * @param y the row, 0 at the top
 * @param width the width of the picture in pixels
 * @param height the height of the picture in pixels
 * @param stage the stage of the picture
 * @param mean whether the pixel is the mean of those of its samples that count, added in their order; if not, it is its only sample
 * @param samples its samples, one or more
 * @param colour its colour, linear
 * @param alpha the share of its samples that count, from 0 to 1, if the picture has alpha
 */
public record PixelStory(int x, int y, int width, int height, Stage stage, boolean mean, List<Sample> samples, Colour colour,
    OptionalDouble alpha) {
    /**
     * The ray through a point of the pixel.
     *
     * @param px pixels from the left edge
     * @param py pixels from the top edge
     * @param clamped whether the colour was clamped to 0 to 1, as it is if a pixel has several points
     * @param counts whether it counts for the pixel's colour: not where the picture is transparent
     * @param colour the colour that counts: that of the ray, or in a view that of the view
     * @param tree the ray's tree; in a view, the tree of the final stage
     */
    public record Sample(double px, double py, boolean clamped, boolean counts, Colour colour, RayTree tree) {
    }
}
