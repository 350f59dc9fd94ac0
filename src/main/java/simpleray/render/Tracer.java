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
    private final boolean transparent;
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

    /**
     * Creates a tracer.
     *
     * @param integrator computes the colours of rays
     * @param camera shoots them
     * @param settings has their depth
     * @param transparent whether the picture is transparent where they hit nothing
     */
    Tracer(Integrator integrator, Camera camera, RenderSettings settings, boolean transparent) {
        this.integrator = integrator;
        this.camera = camera;
        this.settings = settings;
        this.transparent = transparent;
    }

    /**
     * Traces the ray through a point of the picture.
     *
     * @param px pixels from the left edge
     * @param py pixels from the top edge
     * @param colour gets the colour, linear and not clamped
     * @return whether it counts for the colour of its pixel: not where the picture is transparent; the colour is black there
     */
    boolean trace(double px, double py, Colour colour) {
        camera.through(px, py, ray);
        return integrator.trace(ray, colour, settings.depth()) || !transparent;
    }
}
