package simpleray.cli;

import java.util.Random;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Material;
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;

/** The thesis's room filled with any number of small spheres, to see how the cost grows. */
final class ManySpheres {
    private static final long SEED = 2014;
    private static final double WALL = 2;
    private static final double HALF = 1.9;
    private static final double SHININESS = 5;
    private static final int MATERIALS = 8;
    /** How much of its own cell a sphere takes at least and at most. */
    private static final double SMALLEST = 0.3;
    private static final double LARGEST = 0.45;

    private ManySpheres() {
    }

    /**
     * Makes a scene. Each sphere lies somewhere in a cell of its own, so that none overlap, and is a little of a mirror, or of glass.
     *
     * @param n how many spheres
     * @param glass whether they are of glass
     */
    static Scene scene(int n, boolean glass) {
        Random random = new Random(SEED);
        Scene scene = new Scene();
        double[][] walls = {{-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
        scene.setNumberObjects(walls.length + n);
        for (int i = 0; i < walls.length; i++) {
            scene.setObject(i, new Plane(material(random, false), new Vector(walls[i][0], walls[i][1], walls[i][2]), -WALL));
        }
        Material[] materials = new Material[MATERIALS];
        for (int i = 0; i < MATERIALS; i++) {
            materials[i] = material(random, glass);
            materials[i].specular = new Colour(SMALLEST, SMALLEST, SMALLEST);
        }
        int side = (int) Math.ceil(Math.cbrt(n));
        double cell = 2 * HALF / side;
        for (int i = 0; i < n; i++) {
            double r = cell * (SMALLEST + (LARGEST - SMALLEST) * random.nextDouble());
            Point centre = new Point(within(random, i % side, cell, r), within(random, i / side % side, cell, r),
                within(random, i / side / side, cell, r) - WALL / 4);
            scene.setObject(walls.length + i, new Sphere(materials[random.nextInt(MATERIALS)], centre, r));
        }
        scene.ambient = new Colour(SMALLEST, SMALLEST, SMALLEST);
        scene.setNumberLights(1);
        scene.setLight(0, new PointLight(new Point(-1.2, 1.8, 2.5)));
        return scene;
    }

    private static double within(Random random, int i, double cell, double r) {
        return -HALF + i * cell + r + (cell - 2 * r) * random.nextDouble();
    }

    private static Material material(Random random, boolean glass) {
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
