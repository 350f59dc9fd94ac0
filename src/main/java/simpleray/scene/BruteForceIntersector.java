package simpleray.scene;

import java.util.stream.IntStream;
import simpleray.math.Colour;
import simpleray.math.Ray;

/** Tests all objects of a scene in turn (thesis, chapter 4). <em>Mutable</em>: one thread's own. The scene must not change meanwhile. */
public final class BruteForceIntersector implements Intersector {
    private final Scene scene;
    private final Hit scratch = new Hit();

    /**
     * Creates an intersector.
     *
     * @param scene the scene
     */
    public BruteForceIntersector(Scene scene) {
        this.scene = scene;
    }

    @Override
    public boolean intersect(Ray ray, Hit hit) {
        hit.reset();
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            scene.getObject(i).intersect(ray, i, hit);
        }
        return hit.place != Hit.NONE;
    }

    @Override
    public boolean occluded(Ray ray, double distance, int light, Colour left) {
        scratch.reset();
        for (int i = 0; i < scene.getNumberObjects() && !left.isBlack(); i++) {
            Object object = scene.getObject(i);
            if (object.occludes(ray, distance, scratch)) {
                left.mult(object.transmitted(ray, distance, scratch));
            }
        }
        return left.isBlack();
    }

    /**
     * Finds the objects between a point and a light.
     *
     * @param ray the ray from the point towards the light, of unit direction
     * @param distance the distance of the light, in lengths of the ray's direction; infinite for a directional one
     * @return the objects' indices, in the order of the scene, up to the one that blocks the rest of the light
     */
    public int[] between(Ray ray, double distance) {
        scratch.reset();
        IntStream.Builder places = IntStream.builder();
        Colour left = new Colour(1, 1, 1);
        for (int i = 0; i < scene.getNumberObjects() && !left.isBlack(); i++) {
            Object object = scene.getObject(i);
            if (object.occludes(ray, distance, scratch)) {
                places.add(i);
                left.mult(object.transmitted(ray, distance, scratch));
            }
        }
        return places.build().toArray();
    }
}
