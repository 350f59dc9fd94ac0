package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Moves an eye through a scene so that it goes through no surface: "collide and slide" (Fauerby 2003) for a point. */
public final class EyePath {
    /** The least distance to a surface, as a share of the distance to what the eye looks at. */
    public static final double MARGIN = 0.01;
    /** The surfaces along which one move slides: of a corner, three at most. */
    private static final int MAX_SLIDES = 4;

    private EyePath() {
    }

    /**
     * Finds how far the eye gets on a straight way.
     *
     * @param scene the scene; surfaces stop the eye from both sides
     * @param from where the eye is
     * @param to where it is to go
     * @param margin the least distance that it keeps from a surface, unless it is nearer already
     * @return where it comes to: the end of the way, or beside a surface, along which it slides; {@code from} if it would slide into another
     */
    public static Point end(Scene scene, Point from, Point to, double margin) {
        Intersector surfaces = new BruteForceIntersector(scene);
        Hit hit = new Hit();
        Interaction at = new Interaction();
        Point end = new Point(to);
        for (int i = 0; i < MAX_SLIDES; i++) {
            Vector way = Vector.subtract(end, from);
            double length = way.norm();
            if (!(length > 0) || !Double.isFinite(length)) {
                return end;
            }
            Ray ray = new Ray(from, Vector.scale(way, 1 / length));
            if (!surfaces.intersect(ray, hit)) {
                return end;
            }
            at.set(ray, hit, scene.getObject(hit.place));
            double cosine = -at.normal.dot(ray.direction);
            double before = hit.t * cosine;                   // distances from the plane of the surface
            double after = before - length * cosine;
            double least = Math.min(margin, before);
            double missing = least - after;
            if (missing <= least * Object.THRESHOLD) {
                return end;
            }
            end.add(Vector.scale(at.normal, missing));
        }
        return from;
    }
}
