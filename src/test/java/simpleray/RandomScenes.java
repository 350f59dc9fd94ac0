package simpleray;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.AreaLight;
import simpleray.scene.Cone;
import simpleray.scene.Cylinder;
import simpleray.scene.DirectionalLight;
import simpleray.scene.Light;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;
import simpleray.scene.Triangle;

/** Scenes of all shapes at random: crowded and sparse, near and far, with twins at the same place, mirrors, glass and lights inside things. */
public final class RandomScenes {
    private static final String TETRAHEDRON = """
        v 1 1 1
        v -1 -1 1
        v -1 1 -1
        v 1 -1 -1
        f 1 2 4
        f 1 3 2
        f 1 4 3
        f 2 3 4
        """;

    private final Random random;
    private final Path obj;
    private double scale;
    private double spread;
    private Point middle;

    /**
     * Prepares scenes.
     *
     * @param seed the seed; the same scenes follow from the same one
     * @param folder where an OBJ file may be written
     */
    public RandomScenes(long seed, Path folder) {
        random = new Random(seed);
        obj = folder.resolve("tetrahedron.obj");
        try {
            Files.writeString(obj, TETRAHEDRON);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** {@return another scene, of up to so many objects} */
    public Scene next(int most) {
        Scene scene = new Scene();
        scale = random.nextInt(4) == 0 ? Math.pow(10, random.nextInt(7) - 3) : 1;
        spread = random.nextInt(3) == 0 ? 3 : 0;
        middle = new Point(0, 0, -scale * random.nextInt(4));
        int n = random.nextInt(most + 1);
        scene.setNumberObjects(n);
        Material[] materials = new Material[4];
        for (int i = 0; i < materials.length; i++) {
            materials[i] = material();
        }
        for (int i = 0; i < n; i++) {
            Material material = materials[random.nextInt(materials.length)];
            boolean twin = i > 0 && random.nextInt(8) == 0;
            scene.setObject(i, twin ? twin(scene.getObject(random.nextInt(i)), material) : object(material));
        }
        int m = random.nextInt(4);
        scene.setNumberLights(m);
        for (int i = 0; i < m; i++) {
            Light light = light();
            light.intensity = colour(1.5);
            scene.setLight(i, light);
        }
        scene.ambient = colour(0.4);
        scene.settings.background = random.nextBoolean() ? colour(1) : null;
        return scene;
    }

    /** {@return a number from -1 to 1, often a round one} */
    private double number() {
        return random.nextInt(4) == 0 ? (random.nextInt(9) - 4) / 4.0 : 2 * random.nextDouble() - 1;
    }

    private double size() {
        return scale * (random.nextInt(12) == 0 ? 1.5 : random.nextInt(3) == 0 ? 0.25 : 0.4 * random.nextDouble() + 1e-3);
    }

    private Point point() {
        double far = scale * (spread > 0 && random.nextInt(6) == 0 ? Math.pow(10, spread) : 1.5);
        return new Point(middle.x + far * number(), middle.y + far * number(), middle.z + far * number());
    }

    private Vector vector() {
        Vector v = new Vector(number(), number(), number());
        return v.norm() == 0 ? new Vector(0, -2, 0) : v;
    }

    private Colour colour(double most) {
        return new Colour(most * random.nextDouble(), random.nextInt(4) == 0 ? 0 : most * random.nextDouble(), most * random.nextDouble());
    }

    private Material material() {
        Material material = new Material();
        material.ambient = colour(1);
        material.diffuse = colour(1);
        material.specular = random.nextBoolean() ? colour(0.8) : new Colour();
        material.shininess = random.nextBoolean() ? random.nextInt(6) : 12 * random.nextDouble();
        if (random.nextInt(3) == 0) {
            material.transmission = colour(0.9);
            material.index = 1 + random.nextDouble();
        }
        if (random.nextInt(4) == 0) {
            material.mirror = random.nextBoolean() ? colour(0.8) : new Colour();
        }
        return material;
    }

    private Light light() {
        return switch (random.nextInt(6)) {
            case 0, 1 -> new DirectionalLight(vector());
            case 2 -> {
                Vector u = vector();
                yield new AreaLight(point(), Vector.scale(u, size()), Vector.scale(Vector.cross(u, new Vector(0.3, -0.5, 0.7)), size()),
                    1 + random.nextInt(6));
            }
            default -> new PointLight(point());
        };
    }

    private Object object(Material material) {
        return switch (random.nextInt(10)) {
            case 0 -> new Plane(material, vector(), 3 * scale * number());
            case 1, 2 -> new Triangle(material, point(), point(), point());
            case 3 -> {
                Point start = point();
                yield new Cylinder(material, start, Point.add(start, Vector.scale(vector(), 2 * size())), size());
            }
            case 4 -> mesh(material);
            case 5 -> {
                Point start = point();
                double radius = random.nextInt(3) == 0 ? 0 : size();
                yield new Cone(material, start, radius, Point.add(start, Vector.scale(vector(), 2 * size())), size());
            }
            default -> new Sphere(material, point(), size());
        };
    }

    private Mesh mesh(Material material) {
        try {
            return new Mesh(material, obj.toString(), point(), (random.nextBoolean() ? 1 : -1) * size());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** {@return an object at the very place of another, if its shape can be copied} */
    private Object twin(Object other, Material material) {
        if (other instanceof Sphere s) {
            return new Sphere(material, s.centre, s.radius);
        }
        if (other instanceof Plane p) {
            return new Plane(material, p.normal, p.constant);
        }
        if (other instanceof Triangle t) {
            return new Triangle(material, t.b, t.c, t.a);
        }
        if (other instanceof Cone c) {
            return new Cone(material, c.start, c.startRadius, c.end, c.endRadius);
        }
        return object(material);
    }
}
