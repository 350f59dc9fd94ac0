package simpleray.render;

import simpleray.math.Colour;
import simpleray.math.Ray;
import simpleray.scene.BruteForceIntersector;
import simpleray.scene.Camera;
import simpleray.scene.Integrator;
import simpleray.scene.Intersector;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.WhittedIntegrator;
import simpleray.trace.CompiledScene;

/** Traces the ray through a point of the picture. <em>Mutable</em>: one thread's own. */
final class Tracer {
    private final Integrator integrator;
    private final Camera camera;
    private final RenderSettings settings;
    private final Ray ray = new Ray();

    /**
     * Creates the intersector of a scene, for one thread.
     *
     * @param compiled the compiled scene; null to test all objects in turn
     * @param stats gets the counts of tests and steps
     */
    static Intersector intersector(Scene scene, CompiledScene compiled, RayStats stats) {
        return compiled == null ? new BruteForceIntersector(scene) : compiled.intersector(stats);
    }

    /**
     * Creates the integrator of a stage, for one thread.
     *
     * @param intersector finds hits in this scene
     * @param stats gets the counts of rays
     */
    static Integrator integrator(Scene scene, Intersector intersector, Stage stage, RayStats stats) {
        return stage.isView() ? new ViewIntegrator(stage, scene, intersector, stats)
            : new WhittedIntegrator(scene, intersector, stage.terms(), stats, null);
    }

    Tracer(Integrator integrator, Camera camera, RenderSettings settings) {
        this.integrator = integrator;
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
        integrator.trace(ray, colour, settings.depth());
    }
}
