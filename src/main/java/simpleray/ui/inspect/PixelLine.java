package simpleray.ui.inspect;

import java.awt.Point;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.rays.StoryText;
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
        int at = light.channels() * pixel.x;
        if (light.hasAlpha() && row[at + Picture.RGB] == 0) {
            return text + "   transparent";
        }
        Colour colour = new Colour(row[at], row[at + 1], row[at + 2]);
        return text + "   linear " + StoryText.colour(colour) + "   8-bit " + StoryText.levels(colour)
            + (light.hasAlpha() ? "   alpha " + Picture.level(row[at + Picture.RGB]) : "");
    }

    /** {@return what is known of a pixel whose row is not whole: what one sees} */
    static String painted(int block, int argb) {
        if (block <= 0) {
            return block == 0 ? "failed" : "not rendered yet";
        }
        int alpha = argb >>> 24;
        String levels = alpha == 0 ? "transparent" : "8-bit " + (argb >> 16 & LEVEL) + ' ' + (argb >> 8 & LEVEL) + ' ' + (argb & LEVEL)
            + (alpha < LEVEL ? "   alpha " + alpha : "");
        return block == 1 ? levels : levels + " of a block of " + block + " \u00D7 " + block + ", not rendered itself yet";
    }
}
