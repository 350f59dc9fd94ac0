package simpleray.scene;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CancellationException;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.RayTree.Between;
import simpleray.scene.RayTree.Lamp;
import simpleray.scene.RayTree.Next;
import simpleray.scene.RayTree.Thing;
import simpleray.scene.RayTree.Verdict;

/**
 * Records trees of rays that explain their colours, while a {@link WhittedIntegrator} traces them. <em>Mutable</em>: one thread's
 * own, and for one pixel. An interrupt of the thread cancels the tracing with a {@link CancellationException}.
 */
public final class RayTreeRecorder implements Recorder {
    /** The most rays recorded in full; of later ones only the colours are, since a tree of much glass would fill the memory. */
    public static final int MAX_RAYS = 10_000;

    private final Scene scene;
    private final BruteForceIntersector all;
    private final boolean opaque;
    private final int most;
    private final Deque<Node> open = new ArrayDeque<>();      // the rays that have not ended, the latest first
    private int rays;
    private RayTree latest;

    /** A ray that has not ended, as far as it is known. */
    private static final class Node {
        final Ray ray;
        final int depth;
        final boolean told;
        Thing object;                                         // null until the hit is known
        double distance;
        Point point;
        Vector normal;
        boolean enters;
        Material material;
        final List<Lamp> lamps = new ArrayList<>();
        Colour ambient;
        Colour diffuse;
        Colour specular;
        Next mirror;
        Next refracted;

        Node(Ray ray, int depth, boolean told) {
            this.ray = new Ray(new Point(ray.origin), new Vector(ray.direction));
            this.depth = depth;
            this.told = told;
        }
    }

    /**
     * Creates a recorder for one pixel.
     *
     * @param scene the scene, which must not change meanwhile
     */
    public RayTreeRecorder(Scene scene) {
        this(scene, MAX_RAYS);
    }

    /** Creates a recorder with another limit of rays recorded in full. */
    RayTreeRecorder(Scene scene, int most) {
        this.scene = scene;
        this.most = most;
        all = new BruteForceIntersector(scene);
        boolean black = true;
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            black &= scene.getObject(i).isOpaque();
        }
        opaque = black;
    }

    /** {@return the tree of the ray from the eye that was traced last} */
    public RayTree tree() {
        return latest;
    }

    /**
     * Describes an object of a scene.
     *
     * @param scene the scene
     * @param place its index
     * @return its number, kind and line
     */
    public static Thing object(Scene scene, int place) {
        return object(scene, place, null);
    }

    /**
     * Describes an object of a scene where it is hit.
     *
     * @param scene the scene
     * @param hit the hit
     * @return its number, kind and line, and where the material stands that it has there
     */
    public static Thing object(Scene scene, Hit hit) {
        return object(scene, hit.place, scene.getObject(hit.place).material(hit.part));
    }

    private static Thing object(Scene scene, int place, Material material) {
        Object object = scene.getObject(place);
        RayTree.Mtl mtl = object instanceof Mesh mesh ? mesh.origin(material) : null;
        return new Thing(place + 1, ObjectKind.TABLE.name(object), scene.objectLine(place), mtl);
    }

    @Override
    public void begin(Ray ray, int depth, int level) {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("the story was cancelled");
        }
        if (level == 0) {
            open.clear();                                     // of a ray that was cancelled
        }
        open.push(new Node(ray, depth, ++rays <= most));
    }

    @Override
    public void hit(Ray ray, Interaction at) {
        Node node = open.peek();
        if (node.told) {
            node.object = object(scene, at.place, at.material);
            node.distance = at.t;
            node.point = new Point(at.point);
            node.normal = new Vector(at.normal);
            node.enters = at.enters;
            node.material = at.material;
        }
    }

    @Override
    public void light(int number, VisibilityTester seen, Colour arriving, Vector halfway, double cosine, Colour diffuse, Colour specular) {
        Node node = open.peek();
        if (node.told) {
            Light light = scene.getLight(number);
            Thing thing = new Thing(number + 1, LightKind.TABLE.name(light), scene.lightLine(number));
            Vector towards = new Vector(seen.towards);
            List<Between> between = between(node.point, towards, seen, light.intensity, arriving);
            node.lamps.add(new Lamp(thing, light.intensity, seen.distance, towards, seen.facing, new Vector(halfway), cosine,
                verdict(seen, between), between, new Colour(arriving), new Colour(diffuse), new Colour(specular)));
        }
    }

    /** {@return the objects between a point and a light, up to the one that blocks} */
    private List<Between> between(Point point, Vector towards, VisibilityTester seen, Colour intensity, Colour arriving) {
        boolean whole = !arriving.isBlack() && arriving.r == intensity.r && arriving.g == intensity.g && arriving.b == intensity.b;
        if (!seen.shadows || seen.facing <= 0 || whole && opaque) {   // clear glass between does not dim
            return List.of();
        }
        List<Between> between = new ArrayList<>();
        Ray ray = new Ray(point, towards);
        for (int place : all.between(ray, seen.end)) {
            between.add(new Between(object(scene, place), new Colour(scene.getObject(place).transmitted(ray, seen.end, new Hit()))));
        }
        return List.copyOf(between);
    }

    private static Verdict verdict(VisibilityTester seen, List<Between> between) {
        if (seen.facing <= 0) {
            return Verdict.TURNED_AWAY;
        }
        if (!seen.shadows) {
            return Verdict.NO_SHADOWS;
        }
        Colour through = new Colour(1, 1, 1);
        between.forEach(object -> through.mult(object.transmission()));
        return between.isEmpty() ? Verdict.REACHES : through.isBlack() ? Verdict.BLOCKED : Verdict.DIMMED;
    }

    @Override
    public void lit(Colour ambient, Colour diffuse, Colour specular) {
        Node node = open.peek();
        node.ambient = new Colour(ambient);
        node.diffuse = new Colour(diffuse);
        node.specular = new Colour(specular);
    }

    @Override
    public void followed(Colour share, Colour added, boolean refracted) {
        Node node = open.peek();
        Next next = new Next(new Colour(share), new Colour(added), latest);
        if (refracted) {
            node.refracted = next;
        } else {
            node.mirror = next;
        }
    }

    @Override
    public void end(Colour colour) {
        Node node = open.pop();
        RayTree.Hit hit = node.object == null ? null : new RayTree.Hit(node.object, node.distance, node.point, node.normal, node.enters,
            node.material, scene.ambient, node.ambient, List.copyOf(node.lamps), node.diffuse, node.specular, node.mirror, node.refracted);
        latest = new RayTree(node.ray, node.depth, node.told, hit, new Colour(colour));
    }
}
