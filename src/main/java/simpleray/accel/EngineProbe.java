package simpleray.accel;

import java.util.Arrays;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.scene.Probe;

/** Asks a {@link Finder} what rays hit. Its answers are those of {@link Probe#of}. */
final class EngineProbe implements Probe {
    private static final int[] NOTHING = {};

    private final Engine engine;
    private final Finder finder;
    private final Probe plain;

    EngineProbe(Engine engine) {
        this.engine = engine;
        finder = new Finder(engine);
        plain = Probe.of(engine.scene);
    }

    /** {@return what was done so far} */
    Tally tally() {
        return finder.tally;
    }

    @Override
    public int nearest(Ray ray, int level, boolean refracted) {
        Point eye = engine.eye;
        finder.tally.ray(level);
        if (level == 0) {
            finder.tally.primary++;
        } else if (refracted) {
            finder.tally.refracted++;
        } else {
            finder.tally.reflected++;
        }
        boolean fromEye = level == 0 && ray.origin.x == eye.x && ray.origin.y == eye.y && ray.origin.z == eye.z;
        return finder.nearest(ray, fromEye) ? engine.primitives.order[finder.hit] : NONE;
    }

    @Override
    public double distance() {
        return finder.t;
    }

    @Override
    public void dim(Colour light, Ray towards, double distance, int number) {
        finder.tally.shadow++;
        if (finder.isBlocked(towards, distance, number)) {
            light.reset();
            return;
        }
        for (int place : dimming()) {
            light.mult(engine.scene.getObject(place).surfaceMaterial.transmission);
        }
    }

    @Override
    public int[] between(Ray towards, double distance, int number) {
        finder.tally.shadow++;
        boolean blocked = finder.isBlocked(towards, distance, number);
        // which objects are asked until nothing is left depends on all of them
        return blocked || finder.dimmers > 0 ? plain.between(towards, distance, number) : NOTHING;
    }

    /** {@return what was found to dim a light, in the order of the scene: products depend on it in the last bit} */
    private int[] dimming() {
        int[] places = new int[finder.dimmers];
        for (int i = 0; i < places.length; i++) {
            places[i] = engine.primitives.order[finder.dimming[i]];
        }
        Arrays.sort(places);
        return places;
    }
}
