package simpleray.render;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.ToDoubleFunction;
import simpleray.math.Ray;
import simpleray.scene.Scene;
import simpleray.scene.StandIn;

/** An object whose intersection a test supplies, and which records the threads that intersect it. */
final class Obstacle extends StandIn {
    /** These threads. */
    final Set<Thread> threads = ConcurrentHashMap.newKeySet();
    private final ToDoubleFunction<Ray> hit;

    Obstacle(ToDoubleFunction<Ray> hit) {
        this.hit = hit;
    }

    /** {@return a scene with this object alone} */
    Scene alone() {
        Scene scene = new Scene();
        scene.setNumberObjects(1);
        scene.setObject(0, this);
        return scene;
    }

    @Override
    public double intersect(Ray ray) {
        threads.add(Thread.currentThread());
        return hit.applyAsDouble(ray);
    }
}
