package simpleray.render;

/** Receives the progress of a rendering. */
@FunctionalInterface
public interface RenderListener {
    /** Does nothing. */
    RenderListener NONE = y -> { };

    /**
     * Called when a row is finished and set in the picture, by the thread that finished it. Rows come in any order, and several threads may
     * call at once. Should return quickly.
     *
     * @param y the row, 0 at the top
     */
    void rowFinished(int y);
}
