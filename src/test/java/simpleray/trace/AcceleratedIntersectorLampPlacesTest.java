package simpleray.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.BruteForceIntersector;
import simpleray.scene.Cone;
import simpleray.scene.Cylinder;
import simpleray.scene.Hit;
import simpleray.scene.Interaction;
import simpleray.scene.Intersector;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.Scenes;
import simpleray.scene.Sphere;
import simpleray.scene.Triangle;
import simpleray.scene.VisibilityTester;

/** A lamp in a surface of any shape, at any scale and place, lights all that faces it: with and without accelerating structures. */
class AcceleratedIntersectorLampPlacesTest {
    private static final int LAMPS = 60;
    private static final int POINTS = 20;

    private final Random random = new Random(11);
    private double scale;
    private double far;

    private double number() {
        return 2 * random.nextDouble() - 1;
    }

    private Vector direction() {
        Vector v = new Vector(number(), number(), number());
        return v.norm() < 0.1 ? direction() : v.normalised();
    }

    private Point point() {
        return new Point(far + scale * number(), scale * number() - far, scale * number() + far / 3);
    }

    /** {@return the point on a line from a point} */
    private static Point at(Point from, Vector direction, double distance) {
        return Point.add(from, Vector.scale(direction, distance));
    }

    /** {@return a shape in whose surface the lamp lies, and which does not lie between it and what is on the other side of its tangent plane} */
    private Object around(String shape, Point lamp, Vector outward, Material material) {
        Vector across = Vector.cross(outward, direction()).normalised();
        Vector along = Vector.cross(outward, across);
        Point[] corners = {at(at(lamp, across, -3 * scale), along, -scale), at(at(lamp, across, 2 * scale), along, -2 * scale),
            at(at(lamp, across, scale), along, 4 * scale)};
        return switch (shape) {
            case "plane" -> new Plane(material, Vector.scale(outward, 3), 3 * outward.dot(lamp));
            case "triangle" -> new Triangle(material, corners[0], corners[1], corners[2]);
            case "mesh" -> Mesh.of(material, Arrays.stream(corners).flatMapToDouble(p -> DoubleStream.of(p.x, p.y, p.z)).toArray(),
                new int[] {0, 1, 2});
            case "sphere" -> new Sphere(material, at(lamp, outward, -scale), scale);
            case "end" -> new Cylinder(material, lamp, at(lamp, outward, -scale), 0.7 * scale);
            case "cone" -> {
                Vector axis = Vector.add(Vector.scale(along, 4), Vector.scale(outward, -3)).normalised();   // radius 3/4 of the height
                Point apex = at(lamp, along, -0.5 * scale);
                yield new Cone(material, apex, 0, at(apex, axis, 0.8 * scale), 0.6 * scale);
            }
            default -> {
                Point middle = at(lamp, outward, -0.4 * scale);
                yield new Cylinder(material, at(middle, across, scale), at(middle, across, -scale), 0.4 * scale);
            }
        };
    }

    @ParameterizedTest
    @CsvSource({"1e-6, 0", "1e-3, 0", "1e-3, 0.1", "1, 0", "1, 1000", "1, 1e6", "1000, 0", "1000, 1e9", "1e6, 0", "1e6, 1e9", "1e9, 0", "1e9, 1e9"})
    void itLightsWhatFacesIt(double scale, double far) {
        this.scale = scale;
        this.far = far;
        Material matt = new Material();
        Material glass = Scenes.glass(0, 0.5, 1.5);
        List<String> wrong = new ArrayList<>();
        for (String shape : new String[] {"plane", "triangle", "mesh", "sphere", "end", "side", "cone"}) {
            for (int i = 0; i < LAMPS; i++) {
                Point lamp = point();
                Vector outward = direction();
                Material material = i % 2 == 0 ? matt : glass;
                Scene scene = Scenes.of(around(shape, lamp, outward, material), new Sphere(matt, at(lamp, outward, 50 * scale), scale));
                Scenes.light(scene, new PointLight(lamp));
                RayStats stats = new RayStats();
                List<VisibilityTester> testers = List.of(new VisibilityTester(new BruteForceIntersector(scene), true, stats),
                    new VisibilityTester(new CompiledScene(scene, at(lamp, outward, 3 * scale), 1, 1_000_000)
                        .intersector(stats), true, stats));
                for (int k = 0; k < POINTS; k++) {
                    Vector aside = k % 2 == 0 ? Vector.add(outward, Vector.scale(direction(), 0.9))
                        : Vector.add(Vector.scale(outward, 0.01), Vector.cross(outward, direction()).normalised());
                    Interaction at = new Interaction();
                    at.point.copy(at(lamp, aside, scale * (0.5 + 5 * random.nextDouble())));
                    at.normal.copy(Vector.negate(outward));
                    for (VisibilityTester tester : testers) {
                        Colour arriving = new Colour(1, 1, 1);
                        tester.reaches(scene.getLight(0), 0, at, arriving);
                        if (arriving.r != 1) {
                            wrong.add(shape + " " + arriving + " at an angle of " + aside.normalised().dot(outward));
                        }
                    }
                    Point half = at(lamp, aside, 0.02 * scale);          // what is before the lamp still shadows
                    Scene shaded = Scenes.of(scene.getObject(0), new Sphere(matt, half, 0.01 * scale));
                    if (scale > 1e-5 && new VisibilityTester(new BruteForceIntersector(shaded), true, stats)
                            .reaches(scene.getLight(0), 0, at, new Colour(1, 1, 1))) {
                        wrong.add(shape + ": what is before the lamp throws no shadow");
                    }
                }
            }
        }
        assertThat(wrong).isEmpty();
    }

    /** In its own surface a lamp has N·L = 0, and a hair above it more than 0: at all points, or a highlight has specks. */
    @ParameterizedTest
    @CsvSource({"1e-3, 0", "1e-3, 1000", "1, 0", "1, 1000", "1, 9000", "1, 1e5", "1000, 0", "1e6, 0", "1e6, 1e9"})
    void roundingDoesNotDecideWhetherAFlatSurfaceFacesIt(double scale, double far) {
        this.scale = scale;
        this.far = far;
        List<String> wrong = new ArrayList<>();
        double hair = 1e-9 * Math.max(scale, far / 1000);
        for (String shape : new String[] {"plane", "triangle", "mesh", "end"}) {
            for (int i = 0; i < LAMPS; i++) {
                Point lamp = point();
                Vector outward = direction();
                Object surface = around(shape, lamp, outward, new Material());
                Scene scene = Scenes.of(surface);
                Scenes.light(scene, new PointLight(lamp), new PointLight(at(lamp, outward, hair)),
                    new PointLight(at(lamp, outward, -hair)));
                RayStats stats = new RayStats();
                Point eye = at(at(lamp, outward, 3 * scale), direction(), scale);
                List<Intersector> intersectors = List.of(new BruteForceIntersector(scene),
                    new CompiledScene(scene, eye, 1, 1_000_000).intersector(stats));
                for (int k = 0; k < POINTS; k++) {
                    Ray ray = new Ray(eye, Vector.subtract(at(lamp, direction(), 0.6 * scale), eye).normalised());
                    for (Intersector intersector : intersectors) {
                        Hit hit = new Hit();
                        if (!intersector.intersect(ray, hit)) {
                            continue;
                        }
                        Interaction at = new Interaction();
                        at.set(ray, hit, surface);
                        if (at.normal.dot(outward) < 0.5) {              // the side of the cylinder
                            continue;
                        }
                        VisibilityTester tester = new VisibilityTester(intersector, true, stats);
                        for (int light = 0; light < 3; light++) {
                            boolean lit = tester.reaches(scene.getLight(light), light, at, new Colour(1, 1, 1));
                            if (lit != (light == 1)) {
                                wrong.add(shape + " and light " + light + ": N·L is " + tester.facing);
                            }
                        }
                    }
                }
            }
        }
        assertThat(wrong).isEmpty();
    }
}
