package simpleray.render;

/**
 * How a scene is rendered. <em>Constant.</em>
 *
 * @param stage which picture is made
 * @param depth the most reflections of a primary ray, 0 to {@link #MOST_DEPTH}
 * @param threads how many threads work, 1 or more; the picture does not depend on it
 */
public record RenderSettings(Stage stage, int depth, int threads) {
    /** The depth unless set. */
    public static final int DEFAULT_DEPTH = 10;
    /** The greatest depth; each reflection takes a piece of a thread's stack. */
    public static final int MOST_DEPTH = 1000;

    /**
     * Checks the ranges.
     *
     * @param stage which picture is made
     * @param depth the most reflections of a primary ray, 0 to {@link #MOST_DEPTH}
     * @param threads how many threads work, 1 or more
     */
    public RenderSettings {
        if (depth < 0 || depth > MOST_DEPTH) {
            throw new IllegalArgumentException("the depth must be 0 to " + MOST_DEPTH + ", and is " + depth);
        }
        if (threads < 1) {
            throw new IllegalArgumentException("the number of threads must be 1 or more, and is " + threads);
        }
    }

    /** Creates the defaults: the final stage, depth 10, a thread for each processor. */
    public RenderSettings() {
        this(Stage.FINAL, DEFAULT_DEPTH, Runtime.getRuntime().availableProcessors());
    }

    /**
     * Changes the stage.
     *
     * @param other another stage
     * @return these settings with that stage
     */
    public RenderSettings with(Stage other) {
        return new RenderSettings(other, depth, threads);
    }
}
