package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** A ray at the surface that it hits: all that shading needs. <em>Mutable</em>: one thread's own, reused for other rays. */
public final class Interaction {
    /** The material at the hit. */
    public Material material;
    /** The index of the object that is hit in the scene. */
    public int place;
    /** The distance that the ray travelled. */
    public double t;
    /** The origin of further rays: the hit point, moved a little to the ray's side of the surface if its coordinates are large. */
    public final Point point = new Point();
    /** The unit normal of the true shape, outward; it decides whether a ray enters or leaves. */
    public final Vector outward = new Vector();
    /** The unit normal N by which the surface is lit and rays bend, turned to the side from which the ray comes. */
    public final Vector normal = new Vector();
    /** Whether the ray enters the object here, and does not leave it. */
    public boolean enters;

    private double height;                                    // the distance by which the point was moved off the surface

    /** Creates an empty interaction. */
    public Interaction() {
    }

    /**
     * Computes the interaction at a hit.
     *
     * @param ray the ray, of unit direction
     * @param hit its hit
     * @param what the object that is hit
     */
    public void set(Ray ray, Hit hit, Object what) {
        material = what.surfaceMaterial;
        place = hit.place;
        t = hit.t;
        Vector d = ray.direction;
        point.set(ray.origin.x + d.x * t, ray.origin.y + d.y * t, ray.origin.z + d.z * t);
        what.surface(hit, this);
        enters = outward.dot(d) < 0;
        if (normal.dot(d) > 0) {                              // both sides of a surface are lit and mirror
            normal.negate();
        }
        height = Optics.lift(point, normal, t);
    }

    /** Moves the point to the other side of the surface, for a refracted ray. */
    void sink() {
        Optics.sink(point, normal, height);
    }
}
