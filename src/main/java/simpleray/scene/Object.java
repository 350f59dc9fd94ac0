package simpleray.scene;

import java.io.IOException;
import simpleray.math.Bounds;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** An object that a ray can hit (thesis, chapter 5). Not {@link java.lang.Object}, which each class extends anyway. */
public abstract class Object implements SceneElement {
    /** The result of {@link #intersect} for a miss. */
    public static final double MISS = -1;
    /** Hits at this t or below do not count, so that a ray does not hit the surface it starts on. */
    public static final double THRESHOLD = 1e-7;

    /** The material of the surface; kept, not copied, and perhaps shared with other objects. */
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
     * Computes the normal at a point of the surface, without a new vector if the kind overrides this. Any thread may call.
     *
     * @param pt the point
     * @param out gets the result of {@link #normal(Point)}
     */
    public void normal(Point pt, Vector out) {
        out.copy(normal(pt));
    }

    /**
     * Finds the nearest hit of a ray, if it comes before the hit so far. Any thread may call, each with a hit of its own. An object of many
     * parts may search no farther than the hit so far.
     *
     * @param ray the ray; its direction need not be of unit length
     * @param place the object's index in the scene
     * @param hit is replaced if this object's comes before it; must be reset for each ray
     */
    public void intersect(Ray ray, int place, Hit hit) {
        double t = intersect(ray);
        if (hit.accepts(t, place)) {
            hit.set(t, place);
        }
    }

    /** {@return the number of parts that can be tested one by one; 1 for most objects} */
    public int parts() {
        return 1;
    }

    /**
     * Computes the box of a part, if {@link #bounds()} is not null. Any thread may call.
     *
     * @param part the part, from 0
     * @param box gets xmin, ymin, zmin, xmax, ymax, zmax
     */
    public void partBounds(int part, double[] box) {
        bounds().get(box);
    }

    /**
     * Finds the hit of a ray on a part, as {@link #intersect(Ray, int, Hit)} on the whole.
     *
     * @param ray the ray
     * @param place the object's index in the scene
     * @param part the part, from 0
     * @param hit is replaced if this object's comes before it
     */
    public void intersect(Ray ray, int place, int part, Hit hit) {
        intersect(ray, place, hit);
    }

    /**
     * Tests whether a ray hits a part before some distance, as {@link #occludes(Ray, double, Hit)} for the whole.
     *
     * @param ray the ray
     * @param distance the distance, in lengths of the ray's direction
     * @param part the part, from 0
     * @param scratch working space, the calling thread's own; must be reset for each ray
     * @return whether there is a hit
     */
    public boolean occludes(Ray ray, double distance, int part, Hit scratch) {
        return occludes(ray, distance, scratch);
    }

    /**
     * Builds what intersection needs, such as a mesh's tree, which is otherwise built at the first hit.
     *
     * @param threads the number of threads to use
     */
    public void prepare(int threads) {
        // most objects need nothing
    }

    /**
     * Tests whether a ray hits the object before some distance. Any thread may call.
     *
     * @param ray the ray; its direction need not be of unit length
     * @param distance the distance, in lengths of the ray's direction
     * @param scratch working space, the calling thread's own; must be reset for each ray
     * @return whether there is a hit
     */
    public boolean occludes(Ray ray, double distance, Hit scratch) {
        double t = intersect(ray);
        return t >= 0 && t < distance;
    }

    /**
     * Returns the normal at a point of the surface. Any thread may call.
     *
     * @param pt the point
     * @return a new vector of unit length, which the caller may change; outward where there is an outside
     */
    public abstract Vector normal(Point pt);

    /**
     * Returns a box that contains the object. Any thread may call.
     *
     * @return the box; null if the object is infinite
     */
    public abstract Bounds bounds();

    /**
     * Computes the normals at a hit. Any thread may call.
     *
     * @param hit the hit, from {@link #intersect(Ray, int, Hit)}
     * @param at has the hit point, and gets both normals, of unit length and outward; they differ only where vertex normals make facets
     *     look round. It has the object's material, and gets another if there it has another
     */
    public void surface(Hit hit, Interaction at) {
        normal(at.point, at.outward);
        at.normal.copy(at.outward);
    }

    /**
     * Returns this object in another place. Any thread may call.
     *
     * @param t the offset from where it is
     * @return a new object, of the same material; a mesh has the same triangles, not a copy
     * @throws IllegalArgumentException if no scene may have it there, such as {@code numbers from -1e100 to 1e100} exceeded; the message
     *     says what is expected
     */
    public abstract Object moved(Vector t);

    /**
     * Prints the object as the thesis's Interpretation does, two lines without the last line break.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    @Override
    public abstract void print(SceneWriter os) throws IOException;

    /**
     * Reads the object without the code of its kind, and its material last.
     *
     * @param is where from
     * @throws IOException if it is missing or is no object
     */
    @Override
    public abstract void read(SceneReader is) throws IOException;

    /**
     * Writes the object in the form that {@link #read} reads.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    @Override
    public abstract void write(SceneWriter os) throws IOException;

    /**
     * Returns the material of a part.
     *
     * @param part the part, from 0
     * @return its material, not a copy
     */
    public Material material(int part) {
        return surfaceMaterial;
    }

    /** {@return whether no light passes through it} */
    public boolean isOpaque() {
        return surfaceMaterial.transmission.isBlack();
    }

    /**
     * Returns the share of light that passes through the object where a ray hits it, once or more, before some distance. Any thread may call.
     *
     * @param ray the ray; its direction need not be of unit length
     * @param distance the distance, in lengths of the ray's direction
     * @param scratch working space, the calling thread's own; must be reset for each ray
     * @return the share, not to be changed
     */
    public Colour transmitted(Ray ray, double distance, Hit scratch) {
        return surfaceMaterial.transmission;
    }

    /** {@return whether it is closed all around, and thus has an inside that is not infinite} */
    public boolean isSolid() {
        return false;
    }

    /**
     * Reads the object's material, or refers to an equal one read before.
     *
     * @param is where from
     * @throws IOException if it is missing
     */
    protected final void readMaterial(SceneReader is) throws IOException {
        surfaceMaterial = is.kept(Materials.class, Materials.MAKER).read(is);
    }
}
