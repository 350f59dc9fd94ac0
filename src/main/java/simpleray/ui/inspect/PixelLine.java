package simpleray.ui.inspect;

import java.awt.Point;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.render.StoryText;
import simpleray.ui.picture.SimpleRay;

/** Describes a pixel without following a ray. */
final class PixelLine {
    private static final int LEVEL = 0xFF;

    private PixelLine() {
    }

    /**
     * {@return a pixel's place and colour, as far as that is known; null if there is no such pixel}
     *
     * @param light the picture, of which only whole rows are known; null if it is not begun
     * @param shown what is shown of it
     */
    static String colours(Picture light, Point pixel, SimpleRay shown) {
        if (light != null && (pixel.x >= light.width() || pixel.y >= light.height())) {
            return null;
        }
        String text = "x " + pixel.x + ", y " + pixel.y;
        double[] row = light == null ? null : light.row(pixel.y);
        if (row == null) {
            return text + "   " + (shown.has(pixel) ? painted(shown.blockAt(pixel), shown.levelsAt(pixel)) : "not rendered yet");
        }
        Colour colour = new Colour(row[3 * pixel.x], row[3 * pixel.x + 1], row[3 * pixel.x + 2]);
        return text + "   linear " + StoryText.colour(colour) + "   8-bit " + StoryText.levels(colour);
    }

    /** {@return what is known of a pixel whose row is not whole: what one sees} */
    static String painted(int block, int rgb) {
        if (block <= 0) {
            return block == 0 ? "failed" : "not rendered yet";
        }
        String levels = "8-bit " + (rgb >> 16 & LEVEL) + ' ' + (rgb >> 8 & LEVEL) + ' ' + (rgb & LEVEL);
        return block == 1 ? levels : levels + " of a block of " + block + " \u00D7 " + block + ", not rendered itself yet";
    }
}
