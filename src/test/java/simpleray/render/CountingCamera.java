package simpleray.render;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.scene.Camera;

/** A camera that counts its primary rays, and keeps the points in the picture of the first few. */
final class CountingCamera implements Camera {
    private static final int MAX_PLACES = 1000;

    private final Camera camera;
    private final AtomicLong rays = new AtomicLong();
    private final List<String> places = new CopyOnWriteArrayList<>();

    CountingCamera(Camera camera) {
        this.camera = camera;
    }

    long rays() {
        return rays.get();
    }

    /** {@return the points of the first rays, in order, as "px py"} */
    List<String> places() {
        return places;
    }

    @Override
    public int width() {
        return camera.width();
    }

    @Override
    public Point eye() {
        return camera.eye();
    }

    @Override
    public int height() {
        return camera.height();
    }

    @Override
    public void through(double px, double py, Ray ray) {
        if (rays.incrementAndGet() <= MAX_PLACES) {
            places.add(px + " " + py);
        }
        camera.through(px, py, ray);
    }
}
