package simpleray.trace;

import java.util.Arrays;
import simpleray.accel.BvhTraversal;
import simpleray.accel.CellIntersector;
import simpleray.accel.GridTraversal;
import simpleray.accel.LeafIntersector;
import simpleray.accel.LightBuffer;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Hit;
import simpleray.scene.Intersector;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.RayStats;
import simpleray.scene.Sphere;

/** Finds hits in a {@link CompiledScene}. <em>Mutable</em>: one thread's own. */
final class AcceleratedIntersector implements Intersector, LeafIntersector, CellIntersector {
    private final CompiledScene compiled;
    private final RayStats stats;
    private final BvhTraversal traversal;                     // null if there is a grid, or objects are few
    private final GridTraversal grid;                         // null if there is a tree, or objects are few
    private final double[] spheres;
    private final int[] order;
    private final Object[] objects;

    // the ray in question: what it hits, or how far the light is and what dims it
    private Ray ray;
    private Hit hit;
    private double distance;
    private final Hit scratch = new Hit();
    private int[] dimming = new int[16];                      // places in the scene, in no order, some perhaps more than once
    private int dimmers;

    AcceleratedIntersector(CompiledScene compiled, RayStats stats) {
        this.compiled = compiled;
        this.stats = stats;
        spheres = compiled.spheres;
        order = compiled.order;
        objects = compiled.objects;
        traversal = compiled.bvh == null ? null : new BvhTraversal(this);
        grid = compiled.grid == null ? null : new GridTraversal(compiled.grid, this, this);
    }

    @Override
    public boolean intersect(Ray ray, Hit hit) {
        this.ray = ray;
        this.hit = hit;
        hit.reset();
        Point o = ray.origin;
        Point eye = compiled.eye;
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = compiled.bounded; i < compiled.afterPlanes; i++) {   // in the order of the scene: of two at one t the first stays
            double t = plane(i);
            if (t >= 0 && t < nearest) {
                nearest = t;
                hit.set(t, order[i]);
            }
        }
        for (int i = compiled.afterPlanes; i < objects.length; i++) {
            objects[i].intersect(ray, order[i], hit);
        }
        stats.tests += objects.length - compiled.bounded;
        if (compiled.eyeBuffer != null && o.x == eye.x && o.y == eye.y && o.z == eye.z) {
            closest(compiled.eyeBuffer);
        } else if (traversal != null) {
            Vector d = ray.direction;
            traversal.closest(compiled.bvh, o.x, o.y, o.z, d.x, d.y, d.z, hit.t);
            stats.steps = traversal.steps;
        } else if (grid != null) {
            grid.closest(ray, hit.t);
            stats.steps = grid.steps;
        } else {
            closest(0, compiled.bounded);
        }
        return hit.place != Hit.NONE;
    }

    /** Asks the parts that lie in the ray's direction from the eye, until the rest is farther away than the nearest hit. */
    private void closest(LightBuffer buffer) {
        Vector d = ray.direction;
        int cell = buffer.cell(d.x, d.y, d.z);
        int first = buffer.start(cell);
        int end = buffer.start(cell + 1);
        int k = first;
        for (; k < end && buffer.near(buffer.primitive(k)) <= hit.t; k++) {
            int part = buffer.primitive(k);
            if (compiled.firstParts == null) {
                test(part);
            } else {
                int i = compiled.owner(part);
                objects[i].intersect(ray, order[i], part - compiled.firstParts[i], hit);
            }
        }
        stats.tests += k - first;
    }

    @Override
    public double closest(int first, int end) {
        for (int i = first; i < end; i++) {
            test(i);
        }
        stats.tests += end - first;
        return hit.t;
    }

    @Override
    public double closest(int[] list, int first, int end) {
        for (int k = first; k < end; k++) {
            test(list[k]);
        }
        stats.tests += end - first;
        return hit.t;
    }

    /** Offers the hit of the ray on a bounded object. */
    private void test(int i) {
        if (spheres[4 * i + 3] > 0) {
            double t = sphere(4 * i);
            if (hit.accepts(t, order[i])) {
                hit.set(t, order[i]);
            }
        } else {
            objects[i].intersect(ray, order[i], hit);
        }
    }

    private double sphere(int at) {
        Point o = ray.origin;
        Vector d = ray.direction;
        return Sphere.hit(o.x - spheres[at], o.y - spheres[at + 1], o.z - spheres[at + 2], d.x, d.y, d.z, spheres[at + 3]);
    }

    private double plane(int i) {
        int at = 4 * (i - compiled.bounded);
        Point o = ray.origin;
        Vector d = ray.direction;
        double nx = compiled.planes[at];
        double ny = compiled.planes[at + 1];
        double nz = compiled.planes[at + 2];
        return Plane.hit(compiled.planes[at + 3] - (nx * o.x + ny * o.y + nz * o.z), nx * d.x + ny * d.y + nz * d.z);
    }

    @Override
    public boolean occluded(Ray ray, double distance, int light, Colour left) {
        this.ray = ray;
        this.distance = distance;
        scratch.reset();
        dimmers = 0;
        if (isBlocked(light)) {
            left.reset();
        } else if (dimmers > 0) {
            dim(left);
        }
        return left.isBlack();
    }

    /** {@return whether anything opaque is in the way to a light}; notes what dims it */
    private boolean isBlocked(int light) {
        for (int i = compiled.bounded; i < compiled.afterPlanes; i++) {
            double t = plane(i);
            if (t >= 0 && t < distance && blocks(i)) {
                stats.tests += i - compiled.bounded + 1;
                return true;
            }
        }
        stats.tests += objects.length - compiled.bounded;
        for (int i = compiled.afterPlanes; i < objects.length; i++) {
            if (objects[i].occludes(ray, distance, scratch) && blocks(i)) {
                return true;
            }
        }
        boolean blocked = false;
        LightBuffer buffer = compiled.lightBuffers[light];
        if (buffer != null && distance <= buffer.reach()) {
            blocked = occluded(buffer);
        } else if (traversal != null) {
            Point o = ray.origin;
            Vector d = ray.direction;
            blocked = traversal.occluded(compiled.bvh, o.x, o.y, o.z, d.x, d.y, d.z, distance);
            stats.steps = traversal.steps;
        } else if (grid != null) {
            blocked = grid.occluded(ray, distance);
            stats.steps = grid.steps;
        } else {
            blocked = occluded(0, compiled.bounded);
        }
        return blocked;
    }

    /** {@return whether anything opaque is in the way to a light, of the parts that are as near to it as the ray's origin} */
    private boolean occluded(LightBuffer buffer) {
        Vector d = ray.direction;
        int cell = buffer.cell(-d.x, -d.y, -d.z);
        int first = buffer.start(cell);
        int end = buffer.start(cell + 1);
        boolean blocked = false;
        int k = first;
        for (; k < end && !blocked && buffer.near(buffer.primitive(k)) <= distance; k++) {
            int part = buffer.primitive(k);
            int i = compiled.owner(part);
            blocked = (compiled.firstParts == null ? occludes(i)
                : objects[i].occludes(ray, distance, part - compiled.firstParts[i], scratch)) && blocks(i);
        }
        stats.tests += k - first;
        return blocked;
    }

    @Override
    public boolean occluded(int first, int end) {
        for (int i = first; i < end; i++) {
            if (occludes(i) && blocks(i)) {
                stats.tests += i - first + 1;
                return true;
            }
        }
        stats.tests += end - first;
        return false;
    }

    @Override
    public boolean occluded(int[] list, int first, int end) {
        for (int k = first; k < end; k++) {
            if (occludes(list[k]) && blocks(list[k])) {
                stats.tests += k - first + 1;
                return true;
            }
        }
        stats.tests += end - first;
        return false;
    }

    /** {@return whether a bounded object is in the way} */
    private boolean occludes(int i) {
        if (spheres[4 * i + 3] > 0) {
            double t = sphere(4 * i);
            return t >= 0 && t < distance;
        }
        return objects[i].occludes(ray, distance, scratch);
    }

    /** {@return whether an object that is in the way is opaque}; notes it if it is not */
    private boolean blocks(int i) {
        if (objects[i].surfaceMaterial.transmission.isBlack()) {
            return true;
        }
        if (dimmers == dimming.length) {
            dimming = Arrays.copyOf(dimming, 2 * dimmers);
        }
        dimming[dimmers++] = order[i];
        return false;
    }

    /** Dims a light by all that lets some through, once each, in the order of the scene: products depend on it in the last bit. */
    private void dim(Colour left) {
        Arrays.sort(dimming, 0, dimmers);
        for (int k = 0; k < dimmers && !left.isBlack(); k++) {
            if (k == 0 || dimming[k] != dimming[k - 1]) {     // one in several lists is met several times
                left.mult(compiled.scene.getObject(dimming[k]).surfaceMaterial.transmission);
            }
        }
    }
}
