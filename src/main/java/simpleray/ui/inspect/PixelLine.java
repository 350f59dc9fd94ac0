package simpleray.ui.inspect;

import java.awt.Point;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.render.StoryText;

/** Describes a pixel without following a ray. */
final class PixelLine {
    private PixelLine() {
    }

    /** {@return a pixel's place and colour, as far as that is known; null if there is no such pixel} Of a picture not begun the light is null. */
    static String colours(Picture light, Point pixel) {
        if (light != null && (pixel.x >= light.width() || pixel.y >= light.height())) {
            return null;
        }
        String text = "x " + pixel.x + ", y " + pixel.y;
        double[] row = light == null ? null : light.row(pixel.y);
        if (row == null) {
            return text + "   not rendered yet";
        }
        Colour colour = new Colour(row[3 * pixel.x], row[3 * pixel.x + 1], row[3 * pixel.x + 2]);
        return text + "   linear " + StoryText.colour(colour) + "   8-bit " + StoryText.levels(colour);
    }
}
