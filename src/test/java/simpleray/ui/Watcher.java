package simpleray.ui;

import java.util.function.Consumer;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** An object that no ray hits, and that is told of every ray. */
final class Watcher extends Object {
    private final Consumer<Ray> task;

    Watcher(Consumer<Ray> task) {
        super(new Material());
        this.task = task;
    }

    @Override
    public double intersect(Ray ray) {
        task.accept(ray);
        return MISS;
    }

    @Override
    public Vector normal(Point pt) {
        throw new IllegalStateException("nothing hits this");
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
