package simpleray.scene;

import java.util.stream.IntStream;
import simpleray.math.Colour;
import simpleray.math.Ray;

/** Asks all objects of a scene in turn, as {@link Scene#intersect} does. */
final class PlainProbe implements Probe {
    private final Scene scene;
    private double distance;

    PlainProbe(Scene scene) {
        this.scene = scene;
    }

    @Override
    public int nearest(Ray ray, int level, boolean refracted) {
        int nearest = NONE;
        distance = Double.POSITIVE_INFINITY;
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            double t = scene.getObject(i).intersect(ray);
            if (t >= 0 && t < distance) {
                nearest = i;
                distance = t;
            }
        }
        return nearest;
    }

    @Override
    public double distance() {
        return distance;
    }

    @Override
    public void dim(Colour light, Ray towards, double far, int number) {
        for (int place : between(towards, far, number)) {
            light.mult(scene.getObject(place).surfaceMaterial.transmission);
        }
    }

    @Override
    public int[] between(Ray towards, double far, int number) {
        IntStream.Builder places = IntStream.builder();
        Colour left = new Colour(1, 1, 1);
        for (int i = 0; i < scene.getNumberObjects() && !left.isBlack(); i++) {
            double t = scene.getObject(i).intersect(towards);
            if (t >= 0 && t < far) {
                places.add(i);
                left.mult(scene.getObject(i).surfaceMaterial.transmission);
            }
        }
        return places.build().toArray();
    }
}
