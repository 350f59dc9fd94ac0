package simpleray.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Powers;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Story.Between;
import simpleray.scene.Story.Hit;
import simpleray.scene.Story.Lamp;
import simpleray.scene.Story.Next;
import simpleray.scene.Story.Thing;
import simpleray.scene.Story.Verdict;

/**
 * Tells why rays see what they see, by the sums of {@link Scene#intersect} in their order, so that each story's colour is that of the
 * picture to the last bit. <em>Mutable</em>: one thread's own, and for one pixel.
 */
public final class Storyteller {
    /** So many rays are told of; from then on there is no more than their colours, or the story of much glass would fill the memory. */
    public static final int MOST_RAYS = 10_000;

    private final Scene scene;
    private final Probe probe;
    private final Terms terms;
    private final int most;
    private int rays;

    /**
     * Creates a storyteller for one pixel.
     *
     * @param scene the scene, which must not change meanwhile
     * @param probe what finds hits in this scene
     * @param terms which parts of the colour are wanted
     */
    public Storyteller(Scene scene, Probe probe, Terms terms) {
        this(scene, probe, terms, MOST_RAYS);
    }

    /** Creates one that tells of so many rays. */
    Storyteller(Scene scene, Probe probe, Terms terms, int most) {
        this.scene = scene;
        this.probe = probe;
        this.terms = terms;
        this.most = most;
    }

    /**
     * Tells the story of a ray from the eye.
     *
     * @param ray the ray, of unit direction; not to be changed any more
     * @param depth how many reflections and refractions may follow, 0 or more
     * @return the story
     * @throws CancellationException if the calling thread is interrupted
     */
    public Story tell(Ray ray, int depth) {
        return tell(ray, depth, 0, false);
    }

    /**
     * Names an object of a scene.
     *
     * @param scene the scene
     * @param place its place, from 0
     * @return its number, kind and line
     */
    public static Thing object(Scene scene, int place) {
        return new Thing(place + 1, ObjectKind.TABLE.name(scene.getObject(place)), scene.objectLine(place));
    }

    private Story tell(Ray ray, int depth, int level, boolean refracted) {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("the story was cancelled");
        }
        boolean told = ++rays <= most;
        Colour colour = new Colour();
        int place = probe.nearest(ray, level, refracted);
        if (place == Probe.NONE) {
            if (terms.ambient() && scene.settings.background != null) {
                colour.copy(scene.settings.background);
            }
            return new Story(ray, depth, told, null, colour);
        }
        double distance = probe.distance();
        Object object = scene.getObject(place);
        Material material = object.surfaceMaterial;
        Point point = ray.getPointAt(distance);
        Surface surface = object.surface(ray, distance, point);
        Vector normal = surface.towards(ray.direction);
        double height = Optics.lift(point, normal, distance);
        List<Lamp> lamps = lamps(material, point, normal, Vector.negate(ray.direction));
        Colour ambient = terms.ambient() ? Colour.mult(material.ambient, scene.ambient) : new Colour();
        Colour diffuse = new Colour();
        Colour specular = new Colour();
        for (Lamp lamp : lamps) {
            diffuse.add(lamp.diffuse());
            specular.add(lamp.specular());
        }
        colour.add(ambient);
        colour.add(diffuse);
        colour.add(specular);

        Next mirrored = null;
        Next through = null;
        int bounces = Math.min(depth, material.reflections());
        boolean enters = surface.isEnteredBy(ray.direction);
        if (terms.reflections() && bounces > 0) {
            Vector bent = new Vector();
            boolean passes = !material.transmission.isBlack()
                && Optics.refract(bent, ray.direction, normal, enters ? 1 / material.index : material.index);
            Colour share = passes ? material.specular : Colour.add(material.specular, material.transmission);
            Vector mirror = new Vector();
            Optics.mirror(mirror, ray.direction, normal);
            mirrored = next(colour, share, new Ray(point, mirror), bounces - 1, level + 1, false);
            Point beyond = Optics.below(point, normal, height);
            through = passes ? next(colour, material.transmission, new Ray(beyond, bent), bounces - 1, level + 1, true) : null;
        }
        return new Story(ray, depth, told, !told ? null : new Hit(object(scene, place), distance, point, normal, enters, material,
            scene.ambient, ambient, lamps, diffuse, specular, mirrored, through), colour);
    }

    /** Adds what a ray sees that goes on from a hit. {@return its story; null if nothing of it counts} */
    private Next next(Colour colour, Colour share, Ray ray, int depth, int level, boolean refracted) {
        if (share.isBlack()) {
            return null;
        }
        Story story = tell(ray, depth, level, refracted);
        Colour part = Colour.mult(story.colour(), share);
        colour.add(part);
        return new Next(share, part, story);
    }

    private List<Lamp> lamps(Material material, Point point, Vector normal, Vector view) {
        List<Lamp> lamps = new ArrayList<>();
        for (int i = 0; i < scene.getNumberLights(); i++) {
            Light light = scene.getLight(i);
            Vector towards = new Vector();
            double distance = light.towards(point, towards);
            double facing = normal.dot(towards);
            Vector halfway = Vector.add(towards, view);
            halfway.normalise();
            double cosine = normal.dot(halfway);
            List<Between> between = new ArrayList<>();
            Colour arriving = new Colour();
            Verdict verdict = arriving(arriving, between, new Ray(point, towards), facing, distance, i);
            Colour diffuse = new Colour();
            Colour specular = new Colour();
            if (terms.diffuse() && !arriving.isBlack()) {
                diffuse = Colour.mult(material.diffuse, arriving);
                diffuse.scale(facing);
            }
            if (terms.specular() && !material.specular.isBlack() && !arriving.isBlack()) {
                specular = Colour.mult(material.specular, arriving);
                specular.scale(Powers.power(Math.min(1, Math.max(0, cosine)), material.shininess));
            }
            lamps.add(new Lamp(new Thing(i + 1, LightKind.TABLE.name(light), scene.lightLine(i)), light.intensity, distance, towards,
                facing, halfway, cosine, verdict, List.copyOf(between), arriving, diffuse, specular));
        }
        return List.copyOf(lamps);
    }

    /** Finds what is left of a light, and what is between. */
    private Verdict arriving(Colour left, List<Between> between, Ray towards, double facing, double distance, int number) {
        if (facing <= 0) {
            return Verdict.TURNED_AWAY;
        }
        left.copy(scene.getLight(number).intensity);
        if (!terms.shadows()) {
            return Verdict.NO_SHADOWS;
        }
        Colour through = new Colour(1, 1, 1);
        for (int place : probe.between(towards, distance, number)) {
            Colour transmission = scene.getObject(place).surfaceMaterial.transmission;
            between.add(new Between(object(scene, place), transmission));
            left.mult(transmission);
            through.mult(transmission);
        }
        return between.isEmpty() ? Verdict.REACHES : through.isBlack() ? Verdict.BLOCKED : Verdict.DIMMED;
    }
}
