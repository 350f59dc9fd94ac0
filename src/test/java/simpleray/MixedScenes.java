package simpleray;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.AreaLight;
import simpleray.scene.Cone;
import simpleray.scene.Cylinder;
import simpleray.scene.DirectionalLight;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;
import simpleray.scene.Triangle;

/** Scenes at random with an object of each shape and of matt, mirror and glass, none in another's place, under two lamps, a sun and an area light. */
final class MixedScenes {
    /** A free camera that sees all of them, and on whose picture nothing lies evenly. */
    static final PerspectiveCamera.Pose POSE = new PerspectiveCamera.Pose(0.3, 1.7, 6, 0.1, 0.2, 0, 45);

    private MixedScenes() {
    }

    /** {@return the scene of a seed; a file that it needs is written into the folder} */
    static Scene of(long seed, Path folder) throws IOException {
        Random random = new Random(seed);
        List<Object> objects = new ArrayList<>();
        objects.add(new Plane(matt(random), new Vector(0.1 * random.nextDouble(), 2, 0.1), -3));
        objects.add(new Sphere(mirror(random), place(random, -1.6, 0.3), 0.5 + 0.3 * random.nextDouble()));
        objects.add(new Sphere(glass(random), place(random, 0.2, 1.2), 0.4 + 0.2 * random.nextDouble()));
        Point foot = place(random, 1.7, -0.4);
        objects.add(new Cylinder(mirror(random), foot, Point.add(foot, new Vector(0.3, 0.9, -0.2)), 0.4));
        objects.add(new Triangle(matt(random), place(random, -2, -2.5), place(random, 2, -2.7), place(random, 0.3, -3)));
        objects.add(new Mesh(matt(random), Bodies.box(folder).toString(), place(random, 0, -0.9), 0.3 + 0.1 * random.nextDouble()));
        Point end = place(random, -0.6, 1.9);
        objects.add(new Cylinder(glass(random), end, Point.add(end, new Vector(0.5, 0.1, 0.2)), 0.15));
        Point base = place(random, 1.1, 1.6);
        objects.add(new Cone(matt(random), base, 0.25, Point.add(base, new Vector(0.1, 0.4, 0.1)), 0.1));
        Scene scene = Bodies.scene(objects);
        scene.ambient = new Colour(0.2, 0.15, 0.1);
        scene.settings.background = new Colour(0.1, 0.2, 0.4);
        scene.setNumberLights(4);
        scene.setLight(0, new PointLight(new Point(-3 + random.nextDouble(), 4, 3)));
        scene.setLight(1, new PointLight(new Point(2, 3 + random.nextDouble(), 5)));
        scene.setLight(2, new DirectionalLight(new Vector(-0.4, -1.3, -random.nextDouble())));
        Point corner = new Point(-1, 4, 1 + random.nextDouble());
        scene.setLight(3, new AreaLight(corner, new Vector(0.5, 0, 0.1), new Vector(0.1, 0.3, 0.4), 3));
        for (int i = 0; i < scene.getNumberLights(); i++) {
            scene.getLight(i).intensity = colour(random, 0.4);
        }
        return scene;
    }

    private static Point place(Random random, double x, double z) {
        return new Point(x + 0.2 * random.nextDouble(), 0.8 * random.nextDouble() - 0.3, z + 0.2 * random.nextDouble());
    }

    private static Colour colour(Random random, double most) {
        return new Colour(most * (0.5 + random.nextDouble() / 2), most * random.nextDouble(), most * random.nextDouble());
    }

    private static Material matt(Random random) {
        Material material = new Material();
        material.ambient = colour(random, 1);
        material.diffuse = colour(random, 1);
        material.specular = new Colour();
        return material;
    }

    private static Material mirror(Random random) {
        Material material = matt(random);
        material.specular = colour(random, 0.7);
        material.shininess = 5 + random.nextInt(20);
        return material;
    }

    private static Material glass(Random random) {
        Material material = mirror(random);
        material.diffuse = new Colour();
        material.mirror = colour(random, 0.4);
        material.transmission = colour(random, 0.9);
        material.index = 1 + random.nextDouble();
        return material;
    }
}
