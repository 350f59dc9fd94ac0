package simpleray.cli;

import java.util.Random;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;

/** Scenes to measure: the thesis's room filled with any number of spheres or triangles, the same ones each time. */
final class BenchScenes {
    private static final long SEED = 2014;
    private static final double WALL = 2;
    private static final double[][] WALLS = {{-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
    private static final double HALF = 1.9;
    private static final double SHININESS = 5;
    private static final int MATERIALS = 8;
    /** The smallest and the largest radius of an even sphere, as a share of its cell. */
    private static final double SMALLEST = 0.3;
    private static final double LARGEST = 0.45;

    private static final int HEAPS = 50;
    /** Ranges of powers of ten: of a heap's spread, and of a sphere's radius as a share of the distance between two in its heap. */
    private static final double[] SPREAD = {-1.7, -0.4};
    private static final double[] SHARE = {-1.3, 0.4};

    /** The closed ring of {@link #mesh}: its radius, that of its tube, and the height and the number of its waves. */
    private static final double RING = 0.9;
    private static final double TUBE = 0.4;
    private static final double WAVE = 0.06;
    private static final int WAVES = 24;

    private final Random random = new Random(SEED);
    private final Scene scene = new Scene();
    private final Material[] materials = new Material[MATERIALS];

    /** Creates the room, for n objects in it. */
    private BenchScenes(int n, boolean glass) {
        scene.setNumberObjects(WALLS.length + n);
        for (int i = 0; i < WALLS.length; i++) {
            scene.setObject(i, new Plane(material(false), new Vector(WALLS[i][0], WALLS[i][1], WALLS[i][2]), -WALL));
        }
        for (int i = 0; i < MATERIALS; i++) {
            materials[i] = material(glass);
            materials[i].specular = new Colour(SMALLEST, SMALLEST, SMALLEST);
        }
        scene.ambient = new Colour(SMALLEST, SMALLEST, SMALLEST);
        scene.setNumberLights(1);
        scene.setLight(0, new PointLight(new Point(-1.2, 1.8, 2.5)));
    }

    /**
     * Makes a scene of evenly distributed spheres. Each is in a cell of its own, so that none overlap, and reflects a little, or is of
     * glass.
     *
     * @param n the number of spheres
     * @param glass whether they are of glass
     */
    static Scene even(int n, boolean glass) {
        BenchScenes room = new BenchScenes(n, glass);
        int side = (int) Math.ceil(Math.cbrt(n));
        double cell = 2 * HALF / side;
        for (int i = 0; i < n; i++) {
            double r = cell * (SMALLEST + (LARGEST - SMALLEST) * room.random.nextDouble());
            Point centre = new Point(room.within(i % side, cell, r), room.within(i / side % side, cell, r),
                room.within(i / side / side, cell, r) - WALL / 4);
            room.set(i, new Sphere(room.anyMaterial(), centre, r));
        }
        return room.scene;
    }

    /**
     * Makes a scene of spheres in heaps, as objects are in the world: wide and tight heaps, of many and of few spheres of all sizes, which
     * overlap. The radii span three decades.
     *
     * @param n the number of spheres
     */
    static Scene clusters(int n) {
        BenchScenes room = new BenchScenes(n, false);
        Random random = room.random;
        Point[] middles = new Point[HEAPS];
        double[] spreads = new double[HEAPS];
        for (int i = 0; i < HEAPS; i++) {
            middles[i] = new Point(room.between(-HALF, HALF), room.between(-HALF, 1), room.between(-HALF, 0));
            spreads[i] = Math.pow(10, room.between(SPREAD[0], SPREAD[1]));
        }
        double gap = 1 / Math.cbrt(Math.ceil((double) n / HEAPS));
        for (int i = 0; i < n; i++) {
            double share = random.nextDouble();
            int heap = (int) (HEAPS * share * share);         // the first heaps get the most
            double spread = spreads[heap];
            double r = spread * gap * Math.pow(10, room.between(SHARE[0], SHARE[1]));
            Point m = middles[heap];
            Point centre = new Point(clamp(m.x + spread * random.nextGaussian(), HALF), clamp(m.y + spread * random.nextGaussian(), HALF),
                clamp(m.z + spread * random.nextGaussian(), 1));
            room.set(i, new Sphere(room.anyMaterial(), centre, r));
        }
        return room.scene;
    }

    /**
     * Makes a scene of one mesh, a ring in the middle of the room whose tube has waves.
     *
     * @param n the approximate number of triangles
     */
    static Scene mesh(int n) {
        BenchScenes room = new BenchScenes(1, false);
        int across = (int) Math.ceil(Math.sqrt(n / 4.0));     // quadrilaterals about the tube; twice as many along the ring
        int along = 2 * across;
        double[] vertices = new double[3 * along * across];
        int[] corners = new int[6 * along * across];
        for (int i = 0, k = 0; i < along; i++) {
            for (int j = 0; j < across; j++, k++) {
                double u = 2 * Math.PI * i / along;
                double v = 2 * Math.PI * j / across;
                double tube = TUBE + WAVE * Math.sin(WAVES * u) * Math.sin(WAVES / 4 * v);
                double out = RING + tube * Math.cos(v);
                vertices[3 * k] = out * Math.cos(u);
                vertices[3 * k + 1] = out * Math.sin(u);
                vertices[3 * k + 2] = tube * Math.sin(v) - WALL / 2;
                int right = (i + 1) % along * across;
                int up = (j + 1) % across;
                int[] two = {k, right + j, right + up, k, right + up, i * across + up};
                System.arraycopy(two, 0, corners, 6 * k, two.length);
            }
        }
        room.set(0, Mesh.of(room.anyMaterial(), vertices, corners));
        return room.scene;
    }

    private void set(int i, Object object) {
        scene.setObject(WALLS.length + i, object);
    }

    private Material anyMaterial() {
        return materials[random.nextInt(MATERIALS)];
    }

    private double between(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    private static double clamp(double d, double high) {
        return Math.max(-HALF, Math.min(high, d));
    }

    private double within(int i, double cell, double r) {
        return -HALF + i * cell + r + (cell - 2 * r) * random.nextDouble();
    }

    private Material material(boolean glass) {
        Material material = new Material();
        material.diffuse = new Colour(random.nextDouble(), random.nextDouble(), random.nextDouble());
        material.ambient = Colour.scale(material.diffuse, LARGEST);
        material.shininess = SHININESS;
        if (glass) {
            material.transmission = new Colour(SHININESS / MATERIALS, SHININESS / MATERIALS, SHININESS / MATERIALS);
            material.index = 1 + SMALLEST;
        }
        return material;
    }
}
