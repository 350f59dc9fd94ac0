package simpleray.accel;

import java.util.Arrays;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.scene.Hit;
import simpleray.scene.Intersector;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.RayStats;

/** Finds hits in an {@link Engine}. <em>Mutable</em>: one thread's own. */
final class AcceleratedIntersector implements Intersector {
    private final Engine engine;
    private final Finder finder;

    AcceleratedIntersector(Engine engine, RayStats stats) {
        this.engine = engine;
        finder = new Finder(engine, stats);
    }

    @Override
    public boolean intersect(Ray ray, Hit hit) {
        hit.reset();
        Point eye = engine.eye;
        if (!finder.nearest(ray, ray.origin.x == eye.x && ray.origin.y == eye.y && ray.origin.z == eye.z)) {
            return false;
        }
        int place = engine.primitives.order[finder.hit];
        Object object = engine.primitives.objects[finder.hit];
        if (object instanceof Mesh) {                         // which of its triangles is hit matters, too
            object.intersect(ray, place, hit);
        } else {
            hit.set(finder.t, place);
        }
        return true;
    }

    @Override
    public boolean occluded(Ray ray, double distance, int light, Colour left) {
        if (finder.isBlocked(ray, distance, light)) {
            left.reset();
        } else if (finder.dimmers > 0) {
            dim(left);
        }
        return left.isBlack();
    }

    /** Dims a light by all that lets some through, in the order of the scene: products depend on it in the last bit. */
    private void dim(Colour left) {
        int[] places = new int[finder.dimmers];
        for (int i = 0; i < places.length; i++) {
            places[i] = engine.primitives.order[finder.dimming[i]];
        }
        Arrays.sort(places);
        for (int i = 0; i < places.length && !left.isBlack(); i++) {
            left.mult(engine.scene.getObject(places[i]).surfaceMaterial.transmission);
        }
    }
}
