package simpleray.scene;

import java.util.Arrays;
import simpleray.math.Colour;
import simpleray.math.Powers;
import simpleray.math.Ray;
import simpleray.math.Vector;

/**
 * Computes the colours of rays: the local colour of the surface they hit, and recursively those of mirror and refracted rays (thesis, chapter 4;
 * Whitted, "An improved illumination model for shaded display", 1980). This is the only place that shades. <em>Mutable</em>: one thread's own.
 */
public final class WhittedIntegrator implements Integrator {
    private static final Colour BLACK = new Colour();

    private final Scene scene;
    private final Intersector intersector;
    private final Terms terms;
    private final Recorder recorder;                          // null for none
    private final RayStats stats;
    private final VisibilityTester visibility;
    private final Light[] lights;
    private final Hit hit = new Hit();
    private final PointLight lamp = new PointLight();         // a point of an area light
    private final Colour diffuseBefore = new Colour();        // the sums of the lights before an area light
    private final Colour specularBefore = new Colour();
    private final Colour arriving = new Colour();
    private final Vector halfway = new Vector();
    private Bounce[] bounces = {};                            // reused, so that rays allocate nothing

    /** The working data of one depth of the recursion. */
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
     * @param terms the terms of the colour to compute
     * @param stats counts the rays
     * @param recorder is told of each step; null for none
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

    /**
     * Whitted's recursion: the local colour of a surface, plus the mirror ray's colour times its share (Ks, or the material's mirror), plus the
     * refracted ray's colour times Kt. At total internal reflection the mirror ray counts its share + Kt. One method, too long for
     * HotSpot to inline into itself, and so compiled early.
     */
    private boolean trace(Ray ray, Colour colour, int depth, int level) {
        stats.ray(level);
        if (recorder != null) {
            recorder.begin(ray, depth, level);
        }
        boolean hits = intersector.intersect(ray, hit);
        if (hits) {
            Bounce bounce = bounce(level);
            Interaction at = bounce.at;
            at.set(ray, hit, scene.getObject(hit.place));
            if (recorder != null) {
                recorder.hit(ray, at);
            }
            setLocal(colour, ray, at);
            Material material = at.material;
            int bounces = Math.min(depth, material.reflections());
            if (terms.reflections() && bounces > 0) {
                Colour share = bounce.share;
                Ray next = bounce.next;
                boolean passes = !material.transmission.isBlack()
                    && Optics.refract(bounce.bent, ray.direction, at.normal, at.enters ? 1 / material.index : material.index);
                share.copy(material.mirrored());
                if (!passes) {
                    share.add(material.transmission);
                }
                if (!share.isBlack()) {
                    stats.reflected++;
                    Optics.mirror(next.direction, ray.direction, at.normal);
                    trace(next, bounce.seen, bounces - 1, level + 1);
                    addSeen(colour, bounce, false);
                }
                if (passes) {
                    stats.refracted++;
                    share.copy(material.transmission);
                    next.direction.copy(bounce.bent);
                    at.sink();
                    trace(next, bounce.seen, bounces - 1, level + 1);
                    addSeen(colour, bounce, true);
                }
            }
        } else {
            boolean shown = terms.ambient() && scene.settings.background != null;
            colour.copy(shown ? scene.settings.background : BLACK);
        }
        if (recorder != null) {
            recorder.end(colour);
        }
        return hits;
    }

    private void addSeen(Colour colour, Bounce bounce, boolean refracted) {
        bounce.seen.mult(bounce.share);
        colour.add(bounce.seen);
        if (recorder != null) {
            recorder.followed(bounce.share, bounce.seen, refracted);
        }
    }

    private static void set(Colour colour, double r, double g, double b) {
        colour.r = r;
        colour.g = g;
        colour.b = b;
    }

    private Bounce bounce(int level) {
        if (level == bounces.length) {
            bounces = Arrays.copyOf(bounces, level + 1);
            bounces[level] = new Bounce();
        }
        return bounces[level];
    }

    /**
     * Computes the local colour, Ka·GA + Σ LC (Kd (N·L) + Ks (N·H)^shininess) over the lights that reach the surface (thesis, chapter 4). The
     * three terms are summed separately, so that pictures of single terms add up to the picture of all to the last bit. The points of an area
     * light are summed row by row, and their sum is then added as that of any light.
     */
    private void setLocal(Colour colour, Ray ray, Interaction at) {
        Material material = at.material;
        Colour kd = material.diffuse;
        Colour ks = material.specular;
        boolean shiny = terms.specular() && !ks.isBlack();
        double diffuseR = 0;                                  // doubles in place of colours: HotSpot keeps them in registers
        double diffuseG = 0;
        double diffuseB = 0;
        double specularR = 0;
        double specularG = 0;
        double specularB = 0;
        for (int i = 0; i < lights.length && (terms.lights() || recorder != null); i++) {
            Light light = lights[i];
            AreaLight area = light instanceof AreaLight a ? a : null;
            int points = 1;
            if (area != null) {
                points = area.points();
                light = lamp;
                set(diffuseBefore, diffuseR, diffuseG, diffuseB);
                set(specularBefore, specularR, specularG, specularB);
                diffuseR = 0;
                diffuseG = 0;
                diffuseB = 0;
                specularR = 0;
                specularG = 0;
                specularB = 0;
                visibility.approach(area, at);
            }
            for (int k = 0; k < points; k++) {
                if (area != null) {
                    area.point(k, lamp);
                }
                arriving.copy(light.intensity);
                boolean lit = visibility.reaches(light, i, at, arriving);
                double facing = lit && terms.diffuse() ? visibility.facing : 0;
                double highlight = 0;
                double cosine = 0;
                if (lit && shiny || recorder != null) {
                    Vector.subtract(halfway, visibility.towards, ray.direction);
                    halfway.normalise();
                    cosine = at.normal.dot(halfway);
                    highlight = lit && shiny ? Powers.power(Math.min(1, Math.max(0, cosine)), material.shininess) : 0;
                }
                double r = facing == 0 ? 0 : kd.r * arriving.r * facing;
                double g = facing == 0 ? 0 : kd.g * arriving.g * facing;
                double b = facing == 0 ? 0 : kd.b * arriving.b * facing;
                double shineR = highlight == 0 ? 0 : ks.r * arriving.r * highlight;
                double shineG = highlight == 0 ? 0 : ks.g * arriving.g * highlight;
                double shineB = highlight == 0 ? 0 : ks.b * arriving.b * highlight;
                diffuseR += r;
                diffuseG += g;
                diffuseB += b;
                specularR += shineR;
                specularG += shineG;
                specularB += shineB;
                if (recorder != null) {
                    recorder.light(i, visibility, arriving, halfway, cosine, new Colour(r, g, b), new Colour(shineR, shineG, shineB));
                }
            }
            if (area != null) {
                visibility.leave();
                if (recorder != null) {
                    recorder.points(i, new Colour(diffuseR, diffuseG, diffuseB), new Colour(specularR, specularG, specularB));
                }
                diffuseR += diffuseBefore.r;
                diffuseG += diffuseBefore.g;
                diffuseB += diffuseBefore.b;
                specularR += specularBefore.r;
                specularG += specularBefore.g;
                specularB += specularBefore.b;
            }
        }
        boolean ambient = terms.ambient();
        double ambientR = ambient ? material.ambient.r * scene.ambient.r : 0;
        double ambientG = ambient ? material.ambient.g * scene.ambient.g : 0;
        double ambientB = ambient ? material.ambient.b * scene.ambient.b : 0;
        colour.r = ambientR + diffuseR + specularR;
        colour.g = ambientG + diffuseG + specularG;
        colour.b = ambientB + diffuseB + specularB;
        if (recorder != null) {
            recorder.lit(new Colour(ambientR, ambientG, ambientB), new Colour(diffuseR, diffuseG, diffuseB),
                new Colour(specularR, specularG, specularB));
        }
    }
}
