package simpleray.render;

import simpleray.math.Colour;
import simpleray.scene.Camera;
import simpleray.scene.Scene;

/** Finds the colour at a point of the picture. Any thread may call. */
final class Tracer {
    private final Scene scene;
    private final Camera camera;
    private final RenderSettings settings;

    Tracer(Scene scene, Camera camera, RenderSettings settings) {
        this.scene = scene;
        this.camera = camera;
        this.settings = settings;
    }

    /**
     * Traces the ray through a point of the picture.
     *
     * @param px pixels from the left edge
     * @param py pixels from the top edge
     * @param colour gets the colour, linear and not clamped
     */
    void trace(double px, double py, Colour colour) {
        scene.intersect(camera.through(px, py), colour, settings.depth(), settings.stage().terms());
    }
}
