package simpleray.convert;

import java.io.IOException;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.EarClipper;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.Scene;
import simpleray.scene.Triangle;
import simpleray.text.SceneWriter;

/** The polygons of a scene, cut into triangles. A few can stand in the scene; many, and those with normals, go to an OBJ. <em>Mutable.</em> */
public final class Facets {
    /** The most polygons that stand in a scene as triangles. */
    static final int MAX_TRIANGLES = 300;

    private static final int MIN_CORNERS = 3;

    private final List<Facet> facets = new ArrayList<>();
    private final IdentityHashMap<Material, Integer> materials = new IdentityHashMap<>();   // their numbers in OBJ and MTL, from 1
    private final EarClipper clipper = new EarClipper();
    private int polygons;
    private boolean smooth;

    private record Facet(Triangle triangle, Vector[] normals) {
    }

    /** Creates facets without any polygon yet. */
    Facets() {
    }

    /**
     * Adds a polygon.
     *
     * @param material its material
     * @param vertices x, y, z of each corner, three corners or more
     * @param normals those of the corners likewise; null for none
     * @param crossed is run if the polygon crosses itself, and so is the fan from its first corner
     * @return its triangles; none if it is flat
     */
    List<Triangle> add(Material material, double[] vertices, double[] normals, Runnable crossed) {
        int count = vertices.length / 3;
        int[] corners = new int[count];
        for (int i = 0; i < count; i++) {
            corners[i] = i;
        }
        int[] cut = count == MIN_CORNERS ? EarClipper.FAN : clipper.cut(vertices, corners, count);
        boolean fan = cut == null || cut == EarClipper.FAN;
        List<Triangle> added = new ArrayList<>();
        for (int i = 0; i < (fan ? count - 2 : cut.length / 3); i++) {
            int[] three = fan ? new int[] {0, i + 1, i + 2} : new int[] {cut[3 * i], cut[3 * i + 1], cut[3 * i + 2]};
            Triangle triangle = new Triangle(material, point(vertices, three[0]), point(vertices, three[1]), point(vertices, three[2]));
            if (!triangle.isFlat()) {
                facets.add(new Facet(triangle, normals == null ? null
                    : new Vector[] {vector(normals, three[0]), vector(normals, three[1]), vector(normals, three[2])}));
                added.add(triangle);
            }
        }
        if (!added.isEmpty()) {
            polygons++;
            smooth |= normals != null;
            materials.putIfAbsent(material, materials.size() + 1);
            if (cut == null) {
                crossed.run();
            }
        }
        return added;
    }

    private static Point point(double[] xyz, int i) {
        return new Point(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
    }

    private static Vector vector(double[] xyz, int i) {
        return new Vector(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
    }

    /** {@return whether they belong into an OBJ: there are many, or some have normals} */
    public boolean areMesh() {
        return smooth || polygons > MAX_TRIANGLES;
    }

    /** {@return whether they have more than one material, and so need an MTL file} */
    public boolean areColourful() {
        return materials.size() > 1;
    }

    /** {@return a scene in which a mesh of this OBJ stands in place of all triangles, where the first of them stood} */
    Scene inMesh(Scene scene, String obj) {
        List<Object> objects = new ArrayList<>();
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            objects.add(scene.getObject(i));
        }
        Triangle first = facets.get(0).triangle;
        objects.set(objects.indexOf(first), Mesh.named(first.surfaceMaterial, obj, areColourful()));
        objects.removeIf(Triangle.class::isInstance);
        return scene.with(objects);
    }

    /** Writes an OBJ; corners in one place are one vertex. */
    void writeObj(SceneWriter os, String mtl) throws IOException {
        if (areColourful()) {
            os.writeString("mtllib " + mtl + '\n');
        }
        Map<List<Double>, Integer> vertices = new LinkedHashMap<>();
        Map<List<Double>, Integer> normals = new LinkedHashMap<>();
        for (Facet facet : facets) {
            for (Point p : corners(facet)) {
                number(vertices, p.x, p.y, p.z);
            }
            for (Vector n : facet.normals == null ? new Vector[0] : facet.normals) {
                number(normals, n.x, n.y, n.z);
            }
        }
        writeAll(os, "v ", vertices);
        writeAll(os, "vn ", normals);
        Material material = null;
        for (Facet facet : facets) {
            if (areColourful() && facet.triangle.surfaceMaterial != material) {
                material = facet.triangle.surfaceMaterial;
                os.writeString("usemtl m" + materials.get(material) + '\n');
            }
            os.writeString("f");
            for (int i = 0; i < MIN_CORNERS; i++) {
                Point p = corners(facet)[i];
                os.writeString(" " + number(vertices, p.x, p.y, p.z));
                if (facet.normals != null) {
                    os.writeString("//" + number(normals, facet.normals[i].x, facet.normals[i].y, facet.normals[i].z));
                }
            }
            os.writeNewline();
        }
    }

    private static Point[] corners(Facet facet) {
        return new Point[] {facet.triangle.a, facet.triangle.b, facet.triangle.c};
    }

    private static int number(Map<List<Double>, Integer> numbers, double x, double y, double z) {
        List<Double> xyz = List.of(x, y, z);
        numbers.putIfAbsent(xyz, numbers.size() + 1);
        return numbers.get(xyz);
    }

    private static void writeAll(SceneWriter os, String keyword, Map<List<Double>, Integer> all) throws IOException {
        for (List<Double> xyz : all.keySet()) {
            os.writeString(keyword);
            for (double number : xyz) {
                os.writeDouble(number);
            }
            os.writeNewline();
        }
    }

    /** Writes the materials; without {@code illum} a material mirrors by its specular colour. */
    void writeMtl(SceneWriter os) throws IOException {
        for (Map.Entry<Material, Integer> each : materials.entrySet().stream().sorted(Map.Entry.comparingByValue()).toList()) {
            Material material = each.getKey();
            os.writeString("newmtl m" + each.getValue() + '\n');
            writeColour(os, "Ka ", material.ambient);
            writeColour(os, "Kd ", material.diffuse);
            writeColour(os, "Ks ", material.specular);
            writeNumber(os, "Ns ", material.shininess);
            if (!material.transmission.isBlack()) {
                writeNumber(os, "Tr ", material.transmission.r);
                writeNumber(os, "Ni ", material.index);
            }
        }
    }

    private static void writeColour(SceneWriter os, String keyword, Colour colour) throws IOException {
        os.writeString(keyword);
        colour.write(os);
        os.writeNewline();
    }

    private static void writeNumber(SceneWriter os, String keyword, double number) throws IOException {
        os.writeString(keyword);
        os.writeDouble(number);
        os.writeNewline();
    }
}
