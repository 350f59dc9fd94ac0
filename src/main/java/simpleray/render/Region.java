package simpleray.render;

/**
 * A rectangle of a picture. <em>Constant.</em>
 *
 * @param x its left column, 0 at the picture's left
 * @param y its top row, 0 at the picture's top
 * @param width its width in pixels, 1 or more
 * @param height its height in pixels, 1 or more
 */
public record Region(int x, int y, int width, int height) {
    /**
     * Checks the ranges.
     *
     * @param x its left column, 0 or more
     * @param y its top row, 0 or more
     * @param width its width in pixels, 1 or more
     * @param height its height in pixels, 1 or more
     */
    public Region {
        if (x < 0 || y < 0 || width < 1 || height < 1) {
            throw new IllegalArgumentException("a region begins at 0 or more and is 1 pixel wide and high or more, and is "
                + text(x, y, width, height));
        }
    }

    /**
     * Returns the region of a whole picture.
     *
     * @param width the picture's width in pixels
     * @param height its height in pixels
     * @return the region
     */
    public static Region whole(int width, int height) {
        return new Region(0, 0, width, height);
    }

    /** {@return the column after the last} */
    public int right() {
        return x + width;
    }

    /** {@return the row after the last} */
    public int bottom() {
        return y + height;
    }

    /**
     * Checks that this region is inside a picture.
     *
     * @param pictureWidth the picture's width in pixels
     * @param pictureHeight its height in pixels
     * @throws IllegalArgumentException if it is not; the message is for the user
     */
    public void requireWithin(int pictureWidth, int pictureHeight) {
        if (!isWithin(pictureWidth, pictureHeight)) {
            throw new IllegalArgumentException("the region " + this + " is not inside the picture of " + pictureWidth + 'x'
                + pictureHeight);
        }
    }

    /**
     * Tells whether this region is inside a picture.
     *
     * @param pictureWidth the picture's width in pixels
     * @param pictureHeight its height in pixels
     * @return whether it is
     */
    public boolean isWithin(int pictureWidth, int pictureHeight) {
        return (long) x + width <= pictureWidth && (long) y + height <= pictureHeight;
    }

    /** {@return this region with a border of one pixel, as far as it is inside the picture} */
    Region grown(int pictureWidth, int pictureHeight) {
        int left = Math.max(0, x - 1);
        int top = Math.max(0, y - 1);
        return new Region(left, top, Math.min(pictureWidth, right() + 1) - left, Math.min(pictureHeight, bottom() + 1) - top);
    }

    /** {@return the four numbers as the command line has them} */
    @Override
    public String toString() {
        return text(x, y, width, height);
    }

    private static String text(int x, int y, int width, int height) {
        return x + "," + y + "," + width + "," + height;
    }
}
