package simpleray.render;

/** Receives the progress of a rendering in passes. Called by several threads at once; should return quickly. */
public interface PassListener extends RenderListener {
    /**
     * Called when some pixels are rendered.
     *
     * @param run the pixels
     * @param light red, green and blue of each, linear and not clamped, and its alpha if the picture has any; the listener may keep and change
     *     it
     */
    void runFinished(PixelRun run, double[] light);

    /** Called when the first pass is finished, and the whole is there in coarse blocks. */
    void coarseFinished();

    /**
     * Called once for a row that will never be finished, because one of its pixels could not be rendered.
     *
     * @param y the row, 0 at the top
     * @param fault the exception
     */
    void rowFailed(int y, Throwable fault);
}
