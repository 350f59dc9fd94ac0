package simpleray.scene;

import java.io.IOException;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** Something that a ray can hit (thesis, chapter 5). Not {@link java.lang.Object}, which each class extends anyway. */
public abstract class Object implements SceneElement {
    /** What {@link #intersect} returns for a miss. */
    public static final double MISS = -1;
    /** Hits at this t or below are no hits, so that a ray does not hit the surface it starts on. */
    public static final double THRESHOLD = 1e-7;

    /** What the surface is made of; kept, not copied, and perhaps another object's too. */
    public Material surfaceMaterial;

    /**
     * For subclasses.
     *
     * @param material the material, referenced
     */
    protected Object(Material material) {
        surfaceMaterial = material;
    }

    /**
     * Finds the nearest hit of a ray. Any thread may call.
     *
     * @param ray the ray; its direction need not be of unit length
     * @return t of the hit, above {@link #THRESHOLD}, in lengths of the ray's direction; {@link #MISS}, which is negative, if none
     */
    public abstract double intersect(Ray ray);

    /**
     * Finds the normal at a point of the surface without a new vector, where a kind can. Any thread may call.
     *
     * @param pt the point
     * @param out gets what {@link #normal(Point)} returns
     */
    public void normal(Point pt, Vector out) {
        out.copy(normal(pt));
    }

    /**
     * Offers the nearest hit of a ray. Any thread may call, each with a hit of its own. An object of many parts may look no farther than what
     * was found already.
     *
     * @param ray the ray; its direction need not be of unit length
     * @param place the object's place in the scene, from 0
     * @param hit becomes this object's if that comes before it; reset since the ray before
     */
    public void intersect(Ray ray, int place, Hit hit) {
        double t = intersect(ray);
        if (hit.accepts(t, place)) {
            hit.set(t, place);
        }
    }

    /** {@return how many parts it has that can be tested one by one; most have one} */
    public int parts() {
        return 1;
    }

    /**
     * Finds the box of a part. To be asked only if {@link #bounds()} is not null. Any thread may call.
     *
     * @param part the part, from 0
     * @param box gets xmin, ymin, zmin, xmax, ymax, zmax
     */
    public void partBounds(int part, double[] box) {
        bounds().get(box);
    }

    /**
     * Offers the hit of a ray on a part, as {@link #intersect(Ray, int, Hit)} does that on the whole.
     *
     * @param ray the ray
     * @param place the object's place in the scene, from 0
     * @param part the part, from 0
     * @param hit becomes this object's if that comes before it
     */
    public void intersect(Ray ray, int place, int part, Hit hit) {
        intersect(ray, place, hit);
    }

    /**
     * Tells whether a ray hits a part before some distance, as {@link #occludes(Ray, double, Hit)} does of the whole.
     *
     * @param ray the ray
     * @param distance the distance, in lengths of the ray's direction
     * @param part the part, from 0
     * @param scratch working space, the calling thread's own, reset since the ray before
     * @return whether it does
     */
    public boolean occludes(Ray ray, double distance, int part, Hit scratch) {
        return occludes(ray, distance, scratch);
    }

    /**
     * Makes ready what hits need, if there is anything; else it is made when first it is needed.
     *
     * @param threads how many threads may work on it
     */
    public void prepare(int threads) {
        // most objects need nothing
    }

    /**
     * Tells whether a ray hits the object before some distance. Any thread may call.
     *
     * @param ray the ray; its direction need not be of unit length
     * @param distance the distance, in lengths of the ray's direction
     * @param scratch working space, the calling thread's own, reset since the ray before
     * @return whether {@link #intersect(Ray)} finds a hit there
     */
    public boolean occludes(Ray ray, double distance, Hit scratch) {
        double t = intersect(ray);
        return t >= 0 && t < distance;
    }

    /**
     * Finds the normal at a point of the surface. Any thread may call.
     *
     * @param pt the point
     * @return a new vector of unit length, which the caller may change; outward where there is an outside
     */
    public abstract Vector normal(Point pt);

    /**
     * Finds a box that holds the object. Any thread may call.
     *
     * @return the box; null if the object is infinite
     */
    public abstract Bounds bounds();

    /**
     * Finds the normals at a hit. Any thread may call.
     *
     * @param hit what {@link #intersect(Ray, int, Hit)} found
     * @param at its point is where the hit is; gets both normals, of unit length and outward, which are one unless vertex normals make
     *     facets look round
     */
    public void surface(Hit hit, Interaction at) {
        normal(at.point, at.outward);
        at.normal.copy(at.outward);
    }

    /**
     * Prints the object as the thesis's Interpretation does, two lines without the last line break.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    @Override
    public abstract void print(SceneWriter os) throws IOException;

    /**
     * Reads the object, its material last, all but the code of its kind.
     *
     * @param is where from
     * @throws IOException if it is not there or makes no object
     */
    @Override
    public abstract void read(SceneReader is) throws IOException;

    /**
     * Writes the object, so that {@link #read} gets an equal one.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    @Override
    public abstract void write(SceneWriter os) throws IOException;

    /** {@return whether it is closed all around, and thus has an inside that is not infinite} */
    public boolean isSolid() {
        return false;
    }

    /**
     * Reads the object's material, which is that of an earlier object if they are equal.
     *
     * @param is where from
     * @throws IOException if it is not there
     */
    protected final void readMaterial(SceneReader is) throws IOException {
        surfaceMaterial = is.kept(Materials.class, Materials.MAKER).read(is);
    }
}
