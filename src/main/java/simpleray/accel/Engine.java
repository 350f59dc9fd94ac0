package simpleray.accel;

import java.util.ArrayList;
import java.util.List;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.DirectionalLight;
import simpleray.scene.Intersector;
import simpleray.scene.Light;
import simpleray.scene.Object;
import simpleray.scene.PointLight;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;

/**
 * A scene made ready for fast rendering: flat arrays, a tree of boxes, lists of what lies in each direction from the eye and the lights.
 * <em>Constant</em>, as long as the scene is; any thread may ask for an intersector.
 */
public final class Engine {
    /** From so many bounded objects on a tree pays. */
    private static final int TREE = 9;
    /** The most lights that get a buffer of their own. */
    private static final int BUFFERS = 8;

    final Scene scene;
    final Primitives primitives;
    final Boxes boxes;
    final Structure structure;
    final Light[] lights;
    /** The unit vectors towards directional lights; null for others. */
    final Vector[] directions;
    final Point eye;
    final DirectionBuffer eyeBuffer;
    final DirectionBuffer[] lightBuffers;
    /** All objects, or those that are not in the structure. */
    final FewBuffer everywhere;
    final FewBuffer eyeFew;
    final FewBuffer[] lightFew;
    private final boolean listed;                             // whether the eye's lists were made if they can be

    /** Ways to the bounded objects. */
    enum Kind { BEST, GRID, BVH }

    /**
     * Makes a scene ready.
     *
     * @param scene the scene, which must not change any more
     * @param eye where primary rays start
     * @param threads how many threads may work on it
     */
    public Engine(Scene scene, Point eye, int threads) {
        this(scene, eye, threads, Kind.BEST, true);
    }

    /** Makes a scene ready in one way, with or without lists of what lies in each direction. */
    Engine(Scene scene, Point eye, int threads, Kind kind, boolean lists) {
        this.scene = scene;
        this.eye = eye;
        listed = lists;
        lights = new Light[scene.getNumberLights()];
        directions = new Vector[lights.length];
        lightBuffers = new DirectionBuffer[lights.length];
        lightFew = new FewBuffer[lights.length];
        for (int i = 0; i < lights.length; i++) {
            lights[i] = scene.getLight(i);
            if (lights[i] instanceof DirectionalLight) {
                directions[i] = new Vector();
                lights[i].towards(eye, directions[i]);
            }
        }
        Object[] all = Primitives.objects(scene);
        int[] bounded = Primitives.bounded(all);
        int[] unbounded = Primitives.others(all.length, bounded);   // while those are in order
        boolean many = bounded.length >= (kind == Kind.BEST ? TREE : 1);
        int buffers = lists ? Math.min(BUFFERS, lights.length) : 0;
        try (Pool pool = new Pool(threads)) {
            boxes = bounded.length == 0 ? null : new Boxes(all, bounded, pool);
            Grid grid = many && kind != Kind.BVH ? Grid.of(boxes, kind == Kind.GRID, pool) : null;
            structure = many && grid == null ? Bvh.build(boxes, pool) : grid;
            // from here on the order of the boxes stays, and all else can be made at once
            Pool.Task<Grid> filling = grid == null ? null : pool.begin(() -> {
                grid.fill();
                return grid;
            });
            boolean seen = lists && bounded.length >= TREE;
            Pool.Task<DirectionBuffer> fromEye = seen ? pool.begin(() -> DirectionBuffer.of(boxes, eye)) : null;
            List<Pool.Task<DirectionBuffer>> fromLights = new ArrayList<>();
            for (int i = 0; seen && i < buffers; i++) {
                fromLights.add(lights[i] instanceof PointLight light ? pool.begin(() -> DirectionBuffer.of(boxes, light.origin)) : null);
            }
            primitives = new Primitives(all, boxes, unbounded);
            everywhere = FewBuffer.everywhere(primitives, structure == null);
            eyeFew = lists ? few(eye) : null;
            for (int i = 0; i < buffers; i++) {
                lightFew[i] = lights[i] instanceof PointLight light ? few(light.origin) : null;
            }
            eyeBuffer = fromEye == null ? null : pool.await(fromEye);
            for (int i = 0; i < fromLights.size(); i++) {
                lightBuffers[i] = fromLights.get(i) == null ? null : pool.await(fromLights.get(i));
            }
            if (filling != null) {
                pool.await(filling);
            }
        }
    }

    /** Takes what does not depend on the eye. */
    private Engine(Engine other, Point eye, boolean lists) {
        scene = other.scene;
        this.eye = eye;
        lights = other.lights;
        directions = other.directions;
        lightBuffers = other.lightBuffers;
        lightFew = other.lightFew;
        boxes = other.boxes;
        structure = other.structure;
        primitives = other.primitives;
        everywhere = other.everywhere;
        boolean same = eye.x == other.eye.x && eye.y == other.eye.y && eye.z == other.eye.z;
        eyeFew = same ? other.eyeFew : few(eye);
        listed = lists || same && other.listed;
        eyeBuffer = same && other.listed ? other.eyeBuffer : lists && primitives.bounded >= TREE ? DirectionBuffer.of(boxes, eye) : null;
    }

    /** {@return the list by direction of all that has no tree over it, as seen from a point} */
    private FewBuffer few(Point from) {
        return FewBuffer.of(primitives, primitives.bounded < TREE ? boxes : null, from);
    }

    /**
     * Makes the scene ready for another eye, or for the same one; what takes long is not done again.
     *
     * @param other where primary rays start
     * @return an engine for that eye; it may lack the lists of what lies in each direction from there
     */
    public Engine seenFrom(Point other) {
        return new Engine(this, other, false);
    }

    /** {@return this, or the same with lists of what lies in each direction from the eye} They take time, and make many rays faster. */
    public Engine listed() {
        return listed ? this : new Engine(this, eye, true);
    }

    /**
     * Makes what finds hits in the scene, for one thread.
     *
     * @param stats gets the counts of tests and steps
     * @return the intersector
     */
    public Intersector intersector(RayStats stats) {
        return new AcceleratedIntersector(this, stats);
    }
}
