package simpleray.render;

import simpleray.accel.Engine;
import simpleray.math.Colour;
import simpleray.math.Ray;
import simpleray.scene.Camera;
import simpleray.scene.Probe;
import simpleray.scene.RayTracer;
import simpleray.scene.Scene;

/** Finds the colour at a point of the picture. <em>Mutable</em>: one thread's own. */
final class Tracer {
    private final RayTracer rays;
    private final Camera camera;
    private final RenderSettings settings;
    private final Ray ray = new Ray();

    /**
     * Makes what finds the colours of a stage, for one thread.
     *
     * @param engine the scene made ready; null to ask the scene itself
     * @param counted whether its work counts
     */
    static RayTracer rays(Scene scene, Engine engine, Stage stage, boolean counted) {
        if (stage.isView()) {
            return new ViewTracer(stage, scene, engine == null ? Probe.of(scene) : engine.probe(counted));
        }
        return engine == null ? scene : counted ? engine.worker() : engine.uncounted();
    }

    Tracer(RayTracer rays, Camera camera, RenderSettings settings) {
        this.rays = rays;
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
        camera.through(px, py, ray);
        rays.intersect(ray, colour, settings.depth(), settings.stage().terms());
    }
}
