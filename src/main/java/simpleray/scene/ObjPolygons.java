package simpleray.scene;

import de.javagl.obj.AbstractWritableObj;
import de.javagl.obj.FloatTuple;
import de.javagl.obj.ObjFace;
import de.javagl.obj.ObjReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.Consumer;
import simpleray.text.Problem;
import simpleray.text.SceneBytes;

/**
 * Takes the polygons of a Wavefront OBJ as they are read, and makes triangles of them: each polygon a fan from its first vertex.
 * <em>Mutable</em>, for one thread. Coordinates are read as floats.
 */
final class ObjPolygons extends AbstractWritableObj {
    private static final int INITIAL = 1 << 10;

    private final ObjLines lines;
    private final double[] scratch = new double[3];
    private double[] vertices = new double[3 * INITIAL];
    private double[] normals = new double[3 * INITIAL];
    private int[] corners = new int[3 * INITIAL];
    private int[] cornerNormals;
    private int vertexEnd;
    private int normalEnd;
    private int cornerEnd;
    private int flat;
    private Problem firstFlat;

    private ObjPolygons(ObjLines lines) {
        this.lines = lines;
    }

    /** Reads a file of which nobody asks for the digest. */
    static Triangles read(Path path, Consumer<Problem> warnings) throws IOException {
        return read(path, warnings, digest -> { });
    }

    /**
     * Reads a file.
     *
     * @param path the file; its path as given stands in messages
     * @param warnings told of each warning
     * @param digest told of the file's SHA-256
     * @return its triangles, at least one
     * @throws simpleray.text.SceneFormatException if it is no OBJ with polygons
     * @throws FileSystemException if it cannot be opened, with a reason that people understand
     * @throws IOException if it cannot be read
     */
    static Triangles read(Path path, Consumer<Problem> warnings, Consumer<String> digest) throws IOException {
        if (Files.isDirectory(path)) {
            throw new FileSystemException(path.toString(), null, "is a folder");
        }
        if (Files.exists(path) && !Files.isRegularFile(path)) {   // a pipe or a device may never end
            throw new FileSystemException(path.toString(), null, "is no regular file");
        }
        try (SceneBytes in = new SceneBytes(Files.newInputStream(path), 0)) {
            Triangles read = read(in, path.toString(), warnings);
            digest.accept(in.sha256());
            return read;
        } catch (NoSuchFileException | AccessDeniedException e) {
            String reason = e instanceof NoSuchFileException ? "no such file" : "may not be read";
            throw (IOException) new FileSystemException(path.toString(), null, reason).initCause(e);
        }
    }

    /** Reads the text of an OBJ; messages call it by this name. */
    static Triangles read(InputStream in, String name, Consumer<Problem> warnings) throws IOException {
        ObjLines lines = new ObjLines(new InputStreamReader(in, StandardCharsets.UTF_8), name);
        return ObjReader.read(lines, new ObjPolygons(lines)).triangles(warnings);
    }

    @Override
    public void addVertex(FloatTuple v) {
        vertices = roomFor(3, vertices, vertexEnd);
        vertices[vertexEnd++] = v.getX();
        vertices[vertexEnd++] = v.getY();
        vertices[vertexEnd++] = v.getZ();
    }

    @Override
    public void addNormal(FloatTuple n) {
        normals = roomFor(3, normals, normalEnd);
        double x = n.getX();
        double y = n.getY();
        double z = n.getZ();
        double length = Math.sqrt(x * x + y * y + z * z);
        double scale = length > 0 ? 1 / length : 0;
        normals[normalEnd++] = x * scale;
        normals[normalEnd++] = y * scale;
        normals[normalEnd++] = z * scale;
    }

    @Override
    public void addFace(ObjFace face) {
        if (face.containsNormalIndices() && cornerNormals == null) {
            cornerNormals = new int[corners.length];
            Arrays.fill(cornerNormals, 0, cornerEnd, -1);
        }
        for (int i = 2; i < face.getNumVertices(); i++) {
            addTriangle(face, i);
        }
    }

    private void addTriangle(ObjFace face, int last) {
        int a = face.getVertexIndex(0);
        int b = face.getVertexIndex(last - 1);
        int c = face.getVertexIndex(last);
        if (!Triangles.cross(vertices, 3 * a, 3 * b, 3 * c, scratch)) {
            if (flat++ == 0) {
                firstFlat = lines.warning("");
            }
            return;
        }
        if (cornerEnd == corners.length) {
            corners = Arrays.copyOf(corners, larger(cornerEnd));
            cornerNormals = cornerNormals == null ? null : Arrays.copyOf(cornerNormals, corners.length);
        }
        if (cornerNormals != null) {
            boolean has = face.containsNormalIndices();
            cornerNormals[cornerEnd] = has ? face.getNormalIndex(0) : -1;
            cornerNormals[cornerEnd + 1] = has ? face.getNormalIndex(last - 1) : -1;
            cornerNormals[cornerEnd + 2] = has ? face.getNormalIndex(last) : -1;
        }
        corners[cornerEnd++] = a;
        corners[cornerEnd++] = b;
        corners[cornerEnd++] = c;
    }

    private Triangles triangles(Consumer<Problem> warnings) throws IOException {
        if (cornerEnd == 0) {
            throw lines.missing("a polygon that has an area");
        }
        if (flat > 0) {
            warnings.accept(new Problem(firstFlat.file(), firstFlat.line(), firstFlat.column(), false, "expected triangles that have an"
                + " area, found " + flat + " without, which " + (flat == 1 ? "is" : "are") + " skipped", firstFlat.source()));
        }
        return new Triangles(Arrays.copyOf(vertices, vertexEnd), Arrays.copyOf(corners, cornerEnd), Arrays.copyOf(normals, normalEnd),
            cornerNormals == null ? null : Arrays.copyOf(cornerNormals, cornerEnd));
    }

    private static double[] roomFor(int more, double[] array, int end) {
        return end + more <= array.length ? array : Arrays.copyOf(array, larger(end));
    }

    /** {@return a length half as much again, a multiple of 3 as all lengths here are} */
    private static int larger(int length) {
        return (int) Math.min((Integer.MAX_VALUE - 8L) / 3, length / 3 * 3L / 2 + 1) * 3;
    }
}
