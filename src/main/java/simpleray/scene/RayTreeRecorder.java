package simpleray.scene;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.RayTree.Between;
import simpleray.scene.RayTree.Contribution;
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

    /** The most points of area lights that are recorded one by one. */
    public static final int MAX_POINTS = 1 << 15;
    /** The most tests of objects that find what lies between a pixel's hits and points of area lights, some tenths of a second. */
    private static final long MAX_TESTS = 1L << 24;

    private final Scene scene;
    private final BruteForceIntersector all;
    private final boolean each;
    private final boolean opaque;
    private final int most;
    private final int mostPoints;
    private final long mostTests;
    private final Deque<Node> open = new ArrayDeque<>();      // the rays that have not ended, the latest first
    private int rays;
    private int points;                                       // of area lights, recorded one by one
    private long tests;
    private final PointLight lamp = new PointLight();
    private AreaSum area;                                     // the area light whose points are being computed; null if none
    private RayTree latest;

    /** An area light, as far as its points are known. */
    private static final class AreaSum {
        boolean shadows;
        int whole;
        int dimmed;
        int blocked;
        int turnedAway;
        TreeSet<Integer> between = new TreeSet<>();           // null once it would take too long
        List<Lamp> lamps = new ArrayList<>();                 // null once there are too many
    }

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
        final List<Contribution> lamps = new ArrayList<>();
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
     * Creates a recorder for one pixel, which does not record each point of an area light.
     *
     * @param scene the scene, which must not change meanwhile
     */
    public RayTreeRecorder(Scene scene) {
        this(scene, false);
    }

    /**
     * Creates a recorder for one pixel.
     *
     * @param scene the scene, which must not change meanwhile
     * @param each whether each point of an area light is recorded, and not only their sum
     */
    public RayTreeRecorder(Scene scene, boolean each) {
        this(scene, each, MAX_RAYS, MAX_POINTS, MAX_TESTS);
    }

    /** Creates a recorder with other limits of rays recorded in full, of points recorded one by one, and of tests. */
    RayTreeRecorder(Scene scene, boolean each, int most, int mostPoints, long mostTests) {
        this.scene = scene;
        this.each = each;
        this.most = most;
        this.mostPoints = mostPoints;
        this.mostTests = mostTests;
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
            area = null;
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
        if (!node.told) {
            return;
        }
        Light light = scene.getLight(number);
        Colour intensity = light.intensity;
        if (light instanceof AreaLight of) {
            area = area == null ? new AreaSum() : area;
            area.shadows = seen.shadows;
            of.point(0, lamp);                                // all its points have the same colour
            intensity = new Colour(lamp.intensity);
            count(node.point, seen, intensity, arriving);
            if (!each || area.lamps == null || ++points > mostPoints) {
                area.lamps = each ? null : List.of();
                return;
            }
        }
        Vector towards = new Vector(seen.towards);
        List<Between> between = between(node.point, towards, seen, intensity, arriving);
        Lamp told = new Lamp(light(number), intensity, seen.distance, towards, seen.facing, new Vector(halfway), cosine,
            verdict(seen, between), between, new Colour(arriving), new Colour(diffuse), new Colour(specular));
        if (area == null) {
            node.lamps.add(told);
        } else {
            area.lamps.add(told);
        }
    }

    private Thing light(int number) {
        return new Thing(number + 1, LightKind.TABLE.name(scene.getLight(number)), scene.lightLine(number));
    }

    /** Counts whether a point of an area light reaches a hit, and finds what lies between. */
    private void count(Point point, VisibilityTester seen, Colour intensity, Colour arriving) {
        if (seen.facing <= 0) {
            area.turnedAway++;
            return;
        }
        boolean whole = isWhole(intensity, arriving);
        area.whole += whole ? 1 : 0;
        area.blocked += !whole && arriving.isBlack() ? 1 : 0;
        area.dimmed += !whole && !arriving.isBlack() ? 1 : 0;
        if (!whole && area.between != null) {
            tests += scene.getNumberObjects();
            if (tests > mostTests) {
                area.between = null;
            } else {
                IntStream.of(all.between(new Ray(point, seen.towards), seen.end)).forEach(area.between::add);
            }
        }
    }

    private static boolean isWhole(Colour intensity, Colour arriving) {
        return arriving.r == intensity.r && arriving.g == intensity.g && arriving.b == intensity.b;
    }

    @Override
    public void points(int number, Colour diffuse, Colour specular) {
        Node node = open.peek();
        if (node.told) {
            List<Thing> between = area.between == null ? null : area.between.stream().map(place -> object(scene, place)).toList();
            int all = area.whole + area.dimmed + area.blocked + area.turnedAway;
            node.lamps.add(new RayTree.Area(light(number), scene.getLight(number).intensity, all, area.shadows, area.whole, area.dimmed,
                area.blocked, between, new Colour(diffuse), new Colour(specular), area.lamps == null ? null : List.copyOf(area.lamps)));
            area = null;
        }
    }

    /** {@return the objects between a point and a light, up to the one that blocks} */
    private List<Between> between(Point point, Vector towards, VisibilityTester seen, Colour intensity, Colour arriving) {
        boolean whole = !arriving.isBlack() && isWhole(intensity, arriving);
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
