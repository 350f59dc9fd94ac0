package simpleray.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;

/** Scenes of all kinds of objects, lights, materials and settings, with numbers as people write them and as only machines do. */
final class RandomScenes {
    private RandomScenes() {
    }

    static Scene scene(Random random) {
        Object[] objects = new Object[random.nextInt(5)];
        for (int i = 0; i < objects.length; i++) {
            objects[i] = object(random);
        }
        Scene scene = Scenes.of(objects);
        scene.ambient = colour(random);
        Light[] lights = new Light[random.nextInt(4)];
        for (int i = 0; i < lights.length; i++) {
            lights[i] = switch (random.nextInt(3)) {
                case 0 -> new DirectionalLight(vector(random));
                case 1 -> new PointLight(point(random));
                default -> new AreaLight(point(random), new Vector(near(random)), new Vector(near(random)), 1 + random.nextInt(64));
            };
            lights[i].intensity = colour(random);
        }
        Scenes.light(scene, lights);
        scene.settings = settings(random);
        if (random.nextBoolean()) {
            film(random, scene);
        }
        return scene;
    }

    private static Object object(Random random) {
        Material material = material(random);
        return switch (random.nextInt(5)) {
            case 0 -> new Plane(material, vector(random), length(random));
            case 1 -> new Triangle(material, near(random), near(random), near(random));
            case 2 -> new Cylinder(material, point(random), near(random), Math.min(Lengths.MAX, above(random)));
            case 3 -> new Cone(material, point(random), Math.min(Lengths.MAX, Math.abs(number(random))), near(random),
                Math.min(Lengths.MAX, above(random)));
            default -> new Sphere(material, point(random), Math.min(Lengths.MAX, above(random)));
        };
    }

    private static Material material(Random random) {
        Material material = Scenes.material(colour(random), colour(random), colour(random), Math.abs(number(random)));
        if (random.nextBoolean()) {
            material.transmission = colour(random);
        }
        material.mirror = maybe(random, colour(random));
        if (random.nextBoolean()) {
            material.index = Math.max(1, Math.abs(number(random)));
        }
        return material;
    }

    private static SceneSettings settings(Random random) {
        SceneSettings settings = new SceneSettings();
        settings.background = maybe(random, colour(random));
        if (random.nextBoolean()) {
            settings.camera = new PerspectiveCamera.Pose(number(random), 1, number(random), number(random), 2, number(random),
                Math.nextUp(random.nextDouble() * 179));
            settings.up = maybe(random, new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()));
        } else if (random.nextBoolean()) {
            settings.parallel = new ParallelCamera.View(number(random), 1, number(random), number(random), 2, number(random),
                Math.min(1e100, above(random)));
        } else {
            settings.cop = maybe(random, above(random));
            double xmin = random.nextGaussian();
            double ymin = -above(random);
            settings.window = maybe(random, new SceneSettings.Window(xmin, Math.nextUp(xmin), ymin, above(random)));
        }
        settings.resolution = maybe(random, new SceneSettings.Resolution(1 + random.nextInt(SceneSettings.MAX_RESOLUTION),
            1 + random.nextInt(SceneSettings.MAX_RESOLUTION)));
        settings.depth = maybe(random, random.nextInt(SceneSettings.MAX_DEPTH + 1));
        settings.samples = maybe(random, 1 + random.nextInt(SceneSettings.MAX_SAMPLES));
        return settings;
    }

    /** Puts a scene in motion. The curve is linear, so that all frames are between the keys. */
    private static void film(Random random, Scene scene) {
        SceneSettings settings = scene.settings;
        settings.frames = new SceneSettings.Frames(2 + random.nextInt(Film.MAX_FRAMES - 1), Math.min(Film.MAX_RATE, above(random)));
        settings.curve = Curve.LINEAR;
        settings.keys = new ArrayList<>();
        for (double frame : new double[] {random.nextDouble(), 1, 0}) {
            if (scene.getNumberLights() > 0) {
                settings.keys.add(key(frame, Key.Kind.COLOUR, scene.getNumberLights(), random.nextDouble(), random.nextDouble(), 1e100));
            }
            if (scene.getNumberObjects() > 0 && !(scene.getObject(0) instanceof Plane)) {
                settings.keys.add(key(frame, Key.Kind.OBJECT, 1, random.nextGaussian(), 1.0 + random.nextInt(9), -0.0));
            }
            if (settings.cop == null && settings.window == null && settings.parallel == null) {
                settings.keys.add(key(frame, Key.Kind.CAMERA, 0, random.nextGaussian(), 1.0, 1e100, 0.1, 2.0, random.nextGaussian(),
                    Math.nextUp(random.nextDouble() * 179)));
            }
        }
        settings.keys = settings.keys.isEmpty() ? null : settings.keys;
    }

    private static Key key(double frame, Key.Kind kind, int number, Double... values) {
        return new Key(frame, new Key.Thing(kind, number), List.of(values));
    }

    private static <T> T maybe(Random random, T thing) {
        return random.nextBoolean() ? thing : null;
    }

    private static Colour colour(Random random) {
        return new Colour(Math.abs(number(random)), Math.abs(number(random)), Math.abs(number(random)));
    }

    private static Vector vector(Random random) {
        return new Vector(length(random), Math.abs(length(random)) + Double.MIN_VALUE, length(random));
    }

    private static Point point(Random random) {
        return new Point(length(random), length(random), length(random));
    }

    /** {@return a point near the origin: three of them are hardly ever on one line} */
    private static Point near(Random random) {
        return new Point(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    }

    private static double above(Random random) {
        return Math.max(Double.MIN_VALUE, Math.abs(number(random)));
    }

    /** {@return a number that an object may have} */
    private static double length(Random random) {
        return Math.max(-Lengths.MAX, Math.min(Lengths.MAX, number(random)));
    }

    /** {@return a number: as people write them, or any finite pattern of bits, or a zero of either sign} */
    private static double number(Random random) {
        double any = Double.longBitsToDouble(random.nextLong());
        return switch (random.nextInt(4)) {
            case 0 -> random.nextInt(2001) / 100.0 - 10;
            case 1 -> random.nextGaussian();
            case 2 -> random.nextBoolean() ? 0.0 : -0.0;
            default -> Double.isFinite(any) ? any : Double.MAX_VALUE;
        };
    }
}
