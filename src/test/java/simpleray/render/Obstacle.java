package simpleray.render;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.ToDoubleFunction;
import simpleray.math.Ray;
import simpleray.scene.Scene;
import simpleray.scene.StandIn;

/** An object that does what a test wants when a ray asks for a hit, and knows which threads asked. */
final class Obstacle extends StandIn {
    /** The threads that asked. */
    final Set<Thread> threads = ConcurrentHashMap.newKeySet();
    private final ToDoubleFunction<Ray> hit;

    Obstacle(ToDoubleFunction<Ray> hit) {
        this.hit = hit;
    }

    /** {@return a scene with nothing but this in it} */
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
