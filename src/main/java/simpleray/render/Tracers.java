package simpleray.render;

import java.util.ArrayList;
import java.util.List;
import simpleray.scene.Camera;
import simpleray.scene.Intersector;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.trace.CompiledScene;

/** Creates the tracer of each thread of a rendering, and adds up their statistics. Any thread may call. */
final class Tracers {
    private final Scene scene;
    private final Camera camera;
    private final RenderSettings settings;
    private final CompiledScene compiled;                     // null if all objects are tested in turn
    private final List<RayStats> counts = new ArrayList<>();
    private final Object listing = new Object();
    private CompiledScene listed;

    /** If the compiled scene is null, all objects are tested in turn. */
    Tracers(Scene scene, Camera camera, RenderSettings settings, CompiledScene compiled) {
        this.scene = scene;
        this.camera = camera;
        this.settings = settings;
        this.compiled = compiled;
    }

    /**
     * Creates a tracer for one thread.
     *
     * @param many whether many rays follow, for which a light buffer of the eye pays; the first thread that asks builds it
     */
    Tracer tracer(boolean many) {
        RayStats stats = new RayStats();
        synchronized (counts) {
            counts.add(stats);
        }
        return tracer(many && compiled != null ? listed() : compiled, stats);
    }

    /** {@return the sum of all threads' statistics, once they have ended; null if all objects were tested in turn} */
    RayStats stats() {
        if (compiled == null) {
            return null;
        }
        RayStats sum = new RayStats();
        synchronized (counts) {
            for (RayStats stats : counts) {
                sum.add(stats);
            }
        }
        return sum;
    }

    private Tracer tracer(CompiledScene ready, RayStats stats) {
        Intersector intersector = Tracer.intersector(scene, ready, stats);
        return new Tracer(Tracer.integrator(scene, intersector, settings.stage(), stats), camera, settings, scene.settings.isTransparent());
    }

    private CompiledScene listed() {
        synchronized (listing) {
            if (listed == null) {
                listed = compiled.listed();
            }
            return listed;
        }
    }
}
