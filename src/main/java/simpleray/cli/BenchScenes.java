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

/** The thesis's room filled with any number of spheres or triangles, to see what they cost; the same ones each time. */
final class BenchScenes {
    private static final long SEED = 2014;
    private static final double WALL = 2;
    private static final double[][] WALLS = {{-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
    private static final double HALF = 1.9;
    private static final double SHININESS = 5;
    private static final int MATERIALS = 8;
    /** How much of its own cell an even sphere takes at least and at most. */
    private static final double SMALLEST = 0.3;
    private static final double LARGEST = 0.45;

    private static final int HEAPS = 50;
    /** The powers of ten between which a heap's spread lies, and a sphere's radius as a share of what is between two in its heap. */
    private static final double[] SPREAD = {-1.7, -0.4};
    private static final double[] SHARE = {-1.3, 0.4};

    /** The closed ring of {@link #mesh}: the radius to the middle of the tube, the tube's own, and how high its waves are and how many. */
    private static final double RING = 0.9;
    private static final double TUBE = 0.4;
    private static final double WAVE = 0.06;
    private static final int WAVES = 24;

    private final Random random = new Random(SEED);
    private final Scene scene = new Scene();
    private final Material[] materials = new Material[MATERIALS];

    /** Makes the room, for n objects in it. */
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
     * Makes a scene of spheres that lie evenly. Each is somewhere in a cell of its own, so that none overlap, and is a little of a mirror,
     * or of glass.
     *
     * @param n how many spheres
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
     * Makes a scene of spheres that lie in heaps, as things do in the world: heaps wide and tight, of many and of few, in which spheres of all
     * sizes overlap. The radii span three decades.
     *
     * @param n how many spheres
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
     * @param n about how many triangles
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
