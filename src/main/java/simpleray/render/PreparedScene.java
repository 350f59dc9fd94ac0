package simpleray.render;

import java.util.function.Supplier;
import simpleray.math.Point;
import simpleray.scene.Camera;
import simpleray.scene.Scene;
import simpleray.trace.CompiledScene;

/**
 * A scene that is rendered again and again, with any camera and settings, or as frames of a film. What stays of it is compiled only once.
 * <em>Mutable</em>; one rendering at a time.
 */
public final class PreparedScene {
    private final Scene scene;
    private CompiledScene compiled;

    /**
     * Takes a scene as it was read. It is compiled when it is first rendered.
     *
     * @param scene the scene
     */
    public PreparedScene(Scene scene) {
        this.scene = scene;
    }

    /**
     * Prepares a rendering. The previous one must have ended, since a scene does not change while it renders.
     *
     * @param request the options, which override the scene's own settings
     * @return the renderer
     * @throws IllegalArgumentException if an option is out of its range
     */
    public Renderer renderer(RenderRequest request) {
        return request.renderer(scene, this);
    }

    /**
     * Prepares a rendering as the other method does, of exactly this scene.
     *
     * @param camera the camera
     * @param settings all other settings
     * @return the renderer
     */
    public Renderer renderer(Camera camera, RenderSettings settings) {
        return new Renderer(scene, camera, settings, this);
    }

    /**
     * Prepares the rendering of another scene in place of this one. If its objects are the same ones, what is compiled of them is kept. The previous
     * rendering must have ended.
     *
     * @param request the options, which override that scene's own settings
     * @param frame the scene
     * @return the renderer
     * @throws IllegalArgumentException if an option is out of its range
     */
    public Renderer renderer(RenderRequest request, Scene frame) {
        return request.renderer(frame, this);
    }

    /**
     * {@return a scene compiled for an eye} What the scene before has not left ready is compiled.
     *
     * @param asked the scene
     * @param eye the eye; null if the primary rays are parallel
     * @param maker compiles it
     */
    public synchronized CompiledScene compiled(Scene asked, Point eye, Supplier<CompiledScene> maker) {
        compiled = compiled == null ? null : compiled.with(asked);
        if (compiled == null) {
            compiled = maker.get();
        }
        return compiled.seenFrom(eye);
    }
}
