package simpleray.ui;

import java.util.function.Consumer;
import simpleray.math.Ray;
import simpleray.scene.StandIn;

/** An object that no ray hits, and that is told of every ray. */
final class Watcher extends StandIn {
    private final Consumer<Ray> task;

    Watcher(Consumer<Ray> task) {
        this.task = task;
    }

    @Override
    public double intersect(Ray ray) {
        task.accept(ray);
        return MISS;
    }
}
