package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** A ray at the surface that it hits: all that shading asks of it. <em>Mutable</em>: one thread's own, used again for other rays. */
public final class Interaction {
    /** What is hit. */
    public Object object;
    /** Its place in the scene, from 0. */
    public int place;
    /** How far the ray came. */
    public double t;
    /** Where the rays begin that go on from here: where the surface is hit, a little towards where the ray came from if numbers are large. */
    public final Point point = new Point();
    /** The unit normal of the true shape, outward; it decides whether a ray enters or leaves. */
    public final Vector outward = new Vector();
    /** The unit normal N by which the surface is lit and rays bend, turned to the side from which the ray comes. */
    public final Vector normal = new Vector();
    /** Whether the ray enters the object here, and does not leave it. */
    public boolean enters;

    private double height;                                    // how far the point was lifted off the surface

    /** Creates one to be set. */
    public Interaction() {
    }

    /**
     * Finds the surface at a hit.
     *
     * @param ray the ray, of unit direction
     * @param hit its hit
     * @param what the object that is hit
     */
    public void set(Ray ray, Hit hit, Object what) {
        object = what;
        place = hit.place;
        t = hit.t;
        Vector d = ray.direction;
        point.set(ray.origin.x + d.x * t, ray.origin.y + d.y * t, ray.origin.z + d.z * t);
        what.surface(hit, this);
        enters = outward.dot(d) < 0;
        if (normal.dot(d) > 0) {                              // both sides of a surface are lit and mirror alike
            normal.negate();
        }
        height = Optics.lift(point, normal, t);
    }

    /** Moves the point to the other side of the surface, for a ray that goes on through it. */
    void sink() {
        Optics.sink(point, normal, height);
    }
}
