package simpleray.math;

/** A half-line, P = O + D t for t &gt; 0 (thesis, chapter 3). <em>Mutable.</em> */
public final class Ray {
    /** The origin of the ray. */
    public Point origin;
    /** The direction; t is in lengths of this vector, which is 1 for the rays of a camera. */
    public Vector direction;

    /** Creates a ray from the origin down the z axis, as the viewer looks. */
    public Ray() {
        this(new Point(), new Vector(0, 0, -1));
    }

    /**
     * Creates a ray. The values are referenced, not copied.
     *
     * @param origin the origin
     * @param direction the direction; not zero
     */
    public Ray(Point origin, Vector direction) {
        this.origin = origin;
        this.direction = direction;
    }

    /**
     * Returns a point on the ray.
     *
     * @param t the distance along the ray, in lengths of the direction
     * @return a new point, O + D t
     */
    public Point getPointAt(double t) {
        return Point.add(origin, Vector.scale(direction, t));
    }
}
