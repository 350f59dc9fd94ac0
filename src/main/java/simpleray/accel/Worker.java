package simpleray.accel;

import java.util.Arrays;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Powers;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Material;
import simpleray.scene.Optics;
import simpleray.scene.RayTracer;
import simpleray.scene.Surface;
import simpleray.scene.Terms;

/**
 * Finds the colours of rays as {@link simpleray.scene.Scene#intersect} does, by the same sums in the same order, but asks a {@link Finder}
 * and makes no objects. <em>Mutable</em>: one thread's own.
 */
final class Worker implements RayTracer {
    private static final Colour BLACK = new Colour();

    private final Engine engine;
    private final Finder finder;
    private Hit[] hits = {};
    private final Colour left = new Colour();
    private final Vector halfway = new Vector();

    Worker(Engine engine) {
        this.engine = engine;
        finder = new Finder(engine);
    }

    /** What is found on one level of reflections. */
    private static final class Hit {
        final Vector normal = new Vector();
        final Ray next = new Ray();
        final Ray towards = new Ray(next.origin, new Vector());   // a light
        final Vector bent = new Vector();
        final Colour seen = new Colour();
        final Colour share = new Colour();
    }

    @Override
    public boolean intersect(Ray ray, Colour colour, int depth, Terms terms) {
        Point eye = engine.eye;
        finder.tally.primary++;
        return see(ray, colour, depth, terms, 0, ray.origin.x == eye.x && ray.origin.y == eye.y && ray.origin.z == eye.z);
    }

    /** {@return what was done so far} */
    Tally tally() {
        return finder.tally;
    }

    private boolean see(Ray ray, Colour colour, int depth, Terms terms, int level, boolean fromEye) {
        finder.tally.ray(level);
        if (!finder.nearest(ray, fromEye)) {
            boolean shown = terms.ambient() && engine.scene.settings.background != null;
            colour.copy(shown ? engine.scene.settings.background : BLACK);
            return false;
        }
        if (level == hits.length) {
            hits = Arrays.copyOf(hits, level + 1);
            hits[level] = new Hit();
        }
        Hit hit = hits[level];
        int place = finder.hit;
        double t = finder.t;
        Material material = engine.primitives.materials[place];
        Point point = hit.next.origin;
        Vector d = ray.direction;
        point.set(ray.origin.x + d.x * t, ray.origin.y + d.y * t, ray.origin.z + d.z * t);
        boolean enters = findNormal(hit.normal, ray, place, t, point);
        double height = Optics.lift(point, hit.normal, t);
        addLocal(colour, material, hit, ray.direction, terms);
        int bounces = Math.min(depth, material.reflections());
        if (terms.reflections() && bounces > 0) {
            boolean passes = false;
            hit.share.copy(material.specular);
            if (!material.transmission.isBlack()) {
                passes = Optics.refract(hit.bent, ray.direction, hit.normal, enters ? 1 / material.index : material.index);
                if (!passes) {
                    hit.share.add(material.transmission);
                }
            }
            if (!hit.share.isBlack()) {
                Optics.mirror(hit.next.direction, ray.direction, hit.normal);
                finder.tally.reflected++;
                addSeen(colour, hit.share, hit, bounces - 1, terms, level);
            }
            if (passes) {
                hit.next.direction.copy(hit.bent);
                Optics.sink(point, hit.normal, height);
                finder.tally.refracted++;
                addSeen(colour, material.transmission, hit, bounces - 1, terms, level);
            }
        }
        return true;
    }

    private void addSeen(Colour colour, Colour share, Hit hit, int depth, Terms terms, int level) {
        Colour seen = hit.seen;
        see(hit.next, seen, depth, terms, level + 1, false);
        colour.r += seen.r * share.r;
        colour.g += seen.g * share.g;
        colour.b += seen.b * share.b;
    }

    /** Finds the normal at a hit, on the side from which the ray comes; returns whether the ray enters there. */
    private boolean findNormal(Vector normal, Ray ray, int place, double t, Point point) {
        if (engine.primitives.normal(place, point, normal)) {
            double facing = normal.dot(ray.direction);
            if (facing > 0) {
                normal.negate();
            }
            return facing < 0;
        }
        Surface surface = engine.primitives.objects[place].surface(ray, t, point);
        normal.copy(surface.shading());
        if (normal.dot(ray.direction) > 0) {
            normal.negate();
        }
        return surface.isEnteredBy(ray.direction);
    }

    /** Finds the local colour. All is in local variables, which the machine keeps at hand. */
    private void addLocal(Colour colour, Material material, Hit hit, Vector direction, Terms terms) {
        Point point = hit.next.origin;
        double nx = hit.normal.x;
        double ny = hit.normal.y;
        double nz = hit.normal.z;
        double diffuseR = 0;
        double diffuseG = 0;
        double diffuseB = 0;
        double specularR = 0;
        double specularG = 0;
        double specularB = 0;
        boolean shiny = terms.specular() && !material.specular.isBlack();
        Vector l = hit.towards.direction;
        for (int i = 0; i < engine.lights.length; i++) {
            double distance = Double.POSITIVE_INFINITY;
            if (engine.directions[i] == null) {
                distance = engine.lights[i].towards(point, l);
            } else {
                l.copy(engine.directions[i]);
            }
            double facing = nx * l.x + ny * l.y + nz * l.z;
            if (facing <= 0) {
                continue;
            }
            Colour light = engine.lights[i].intensity;
            if (terms.shadows()) {
                finder.tally.shadow++;
                if (finder.isBlocked(hit.towards, distance, i)) {
                    continue;
                }
                light = finder.dimmers == 0 ? light : dimmed(light);
            }
            if (light.isBlack()) {
                continue;
            }
            if (terms.diffuse()) {
                diffuseR += material.diffuse.r * light.r * facing;
                diffuseG += material.diffuse.g * light.g * facing;
                diffuseB += material.diffuse.b * light.b * facing;
            }
            if (shiny) {
                halfway.set(l.x - direction.x, l.y - direction.y, l.z - direction.z);
                halfway.normalise();
                double cosine = nx * halfway.x + ny * halfway.y + nz * halfway.z;
                double power = Powers.power(cosine <= 0 ? 0 : cosine >= 1 ? 1 : cosine, material.shininess);
                specularR += material.specular.r * light.r * power;
                specularG += material.specular.g * light.g * power;
                specularB += material.specular.b * light.b * power;
            }
        }
        Colour ambient = engine.scene.ambient;
        boolean shown = terms.ambient();
        colour.r = (shown ? material.ambient.r * ambient.r : 0) + diffuseR + specularR;
        colour.g = (shown ? material.ambient.g * ambient.g : 0) + diffuseG + specularG;
        colour.b = (shown ? material.ambient.b * ambient.b : 0) + diffuseB + specularB;
    }

    /** Dims a light by all that lets some through, in the order of the scene: products depend on it in the last bit. */
    private Colour dimmed(Colour light) {
        int count = finder.dimmers;
        int[] order = new int[count];
        for (int i = 0; i < count; i++) {
            order[i] = engine.primitives.order[finder.dimming[i]];
        }
        Arrays.sort(order);
        left.copy(light);
        for (int i = 0; i < count && !left.isBlack(); i++) {
            left.mult(engine.scene.getObject(order[i]).surfaceMaterial.transmission);
        }
        return left;
    }
}
