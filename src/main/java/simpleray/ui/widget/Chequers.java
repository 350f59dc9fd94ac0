package simpleray.ui.widget;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.TexturePaint;
import java.awt.image.BufferedImage;

/** The chequered ground on which the transparent parts of a picture are shown. */
public final class Chequers {
    private static final int SIDE = 8;
    private static final int LIGHT = 0x99;
    private static final int DARK = 0x66;
    private static final int LEVELS = 0xFF;
    private static final BufferedImage TILE = new BufferedImage(2 * SIDE, 2 * SIDE, BufferedImage.TYPE_INT_RGB);

    static {
        for (int y = 0; y < 2 * SIDE; y++) {
            for (int x = 0; x < 2 * SIDE; x++) {
                TILE.setRGB(x, y, over(0, x, y));
            }
        }
    }

    private Chequers() {
    }

    /**
     * Paints the ground.
     *
     * @param g what to paint with
     * @param place where
     */
    public static void paint(Graphics2D g, Rectangle place) {
        g.setPaint(new TexturePaint(TILE, new Rectangle(place.x, place.y, 2 * SIDE, 2 * SIDE)));
        g.fill(place);
    }

    /**
     * Puts a pixel on the ground.
     *
     * @param argb its alpha, red, green and blue from 0 to 255, from the highest byte
     * @param x its column
     * @param y its row
     * @return its red, green and blue there, below an empty byte
     */
    public static int over(int argb, int x, int y) {
        int alpha = argb >>> 24;
        int ground = (x / SIDE + y / SIDE) % 2 == 0 ? LIGHT : DARK;
        int rgb = 0;
        for (int shift = 16; shift >= 0; shift -= Byte.SIZE) {
            int level = ((argb >> shift & LEVELS) * alpha + ground * (LEVELS - alpha) + LEVELS / 2) / LEVELS;
            rgb |= level << shift;
        }
        return rgb;
    }
}
