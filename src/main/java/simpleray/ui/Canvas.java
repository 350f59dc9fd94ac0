package simpleray.ui;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;
import simpleray.render.Region;

/**
 * What a window shows of a picture while it is rendered: blocks that become smaller. Of each pixel it knows how coarse the block is that it
 * belongs to, and a coarse block never hides a finer one, in whatever order they come. <em>Mutable</em>; the event thread's own, but for
 * its making.
 */
final class Canvas {
    private static final byte NOTHING = Byte.MAX_VALUE;
    private static final byte FAILED = 0;
    private static final int HATCH = 6;                       // pixels from line to line
    private static final int DARK = 0xFF202020;
    private static final int RED = 0xFFE04040;

    private final BufferedImage image;
    private final int[] pixels;
    private final byte[] sizes;                               // of the block that each pixel belongs to
    private final int width;
    private final int height;

    /** Pixels of a row as a screen shows them: x, x + step and so on, each the upper left corner of a block. */
    record Strip(int y, int x, int step, int size, int[] rgb) {
    }

    Canvas(int width, int height) {
        this.width = width;
        this.height = height;
        image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        pixels = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        sizes = new byte[pixels.length];
        Arrays.fill(sizes, NOTHING);
    }

    BufferedImage image() {
        return image;
    }

    boolean isOf(int otherWidth, int otherHeight) {
        return width == otherWidth && height == otherHeight;
    }

    /** Lets any block, however coarse, come over what is there of a region. */
    void reopen(Region region) {
        for (int y = region.y(); y < region.bottom(); y++) {
            Arrays.fill(sizes, y * width + region.x(), y * width + region.right(), NOTHING);
        }
    }

    /** Paints blocks, and adds where to what has changed. */
    void paint(Strip strip, Rectangle changed) {
        int bottom = Math.min(height, strip.y + strip.size);
        int right = width;
        for (int y = strip.y; y < bottom; y++) {
            int row = y * width;
            int x = strip.x;
            for (int colour : strip.rgb) {
                right = Math.min(width, x + strip.size);
                for (int i = row + x; i < row + right; i++) {
                    if (sizes[i] >= strip.size) {
                        pixels[i] = colour;
                        sizes[i] = (byte) strip.size;
                    }
                }
                if (y == strip.y && sizes[row + x] != FAILED) {   // the block's corner is the pixel that was traced
                    pixels[row + x] = colour;
                    sizes[row + x] = 1;
                }
                x += strip.step;
            }
        }
        changed.add(new Rectangle(strip.x, strip.y, right - strip.x, bottom - strip.y));
    }

    /** Marks a row that could not be rendered. */
    void hatch(int y, Rectangle changed) {
        for (int x = 0; x < width; x++) {
            pixels[y * width + x] = (x + y) % HATCH < HATCH / 3 ? RED : DARK;
            sizes[y * width + x] = FAILED;
        }
        changed.add(new Rectangle(0, y, width, 1));
    }
}
