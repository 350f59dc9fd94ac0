package simpleray.accel;

import java.util.Arrays;
import simpleray.math.Bounds;
import simpleray.math.Ray;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;

/**
 * The objects of a scene in flat arrays, the bounded ones first and in the order of a tree's leaves: a place here is not the object's
 * place in the scene. <em>Constant.</em>
 */
final class Primitives {
    /** Kinds of objects: spheres that are bounded, planes, and all others. */
    static final int SPHERE = 0;
    static final int PLANE = 1;
    static final int OTHER = -1;

    /** Beyond this a float cannot say where something is. */
    private static final double FARTHEST = 1e17;

    /** How many are bounded; planes follow them. */
    final int bounded;
    /** From how far away a ray towards a light or so may come to find its way among the bounded ones. */
    final double reach;
    /** Where the planes end, and all else that is not bounded begins. */
    final int afterPlanes;
    /** The place of each in the scene. */
    final int[] order;
    /** What each is made of. */
    final Material[] materials;
    /** The objects themselves. */
    final Object[] objects;
    /** Four numbers each: a sphere's centre and radius, or zeros. */
    final double[] spheres;
    /** Four numbers for each plane: its normal and constant. */
    final double[] planes;
    /** Whether none lets light through. */
    final boolean opaque;

    Primitives(Object[] all, Boxes boxes, int[] unbounded) {
        bounded = boxes == null ? 0 : boxes.count();
        reach = boxes == null ? 0 : boxes.reach();
        int count = all.length;
        order = new int[count];
        if (boxes != null) {
            System.arraycopy(boxes.ids, 0, order, 0, bounded);
        }
        int next = bounded;
        for (int place : unbounded) {
            if (all[place] instanceof Plane) {
                order[next++] = place;
            }
        }
        afterPlanes = next;
        for (int place : unbounded) {
            if (!(all[place] instanceof Plane)) {
                order[next++] = place;
            }
        }
        materials = new Material[count];
        objects = new Object[count];
        spheres = new double[4 * bounded];
        planes = new double[4 * (afterPlanes - bounded)];
        boolean allOpaque = true;
        int[] ranks = ranks(order);
        for (int place = 0; place < count; place++) {         // of the scene: so they lie in memory
            int i = ranks[place];
            Object object = all[place];
            objects[i] = object;
            materials[i] = object.surfaceMaterial;
            allOpaque &= materials[i].transmission.isBlack();
            if (i < bounded && object instanceof Sphere sphere) {
                set(spheres, i, sphere.centre.x, sphere.centre.y, sphere.centre.z, sphere.radius);
            } else if (i >= bounded && object instanceof Plane plane) {
                set(planes, i - bounded, plane.normal.x, plane.normal.y, plane.normal.z, plane.constant);
            }
        }
        opaque = allOpaque;
    }

    /** {@return where each place is in an order of them} */
    private static int[] ranks(int[] order) {
        int[] ranks = new int[order.length];
        for (int i = 0; i < order.length; i++) {
            ranks[order[i]] = i;
        }
        return ranks;
    }

    private static void set(double[] numbers, int i, double a, double b, double c, double d) {
        numbers[4 * i] = a;
        numbers[4 * i + 1] = b;
        numbers[4 * i + 2] = c;
        numbers[4 * i + 3] = d;
    }

    int count() {
        return order.length;
    }

    /** {@return the places of the objects whose bounds a tree can hold, in order} */
    static int[] bounded(Object[] all) {
        int[] places = new int[all.length];
        int count = 0;
        for (int i = 0; i < all.length; i++) {
            if (isBounded(all[i])) {
                places[count++] = i;
            }
        }
        return Arrays.copyOf(places, count);
    }

    /** {@return the places of all others, in order} */
    static int[] others(int count, int[] bounded) {
        int[] others = new int[count - bounded.length];
        int next = 0;
        for (int i = 0, k = 0; i < count; i++) {
            if (k < bounded.length && bounded[k] == i) {
                k++;
            } else {
                others[next++] = i;
            }
        }
        return others;
    }

    private static boolean isBounded(Object object) {
        Bounds b = object.bounds();
        return b != null && small(b.xmin()) && small(b.ymin()) && small(b.zmin()) && small(b.xmax()) && small(b.ymax()) && small(b.zmax());
    }

    private static boolean small(double d) {
        return Math.abs(d) < FARTHEST;                        // a NaN is not
    }

    static Object[] objects(Scene scene) {
        Object[] all = new Object[scene.getNumberObjects()];
        for (int i = 0; i < all.length; i++) {
            all[i] = scene.getObject(i);
        }
        return all;
    }

    /** {@return what kind the object at a place is of} */
    int kind(int place) {
        return place < bounded ? spheres[4 * place + 3] > 0 ? SPHERE : OTHER : place < afterPlanes ? PLANE : OTHER;
    }

    /** Copies the four numbers of a sphere or plane; of all else nothing. */
    void copy(int place, double[] numbers, int at) {
        if (place < bounded) {
            System.arraycopy(spheres, 4 * place, numbers, at, 4);
        } else if (place < afterPlanes) {
            System.arraycopy(planes, 4 * (place - bounded), numbers, at, 4);
        }
    }

    /** {@return t of the hit of a ray on the bounded object at a place, or {@link Object#MISS}} */
    double intersectBounded(int place, Ray ray) {
        int at = 4 * place;
        double radius = spheres[at + 3];
        if (radius > 0) {
            Point o = ray.origin;
            Vector d = ray.direction;
            return Sphere.hit(o.x - spheres[at], o.y - spheres[at + 1], o.z - spheres[at + 2], d.x, d.y, d.z, radius);
        }
        return objects[place].intersect(ray);
    }
}
