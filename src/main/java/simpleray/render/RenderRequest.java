package simpleray.render;

import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;

/**
 * What was asked for on the command line or in the window; all else is left to the scene file, and then to the defaults.
 * <em>Constant.</em>
 *
 * @param settings what wins over the scene file; not to be changed
 * @param stage which picture is made
 * @param adaptive whether a pixel gets as many samples as it needs, whatever number the scene file says
 * @param threads how many threads work, 1 or more
 */
public record RenderRequest(SceneSettings settings, Stage stage, boolean adaptive, int threads) {
    /**
     * Changes the stage.
     *
     * @param other another stage
     * @return this request with that stage
     */
    public RenderRequest with(Stage other) {
        return new RenderRequest(settings, other, adaptive, threads);
    }

    /**
     * Prepares the rendering of a scene. The scene's own settings are put under what was asked for.
     *
     * @param scene the scene
     * @return the renderer
     * @throws IllegalArgumentException if something asked for is out of its range
     */
    public Renderer renderer(Scene scene) {
        scene.settings = scene.settings.under(settings);
        SceneSettings all = scene.settings;
        int depth = all.depth == null ? RenderSettings.DEFAULT_DEPTH : all.depth;
        int samples = adaptive ? RenderSettings.ADAPTIVE : all.samples == null ? 1 : all.samples;
        return new Renderer(scene, all.newCamera(), new RenderSettings(stage, depth, samples, threads));
    }
}
