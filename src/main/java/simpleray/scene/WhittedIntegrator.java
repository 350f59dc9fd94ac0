package simpleray.scene;

import java.util.Arrays;
import simpleray.math.Colour;
import simpleray.math.Powers;
import simpleray.math.Ray;
import simpleray.math.Vector;

/**
 * Finds the colours of rays: the local colour of what they hit, and what mirror rays and refracted rays see there in turn (thesis, chapter 4;
 * Whitted, "An improved illumination model for shaded display", 1980). This is the only place that shades. <em>Mutable</em>: one thread's own.
 */
public final class WhittedIntegrator implements Integrator {
    private final Scene scene;
    private final Intersector intersector;
    private final Terms terms;
    private final Recorder recorder;                          // null if nobody listens
    private final RayStats stats;
    private final VisibilityTester visibility;
    private final Light[] lights;
    private final Hit hit = new Hit();
    private final Colour arriving = new Colour();
    private final Colour ambient = new Colour();
    private final Colour diffuse = new Colour();
    private final Colour specular = new Colour();
    private final Colour scattered = new Colour();
    private final Colour highlight = new Colour();
    private final Vector halfway = new Vector();
    private Bounce[] bounces = {};                            // no objects are made for a ray

    /** What is known at one depth of the recursion. */
    private static final class Bounce {
        final Interaction at = new Interaction();
        final Ray next = new Ray(at.point, new Vector());
        final Vector bent = new Vector();
        final Colour share = new Colour();
        final Colour seen = new Colour();
    }

    /**
     * Creates an integrator.
     *
     * @param scene the scene, which must not change while rays are traced
     * @param intersector finds hits in this scene
     * @param terms which parts of the colour are wanted
     * @param stats gets the counts of rays
     * @param recorder hears what is found; null if nobody does
     */
    public WhittedIntegrator(Scene scene, Intersector intersector, Terms terms, RayStats stats, Recorder recorder) {
        scene.requireComplete();
        this.scene = scene;
        this.intersector = intersector;
        this.terms = terms;
        this.stats = stats;
        this.recorder = recorder;
        visibility = new VisibilityTester(intersector, terms.shadows(), stats);
        lights = new Light[scene.getNumberLights()];
        for (int i = 0; i < lights.length; i++) {
            lights[i] = scene.getLight(i);
        }
    }

    @Override
    public boolean trace(Ray ray, Colour colour, int depth) {
        stats.primary++;
        return trace(ray, colour, depth, 0);
    }

    private boolean trace(Ray ray, Colour colour, int depth, int level) {
        stats.ray(level);
        if (recorder != null) {
            recorder.begin(ray, depth, level);
        }
        colour.reset();
        boolean hits = intersector.intersect(ray, hit);
        if (hits) {
            Bounce bounce = bounce(level);
            bounce.at.set(ray, hit, scene.getObject(hit.place));
            if (recorder != null) {
                recorder.hit(ray, bounce.at);
            }
            addLocal(colour, ray, bounce.at);
            int most = Math.min(depth, bounce.at.object.surfaceMaterial.reflections());
            if (terms.reflections() && most > 0) {
                addBounces(colour, ray, bounce, most - 1, level);
            }
        } else if (terms.ambient() && scene.settings.background != null) {
            colour.copy(scene.settings.background);
        }
        if (recorder != null) {
            recorder.end(colour);
        }
        return hits;
    }

    private Bounce bounce(int level) {
        if (level == bounces.length) {
            bounces = Arrays.copyOf(bounces, level + 1);
            bounces[level] = new Bounce();
        }
        return bounces[level];
    }

    /**
     * Adds the local colour, Ka·GA + Σ LC (Kd (N·L) + Ks (N·H)^shininess) over the lights that reach the surface (thesis, chapter 4). The
     * three terms are summed apart, so that pictures of each add up to the picture of all to the last bit.
     */
    private void addLocal(Colour colour, Ray ray, Interaction at) {
        Material material = at.object.surfaceMaterial;
        boolean shiny = terms.specular() && !material.specular.isBlack();
        diffuse.reset();
        specular.reset();
        for (int i = 0; i < lights.length && (terms.lights() || recorder != null); i++) {
            arriving.copy(lights[i].intensity);
            boolean lit = visibility.reaches(lights[i], i, at, arriving);
            double cosine = 0;
            scattered.reset();
            highlight.reset();
            if (lit && terms.diffuse()) {
                Colour.mult(scattered, material.diffuse, arriving);
                scattered.scale(visibility.facing);
                diffuse.add(scattered);
            }
            if (lit && shiny || recorder != null) {
                Vector.subtract(halfway, visibility.towards, ray.direction);
                halfway.normalise();
                cosine = at.normal.dot(halfway);
            }
            if (lit && shiny) {
                Colour.mult(highlight, material.specular, arriving);
                highlight.scale(Powers.power(Math.min(1, Math.max(0, cosine)), material.shininess));
                specular.add(highlight);
            }
            if (recorder != null) {
                recorder.light(i, visibility, arriving, halfway, cosine, scattered, highlight);
            }
        }
        ambient.reset();
        if (terms.ambient()) {
            Colour.mult(ambient, material.ambient, scene.ambient);
        }
        colour.add(ambient);
        colour.add(diffuse);
        colour.add(specular);
        if (recorder != null) {
            recorder.lit(ambient, diffuse, specular);
        }
    }

    /** Adds what is seen in the mirror's direction, times Ks, and through the surface, times Kt. */
    private void addBounces(Colour colour, Ray ray, Bounce bounce, int depth, int level) {
        Interaction at = bounce.at;
        Material material = at.object.surfaceMaterial;
        boolean passes = !material.transmission.isBlack()
            && Optics.refract(bounce.bent, ray.direction, at.normal, at.enters ? 1 / material.index : material.index);
        bounce.share.copy(material.specular);
        if (!passes) {                                        // total internal reflection: what cannot pass is mirrored
            bounce.share.add(material.transmission);
        }
        if (!bounce.share.isBlack()) {
            stats.reflected++;
            Optics.mirror(bounce.next.direction, ray.direction, at.normal);
            addSeen(colour, bounce, false, depth, level);
        }
        if (passes) {
            stats.refracted++;
            bounce.share.copy(material.transmission);
            bounce.next.direction.copy(bounce.bent);
            at.sink();
            addSeen(colour, bounce, true, depth, level);
        }
    }

    private void addSeen(Colour colour, Bounce bounce, boolean refracted, int depth, int level) {
        trace(bounce.next, bounce.seen, depth, level + 1);
        bounce.seen.mult(bounce.share);
        colour.add(bounce.seen);
        if (recorder != null) {
            recorder.followed(bounce.share, bounce.seen, refracted);
        }
    }
}
