package simpleray.image.png;

/** Gets the rows of a picture as its file has them. Any thread may call. */
@FunctionalInterface
public interface RowSink {
    /**
     * Gets a row.
     *
     * @param y its number, 0 at the top
     * @param levels holds red, green and blue of each pixel from the left, and its alpha if there is any, 0 to 255 each; must be copied, since
     *     it is changed later
     * @param from the index of the first level
     */
    void row(int y, byte[] levels, int from);
}
