package simpleray.image;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.Supplier;

/**
 * A picture: rows of linear RGB, not clamped, the top row first. It may have alpha: a fourth number for each pixel, the share of it that is
 * covered, from 0 to 1, by which the colour is not multiplied. <em>Mutable</em>: each row is set once, by any thread, and a row
 * that is set is visible to all threads. A row that is no longer needed can be released.
 */
public final class Picture {
    /** The longest side of a picture, in pixels. */
    public static final int LONGEST_SIDE = 65535;
    /** The numbers of a pixel: red, green and blue. */
    public static final int RGB = 3;
    /** The numbers of a pixel with alpha: red, green, blue and alpha. */
    public static final int RGBA = 4;
    private static final int LEVELS = 255;
    private static final int OPAQUE = 0xFF000000;
    private static final int BITS = 8;
    /** A shift by so many bits leaves only the sign: all bits are 1 for a negative number, and 0 for others. */
    private static final int SIGN = 31;

    private final int width;
    private final int height;
    private final int channels;
    private final AtomicReferenceArray<double[]> rows;
    private volatile List<PictureText> texts = List.of();
    private volatile Supplier<List<PictureText>> textsLater;    // null if they are known

    /**
     * Creates a picture without rows and without alpha.
     *
     * @param width the width in pixels, 1 to {@link #LONGEST_SIDE}
     * @param height the height in pixels, 1 to {@link #LONGEST_SIDE}
     */
    public Picture(int width, int height) {
        this(width, height, RGB);
    }

    /**
     * Creates a picture without rows.
     *
     * @param width the width in pixels, 1 to {@link #LONGEST_SIDE}
     * @param height the height in pixels, 1 to {@link #LONGEST_SIDE}
     * @param channels the numbers of a pixel, {@link #RGB} or {@link #RGBA}
     */
    public Picture(int width, int height, int channels) {
        if (width < 1 || height < 1 || width > LONGEST_SIDE || height > LONGEST_SIDE) {
            throw new IllegalArgumentException("a side of a picture has 1 to " + LONGEST_SIDE + " pixels, not " + width + 'x' + height);
        }
        this.width = width;
        this.height = height;
        this.channels = channels;
        rows = new AtomicReferenceArray<>(height);
    }

    /**
     * Estimates the memory that a picture takes once all its rows are set.
     *
     * @param width its width in pixels
     * @param height its height in pixels
     * @param channels the numbers of a pixel, {@link #RGB} or {@link #RGBA}
     * @return the number of bytes
     */
    public static long bytesNeeded(int width, int height, int channels) {
        return (long) height * ((long) width * channels * Double.BYTES + 24);
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

    /** {@return the numbers of a pixel: {@link #RGB}, or {@link #RGBA} if the picture has alpha} */
    public int channels() {
        return channels;
    }

    /** {@return whether the picture has alpha} */
    public boolean hasAlpha() {
        return channels == RGBA;
    }

    /**
     * Sets a row.
     *
     * @param y its number, 0 at the top
     * @param light red, green and blue of each pixel from the left, linear, and its alpha if there is any; kept, and must not be changed
     *     afterwards
     */
    public void setRow(int y, double[] light) {
        if (light.length != channels * width) {
            throw new IllegalArgumentException("a row of " + width + " pixels has " + channels * width + " numbers, not " + light.length);
        }
        rows.set(y, light);
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
     * @return red, green and blue of each pixel from the left, linear, and its alpha if there is any, not to be changed; null if the row was
     *     not set yet or is released
     */
    public double[] row(int y) {
        return rows.get(y);
    }

    /**
     * Returns a row as it looks on a grey ground.
     *
     * @param y its number, 0 at the top
     * @param ground the ground's red, green and blue, 0 for black
     * @return red, green and blue of each pixel from the left, linear, not to be changed; null if the row was not set yet or is released
     */
    public double[] over(int y, double ground) {
        double[] row = rows.get(y);
        if (!hasAlpha() || row == null) {
            return row;
        }
        double[] over = new double[RGB * width];
        for (int i = 0; i < over.length; i++) {
            double alpha = row[i / RGB * RGBA + RGB];
            over[i] = row[i / RGB * RGBA + i % RGB] * alpha + ground * (1 - alpha);
        }
        return over;
    }

    /**
     * Returns the levels of a row, as in a picture file.
     *
     * @param y its number, 0 at the top
     * @return red, green and blue of each pixel from the left, and its alpha if there is any, 0 to 255 each; a new array
     * @throws IllegalStateException if the picture does not have the row
     */
    public byte[] levels(int y) {
        byte[] levels = new byte[channels * width];
        levels(y, levels, 0);
        return levels;
    }

    /**
     * Converts light to levels.
     *
     * @param linear red, green and blue of each pixel, linear, and its alpha if there is any
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
     * @return a new image with the levels of a picture file, of type {@link BufferedImage#TYPE_INT_RGB}, or
     *     {@link BufferedImage#TYPE_INT_ARGB} if the picture has alpha
     * @throws IllegalStateException if a row is missing
     */
    public BufferedImage toBufferedImage() {
        BufferedImage image = new BufferedImage(width, height, hasAlpha() ? BufferedImage.TYPE_INT_ARGB : BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            image.setRGB(0, y, width, 1, packed(levels(y), channels), 0, width);
        }
        return image;
    }

    /**
     * Packs levels as images of AWT have them.
     *
     * @param levels the levels of some pixels
     * @param channels the numbers of a pixel, {@link #RGB} or {@link #RGBA}
     * @return for each pixel, from the highest byte, alpha, which is 255 if there is none, red, green and blue
     */
    public static int[] packed(byte[] levels, int channels) {
        int[] packed = new int[levels.length / channels];
        for (int x = 0, i = 0; x < packed.length; x++, i += channels) {
            packed[x] = (channels == RGBA ? levels[i + RGB] << 24 : OPAQUE)
                | (levels[i] & LEVELS) << 16 | (levels[i + 1] & LEVELS) << 8 | levels[i + 2] & LEVELS;
        }
        return packed;
    }

    /**
     * Makes a picture of an image of AWT.
     *
     * @param image the image; the picture has alpha if it has
     * @return a new picture, of which {@link #toBufferedImage} makes an equal image
     */
    public static Picture of(BufferedImage image) {
        int channels = image.getColorModel().hasAlpha() ? RGBA : RGB;
        Picture picture = new Picture(image.getWidth(), image.getHeight(), channels);
        for (int y = 0; y < picture.height; y++) {
            byte[] levels = new byte[channels * picture.width];
            for (int x = 0; x < picture.width; x++) {
                int argb = image.getRGB(x, y);
                for (int c = 0; c < channels; c++) {
                    levels[channels * x + c] = (byte) (c < RGB ? argb >> 16 - 8 * c : argb >> 24);
                }
            }
            picture.setRow(y, light(levels));
        }
        return picture;
    }

    /**
     * Writes the levels of a row into an array.
     *
     * @param y its number, 0 at the top
     * @param levels gets red, green and blue of each pixel, and its alpha if there is any, 0 to 255 each
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
     * @param pictures one or more of one size, complete, and all of one alpha or without; added in this order
     * @return a new picture, of the same alpha
     */
    public static Picture sum(List<Picture> pictures) {
        Picture first = pictures.get(0);
        Picture sum = new Picture(first.width, first.height, first.channels);
        for (int y = 0; y < sum.height; y++) {
            double[] row = new double[sum.channels * sum.width];
            for (Picture picture : pictures) {
                double[] light = picture.row(y);
                for (int i = 0; i < row.length; i++) {
                    row[i] += light[i];
                }
            }
            for (int i = RGB; i < row.length && sum.hasAlpha(); i += RGBA) {
                row[i] = first.row(y)[i];
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
        byte[] levels = new byte[1];
        levels(new double[] {c}, levels, 0);
        return levels[0] & LEVELS;
    }

    /**
     * Most of a run's first picture is converted before this method is fully compiled. A loop over pixels without calls and branches takes
     * a tenth of the time until then, and is compiled fast. What is left behind the last three numbers takes the loop below.
     */
    private static void levels(double[] linear, byte[] levels, int from) {
        int i = 0;
        int k = from;
        for (; i + 2 < linear.length; i += 3, k += 3) {
            int red = (int) (LEVELS * linear[i] + 0.5);       // rounds towards 0, so a negative number becomes none above 0; NaN is 0
            int green = (int) (LEVELS * linear[i + 1] + 0.5);
            int blue = (int) (LEVELS * linear[i + 2] + 0.5);
            // below 0 all bits become 0; above 255 all bits become 1, of which a byte keeps eight
            levels[k] = (byte) (red & ~(red >> SIGN) | -(red >> BITS) >> SIGN);
            levels[k + 1] = (byte) (green & ~(green >> SIGN) | -(green >> BITS) >> SIGN);
            levels[k + 2] = (byte) (blue & ~(blue >> SIGN) | -(blue >> BITS) >> SIGN);
        }
        for (; i < linear.length; i++, k++) {
            levels[k] = (byte) Math.max(0, Math.min(LEVELS, (int) (LEVELS * linear[i] + 0.5)));
        }
    }
}
