package simpleray.ui.compare;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;

/**
 * Pixels whose light a screen cannot show: above 1 or below 0 in a channel. In a packed pixel the upper byte, which a screen does
 * not use, holds flags for them.
 */
final class Clipped {
    /** Set in a packed pixel with a channel above 1. */
    static final int ABOVE = 1 << 24;
    /** Set in a packed pixel with a channel below 0, or one that is no number. */
    static final int BELOW = 1 << 25;
    /** The signal colour of pixels above 1. */
    static final int ABOVE_COLOUR = 0xFFFF00FF;
    /** The signal colour of pixels below 0. */
    static final int BELOW_COLOUR = 0xFF00FFFF;

    private static final int BITS = 24;
    private static final int[] MASKS = {0xFF0000, 0xFF00, 0xFF};

    private Clipped() {
    }

    /** {@return ABOVE and BELOW, as the light of a pixel is} */
    static int flags(double red, double green, double blue) {
        int above = red > 1 || green > 1 || blue > 1 ? ABOVE : 0;
        return red >= 0 && green >= 0 && blue >= 0 ? above : above | BELOW;
    }

    /** {@return the signal colour of a packed pixel; 0, which can be seen through, if it is not clipped} */
    static int mark(int packed) {
        return (packed & ABOVE) != 0 ? ABOVE_COLOUR : (packed & BELOW) != 0 ? BELOW_COLOUR : 0;
    }

    /** {@return the marks of a picture, to be painted over it} */
    static BufferedImage marks(int[] packed, int width, int height) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        int[] row = new int[width];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                row[x] = mark(packed[y * width + x]);
            }
            image.setRGB(0, y, width, 1, row, 0, width);
        }
        return image;
    }

    /** {@return a picture as a screen shows it; its pixels are the packed ones themselves} */
    static BufferedImage image(int[] packed, int width, int height) {
        WritableRaster raster = Raster.createPackedRaster(new DataBufferInt(packed, packed.length), width, height, width, MASKS, null);
        return new BufferedImage(new DirectColorModel(BITS, MASKS[0], MASKS[1], MASKS[2]), raster, false, null);
    }
}
