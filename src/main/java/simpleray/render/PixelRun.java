package simpleray.render;

/**
 * Pixels of a row that are traced together: x, x + step and so on, before end. Each is the upper left corner of a square block, and stands
 * for the whole block until the block's other pixels are traced. <em>Constant.</em>
 *
 * @param y the row, 0 at the top
 * @param x the first column
 * @param end the column after the last one, or more
 * @param step the distance between columns, 1 or more
 * @param size the side of the block; 1 for a pixel alone
 * @param preview whether these pixels get better colours later
 */
public record PixelRun(int y, int x, int end, int step, int size, boolean preview) {
    /** {@return the number of pixels} */
    public int count() {
        return (end - x + step - 1) / step;
    }
}
