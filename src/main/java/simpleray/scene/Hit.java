package simpleray.scene;

/**
 * The nearest hit of a ray so far, of two at the same t that of the object listed first. <em>Mutable</em>: one thread's own, used again for
 * each ray. It also keeps what meshes have worked out of the ray, until {@link #reset()}: whoever goes on to another ray must call that first.
 */
public final class Hit {
    /** No object. */
    public static final int NONE = -1;

    /** How far the hit is, in lengths of the ray's direction; infinite if there is none. */
    public double t = Double.POSITIVE_INFINITY;
    /** The place of the object in the scene, from 0; {@link #NONE} if there is no hit. */
    public int place = NONE;
    /** Which part of the object is hit: of a mesh a triangle; of others 0. */
    public int part;
    /** The weights of the three vertices of that triangle, of any sum but 0. */
    public final double[] weights = new double[3];

    private TriangleIntersector triangles;                              // of the rays that go through meshes

    /** Creates a hit of nothing. */
    public Hit() {
    }

    /** Forgets what was hit: another ray begins. */
    public void reset() {
        t = Double.POSITIVE_INFINITY;
        place = NONE;
        if (triangles != null) {
            triangles.mesh = null;
        }
    }

    /**
     * Tells whether another hit comes before this one.
     *
     * @param other its t; a miss is negative
     * @param of the place of the object that is hit there
     * @return whether it is nearer, or as near and of an object that is listed earlier
     */
    public boolean accepts(double other, int of) {
        return other >= 0 && (other < t || other == t && of < place);
    }

    /**
     * Takes a hit that comes before this one.
     *
     * @param nearer its t
     * @param of the place of the object that is hit there
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
