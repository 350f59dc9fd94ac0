package simpleray.render;

import simpleray.scene.SceneSettings;

/**
 * How a scene is rendered. <em>Constant.</em>
 *
 * @param stage which picture is made
 * @param depth the most reflections of a primary ray, 0 to {@link SceneSettings#MAX_DEPTH}
 * @param samples samples along each side of a pixel, 1 to {@link SceneSettings#MAX_SAMPLES}; {@link #ADAPTIVE} where they are needed
 * @param accel how the nearest object is found; the picture does not depend on it
 * @param threads how many threads work, 1 or more; the picture does not depend on it
 * @param region the only piece of the camera's picture that is made; null for all of it
 */
public record RenderSettings(Stage stage, int depth, int samples, Accel accel, int threads, Region region) {
    /** The depth unless set. */
    public static final int DEFAULT_DEPTH = SceneSettings.DEFAULT_DEPTH;
    /** In place of a number of samples: many where a pixel shows an edge, one elsewhere. */
    public static final int ADAPTIVE = 0;

    /**
     * Checks the ranges.
     *
     * @param stage which picture is made
     * @param depth the most reflections of a primary ray, 0 to {@link SceneSettings#MAX_DEPTH}
     * @param samples samples along each side of a pixel, 1 to {@link SceneSettings#MAX_SAMPLES}; or {@link #ADAPTIVE}
     * @param accel how the nearest object is found
     * @param threads how many threads work, 1 or more
     * @param region the only piece that is made; null for all
     */
    public RenderSettings {
        if (depth < 0 || depth > SceneSettings.MAX_DEPTH) {
            throw new IllegalArgumentException("the depth must be 0 to " + SceneSettings.MAX_DEPTH + ", and is " + depth);
        }
        if (samples < ADAPTIVE || samples > SceneSettings.MAX_SAMPLES) {
            throw new IllegalArgumentException("the samples must be 1 to " + SceneSettings.MAX_SAMPLES + ", and are " + samples);
        }
        if (threads < 1) {
            throw new IllegalArgumentException("the number of threads must be 1 or more, and is " + threads);
        }
    }

    /**
     * Leaves it to the program how the nearest object is found.
     *
     * @param stage which picture is made
     * @param depth the most reflections of a primary ray, 0 to {@link SceneSettings#MAX_DEPTH}
     * @param samples samples along each side of a pixel, 1 to {@link SceneSettings#MAX_SAMPLES}; or {@link #ADAPTIVE}
     * @param threads how many threads work, 1 or more
     */
    public RenderSettings(Stage stage, int depth, int samples, int threads) {
        this(stage, depth, samples, Accel.AUTO, threads, null);
    }

    /** Creates the defaults: the final stage, depth 10, one sample, a thread for each processor. */
    public RenderSettings() {
        this(Stage.FINAL, DEFAULT_DEPTH, 1, Runtime.getRuntime().availableProcessors());
    }

    /**
     * Changes the stage.
     *
     * @param other another stage
     * @return these settings with that stage
     */
    public RenderSettings with(Stage other) {
        return new RenderSettings(other, depth, samples, accel, threads, region);
    }
}
