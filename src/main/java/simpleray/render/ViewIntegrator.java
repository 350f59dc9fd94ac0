package simpleray.render;

import simpleray.math.Colour;
import simpleray.math.Ray;
import simpleray.scene.AreaLight;
import simpleray.scene.Hit;
import simpleray.scene.Integrator;
import simpleray.scene.Interaction;
import simpleray.scene.Intersector;
import simpleray.scene.Light;
import simpleray.scene.PointLight;
import simpleray.scene.RayStats;
import simpleray.scene.Recorder;
import simpleray.scene.Scene;
import simpleray.scene.Terms;
import simpleray.scene.VisibilityTester;
import simpleray.scene.WhittedIntegrator;

/**
 * Computes the colours of the stages that show something other than light (docs/pictures.md). A ray that hits nothing is black.
 * <em>Mutable</em>: one thread's own.
 */
final class ViewIntegrator implements Integrator {
    /** The distance between the colours of successive objects (the golden ratio of {@link Renderer} in three dimensions, by Roberts). */
    private static final double RED = 0.8191725133961645;
    private static final double GREEN = 0.6710436067037893;
    private static final double BLUE = 0.5497004779019703;
    /** The lowest component of an object's colour, which tells it from the background. */
    private static final double DARKEST = 0.2;
    /** The terms of the final stage that cast rays. */
    private static final Terms RAYS = new Terms(false, false, false, false, true);

    private final Stage stage;
    private final Scene scene;
    private final Intersector intersector;
    private final RayStats stats;
    private final VisibilityTester visibility;
    private final Deepest deepest = new Deepest();
    private final WhittedIntegrator followed;
    private final Hit hit = new Hit();
    private final Interaction at = new Interaction();
    private final PointLight lamp = new PointLight();         // a point of an area light
    private final Colour left = new Colour();

    /** Notes the number of reflections and refractions on the longest path. */
    private static final class Deepest implements Recorder {
        private int level;

        @Override
        public void begin(Ray ray, int depth, int level) {
            this.level = Math.max(this.level, level);
        }
    }

    /**
     * Creates an integrator.
     *
     * @param stage a view
     * @param scene the scene
     * @param intersector finds hits in this scene
     * @param stats gets the counts of rays
     */
    ViewIntegrator(Stage stage, Scene scene, Intersector intersector, RayStats stats) {
        this.stage = stage;
        this.scene = scene;
        this.intersector = intersector;
        this.stats = stats;
        visibility = new VisibilityTester(intersector, true, stats);
        followed = new WhittedIntegrator(scene, intersector, RAYS, stats, deepest);
    }

    @Override
    public boolean trace(Ray ray, Colour colour, int depth) {
        if (stage == Stage.BOUNCES) {
            return traceBounces(ray, colour, depth);
        }
        colour.reset();
        stats.primary++;
        stats.ray(0);
        if (!intersector.intersect(ray, hit)) {
            return false;
        }
        switch (stage) {
            case NORMALS -> {
                at.set(ray, hit, scene.getObject(hit.place));
                set(colour, (at.normal.x + 1) / 2, (at.normal.y + 1) / 2, (at.normal.z + 1) / 2);
            }
            case DEPTH -> {
                double near = 1 / (1 + hit.t);
                set(colour, near, near, near);
            }
            case OBJECTS -> set(colour, component(hit.place, RED), component(hit.place, GREEN), component(hit.place, BLUE));
            case SHADOWS -> {
                at.set(ray, hit, scene.getObject(hit.place));
                addLights(colour);
            }
            default -> throw new IllegalStateException(stage + " is no view");
        }
        return true;
    }

    private boolean traceBounces(Ray ray, Colour colour, int depth) {
        deepest.level = 0;
        boolean hits = followed.trace(ray, colour, depth);
        double share = depth == 0 ? 0 : (double) deepest.level / depth;
        set(colour, share, share, share);
        return hits;
    }

    private static void set(Colour colour, double r, double g, double b) {
        colour.r = r;
        colour.g = g;
        colour.b = b;
    }

    private static double component(int place, double step) {
        return DARKEST + (1 - DARKEST) * ((place + 1) * step % 1);
    }

    /** Adds an equal share for each light that the surface faces, dimmed by the objects in between. */
    private void addLights(Colour colour) {
        int lights = scene.getNumberLights();
        for (int i = 0; i < lights; i++) {
            Light light = scene.getLight(i);
            if (light instanceof AreaLight area) {
                visibility.approach(area, at);
                for (int k = 0; k < area.points(); k++) {
                    area.point(k, lamp);
                    addLight(colour, lamp, i, 1.0 / area.points());
                }
                visibility.leave();
            } else {
                addLight(colour, light, i, 1);
            }
        }
        if (lights > 0) {
            colour.scale(1.0 / lights);
        }
    }

    private void addLight(Colour colour, Light light, int number, double share) {
        set(left, share, share, share);
        visibility.reaches(light, number, at, left);
        colour.add(left);
    }
}
