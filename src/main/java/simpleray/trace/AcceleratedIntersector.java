package simpleray.trace;

import java.util.Arrays;
import simpleray.accel.BvhTraversal;
import simpleray.accel.GridTraversal;
import simpleray.accel.LightBuffer;
import simpleray.accel.PrimitiveIntersector;
import simpleray.accel.Shaft;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.AreaLight;
import simpleray.scene.Hit;
import simpleray.scene.Intersector;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.RayStats;
import simpleray.scene.Sphere;

/** Finds hits in a {@link CompiledScene}. <em>Mutable</em>: one thread's own. */
final class AcceleratedIntersector implements Intersector, PrimitiveIntersector {
    /** The fewest points of an area light for which a shaft pays, and the most objects in it. */
    private static final int MIN_POINTS = 4;
    private static final int MAX_IN_SHAFT = 48;

    private final CompiledScene compiled;
    private final RayStats stats;
    private final BvhTraversal traversal;                     // null if there is a grid, or objects are few
    private final GridTraversal grid;                         // null if there is a tree, or objects are few
    private final double[] numbers;
    private final int unlisted;
    private final int firstPlane;
    private final int[] firstParts;
    private final int[] order;
    private final Object[] objects;

    // the current ray: its hit, or the distance of the light and the objects that dim it
    private Ray ray;
    private Hit hit;
    private double distance;
    private int plane;
    private final Hit scratch = new Hit();
    private int[] dimming = new int[16];                      // indices in the scene, in no order, perhaps repeated
    private int dimmers;

    // the objects between a point and an area light, the one that blocked last at first
    private final int[] inShaft = new int[MAX_IN_SHAFT];
    private final Shaft shaft = new Shaft(inShaft);
    private final PointLight lamp = new PointLight();
    private int shaftSize = Shaft.NO_LIST;

    AcceleratedIntersector(CompiledScene compiled, RayStats stats) {
        this.compiled = compiled;
        this.stats = stats;
        numbers = compiled.numbers;
        unlisted = compiled.unlisted;
        firstPlane = compiled.firstPlane;
        firstParts = compiled.firstParts;
        order = compiled.order;
        objects = compiled.objects;
        traversal = compiled.bvh == null ? null : new BvhTraversal(this);
        grid = compiled.grid == null ? null : new GridTraversal(compiled.grid, this);
    }

    @Override
    public boolean intersect(Ray ray, Hit hit) {
        this.ray = ray;
        this.hit = hit;
        hit.reset();
        double t = nearestPlane();
        if (t < Double.POSITIVE_INFINITY) {
            hit.set(t, order[plane]);
        }
        if (unlisted < firstPlane) {
            closest(null, unlisted, firstPlane);
        }
        Point o = ray.origin;
        Vector d = ray.direction;
        Point eye = compiled.eye;
        if (compiled.eyeBuffer != null && o.x == eye.x && o.y == eye.y && o.z == eye.z) {
            LightBuffer buffer = compiled.eyeBuffer;          // the parts in this direction that may be nearer than the hit
            int cell = buffer.cell(d.x, d.y, d.z);
            int end = buffer.start(cell + 1);
            for (int k = buffer.start(cell); k < end && buffer.near(k) <= hit.t; k++) {
                int part = buffer.primitive(k);
                if (firstParts == null) {
                    closest(null, part, part + 1);
                } else {
                    int i = compiled.owner(part);
                    objects[i].intersect(ray, order[i], part - firstParts[i], hit);
                    stats.tests++;
                }
            }
        } else if (traversal != null) {
            traversal.closest(compiled.bvh, o.x, o.y, o.z, d.x, d.y, d.z, hit.t);
            stats.steps = traversal.steps;
        } else if (grid != null) {
            grid.closest(ray, hit.t);
            stats.steps = grid.steps;
        }
        return hit.place != Hit.NONE;
    }

    @Override
    public boolean occluded(Ray ray, double distance, int light, Colour left) {
        this.ray = ray;
        this.distance = distance;
        scratch.reset();
        scratch.t = distance;
        dimmers = 0;
        boolean blocked = nearestPlane() < distance && planeBlocks()
            || unlisted < firstPlane && occluded(null, unlisted, firstPlane);
        if (blocked) {
            left.reset();
            return true;
        }
        LightBuffer buffer = compiled.lightBuffers[light];
        Point o = ray.origin;
        Vector d = ray.direction;
        if (buffer != null && distance <= buffer.reach()) {
            // the parts in the direction from the light to the point
            int cell = buffer.cell(-d.x, -d.y, -d.z);
            int end = buffer.start(cell + 1);
            for (int k = buffer.start(cell); k < end && !blocked && buffer.near(k) <= distance; k++) {
                int part = buffer.primitive(k);
                if (firstParts == null) {
                    blocked = occluded(null, part, part + 1);
                } else {
                    int i = compiled.owner(part);
                    blocked = objects[i].occludes(ray, distance, part - firstParts[i], scratch) && blocks(i);
                    stats.tests++;
                }
            }
        } else if (shaftSize != Shaft.NO_LIST) {
            blocked = occludedInShaft();
        } else if (traversal != null) {
            blocked = traversal.occluded(compiled.bvh, o.x, o.y, o.z, d.x, d.y, d.z, distance);
            stats.steps = traversal.steps;
        } else if (grid != null) {
            blocked = grid.occluded(ray, distance);
            stats.steps = grid.steps;
        }
        if (blocked) {
            left.reset();
        } else if (dimmers > 0) {
            dim(left);
        }
        return left.isBlack();
    }

    @Override
    public void approach(Point from, AreaLight light) {
        int last = light.side - 1;
        if (traversal != null && light.points() >= MIN_POINTS) {
            shaft.set(0, from.x, from.y, from.z);
            setCorner(1, light, 0);
            setCorner(2, light, last);
            setCorner(3, light, light.points() - 1);
            setCorner(4, light, light.points() - 1 - last);
            shaftSize = shaft.primitives(compiled.bvh);
        }
    }

    private void setCorner(int i, AreaLight light, int point) {
        light.point(point, lamp);
        shaft.set(i, lamp.origin.x, lamp.origin.y, lamp.origin.z);
    }

    @Override
    public void leave() {
        shaftSize = Shaft.NO_LIST;
    }

    /** {@return whether an object in the shaft blocks the ray} It is then the first to be asked for the next ray. */
    private boolean occludedInShaft() {
        for (int k = 0; k < shaftSize; k++) {
            if (occluded(inShaft, k, k + 1)) {
                int blocker = inShaft[k];
                inShaft[k] = inShaft[0];
                inShaft[0] = blocker;
                return true;
            }
        }
        return false;
    }

    /** {@return t of the ray's nearest hit on a plane, infinite if it hits none} Notes the plane; of two at one t, the first. */
    private double nearestPlane() {
        Point o = ray.origin;
        double x = o.x;
        double y = o.y;
        double z = o.z;
        Vector d = ray.direction;
        double dx = d.x;
        double dy = d.y;
        double dz = d.z;
        double[] n = numbers;
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = firstPlane; i < objects.length; i++) {
            double a = n[4 * i];
            double b = n[4 * i + 1];
            double c = n[4 * i + 2];
            double t = Plane.hit(n[4 * i + 3] - (a * x + b * y + c * z), a * dx + b * dy + c * dz);
            if (t >= 0 && t < nearest) {
                nearest = t;
                plane = i;
            }
        }
        stats.tests += objects.length - firstPlane;
        return nearest;
    }

    /** {@return whether a plane blocks the ray} Notes the planes that dim it. Few block: mostly the scene lies on one side of each. */
    private boolean planeBlocks() {
        for (int i = firstPlane; i < objects.length; i++) {
            if (objects[i].occludes(ray, distance, scratch) && blocks(i)) {
                return true;
            }
        }
        return false;
    }

    @Override
    public double closest(int[] list, int first, int end) {
        for (int k = first; k < end; k++) {
            int i = list == null ? k : list[k];
            if (numbers[4 * i + 3] > 0) {
                double t = sphere(i);
                if (hit.accepts(t, order[i])) {
                    hit.set(t, order[i]);
                }
            } else {
                objects[i].intersect(ray, order[i], hit);
            }
        }
        stats.tests += end - first;
        return hit.t;
    }

    /** {@return t of the ray's hit on a sphere} */
    private double sphere(int i) {
        Point o = ray.origin;
        Vector d = ray.direction;
        double[] n = numbers;
        return Sphere.hit(o.x - n[4 * i], o.y - n[4 * i + 1], o.z - n[4 * i + 2], d.x, d.y, d.z, n[4 * i + 3]);
    }

    @Override
    public boolean occluded(int[] list, int first, int end) {
        for (int k = first; k < end; k++) {
            int i = list == null ? k : list[k];
            boolean isSphere = numbers[4 * i + 3] > 0;
            if ((isSphere ? scratch.accepts(sphere(i), order[i]) : objects[i].occludes(ray, distance, scratch)) && blocks(i)) {
                stats.tests += k - first + 1;
                return true;
            }
        }
        stats.tests += end - first;
        return false;
    }

    /** {@return whether an object in the way is opaque} Notes it if it is not. */
    private boolean blocks(int i) {
        if (compiled.opaque[i]) {
            return true;
        }
        if (dimmers == dimming.length) {
            dimming = Arrays.copyOf(dimming, 2 * dimmers);
        }
        dimming[dimmers++] = order[i];
        return false;
    }

    /** Dims a light once by each noted object, in the order of the scene: the last bit of the product depends on the order. */
    private void dim(Colour left) {
        Arrays.sort(dimming, 0, dimmers);
        for (int k = 0; k < dimmers && !left.isBlack(); k++) {
            if (k == 0 || dimming[k] != dimming[k - 1]) {     // an object in several lists is noted several times
                left.mult(compiled.scene.getObject(dimming[k]).transmitted(ray, distance, scratch));
            }
        }
    }
}
