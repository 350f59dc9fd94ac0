package simpleray.render;

import java.util.ArrayList;
import java.util.List;
import simpleray.scene.Camera;
import simpleray.scene.Intersector;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.trace.CompiledScene;

/** Makes a tracer for each thread of a rendering, and adds up what they did. Any thread may call. */
final class Tracers {
    private final Scene scene;
    private final Camera camera;
    private final RenderSettings settings;
    private final CompiledScene compiled;                     // null if all objects are asked in turn
    private final List<RayStats> counts = new ArrayList<>();
    private final Object listing = new Object();
    private CompiledScene listed;

    /** Creates one. The compiled scene is null to ask all objects in turn. */
    Tracers(Scene scene, Camera camera, RenderSettings settings, CompiledScene compiled) {
        this.scene = scene;
        this.camera = camera;
        this.settings = settings;
        this.compiled = compiled;
    }

    /**
     * Makes a tracer for one thread.
     *
     * @param many whether to have all that makes many rays faster; the first thread that asks makes it
     */
    Tracer tracer(boolean many) {
        RayStats stats = new RayStats();
        synchronized (counts) {
            counts.add(stats);
        }
        return tracer(many && compiled != null ? listed() : compiled, stats);
    }

    /** {@return what all threads did together, to be asked when they have ended; null if all objects were asked in turn} */
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
        return new Tracer(Tracer.integrator(scene, intersector, settings.stage(), stats), camera, settings);
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
