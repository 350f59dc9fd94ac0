package simpleray.math;

/** A half-line, P = O + D t for t &gt; 0 (thesis, chapter 3). <em>Mutable.</em> */
public final class Ray {
    /** Where the ray begins. */
    public Point origin;
    /** Where it goes; t counts in lengths of this vector, which for the rays of a camera is 1. */
    public Vector direction;

    /** Creates a ray from the origin down the z axis, as the viewer looks. */
    public Ray() {
        this(new Point(), new Vector(0, 0, -1));
    }

    /**
     * Creates a ray. The values are referenced, not copied.
     *
     * @param origin where it begins
     * @param direction where it goes; not zero
     */
    public Ray(Point origin, Vector direction) {
        this.origin = origin;
        this.direction = direction;
    }

    /**
     * Finds a point along the ray.
     *
     * @param t how far along, in lengths of the direction
     * @return a new point, O + D t
     */
    public Point getPointAt(double t) {
        return Point.add(origin, Vector.scale(direction, t));
    }
}
