package simpleray.render;

import java.util.function.Supplier;
import simpleray.math.Point;
import simpleray.scene.Scene;
import simpleray.trace.CompiledScene;

/**
 * A scene that is rendered again and again, with any camera and settings. It is compiled only once. <em>Mutable</em>; one rendering at a time.
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

    /** {@return the scene compiled for an eye} The first call compiles it. */
    synchronized CompiledScene compiled(Point eye, Supplier<CompiledScene> maker) {
        if (compiled == null) {
            compiled = maker.get();
        }
        return compiled.seenFrom(eye);
    }
}
