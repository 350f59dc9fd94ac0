package simpleray.scene;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import simpleray.math.Bounds;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * The polygons of a Wavefront OBJ, scaled about its origin and then moved. Both sides are visible; inside is the side from which the
 * vertices run clockwise after scaling: a scale below 0 mirrors the mesh at the origin, and so turns it inside out. Its material is that of all
 * polygons, or of those that MTL files give none.
 *
 * <p>Rays are transformed to the mesh, so that meshes of one file in a scene share its triangles.
 */
public final class Mesh extends Object {
    /** The largest error of a few roundings, as a share of a coordinate. */
    private static final double ROUNDINGS = 0x1p-49;

    /** The OBJ file, as the scene file names it. */
    public String file;
    /** The position of the OBJ's origin. */
    public Point offset;
    /** The factor of the OBJ's size; not 0. */
    public double scale;

    private TriangleMesh mesh;
    private MeshMaterials materials;                          // null without mtl

    /** Creates a mesh without triangles, to be read into. */
    public Mesh() {
        this(new Material(), "", new Point(), 1, Triangles.NONE);
    }

    /**
     * Creates the mesh of a file. The values are referenced, not copied.
     *
     * @param n the material
     * @param file the OBJ file
     * @param offset the position of the OBJ's origin
     * @param scale the factor of the OBJ's size; not 0
     * @throws SceneFormatException if there is an error in the file
     * @throws IOException if it cannot be read
     */
    public Mesh(Material n, String file, Point offset, double scale) throws IOException {
        this(n, file, offset, scale, new TriangleMesh(ObjReader.read(Path.of(file), warning -> { }), Path.of(file)));
    }

    /**
     * Creates a mesh of no file: a scene with it cannot be written. The values are referenced, not copied.
     *
     * @param n the material
     * @param vertices x, y, z of each vertex
     * @param corners three vertices of each triangle, counted from 0, anticlockwise as seen from outside
     * @return the mesh, its facets flat
     */
    public static Mesh of(Material n, double[] vertices, int[] corners) {
        return new Mesh(n, "", new Point(), 1, new Triangles(vertices, corners, new double[0], null));
    }

    /**
     * Creates a mesh that can only be written: its file, which need not be there yet, is not read.
     *
     * @param n the material, referenced
     * @param file the OBJ file
     * @param mtl whether polygons have the materials of the OBJ's MTL files
     * @return the mesh, without triangles
     */
    public static Mesh named(Material n, String file, boolean mtl) {
        Mesh mesh = new Mesh(n, file, new Point(), 1, Triangles.NONE);
        mesh.materials = mtl ? new MeshMaterials(new MaterialRuns(), new MtlMaterial[0], new Material[0]) : null;
        return mesh;
    }

    /** Creates the mesh of some triangles; the file is not read. */
    Mesh(Material n, String file, Point offset, double scale, Triangles triangles) {
        this(n, file, offset, scale, new TriangleMesh(triangles));
    }

    private Mesh(Material n, String file, Point offset, double scale, TriangleMesh mesh) {
        super(n);
        this.file = file;
        this.offset = offset;
        this.scale = scale;
        this.mesh = mesh;
    }

    /** Creates a mesh of the same triangles and materials in another place. */
    private Mesh(Mesh of, Point offset) {
        super(of.surfaceMaterial);
        file = of.file;
        this.offset = offset;
        scale = of.scale;
        mesh = of.mesh;
        materials = of.materials;
    }

    /** {@return the number of triangles} */
    public int size() {
        return mesh.triangles.count();
    }

    /**
     * Finds a vertex of a triangle, where it lies in the scene.
     *
     * @param triangle the triangle, from 0
     * @param corner which of its vertices, from 0 to 2
     * @return the vertex, a new point
     */
    public Point vertex(int triangle, int corner) {
        int v = 3 * mesh.triangles.corners()[3 * triangle + corner];
        double[] all = mesh.triangles.vertices();
        return new Point(all[v] * scale + offset.x, all[v + 1] * scale + offset.y, all[v + 2] * scale + offset.z);
    }

    /**
     * Finds the normal that the file gives a vertex of a triangle.
     *
     * @param triangle the triangle, from 0
     * @param corner which of its vertices, from 0 to 2
     * @return the normal, a new vector of unit length, or zero where the file's points nowhere; null if the triangle has no such normals
     */
    public Vector vertexNormal(int triangle, int corner) {
        int[] numbers = mesh.triangles.cornerNormals();
        if (numbers == null || numbers[3 * triangle] < 0) {
            return null;
        }
        int n = 3 * numbers[3 * triangle + corner];
        double[] all = mesh.triangles.normals();
        return new Vector(all[n], all[n + 1], all[n + 2]);
    }

    /**
     * Finds the line of a triangle's polygon. No mesh keeps its lines: the OBJ is read again up to there.
     *
     * @param triangle the triangle, from 0
     * @return the OBJ, as messages call it, a colon and the line, from 1; null if there is no OBJ, or it has no such triangle any more
     */
    public String place(int triangle) {
        try {
            int line = mesh.path == null ? 0 : ObjReader.line(mesh.path, triangle);
            return line == 0 ? null : mesh.path + ":" + line;
        } catch (IOException e) {
            return null;
        }
    }

    /** {@return a mesh for each material that triangles have, with these triangles alone; this mesh if all have its own} */
    public List<Mesh> pieces() {
        if (materials == null) {
            return List.of(this);
        }
        Map<Material, IntStream.Builder> triangles = new LinkedHashMap<>();
        for (int i = 0; i < size(); i++) {
            triangles.computeIfAbsent(material(i), material -> IntStream.builder()).add(i);
        }
        List<Mesh> pieces = new ArrayList<>();
        triangles.forEach((material, which) ->
            pieces.add(new Mesh(material, file, offset, scale, mesh.triangles.some(which.build().toArray()))));
        return pieces;
    }

    /** {@return where a material stands in an MTL file; null for the mesh's own} */
    RayTree.Mtl origin(Material material) {
        return materials == null ? null : materials.origin(material);
    }

    /** {@return the materials of its MTL files; null if it is to have none} */
    MeshMaterials materials() {
        return materials;
    }

    @Override
    public Material material(int part) {
        Material other = materials == null ? null : materials.get(materials.number(part));
        return other == null ? surfaceMaterial : other;
    }

    @Override
    public boolean isOpaque() {
        return super.isOpaque() && (materials == null || materials.areOpaque());
    }

    /** {@inheritDoc} Each of its materials that is hit counts once, as if its polygons were an object of their own. */
    @Override
    public Colour transmitted(Ray ray, double distance, Hit scratch) {
        if (materials == null) {
            return surfaceMaterial.transmission;
        }
        boolean[] met = ready(ray, scratch).crossed(distance);
        Colour left = new Colour(1, 1, 1);
        for (int i = 0; i < met.length; i++) {
            if (met[i]) {
                left.mult((i < met.length - 1 ? materials.get(i) : surfaceMaterial).transmission);
            }
        }
        return left;
    }

    /** {@return the triangles, which other meshes may share} */
    TriangleMesh mesh() {
        return mesh;
    }

    /** {@inheritDoc} A ray along a triangle misses it; a hit on an edge or a vertex is one. */
    @Override
    public double intersect(Ray ray) {
        Hit hit = new Hit();
        intersect(ray, 0, hit);
        return hit.place == Hit.NONE ? MISS : hit.t;
    }

    @Override
    public void intersect(Ray ray, int place, Hit hit) {
        TriangleIntersector triangles = ready(ray, hit);
        if (triangles.closest(hit.t) && hit.accepts(triangles.t, place)) {
            set(hit, triangles.t, place, triangles.triangle, triangles);
        }
    }

    @Override
    public boolean occludes(Ray ray, double distance, Hit scratch) {
        return ready(ray, scratch).occluded(distance);
    }

    @Override
    public int parts() {
        return size();
    }

    @Override
    public void partBounds(int part, double[] box) {
        mesh.triangles.bounds(part, box);
        Point low = corner(box, scale > 0 ? 0 : 3, -1);
        Point high = corner(box, scale > 0 ? 3 : 0, 1);
        box[0] = low.x;
        box[1] = low.y;
        box[2] = low.z;
        box[3] = high.x;
        box[4] = high.y;
        box[5] = high.z;
    }

    @Override
    public void intersect(Ray ray, int place, int part, Hit hit) {
        TriangleIntersector triangles = ready(ray, hit);
        double t = triangles.test(part);
        if (hit.accepts(t, place) || t == hit.t && place == hit.place && part < hit.part) {
            set(hit, t, place, part, triangles);
        }
    }

    @Override
    public boolean occludes(Ray ray, double distance, int part, Hit scratch) {
        double t = ready(ray, scratch).test(part);
        return t >= 0 && t < distance;
    }

    /** {@return the intersector of this mesh's triangles, prepared for a ray} */
    private TriangleIntersector ready(Ray ray, Hit hit) {
        TriangleIntersector triangles = hit.triangles();
        if (triangles.mesh != this) {
            triangles.mesh = this;
            Point o = ray.origin;
            Vector d = ray.direction;
            triangles.start(mesh, (o.x - offset.x) / scale, (o.y - offset.y) / scale, (o.z - offset.z) / scale, d.x / scale, d.y / scale,
                d.z / scale);
        }
        return triangles;
    }

    private static void set(Hit hit, double t, int place, int part, TriangleIntersector triangles) {
        hit.set(t, place);
        hit.part = part;
        hit.weights[0] = triangles.weightA;
        hit.weights[1] = triangles.weightB;
        hit.weights[2] = triangles.weightC;
    }

    @Override
    public void prepare(int threads) {
        mesh.tree(threads);
    }

    /** {@inheritDoc} It is that of the nearest triangle, not interpolated. All triangles are searched: {@link #surface} is fast. */
    @Override
    public Vector normal(Point p) {
        double[] place = {(p.x - offset.x) / scale, (p.y - offset.y) / scale, (p.z - offset.z) / scale};
        int nearest = 0;
        double distance = Double.POSITIVE_INFINITY;
        for (int i = 0; i < size(); i++) {
            double other = mesh.triangles.squaredDistance(i, place);
            if (other < distance) {
                nearest = i;
                distance = other;
            }
        }
        return outward(nearest);
    }

    /** {@return the unit normal of a triangle, which neither translation nor scaling changes} */
    private Vector outward(int triangle) {
        double[] n = new double[3];
        mesh.triangles.cross(triangle, n);
        return new Vector(n[0], n[1], n[2]).normalised();
    }

    @Override
    public void surface(Hit hit, Interaction at) {
        double[] n = hit.triangles().normal;
        mesh.triangles.cross(hit.part, n);
        at.outward.set(n[0], n[1], n[2]);
        at.outward.normalise();
        if (mesh.triangles.interpolate(hit.part, hit.weights, n)) {
            at.normal.set(n[0], n[1], n[2]);
            at.normal.normalise();
        } else {
            at.normal.copy(at.outward);
        }
        if (materials != null) {
            at.material = material(hit.part);
        }
    }

    @Override
    public Bounds bounds() {
        if (size() == 0) {
            return Bounds.of(offset);
        }
        double[] box = mesh.box;
        return Bounds.of(corner(box, 0, -1), corner(box, 3, -1), corner(box, 0, 1), corner(box, 3, 1));
    }

    /** {@return a corner of the mesh's box in the scene, moved by a few roundings} */
    private Point corner(double[] box, int at, int roundings) {
        double share = roundings * ROUNDINGS;
        double x = box[at] * scale;
        double y = box[at + 1] * scale;
        double z = box[at + 2] * scale;
        return new Point(x + offset.x + share * (Math.abs(x) + Math.abs(offset.x)),
            y + offset.y + share * (Math.abs(y) + Math.abs(offset.y)), z + offset.z + share * (Math.abs(z) + Math.abs(offset.z)));
    }

    @Override
    public boolean isSolid() {
        return mesh.triangles.isClosed();
    }

    @Override
    public Object moved(Vector t) {
        return new Mesh(this, Lengths.moved(offset, t));
    }

    @Override
    public void print(SceneWriter os) throws IOException {
        os.writeString("Mesh of \"" + file + "\" with " + size() + " triangles, moved by ");
        offset.print(os);
        os.writeString(", scaled by ");
        os.writeDouble(scale);
        double[] box = mesh.box;
        os.writeString(", from ");
        corner(box, scale > 0 ? 0 : 3, 0).print(os);
        os.writeString(" to ");
        corner(box, scale > 0 ? 3 : 0, 0).print(os);
        os.writeString(materials == null ? "" : ", with the materials of its MTL files");
        os.writeNewline();
        surfaceMaterial.print(os);
    }

    @Override
    public void read(SceneReader is) throws IOException {
        file = is.readQuoted("OBJ file");
        mesh = MeshFiles.of(is).load(is, file);
        is.group();
        offset = Lengths.readPoint(is, "offset");
        Lengths.check(is, "offset", offset.x, offset.y, offset.z);
        scale = is.readDouble("scale");
        if (scale == 0) {
            is.reject("scale other than 0");
        } else if (Math.abs(scale) > Lengths.MAX_SCALE) {
            is.reject("scale from -1e60 to 1e60");
        } else if (largest(mesh.box) * Math.abs(scale) * (1 - ROUNDINGS) > Lengths.MAX) {
            is.reject("scale that leaves the mesh's coordinates from -1e100 to 1e100");
        }
        Material own = new Material();
        boolean mtl = own.readOfMesh(is);
        surfaceMaterial = is.kept(Materials.class, Materials.MAKER).shared(own);
        materials = mtl ? MeshFiles.of(is).materials(is, file, mesh, surfaceMaterial) : null;
    }

    private static double largest(double[] box) {
        double largest = 0;
        for (double side : box) {
            largest = Math.max(largest, Math.abs(side));
        }
        return largest;
    }

    @Override
    public void write(SceneWriter os) throws IOException {
        if (file.isEmpty() || file.matches("(?s).*[\"\n\r].*")) {
            throw new IllegalArgumentException("a scene file cannot name the file " + Diagnostic.quoted(file));
        }
        os.writeString('"' + file + "\" ");
        offset.write(os);
        os.writeDouble(scale);
        os.writeString("  ");
        surfaceMaterial.write(os);
        os.writeString(materials == null ? "" : "  mtl");
    }
}
