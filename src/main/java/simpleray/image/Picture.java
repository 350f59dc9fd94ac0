package simpleray.image;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.Supplier;

/**
 * A picture: rows of linear RGB, not clamped, the top row first. <em>Mutable</em>: each row is set once, by any thread, and a row
 * that is set is visible to all threads. A row that is no longer needed can be released.
 */
public final class Picture {
    /** The longest side of a picture, in pixels. */
    public static final int LONGEST_SIDE = 65535;
    private static final int LEVELS = 255;
    private static final int BITS = 8;
    /** A shift by so many bits leaves only the sign: all bits are 1 for a negative number, and 0 for others. */
    private static final int SIGN = 31;

    private final int width;
    private final int height;
    private final AtomicReferenceArray<double[]> rows;
    private volatile List<PictureText> texts = List.of();
    private volatile Supplier<List<PictureText>> textsLater;    // null if they are known

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

    /**
     * Sets the texts that the picture's file carries.
     *
     * @param told the texts
     */
    public void tell(List<PictureText> told) {
        texts = List.copyOf(told);
    }

    /**
     * Sets how to make the texts that the picture's file carries.
     *
     * @param later makes the texts; called by any thread when the file is begun
     */
    public void tell(Supplier<List<PictureText>> later) {
        textsLater = later;
    }

    /** {@return the texts that the picture's file carries} */
    public List<PictureText> texts() {
        Supplier<List<PictureText>> later = textsLater;
        return later == null ? texts : later.get();
    }

    /** {@return the height in pixels} */
    public int height() {
        return height;
    }

    /**
     * Sets a row.
     *
     * @param y its number, 0 at the top
     * @param rgb red, green and blue of each pixel from the left, linear; kept, and must not be changed afterwards
     */
    public void setRow(int y, double[] rgb) {
        if (rgb.length != 3 * width) {
            throw new IllegalArgumentException("a row of " + width + " pixels has " + 3 * width + " numbers, not " + rgb.length);
        }
        rows.set(y, rgb);
    }

    /**
     * Releases the memory of a row. Its array may be reused for another row.
     *
     * @param y its number, 0 at the top
     */
    public void release(int y) {
        rows.set(y, null);
    }

    /**
     * Returns a row.
     *
     * @param y its number, 0 at the top
     * @return red, green and blue of each pixel from the left, linear, not to be changed; null if the row was not set yet or is released
     */
    public double[] row(int y) {
        return rows.get(y);
    }

    /**
     * Returns the levels of a row, as in a picture file.
     *
     * @param y its number, 0 at the top
     * @return red, green and blue of each pixel from the left, 0 to 255 each; a new array
     * @throws IllegalStateException if the picture does not have the row
     */
    public byte[] levels(int y) {
        byte[] levels = new byte[3 * width];
        levels(y, levels, 0);
        return levels;
    }

    /**
     * Converts light to levels.
     *
     * @param linear red, green and blue of each pixel, linear
     * @return their levels, 0 to 255 each; a new array
     */
    public static byte[] levels(double[] linear) {
        byte[] levels = new byte[linear.length];
        levels(linear, levels, 0);
        return levels;
    }

    /**
     * Copies the picture into an image of AWT. No other method loads a class of AWT.
     *
     * @return a new image of type {@link BufferedImage#TYPE_INT_RGB}, with the levels of a picture file
     * @throws IllegalStateException if a row is missing
     */
    public BufferedImage toBufferedImage() {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        int[] rgb = new int[width];
        for (int y = 0; y < height; y++) {
            byte[] levels = levels(y);
            for (int x = 0; x < width; x++) {
                rgb[x] = (levels[3 * x] & LEVELS) << 16 | (levels[3 * x + 1] & LEVELS) << 8 | levels[3 * x + 2] & LEVELS;
            }
            image.setRGB(0, y, width, 1, rgb, 0, width);
        }
        return image;
    }

    /**
     * Makes a picture of an image of AWT.
     *
     * @param image the image; its transparency is lost
     * @return a new picture, of which {@link #toBufferedImage} makes an equal image
     */
    public static Picture of(BufferedImage image) {
        Picture picture = new Picture(image.getWidth(), image.getHeight());
        for (int y = 0; y < picture.height; y++) {
            byte[] levels = new byte[3 * picture.width];
            for (int x = 0; x < picture.width; x++) {
                int rgb = image.getRGB(x, y);
                levels[3 * x] = (byte) (rgb >> 16);
                levels[3 * x + 1] = (byte) (rgb >> 8);
                levels[3 * x + 2] = (byte) rgb;
            }
            picture.setRow(y, light(levels));
        }
        return picture;
    }

    /**
     * Writes the levels of a row into an array.
     *
     * @param y its number, 0 at the top
     * @param levels gets red, green and blue of each pixel, 0 to 255 each
     * @param from the index of the first level
     * @throws IllegalStateException if the picture does not have the row
     */
    public void levels(int y, byte[] levels, int from) {
        double[] linear = rows.get(y);
        if (linear == null) {
            throw new IllegalStateException("row " + y + " of the picture is not there");
        }
        levels(linear, levels, from);
    }

    /**
     * Converts levels to light, which {@link #levels(int)} converts to the same levels.
     *
     * @param levels levels from 0 to 255
     * @return as many numbers from 0 to 1; a new array
     */
    public static double[] light(byte[] levels) {
        double[] light = new double[levels.length];
        for (int i = 0; i < levels.length; i++) {
            light[i] = (levels[i] & LEVELS) / (double) LEVELS;
        }
        return light;
    }

    /**
     * Adds the light of pictures, without clamping.
     *
     * @param pictures one or more of one size, complete; added in this order
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
     * Converts light to a level: clamped to 0..1, linear, without gamma.
     *
     * @param c a component of a colour
     * @return floor(255 c + 0.5), from 0 to 255
     */
    public static int level(double c) {
        byte[] levels = new byte[3];
        levels(new double[] {c, c, c}, levels, 0);
        return levels[0] & LEVELS;
    }

    /**
     * Most of a run's first picture is converted before this method is fully compiled. A loop over pixels without calls and branches takes
     * a tenth of the time until then, and is compiled fast.
     */
    private static void levels(double[] linear, byte[] levels, int from) {
        for (int i = 0, k = from; i < linear.length; i += 3, k += 3) {
            int red = (int) (LEVELS * linear[i] + 0.5);       // rounds towards 0, so a negative number becomes none above 0; NaN is 0
            int green = (int) (LEVELS * linear[i + 1] + 0.5);
            int blue = (int) (LEVELS * linear[i + 2] + 0.5);
            // below 0 all bits become 0; above 255 all bits become 1, of which a byte keeps eight
            levels[k] = (byte) (red & ~(red >> SIGN) | -(red >> BITS) >> SIGN);
            levels[k + 1] = (byte) (green & ~(green >> SIGN) | -(green >> BITS) >> SIGN);
            levels[k + 2] = (byte) (blue & ~(blue >> SIGN) | -(blue >> BITS) >> SIGN);
        }
    }
}
