package simpleray.render;

/**
 * Pixels of a row that are traced in one go: x, x + step and so on, before end. Each stands for a square block, of which it is the
 * upper left corner, until the block's other pixels are known. <em>Constant.</em>
 *
 * @param y the row, 0 at the top
 * @param x the first column
 * @param end the column before which the last one is
 * @param step how far the columns are apart, 1 or more
 * @param size the side of the block; 1 for a pixel alone
 * @param preview whether these pixels get better colours later
 */
public record PixelRun(int y, int x, int end, int step, int size, boolean preview) {
    /** {@return how many pixels there are} */
    public int count() {
        return (end - x + step - 1) / step;
    }
}
