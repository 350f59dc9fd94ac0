package simpleray.render;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.ToDoubleFunction;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.scene.Scene;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** An object that does what a test wants when a ray asks for a hit, and knows which threads asked. */
final class Obstacle extends Object {
    /** The threads that asked. */
    final Set<Thread> threads = ConcurrentHashMap.newKeySet();
    private final ToDoubleFunction<Ray> hit;

    Obstacle(ToDoubleFunction<Ray> hit) {
        super(new Material());
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

    @Override
    public Vector normal(Point pt) {
        return new Vector(0, 0, 1);
    }

    @Override
    public Bounds bounds() {
        return null;
    }

    @Override
    public void print(SceneWriter os) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void read(SceneReader is) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void write(SceneWriter os) {
        throw new UnsupportedOperationException();
    }
}
