package simpleray.trace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simpleray.accel.Bvh;
import simpleray.accel.LightBuffer;
import simpleray.accel.Pool;
import simpleray.accel.PrimitiveBounds;
import simpleray.accel.UniformGrid;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.scene.AreaLight;
import simpleray.scene.Intersector;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;

/**
 * A scene compiled for fast rendering: its objects in flat arrays, the bounded ones first and in the order of a tree's leaves, planes
 * last; a grid or tree of the bounded ones; and light buffers for the eye and the lights. <em>Constant</em>, as long as the scene is;
 * any thread may ask for an intersector.
 */
public final class CompiledScene {
    /** The fewest objects for which a grid pays, and the fewest parts for which a tree and a light buffer pay. */
    private static final int MIN_MANY = 9;
    /** The most parts in light buffers; longer lists would fit into no cache. */
    private static final int MAX_PARTS = 1 << 22;
    /** The most lights with a buffer of their own. */
    private static final int MAX_BUFFERS = 8;
    /** The largest coordinate of an object in a grid or tree. */
    private static final double MAX_COORDINATE = 1e17;

    final Scene scene;
    /** The origin of primary rays; null if they have none in common. */
    final Point eye;
    /** The number of bounded objects. */
    final int bounded;
    /** The index of the first plane; planes come last. */
    final int firstPlane;
    /** The index of the first object that is in no grid and no tree; each ray is tested with these. */
    final int unlisted;
    /** The index of each object in the scene. */
    final int[] order;
    /** The objects. */
    final Object[] objects;
    /** Four numbers per object: a sphere's centre and radius, a plane's normal and constant, or zeros. */
    final double[] numbers;
    /** Whether each object transmits no light. */
    final boolean[] opaque;
    /** The grid of the bounded objects; null if they are few or in a tree. */
    final UniformGrid grid;
    /** The tree of the bounded objects; null if they are few or in a grid. */
    final Bvh bvh;
    /** The number of the first part of each bounded object, and last the number of all parts; null if each object has one. */
    final int[] firstParts;
    /** The light buffer of the eye; null if there is none. */
    final LightBuffer eyeBuffer;
    /** The light buffer of each light; null for a light without. */
    final LightBuffer[] lightBuffers;

    private final int threads;
    private final long rays;
    private final boolean listed;                             // whether there is an eye buffer, if there is an eye and it pays

    /** The structures for the bounded objects. */
    enum Structure { AUTO, GRID, BVH }

    /**
     * Compiles a scene.
     *
     * @param scene the scene, which must not change any more
     * @param eye the origin of primary rays; null if they are parallel
     * @param threads the number of threads to use
     * @param rays the approximate number of primary rays: light buffers pay if it is at least the number of parts to list
     */
    public CompiledScene(Scene scene, Point eye, int threads, long rays) {
        this(scene, eye, threads, Structure.AUTO, rays);
    }

    /** Compiles a scene with a given structure, with or without light buffers. */
    CompiledScene(Scene scene, Point eye, int threads, Structure structure, boolean buffers) {
        this(scene, eye, threads, structure, buffers ? Long.MAX_VALUE : 0);
    }

    private CompiledScene(Scene scene, Point eye, int threads, Structure structure, long rays) {
        this.scene = scene;
        this.rays = rays;
        this.eye = eye;
        this.threads = threads;
        listed = true;
        Object[] all = new Object[scene.getNumberObjects()];
        for (int i = 0; i < all.length; i++) {
            all[i] = scene.getObject(i);
            all[i].prepare(threads);
        }
        int[] ids = bounded(all);
        bounded = ids.length;
        lightBuffers = new LightBuffer[scene.getNumberLights()];
        try (Pool pool = new Pool(threads)) {
            PrimitiveBounds bounds = bounded == 0 ? null : bounds(ids, all, pool);
            boolean forced = structure != Structure.AUTO && bounded > 0;
            boolean shafts = bounded > 0 && hasAreaLight(scene);      // only trees find what is in a shaft
            boolean spread = structure != Structure.BVH && (forced || bounded >= MIN_MANY && !shafts);
            grid = spread ? UniformGrid.of(bounds, forced, pool) : null;
            bvh = grid == null && (forced || shafts || parts(ids, all) >= MIN_MANY) ? Bvh.of(bounds, pool) : null;
            unlisted = grid == null && bvh == null ? 0 : bounded;
            // from here on the order of the boxes is fixed, and the rest can be made in parallel
            Pool.Task<UniformGrid> filling = grid == null ? null : pool.begin(grid::fill);
            order = Arrays.copyOf(ids, all.length);
            firstPlane = arrange(all);
            objects = new Object[all.length];
            numbers = new double[4 * all.length];
            opaque = new boolean[all.length];
            copy(all);
            firstParts = firstParts();
            PrimitiveBounds parts = !canBeListed() ? null : firstParts == null ? bounds : partBounds(pool);
            Pool.Task<LightBuffer> fromEye = parts == null || eye == null ? null
                : pool.begin(() -> LightBuffer.of(parts, eye.x, eye.y, eye.z));
            List<Pool.Task<LightBuffer>> fromLights = new ArrayList<>();
            for (int i = 0; parts != null && i < Math.min(MAX_BUFFERS, lightBuffers.length); i++) {
                Point origin = scene.getLight(i).origin();
                fromLights.add(origin == null ? null : pool.begin(() -> LightBuffer.of(parts, origin.x, origin.y, origin.z)));
            }
            for (int i = 0; i < fromLights.size(); i++) {
                lightBuffers[i] = fromLights.get(i) == null ? null : pool.await(fromLights.get(i));
            }
            eyeBuffer = fromEye == null ? null : pool.await(fromEye);
            if (filling != null) {
                pool.await(filling);
            }
        }
    }

    /** Copies what depends neither on the eye nor on the lights, and what has stayed of these. The scene has the same objects. */
    private CompiledScene(CompiledScene other, Scene scene, Point eye, boolean lists) {
        this.scene = scene;
        this.eye = eye;
        threads = other.threads;
        rays = other.rays;
        bounded = other.bounded;
        firstPlane = other.firstPlane;
        unlisted = other.unlisted;
        order = other.order;
        objects = other.objects;
        numbers = other.numbers;
        opaque = other.opaque;
        grid = other.grid;
        bvh = other.bvh;
        firstParts = other.firstParts;
        lightBuffers = scene == other.scene ? other.lightBuffers : lightBuffers(other);
        boolean same = other.listed && isSame(eye, other.eye);
        listed = lists || same;
        eyeBuffer = same ? other.eyeBuffer : lists && eye != null && canBeListed() ? buffer(eye) : null;
    }

    private LightBuffer[] lightBuffers(CompiledScene other) {
        LightBuffer[] buffers = new LightBuffer[scene.getNumberLights()];
        for (int i = 0; i < Math.min(MAX_BUFFERS, buffers.length) && canBeListed(); i++) {
            Point origin = scene.getLight(i).origin();
            boolean same = i < other.lightBuffers.length && isSame(origin, other.scene.getLight(i).origin());
            buffers[i] = same ? other.lightBuffers[i] : origin == null ? null : buffer(origin);
        }
        return buffers;
    }

    private static boolean isSame(Point a, Point b) {
        return a == b || a != null && b != null && a.x == b.x && a.y == b.y && a.z == b.z;
    }

    private LightBuffer buffer(Point origin) {
        try (Pool pool = new Pool(threads)) {
            return LightBuffer.of(partBounds(pool), origin.x, origin.y, origin.z);
        }
    }

    /** {@return the indices of the objects whose bounds fit into a tree, in order} */
    private static int[] bounded(Object[] all) {
        int[] places = new int[all.length];
        int count = 0;
        for (int i = 0; i < all.length; i++) {
            Bounds b = all[i].bounds();
            if (b != null && small(b.xmin()) && small(b.ymin()) && small(b.zmin()) && small(b.xmax()) && small(b.ymax())
                && small(b.zmax())) {
                places[count++] = i;
            }
        }
        return Arrays.copyOf(places, count);
    }

    private static boolean hasAreaLight(Scene scene) {
        for (int i = 0; i < scene.getNumberLights(); i++) {
            if (scene.getLight(i) instanceof AreaLight) {
                return true;
            }
        }
        return false;
    }

    private static long parts(int[] ids, Object[] all) {
        long sum = 0;
        for (int i : ids) {
            sum += all[i].parts();
        }
        return sum;
    }

    private static boolean small(double d) {
        return Math.abs(d) < MAX_COORDINATE;                  // false for NaN
    }

    private static PrimitiveBounds bounds(int[] ids, Object[] all, Pool pool) {
        return new PrimitiveBounds(ids, new PrimitiveBounds.Source() {
            @Override
            public void bounds(int i, double[] box) {
                all[i].bounds().get(box);                     // allocates nothing, unless it escapes
            }
        }, pool);
    }

    /** Moves the unbounded objects behind the others, planes last. {@return the index of the first plane} */
    private int arrange(Object[] all) {
        boolean[] placed = new boolean[all.length];
        for (int i = 0; i < bounded; i++) {
            placed[order[i]] = true;
        }
        int front = bounded;
        int back = all.length;
        for (int i = all.length - 1; i >= 0; i--) {
            if (!placed[i] && all[i] instanceof Plane) {
                order[--back] = i;
            }
        }
        for (int i = 0; i < all.length; i++) {
            if (!placed[i] && !(all[i] instanceof Plane)) {
                order[front++] = i;
            }
        }
        return back;
    }

    /** Fills the arrays in the order of the scene, which is that of the objects in memory. */
    private void copy(Object[] all) {
        int[] ranks = new int[order.length];
        for (int i = 0; i < order.length; i++) {
            ranks[order[i]] = i;
        }
        for (int place = 0; place < all.length; place++) {
            int i = ranks[place];
            objects[i] = all[place];
            opaque[i] = all[place].isOpaque();
            if (i < bounded && all[place] instanceof Sphere sphere) {
                set(i, sphere.centre.x, sphere.centre.y, sphere.centre.z, sphere.radius);
            } else if (all[place] instanceof Plane plane) {
                set(i, plane.normal.x, plane.normal.y, plane.normal.z, plane.constant);
            }
        }
    }

    private void set(int i, double a, double b, double c, double d) {
        numbers[4 * i] = a;
        numbers[4 * i + 1] = b;
        numbers[4 * i + 2] = c;
        numbers[4 * i + 3] = d;
    }

    private int[] firstParts() {
        long sum = 0;
        boolean alone = true;                                 // whether each object has only one part
        int[] first = new int[bounded + 1];
        for (int i = 0; i < bounded; i++) {
            int parts = objects[i].parts();
            alone &= parts == 1;
            sum += parts;
            first[i + 1] = (int) Math.min(sum, Integer.MAX_VALUE);
        }
        return alone ? null : first;
    }

    /** {@return the number of parts of the bounded objects} */
    private int parts() {
        return firstParts == null ? bounded : firstParts[bounded];
    }

    private boolean canBeListed() {
        return unlisted > 0 && parts() >= MIN_MANY && parts() <= Math.min(rays, MAX_PARTS);
    }

    private PrimitiveBounds partBounds(Pool pool) {
        int[] ids = new int[parts()];
        for (int i = 0; i < ids.length; i++) {
            ids[i] = i;
        }
        return new PrimitiveBounds(ids, new PrimitiveBounds.Source() {
            @Override
            public void bounds(int part, double[] box) {
                int i = owner(part);
                objects[i].partBounds(firstParts == null ? 0 : part - firstParts[i], box);
            }
        }, pool);
    }

    /** {@return the index in {@link #objects} of the object to which a part belongs} */
    int owner(int part) {
        if (firstParts == null) {
            return part;
        }
        int low = 0;
        int high = bounded - 1;
        while (low < high) {
            int middle = (low + high + 1) >>> 1;
            if (firstParts[middle] <= part) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return low;
    }

    /**
     * Returns this scene for another eye, or the same one. Grid, tree and the lights' buffers are shared.
     *
     * @param other the origin of primary rays
     * @return a scene for that eye, perhaps without its light buffer
     */
    public CompiledScene seenFrom(Point other) {
        return new CompiledScene(this, scene, other, false);
    }

    /**
     * Returns another scene of the same objects, whose lights may be others. Grid and tree are shared, and the buffer of each light that is where it was.
     *
     * @param other the scene, which must not change any more
     * @return that scene compiled; null if its objects are others
     */
    public CompiledScene with(Scene other) {
        boolean same = other.getNumberObjects() == objects.length;
        for (int i = 0; i < objects.length && same; i++) {
            same = other.getObject(order[i]) == objects[i];
        }
        return same ? new CompiledScene(this, other, eye, listed) : null;
    }

    /** {@return this scene with a light buffer for the eye} It takes time to build, and makes many rays faster. */
    public CompiledScene listed() {
        return listed ? this : new CompiledScene(this, scene, eye, true);
    }

    /**
     * Creates an intersector for one thread.
     *
     * @param stats gets the counts of tests and steps
     * @return the intersector
     */
    public Intersector intersector(RayStats stats) {
        return new AcceleratedIntersector(this, stats);
    }
}
