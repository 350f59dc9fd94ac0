package simpleray.image;

import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * A picture: rows of linear RGB, not clamped, the top row first. <em>Mutable</em>: each row is set once, by any thread, and a row
 * that is set is seen by all.
 */
public final class Picture {
    /** The longest side of a picture, in pixels. */
    public static final int LONGEST_SIDE = 65535;
    private static final int LEVELS = 255;

    private final int width;
    private final int height;
    private final AtomicReferenceArray<double[]> rows;

    /**
     * Creates a picture without rows.
     *
     * @param width the width in pixels, 1 to {@link #LONGEST_SIDE}
     * @param height the height in pixels, 1 to {@link #LONGEST_SIDE}
     */
    public Picture(int width, int height) {
        if (width < 1 || height < 1 || width > LONGEST_SIDE || height > LONGEST_SIDE) {
            throw new IllegalArgumentException("a side of a picture has 1 to " + LONGEST_SIDE + " pixels, not " + width + 'x' + height);
        }
        this.width = width;
        this.height = height;
        rows = new AtomicReferenceArray<>(height);
    }

    /**
     * Estimates the memory that a picture takes once all its rows are set.
     *
     * @param width its width in pixels
     * @param height its height in pixels
     * @return the number of bytes
     */
    public static long bytesNeeded(int width, int height) {
        return (long) height * (width * 3L * Double.BYTES + 24);
    }

    /** {@return the width in pixels} */
    public int width() {
        return width;
    }

    /** {@return the height in pixels} */
    public int height() {
        return height;
    }

    /**
     * Sets a row.
     *
     * @param y its number, 0 at the top
     * @param rgb red, green and blue of each pixel from the left, linear; kept, and not to be changed any more
     */
    public void setRow(int y, double[] rgb) {
        if (rgb.length != 3 * width) {
            throw new IllegalArgumentException("a row of " + width + " pixels has " + 3 * width + " numbers, not " + rgb.length);
        }
        rows.set(y, rgb);
    }

    /**
     * Finds a row.
     *
     * @param y its number, 0 at the top
     * @return red, green and blue of each pixel from the left, linear, not to be changed; null if the row was not set yet
     */
    public double[] row(int y) {
        return rows.get(y);
    }

    /**
     * Finds a row as it stands in a picture file.
     *
     * @param y its number, 0 at the top
     * @return red, green and blue of each pixel from the left, 0 to 255 each; a new array
     * @throws IllegalStateException if the row was not set yet
     */
    public byte[] levels(int y) {
        double[] linear = rows.get(y);
        if (linear == null) {
            throw new IllegalStateException("row " + y + " of the picture is not there yet");
        }
        byte[] levels = new byte[linear.length];
        for (int i = 0; i < levels.length; i++) {
            levels[i] = (byte) level(linear[i]);
        }
        return levels;
    }

    /**
     * Adds pictures, light to light and not clamped.
     *
     * @param pictures one or more of one size, whole; added in this order
     * @return a new picture
     */
    public static Picture sum(List<Picture> pictures) {
        Picture sum = new Picture(pictures.get(0).width, pictures.get(0).height);
        for (int y = 0; y < sum.height; y++) {
            double[] row = new double[3 * sum.width];
            for (Picture picture : pictures) {
                double[] light = picture.row(y);
                for (int i = 0; i < row.length; i++) {
                    row[i] += light[i];
                }
            }
            sum.setRow(y, row);
        }
        return sum;
    }

    /**
     * Turns light into a level: clamped to 0..1, linear, no gamma.
     *
     * @param c a component of a colour
     * @return floor(255 c + 0.5), from 0 to 255
     */
    public static int level(double c) {
        return (int) Math.floor(LEVELS * Math.min(1, Math.max(0, c)) + 0.5);
    }
}
