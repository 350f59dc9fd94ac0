package simpleray.scene;

/**
 * The nearest hit of a ray so far; of two at the same t, that of the object listed first. <em>Mutable</em>: one thread's own, reused for
 * each ray. It also caches what meshes computed for the ray; call {@link #reset()} before the next ray.
 */
public final class Hit {
    /** No object. */
    public static final int NONE = -1;

    /** The distance of the hit, in lengths of the ray's direction; infinite if there is none. */
    public double t = Double.POSITIVE_INFINITY;
    /** The index of the object in the scene; {@link #NONE} if there is no hit. */
    public int place = NONE;
    /** The part of the object that is hit: the triangle of a mesh, or 0. */
    public int part;
    /** The weights of the three vertices of that triangle, of any sum but 0. */
    public final double[] weights = new double[3];

    private TriangleIntersector triangles;                              // for rays through meshes

    /** Creates an empty hit. */
    public Hit() {
    }

    /** Clears the hit for another ray. */
    public void reset() {
        t = Double.POSITIVE_INFINITY;
        place = NONE;
        if (triangles != null) {
            triangles.mesh = null;
        }
    }

    /**
     * Tests whether another hit comes before this one.
     *
     * @param other its t; negative for a miss
     * @param of the index of its object
     * @return whether it is nearer, or equally near and its object is listed earlier
     */
    public boolean accepts(double other, int of) {
        return other >= 0 && (other < t || other == t && of < place);
    }

    /**
     * Replaces this hit by one that comes before it.
     *
     * @param nearer its t
     * @param of the index of its object
     */
    public void set(double nearer, int of) {
        t = nearer;
        place = of;
        part = 0;
    }

    TriangleIntersector triangles() {
        if (triangles == null) {
            triangles = new TriangleIntersector();
        }
        return triangles;
    }
}
