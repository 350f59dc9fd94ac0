package simpleray;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Cone;
import simpleray.scene.Cylinder;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;
import simpleray.scene.Triangle;

/** Convex bodies about the origin, of each shape, that fit into a sphere of radius √3: to be seen from outside or from within. */
final class Bodies {
    private static final int[][] FACES = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    private static final int SIDES = 12;

    private Bodies() {
    }

    /** {@return each body's scene, without lights, by its name} */
    static Map<String, Scene> all(Material material, Path folder) throws IOException {
        Map<String, Scene> bodies = new LinkedHashMap<>();
        bodies.put("sphere", scene(List.of(new Sphere(material, new Point(), 1))));
        bodies.put("cylinder", scene(List.of(new Cylinder(material, new Point(0, -1, 0), new Point(0, 1, 0), 1))));
        bodies.put("double cone", scene(List.of(new Cone(material, new Point(), 1, new Point(0, 1.3, 0), 0),
            new Cone(material, new Point(0, -1.2, 0), 0, new Point(), 1))));
        bodies.put("box of planes", scene(planes(material)));
        bodies.put("box of triangles", scene(triangles(material)));
        bodies.put("box as a mesh", scene(List.of(new Mesh(material, box(folder).toString(), new Point(), 1))));
        bodies.put("prism of triangles", scene(prism(material)));
        return bodies;
    }

    /** {@return a scene of these objects} */
    static Scene scene(List<? extends Object> objects) {
        Scene scene = new Scene();
        scene.setNumberObjects(objects.size());
        for (int i = 0; i < objects.size(); i++) {
            scene.setObject(i, objects.get(i));
        }
        return scene;
    }

    /** {@return an OBJ file of the cube from -1 to 1} */
    static Path box(Path folder) throws IOException {
        Path file = folder.resolve("box.obj");
        List<String> lines = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            Point p = corner(i);
            lines.add("v " + p.x + ' ' + p.y + ' ' + p.z);
        }
        for (int[] f : FACES) {
            lines.add("f " + (f[0] + 1) + ' ' + (f[1] + 1) + ' ' + (f[2] + 1) + ' ' + (f[3] + 1));
        }
        return Files.write(file, lines);
    }

    /** {@return a corner of the cube: one bit of its number for each of x, y and z} */
    private static Point corner(int number) {
        return new Point((number & 1) * 2 - 1, (number >> 1 & 1) * 2 - 1, (number >> 2) * 2 - 1);
    }

    private static List<Object> planes(Material material) {
        List<Object> planes = new ArrayList<>();
        for (int side = -1; side <= 1; side += 2) {
            planes.add(new Plane(material, new Vector(side, 0, 0), 1));
            planes.add(new Plane(material, new Vector(0, side, 0), 1));
            planes.add(new Plane(material, new Vector(0, 0, side), 1));
        }
        return planes;
    }

    /** {@return the cube, two triangles a face, their outside outward} */
    static List<Object> triangles(Material material) {
        List<Object> triangles = new ArrayList<>();
        for (int[] f : FACES) {
            triangles.add(new Triangle(material, corner(f[0]), corner(f[1]), corner(f[2])));
            triangles.add(new Triangle(material, corner(f[0]), corner(f[2]), corner(f[3])));
        }
        return triangles;
    }

    /** {@return an upright prism with many sides: no coordinate of it is a round number} */
    private static List<Object> prism(Material material) {
        List<Object> triangles = new ArrayList<>();
        Point top = new Point(0, 1, 0);
        Point bottom = new Point(0, -1, 0);
        for (int i = 0; i < SIDES; i++) {
            Point low = rim(i, -1);
            Point next = rim(i + 1, -1);
            Point high = rim(i, 1);
            Point across = rim(i + 1, 1);
            triangles.add(new Triangle(material, low, high, next));
            triangles.add(new Triangle(material, next, high, across));
            triangles.add(new Triangle(material, top, across, high));
            triangles.add(new Triangle(material, bottom, low, next));
        }
        return triangles;
    }

    private static Point rim(int number, double y) {
        double angle = 2 * Math.PI * (number % SIDES) / SIDES + 0.1;
        return new Point(StrictMath.cos(angle), y, StrictMath.sin(angle));
    }
}
