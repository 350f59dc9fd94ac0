package simpleray.render;

import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Light;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.scene.Optics;
import simpleray.scene.Probe;
import simpleray.scene.RayTracer;
import simpleray.scene.Scene;
import simpleray.scene.Surface;
import simpleray.scene.Terms;

/**
 * Finds the colours of those stages that show something else than light (docs/pictures.md). Where nothing is hit they are black.
 * <em>Mutable</em>: one thread's own.
 */
final class ViewTracer implements RayTracer {
    /** How far the colours of two objects that follow each other are apart (Roberts, as in {@link Renderer}; for three dimensions). */
    private static final double RED = 0.8191725133961645;
    private static final double GREEN = 0.6710436067037893;
    private static final double BLUE = 0.5497004779019703;
    /** The darkest component of an object's colour, so that none is taken for the background. */
    private static final double DARKEST = 0.2;

    private final Stage stage;
    private final Scene scene;
    private final Probe probe;

    /**
     * Creates a tracer.
     *
     * @param stage a view
     * @param scene the scene
     * @param probe what finds hits in this scene
     */
    ViewTracer(Stage stage, Scene scene, Probe probe) {
        this.stage = stage;
        this.scene = scene;
        this.probe = probe;
    }

    @Override
    public boolean intersect(Ray ray, Colour colour, int depth, Terms terms) {
        colour.reset();
        int place = probe.nearest(ray, 0, false);
        if (place == Probe.NONE) {
            return false;
        }
        double distance = probe.distance();
        switch (stage) {
            case NORMALS -> {
                Vector normal = surface(place, ray, distance).towards(ray.direction);
                set(colour, (normal.x + 1) / 2, (normal.y + 1) / 2, (normal.z + 1) / 2);
            }
            case DEPTH -> {
                double near = 1 / (1 + distance);
                set(colour, near, near, near);
            }
            case OBJECTS -> set(colour, component(place, RED), component(place, GREEN), component(place, BLUE));
            case BOUNCES -> {
                double share = depth == 0 ? 0 : (double) deepest(place, distance, ray, depth, depth, 0) / depth;
                set(colour, share, share, share);
            }
            case SHADOWS -> {
                Point point = ray.getPointAt(distance);
                Vector normal = surface(place, ray, distance).towards(ray.direction);
                Optics.lift(point, normal, distance);
                addLights(colour, point, normal);
            }
            default -> throw new IllegalStateException(stage + " is no view");
        }
        return true;
    }

    private static void set(Colour colour, double r, double g, double b) {
        colour.r = r;
        colour.g = g;
        colour.b = b;
    }

    private static double component(int place, double step) {
        return DARKEST + (1 - DARKEST) * ((place + 1) * step % 1);
    }

    private Surface surface(int place, Ray ray, double distance) {
        return scene.getObject(place).surface(ray, distance, ray.getPointAt(distance));
    }

    /** {@return how many reflections and refractions led to the last ray of the longest way from a hit} No way is longer than the most. */
    private int deepest(int place, double distance, Ray ray, int depth, int most, int level) {
        Object object = scene.getObject(place);
        Material material = object.surfaceMaterial;
        int bounces = Math.min(depth, material.reflections());
        if (bounces <= 0) {
            return level;
        }
        Point point = ray.getPointAt(distance);
        Surface surface = object.surface(ray, distance, point);
        Vector normal = surface.towards(ray.direction);
        double height = Optics.lift(point, normal, distance);
        Vector bent = new Vector();
        boolean clear = !material.transmission.isBlack();
        boolean passes = clear
            && Optics.refract(bent, ray.direction, normal, surface.isEnteredBy(ray.direction) ? 1 / material.index : material.index);
        int deepest = level;
        if (!material.specular.isBlack() || clear && !passes) {
            Vector mirror = new Vector();
            Optics.mirror(mirror, ray.direction, normal);
            deepest = follow(new Ray(point, mirror), bounces - 1, most, level + 1, false);
        }
        if (passes && deepest < most) {
            deepest = Math.max(deepest, follow(new Ray(Optics.below(point, normal, height), bent), bounces - 1, most, level + 1, true));
        }
        return deepest;
    }

    private int follow(Ray ray, int depth, int most, int level, boolean refracted) {
        int place = probe.nearest(ray, level, refracted);
        return place == Probe.NONE ? level : deepest(place, probe.distance(), ray, depth, most, level);
    }

    /** Adds an equal share for each light that the surface faces, as much of it as what is between lets through. */
    private void addLights(Colour colour, Point point, Vector normal) {
        Vector towards = new Vector();
        Colour left = new Colour();
        for (int i = 0; i < scene.getNumberLights(); i++) {
            Light light = scene.getLight(i);
            double distance = light.towards(point, towards);
            if (normal.dot(towards) > 0) {
                set(left, 1, 1, 1);
                probe.dim(left, new Ray(point, towards), distance, i);
                colour.add(left);
            }
        }
        if (scene.getNumberLights() > 0) {
            colour.scale(1.0 / scene.getNumberLights());
        }
    }
}
