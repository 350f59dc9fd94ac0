package simpleray.image.png;

import java.io.IOException;
import java.io.OutputStream;
import simpleray.image.Picture;

/**
 * A picture of differences: black where there is none, and from blue for 1 level over red to yellow for 255, by the logarithm, so that
 * small ones are seen. <em>Mutable,</em> for one thread.
 */
public final class HeatMap {
    private static final int LARGEST = 255;

    private final Picture picture;
    private final PngWriter png;

    /**
     * Begins a map.
     *
     * @param width its width in pixels
     * @param height its height in pixels
     * @param out where to; it stays open
     */
    public HeatMap(int width, int height, OutputStream out) {
        picture = new Picture(width, height);
        png = new PngWriter(picture, out);
    }

    /**
     * Draws a row.
     *
     * @param y its number, 0 at the top
     * @param differences the difference of each pixel, 0 to 255
     * @throws IOException if it cannot be written
     */
    public void row(int y, int[] differences) throws IOException {
        double[] rgb = new double[3 * differences.length];
        for (int x = 0; x < differences.length; x++) {
            if (differences[x] > 0) {
                double heat = Math.log(differences[x]) / Math.log(LARGEST);
                rgb[3 * x] = Math.min(1, 2 * heat);
                rgb[3 * x + 1] = Math.max(0, 2 * heat - 1);
                rgb[3 * x + 2] = Math.max(0, 1 - 2 * heat);
            }
        }
        picture.setRow(y, rgb);
        png.row(y);
        picture.release(y);
    }

    /**
     * Ends the file, once all rows are drawn.
     *
     * @throws IOException if it cannot be written
     */
    public void end() throws IOException {
        png.end();
    }
}
