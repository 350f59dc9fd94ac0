package simpleray.render;

/** Is told how far a rendering in passes has come. Called by several threads at once; should be quick. */
public interface PassListener extends RenderListener {
    /**
     * Some pixels are there.
     *
     * @param run which
     * @param rgb red, green and blue of each, linear and not clamped; the listener's own
     */
    void runFinished(PixelRun run, double[] rgb);

    /** The first pass is over: all of what is rendered is there in coarse blocks. */
    void coarseFinished();

    /**
     * A pixel of a row could not be rendered: the row will never be finished. Called once for each such row.
     *
     * @param y the row, 0 at the top
     * @param fault what was thrown
     */
    void rowFailed(int y, Throwable fault);
}
