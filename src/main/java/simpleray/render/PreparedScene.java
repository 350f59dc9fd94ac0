package simpleray.render;

import java.util.function.Supplier;
import simpleray.math.Point;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.trace.CompiledScene;

/**
 * A scene that is rendered again and again, by requests that may differ in the camera and in all else: what takes long to make ready is
 * made once. <em>Mutable</em>; one rendering at a time.
 */
public final class PreparedScene {
    private final Scene scene;
    private final SceneSettings own;
    private CompiledScene compiled;

    /**
     * Takes a scene as it was read; nothing is made ready yet.
     *
     * @param scene the scene; its settings are changed by each request
     */
    public PreparedScene(Scene scene) {
        this.scene = scene;
        own = scene.settings;
    }

    /**
     * Prepares a rendering. The one before must have ended: a scene does not change while it renders.
     *
     * @param request what is asked for beside the scene's own settings
     * @return the renderer
     * @throws IllegalArgumentException if something asked for is out of its range
     */
    public Renderer renderer(RenderRequest request) {
        scene.settings = own;
        return request.renderer(scene, this);
    }

    /** {@return the scene made ready for an eye} What is to be made once is made now, if it was not. */
    synchronized CompiledScene compiled(Point eye, Supplier<CompiledScene> maker) {
        if (compiled == null) {
            compiled = maker.get();
        }
        return compiled.seenFrom(eye);
    }
}
