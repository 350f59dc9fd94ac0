package simpleray.render;

/** Is told how far a rendering has come. */
@FunctionalInterface
public interface RenderListener {
    /** Listens to nothing. */
    RenderListener NONE = y -> { };

    /**
     * A row is finished and set in the picture. Called by the thread that finished it, for rows in any order; should be quick, and
     * must be ready to be called by several threads at once.
     *
     * @param y the row, 0 at the top
     */
    void rowFinished(int y);
}
