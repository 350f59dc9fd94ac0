package simpleray.image.png;

/** Takes the rows of a picture as they stand in its file. Any thread may call. */
@FunctionalInterface
public interface RowSink {
    /**
     * Takes a row.
     *
     * @param y its number, 0 at the top
     * @param levels holds red, green and blue of each pixel from the left, 0 to 255 each; changed later, and so to be copied
     * @param from where in it they begin
     */
    void row(int y, byte[] levels, int from);
}
