package simpleray.render;

import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;

/**
 * What was asked for on the command line or in the window; all else is left to the scene file, and then to the defaults.
 * <em>Constant.</em>
 *
 * @param settings what wins over the scene file; not to be changed
 * @param stage which picture is made
 * @param adaptive whether a pixel gets as many samples as it needs, whatever number the scene file says
 * @param accel how the nearest object is found
 * @param threads how many threads work, 1 or more
 * @param region the only piece of the picture that is made; null for all of it
 * @param band the only band of that piece that is made; null for all of it
 */
public record RenderRequest(SceneSettings settings, Stage stage, boolean adaptive, Accel accel, int threads, Region region, Band band) {
    /** Leaves all to the scene: its final picture, rendered by a thread for each processor. */
    public RenderRequest() {
        this(new SceneSettings(), Stage.FINAL, false, Runtime.getRuntime().availableProcessors());
    }

    /**
     * Leaves it to the program how the nearest object is found.
     *
     * @param settings what wins over the scene file; not to be changed
     * @param stage which picture is made
     * @param adaptive whether a pixel gets as many samples as it needs
     * @param threads how many threads work, 1 or more
     */
    public RenderRequest(SceneSettings settings, Stage stage, boolean adaptive, int threads) {
        this(settings, stage, adaptive, Accel.AUTO, threads, null, null);
    }

    /**
     * Changes how the nearest object is found.
     *
     * @param other another way
     * @return this request with that way
     */
    public RenderRequest with(Accel other) {
        return new RenderRequest(settings, stage, adaptive, other, threads, region, band);
    }

    /**
     * Changes the stage.
     *
     * @param other another stage
     * @return this request with that stage
     */
    public RenderRequest with(Stage other) {
        return new RenderRequest(settings, other, adaptive, accel, threads, region, band);
    }

    /**
     * Changes the region.
     *
     * @param other the only piece of the picture that is made; null for all of it
     * @return this request with that region
     */
    public RenderRequest with(Region other) {
        return new RenderRequest(settings, stage, adaptive, accel, threads, other, band);
    }

    /**
     * Changes the band.
     *
     * @param other the only band of the region, or of the picture, that is made; null for all of it
     * @return this request with that band
     */
    public RenderRequest with(Band other) {
        return new RenderRequest(settings, stage, adaptive, accel, threads, region, other);
    }

    /**
     * Changes what wins over the scene file.
     *
     * @param other other settings, not to be changed
     * @return this request with those settings
     */
    public RenderRequest with(SceneSettings other) {
        return new RenderRequest(other, stage, adaptive, accel, threads, region, band);
    }

    /**
     * Applies what was asked for to a scene, or to the first frame of a film.
     *
     * @param scene the scene, which stays as it is
     * @return the scene with what was asked for over its own settings
     */
    public Scene applyTo(Scene scene) {
        Scene still = scene.settings.frames == null ? scene : scene.still(0);
        return still.with(still.settings.under(settings));
    }

    /**
     * Checks the ranges of what was asked for, as far as they do not depend on the scene.
     *
     * @throws IllegalArgumentException if something is out of its range
     */
    public void check() {
        if (settings.up == null || settings.isFree()) {       // else the scene has what up belongs to
            settings.newCamera();
        }
        renderSettings(settings, region);
    }

    /**
     * Finds the rectangle that is cut into bands: the region, or all of the picture.
     *
     * @param all the settings that hold, of the scene and of this request
     * @return the rectangle
     * @throws IllegalArgumentException if the region is not inside the picture
     */
    public Region whole(SceneSettings all) {
        SceneSettings.Resolution size = Setting.RESOLUTION.in(all);
        if (region == null) {
            return Region.whole(size.width(), size.height());
        }
        region.requireWithin(size.width(), size.height());
        return region;
    }

    /**
     * Prepares the rendering of a scene, with what was asked for over the scene's own settings.
     *
     * @param scene the scene
     * @return the renderer
     * @throws IllegalArgumentException if something asked for is out of its range
     */
    public Renderer renderer(Scene scene) {
        return renderer(scene, null);
    }

    /** Prepares the rendering of a scene of which something is ready, or null. */
    Renderer renderer(Scene scene, PreparedScene prepared) {
        Scene asked = applyTo(scene);
        Region piece = band == null ? region : band.of(whole(asked.settings));
        return new Renderer(asked, asked.settings.newCamera(), renderSettings(asked.settings, piece), prepared);
    }

    private RenderSettings renderSettings(SceneSettings all, Region piece) {
        int samples = adaptive ? RenderSettings.ADAPTIVE : Setting.SAMPLES.in(all);
        return new RenderSettings(stage, Setting.DEPTH.in(all), samples, accel, threads, piece);
    }
}
