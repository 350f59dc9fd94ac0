package simpleray.rays;

import java.util.ArrayList;
import java.util.List;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.render.PixelStory;
import simpleray.scene.RayTree.Area;
import simpleray.scene.RayTree.Contribution;
import simpleray.scene.RayTree.Lamp;
import simpleray.scene.RayTree;
import simpleray.scene.Scene;

/**
 * A straight piece of a pixel's ray tree. <em>Constant</em>; its points must not be changed.
 *
 * @param kind what it shows
 * @param from where it begins: a ray's origin, or a hit point
 * @param to where it ends: the hit point, the light, or what blocks the light
 * @param endless whether it goes on without end, since nothing is hit or the light is infinitely far
 * @param ray the ray that it is, or from whose hit it starts
 * @param lamp the light that it belongs to; null if to none
 */
public record RaySegment(Kind kind, Point from, Point to, boolean endless, RayTree ray, Lamp lamp) {
    /** What a segment shows. */
    public enum Kind {
        /** The ray from the eye. */
        PRIMARY("primary ray"),
        /** A mirror ray. */
        MIRROR("mirror ray"),
        /** A refracted ray. */
        REFRACTED("refracted ray"),
        /** A shadow ray that arrives at its light. */
        ARRIVING("shadow ray that arrives"),
        /** A shadow ray up to the object that stops it. */
        STOPPED("shadow ray that is stopped"),
        /** The normal N at a hit. */
        NORMAL("normal N"),
        /** The vector H halfway between L and the way back. */
        HALFWAY("halfway vector H");

        private final String label;

        Kind(String label) {
            this.label = label;
        }

        /** {@return what a legend calls it} */
        public String label() {
            return label;
        }

        /** {@return whether it is a vector at a hit and no ray} */
        public boolean isVector() {
            return this == NORMAL || this == HALFWAY;
        }
    }

    /** The length of what has no end, in lengths of the primary ray. */
    private static final double FAR = 0.75;
    /** The most points of an area light whose shadow rays are all drawn; of more points, those of a grid. */
    private static final int FAN = 9;
    private static final int FAN_SIDE = 3;
    /** How far from the first hit the eye outside is to see lights, in lengths of the primary ray. */
    private static final double REACH = 3;
    /** How far it is to see hits: with those of a mirror ray along a floor to the horizon, all others would be a dot. */
    private static final double MAX_REACH = 10;
    /** The length of vectors, likewise. */
    private static final double VECTOR = 0.12;

    /**
     * Returns the segments of a pixel, in the order in which Whitted's recursion traces them (chapter 2): each ray, then the shadow rays
     * from its hit, then its mirror ray with all that comes of it, then its refracted ray. The vectors at a hit stand before its shadow rays.
     *
     * @param tree the tree of a primary ray
     * @param scene its scene, in which the blockers are found
     * @return the segments, one or more
     */
    public static List<RaySegment> of(RayTree tree, Scene scene) {
        List<RaySegment> all = new ArrayList<>();
        add(tree, Kind.PRIMARY, scene, tree.hit() == null ? distance(tree.ray().origin) : tree.hit().distance(), all);
        return all;
    }

    /**
     * Returns the segments of the sample in the middle of a pixel.
     *
     * @param story the pixel
     * @param scene its scene
     * @return the segments, one or more
     */
    public static List<RaySegment> of(PixelStory story, Scene scene) {
        return of(story.samples().get(story.samples().size() / 2).tree(), scene);
    }

    /**
     * {@return the ends that an eye outside is to see} They are those of the primary ray and of all others, but of a ray to a light far
     * away, as of one without end, the first piece of it: as an arrow it tells where the light is. So it is with hits that are very far.
     */
    static List<Point> framed(List<RaySegment> segments) {
        RaySegment first = segments.get(0);
        double length = Vector.subtract(first.to, first.from).norm();
        List<Point> points = new ArrayList<>(List.of(first.from, first.to));
        for (RaySegment segment : segments) {
            if (!segment.kind.isVector() && Vector.subtract(segment.from, first.to).norm() <= MAX_REACH * length) {
                Vector whole = Vector.subtract(segment.to, segment.from);
                double reach = segment.kind == Kind.ARRIVING ? REACH : MAX_REACH;
                boolean near = Vector.subtract(segment.to, first.to).norm() <= reach * length;
                points.add(near ? segment.to : Point.add(segment.from, Vector.scale(whole, Math.min(1, FAR * length / whole.norm()))));
            }
        }
        return points;
    }

    /** {@return the distance of a point from the origin, round which the scene is if the ray hits nothing of it; 1 if it is there} */
    private static double distance(Point p) {
        double distance = new Vector(p).norm();
        return distance > 0 ? distance : 1;
    }

    private static void add(RayTree tree, Kind kind, Scene scene, double length, List<RaySegment> out) {
        Ray ray = tree.ray();
        RayTree.Hit hit = tree.hit();
        if (hit == null) {
            out.add(new RaySegment(kind, ray.origin, ray.getPointAt(FAR * length), true, tree, null));
            return;
        }
        out.add(new RaySegment(kind, ray.origin, hit.point(), false, tree, null));
        out.add(vector(Kind.NORMAL, hit.normal(), length, tree, null));
        for (Contribution contribution : hit.lamps()) {
            for (Lamp lamp : fan(contribution)) {
                addLight(lamp, scene, length, tree, out);
            }
        }
        if (hit.mirror() != null) {
            add(hit.mirror().tree(), Kind.MIRROR, scene, length, out);
        }
        if (hit.refracted() != null) {
            add(hit.refracted().tree(), Kind.REFRACTED, scene, length, out);
        }
    }

    /**
     * Finds what blocks a light.
     *
     * @param tree a ray
     * @param lamp a light at its hit that is blocked
     * @param scene its scene
     * @return a new point, where the shadow ray hits the object that stops it
     */
    public static Point stop(RayTree tree, Lamp lamp, Scene scene) {
        Ray ray = new Ray(tree.hit().point(), lamp.towards());
        int blocker = lamp.between().get(lamp.between().size() - 1).object().number() - 1;
        return ray.getPointAt(scene.getObject(blocker).intersect(ray));
    }

    /** {@return the light itself, or some points of an area light, spread evenly; none if its points are not told} */
    private static List<Lamp> fan(Contribution contribution) {
        if (contribution instanceof Lamp lamp) {
            return List.of(lamp);
        }
        List<Lamp> all = ((Area) contribution).lamps();
        if (all == null || all.size() <= FAN) {
            return all == null ? List.of() : all;
        }
        int side = (int) Math.round(Math.sqrt(all.size()));
        List<Lamp> some = new ArrayList<>();
        for (int j = 0; j < FAN_SIDE; j++) {
            for (int i = 0; i < FAN_SIDE; i++) {
                some.add(all.get(j * (side - 1) / (FAN_SIDE - 1) * side + i * (side - 1) / (FAN_SIDE - 1)));
            }
        }
        return some;
    }

    private static void addLight(Lamp lamp, Scene scene, double length, RayTree tree, List<RaySegment> out) {
        Point from = tree.hit().point();
        Ray ray = new Ray(from, lamp.towards());
        switch (lamp.verdict()) {
            case REACHES, DIMMED -> {
                boolean endless = lamp.distance() == Double.POSITIVE_INFINITY;
                out.add(vector(Kind.HALFWAY, lamp.halfway(), length, tree, lamp));
                out.add(new RaySegment(Kind.ARRIVING, from, ray.getPointAt(endless ? FAR * length : lamp.distance()), endless, tree, lamp));
            }
            case BLOCKED -> {
                out.add(new RaySegment(Kind.STOPPED, from, stop(tree, lamp, scene), false, tree, lamp));
            }
            default -> {
                return;                                       // no shadow ray is traced
            }
        }
    }

    /**
     * Returns what the thesis's figures 6 and 9 show: the normal at the first hit, and the way to the first light that reaches it. The rays
     * are as long as the vectors.
     *
     * @param segments the segments of a pixel
     * @param specular whether the halfway vector and the ray from the eye are shown too (figure 9)
     * @return some segments; all of them if no light reaches the first hit
     */
    @SuppressWarnings("ReferenceEquality")                    // the very ray, not one like it
    public static List<RaySegment> lighting(List<RaySegment> segments, boolean specular) {
        RaySegment primary = segments.get(0);
        RaySegment light = segments.stream().filter(s -> s.kind == Kind.ARRIVING && s.ray == primary.ray).findFirst().orElse(null);
        if (light == null) {
            return segments;
        }
        RayTree tree = primary.ray;
        double length = tree.hit().distance();
        List<RaySegment> some = new ArrayList<>();
        if (specular) {
            Point before = new Ray(primary.to, Vector.negate(tree.ray().direction)).getPointAt(VECTOR * length);
            some.add(new RaySegment(Kind.PRIMARY, before, primary.to, false, tree, null));
            some.add(vector(Kind.HALFWAY, light.lamp.halfway(), length, tree, light.lamp));
        }
        some.add(vector(Kind.NORMAL, tree.hit().normal(), length, tree, null));
        some.add(vector(Kind.ARRIVING, light.lamp.towards(), length, tree, light.lamp));
        return some;
    }

    private static RaySegment vector(Kind kind, Vector direction, double length, RayTree tree, Lamp lamp) {
        Point from = tree.hit().point();
        return new RaySegment(kind, from, new Ray(from, direction).getPointAt(VECTOR * length), false, tree, lamp);
    }

    /** {@return whether it shows the same ray or vector as another, of a story told again} */
    boolean isSame(RaySegment other) {
        return kind == other.kind && from.equals(other.from) && to.equals(other.to);
    }
}
