package simpleray.ui.picture;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;
import simpleray.render.PixelRun;
import simpleray.render.Region;

/**
 * The image that a window shows while a picture is rendered: blocks that become smaller. It knows for each pixel how coarse its block is,
 * and a coarse block never hides a finer one, in whatever order they come. <em>Mutable</em>; any thread may make one, the event thread
 * alone uses it.
 */
final class ProgressiveImage {
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
    private final boolean alpha;

    /** Makes an empty image of a picture that has alpha or has none. */
    ProgressiveImage(int width, int height, boolean alpha) {
        this.alpha = alpha;
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

    /** {@return whether pixels that are painted may be transparent} */
    boolean hasAlpha() {
        return alpha;
    }

    boolean isOf(int otherWidth, int otherHeight) {
        return width == otherWidth && height == otherHeight;
    }

    /** {@return the side of a pixel's block; 0 if it could not be rendered, negative if nothing is painted there} */
    int blockAt(int x, int y) {
        byte size = sizes[y * width + x];
        return size == NOTHING ? -1 : size;
    }

    /** Lets any block, however coarse, come over the pixels of a region. */
    void reopen(Region region) {
        for (int y = region.y(); y < region.bottom(); y++) {
            Arrays.fill(sizes, y * width + region.x(), y * width + region.right(), NOTHING);
        }
    }

    /** Paints the blocks of a run, each in its colour, and adds their place to the rectangle that has changed. */
    void paint(PixelRun run, int[] argb, Rectangle changed) {
        int bottom = Math.min(height, run.y() + run.size());
        int right = width;
        for (int y = run.y(); y < bottom; y++) {
            int row = y * width;
            int x = run.x();
            for (int colour : argb) {
                right = Math.min(width, x + run.size());
                for (int i = row + x; i < row + right; i++) {
                    if (sizes[i] >= run.size()) {
                        pixels[i] = colour;
                        sizes[i] = (byte) run.size();
                    }
                }
                if (y == run.y() && sizes[row + x] != FAILED) {   // the block's corner is the pixel that was traced
                    pixels[row + x] = colour;
                    sizes[row + x] = 1;
                }
                x += run.step();
            }
        }
        changed.add(new Rectangle(run.x(), run.y(), right - run.x(), bottom - run.y()));
    }

    /** Hatches a row that could not be rendered. */
    void hatch(int y, Rectangle changed) {
        for (int x = 0; x < width; x++) {
            pixels[y * width + x] = (x + y) % HATCH < HATCH / 3 ? RED : DARK;
            sizes[y * width + x] = FAILED;
        }
        changed.add(new Rectangle(0, y, width, 1));
    }
}
