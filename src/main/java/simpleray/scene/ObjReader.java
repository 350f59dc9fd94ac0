package simpleray.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import simpleray.io.Sha256;
import simpleray.text.BadNumber;
import simpleray.text.Diagnostic;
import simpleray.text.NumberParser;
import simpleray.text.SceneFormatException;

/**
 * Reads the polygons of a Wavefront OBJ as triangles: a convex polygon is a fan from its first vertex, any other is cut by an
 * {@link EarClipper}. One that crosses itself is a fan, too, with a warning. <em>Mutable,</em> for one thread.
 *
 * <p>Of the format (Wavefront, "Advanced Visualizer Manual", appendix B1) these lines are read, and all others are skipped:
 * <pre>
 * v  x y z                           a vertex; a weight or a colour after it is skipped
 * vn x y z                           a normal, of any length
 * f  v/vt/vn v/vt/vn v/vt/vn ...     a polygon: indices of vertices, textures and normals; also v, v/vt and v//vn
 * usemtl name                        the material of the polygons that follow
 * mtllib name ...                    the files of the materials
 * </pre>
 * Numbers have the form of a scene file. An index counts from 1, or backwards from -1, the things above its line. {@code fo} is an old word for
 * {@code f}. What a picture does not need (a normal that is 0, not finite or not there; a polygon of fewer than three corners; a vertex that is not
 * finite and that no polygon names) is passed over, with one warning of each kind (spec.md, section 5).
 *
 * <p>A file of a million triangles is read by code that the JVM has not compiled yet. Therefore the methods for common lines are small
 * and work on bytes; they leave any other line to methods that read it again as text, know all rules and report errors.
 */
final class ObjReader {
    private static final Set<String> KEYWORDS = Set.of("v", "vt", "vn", "f", "fo", "l", "o", "g", "s", "usemtl", "mtllib");
    private static final int INITIAL = 1 << 10;
    private static final int MIN_CORNERS = 3;
    /** The most digits that always fit into an {@code int}. */
    private static final int MAX_DIGITS = 9;
    private static final int NONE = -1;
    private static final String NORMAL = "normal ";
    /** A word that is not finite, or a number too large for a double. Not compiled, since few files have such a word. */
    private static final String NOT_FINITE =
        "(?i)[+-]?((nan|inf|infinity)(\\(.*\\))?|1\\.#(ind|inf|[qs]nan)\\d*|(\\d+\\.?\\d*|\\.\\d+)(e\\+?\\d+)?)";

    private final LineReader lines;
    private final NumberParser numbers = new NumberParser();
    private byte[] bytes;                                     // of the line
    private int at;                                           // after the latest word of the line
    private int end;                                          // of the line

    private double[] vertices = new double[3 * INITIAL];
    private double[] normals = new double[3 * INITIAL];
    private int[] triangles = new int[3 * INITIAL];
    private int[] triangleNormals;                            // null until there is a polygon with normals
    private int vertexCount;
    private int normalCount;
    private int triangleEnd;
    private int polygonCount;

    private int[] corners = new int[MIN_CORNERS + 1];         // of the polygon: its vertices
    private int[] cornerNormals = new int[MIN_CORNERS + 1];   // and its normals, or NONE of each
    private int cornerCount;
    private boolean lacksNormals;                             // it names one that is not there
    private final MaterialRuns runs = new MaterialRuns();
    private double[] cross = new double[3];                   // product of the edges of the latest triangle
    private double[] other = new double[3];                   // and of the one before
    private final EarClipper clipper = new EarClipper();

    private final PassedOver flat = new PassedOver("triangles that have an area", "without, which is skipped", "without, which are skipped");
    private final PassedOver few = new PassedOver("polygons of at least 3 corners", "of fewer, which is skipped", "of fewer, which are skipped");
    private final PassedOver crossed = new PassedOver("polygons that do not cross themselves", "that does, which becomes a fan of triangles",
        "that do, which become fans of triangles");
    private final PassedOver aimless = new PassedOver("normals of finite length above 0", "that has none, which is passed over",
        "that have none, which are passed over");
    private final PassedOver bare = new PassedOver("polygons with normals at all corners or at none", "that lacks some, which is shaded flat",
        "that lack some, which are shaded flat");
    private final PassedOver joined = new PassedOver("a line of its own for each keyword", "line that the backslash before it joins to another",
        "lines that the backslash before them joins to others");
    private final PassedOver unused = new PassedOver("finite coordinates", "vertex without, which no polygon names",
        "vertices without, which no polygon names");
    private Map<Integer, SceneFormatException> infinite = Map.of();     // of each vertex that is not finite, what is wrong with it

    private ObjReader(LineReader lines) {
        this.lines = lines;
    }

    /** Reads a file without its digest. */
    static Triangles read(Path path, Consumer<Diagnostic> warnings) throws IOException {
        return read(path, warnings, digest -> { });
    }

    /**
     * Reads a file.
     *
     * @param path the file; its path as given stands in messages
     * @param warnings gets each warning
     * @param digest gets the file's SHA-256
     * @return its triangles, at least one
     * @throws SceneFormatException if it is no OBJ with polygons; a warning of joined lines, which may be the cause, comes first
     * @throws FileSystemException if it cannot be opened, with a readable reason
     * @throws IOException if it cannot be read
     */
    static Triangles read(Path path, Consumer<Diagnostic> warnings, Consumer<String> digest) throws IOException {
        try (DigestInputStream in = MeshFiles.open(path)) {
            Triangles read = read(in, path.toString(), warnings);
            digest.accept(Sha256.hex(in.getMessageDigest().digest()));
            return read;
        }
    }

    /** Reads the text of an OBJ; messages call it by this name. */
    static Triangles read(InputStream in, String name, Consumer<Diagnostic> warnings) throws IOException {
        ObjReader reader = new ObjReader(new LineReader(in, name));
        try {
            while (reader.lines.read()) {
                if (reader.lines.isContinued()) {
                    reader.joined.addJoined(reader.lines, KEYWORDS);
                }
                reader.readLine();
            }
            return reader.triangles(warnings);
        } catch (SceneFormatException e) {
            List<Diagnostic> problems = new ArrayList<>();
            reader.joined.warn(problems::add);                // perhaps its cause
            problems.addAll(e.problems());
            throw new SceneFormatException(problems, false);
        }
    }

    /**
     * Finds the line on which a triangle's polygon begins.
     *
     * @param path the file
     * @param triangle the triangle, from 0
     * @return the line, from 1; 0 if there is no such triangle
     * @throws IOException if the file cannot be read, or has an error before it
     */
    static int line(Path path, int triangle) throws IOException {
        try (InputStream in = MeshFiles.open(path)) {
            ObjReader reader = new ObjReader(new LineReader(in, path.toString()));
            while (reader.lines.read()) {
                reader.readLine();
                if (reader.triangleEnd / 3 > triangle) {
                    return reader.lines.number();
                }
            }
            return 0;
        }
    }

    private void readLine() throws SceneFormatException {
        bytes = lines.bytes;
        end = lines.end;
        at = lines.begin;
        skipBlanks();
        int keyword = at;
        skipWord();
        int first = at > keyword ? bytes[keyword] | ' ' : 0;  // in lower case
        if (at - keyword == 1) {
            if (first == 'v') {
                readVertex();
            } else if (first == 'f') {
                readPolygon();
            }
        } else if (at - keyword == 2 && first == 'f' && (bytes[keyword + 1] | ' ') == 'o') {
            readPolygon();
        } else if (at - keyword == 2 && first == 'v' && (bytes[keyword + 1] | ' ') == 'n') {
            readNormal();
        } else if (first == 'u' || first == 'm') {
            readMaterial(lines.text(keyword, at).toLowerCase(Locale.ROOT));
        }
    }

    private void readMaterial(String keyword) {
        if (keyword.equals("usemtl")) {
            runs.begin(triangleEnd / 3, lines.name(at), lines);
        } else if (keyword.equals("mtllib")) {
            runs.libraries.add(new MaterialRuns.Name(lines.names(at), lines.warning("")));
        }
    }

    private void skipBlanks() {
        int i = at;
        while (i < end && LineReader.isBlank(bytes[i])) {
            i++;
        }
        at = i;
    }

    private void skipWord() {
        int i = at;
        while (i < end && !LineReader.isBlank(bytes[i])) {
            i++;
        }
        at = i;
    }

    private void readVertex() throws SceneFormatException {
        int i = 3 * vertexCount++;
        vertices = withRoom(vertices, i);
        try {
            vertices[i] = readNumber("vertex ", vertexCount, 'x');
            vertices[i + 1] = readNumber("vertex ", vertexCount, 'y');
            vertices[i + 2] = readNumber("vertex ", vertexCount, 'z');
        } catch (NotFiniteException e) {
            unused.add(lines);                                     // or a polygon names it, and then it is an error
            infinite = infinite.isEmpty() ? new HashMap<>() : infinite;
            infinite.put(vertexCount - 1, e.problem);
        }
    }

    /** Reads a normal and scales it to unit length; zero stays zero. */
    private void readNormal() throws SceneFormatException {
        int i = 3 * normalCount++;
        normals = withRoom(normals, i);
        double x;
        double y;
        double z;
        try {
            x = readNumber(NORMAL, normalCount, 'x');
            y = readNumber(NORMAL, normalCount, 'y');
            z = readNumber(NORMAL, normalCount, 'z');
        } catch (NotFiniteException e) {
            aimless.add(lines);                                    // its components stay 0
            return;
        }
        // an exact power of two, so that squares of small components do not underflow
        double unit = Math.scalb(1.0, -Math.getExponent(Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)))));
        x *= unit;
        y *= unit;
        z *= unit;
        double length = Math.sqrt(x * x + y * y + z * z);
        double scale = length > 0 ? 1 / length : 0;
        if (scale == 0) {
            aimless.add(lines);
        }
        normals[i] = x * scale;
        normals[i + 1] = y * scale;
        normals[i + 2] = z * scale;
    }

    private double readNumber(String owner, int number, char axis) throws SceneFormatException, NotFiniteException {
        skipBlanks();
        int word = at;
        double value = numbers.parseDouble(bytes, word);
        at = numbers.end();
        return Math.abs(value) <= Lengths.MAX && bytes[at] != '#' ? value : readUnusualNumber(word, owner, number, axis);   // 1.#IND
    }

    private double readUnusualNumber(int begin, String owner, int number, char axis) throws SceneFormatException, NotFiniteException {
        at = begin;
        skipWord();
        String word = lines.text(begin, at);
        double value = NumberParser.parseDouble(word);
        if (Math.abs(value) <= (owner.equals(NORMAL) ? Double.MAX_VALUE : Lengths.MAX)) {
            return value;
        }
        String why = Double.isNaN(value) ? "" : " (beyond 1e100, the largest coordinate)";
        SceneFormatException problem = lines.error(begin, owner + number + "'s " + axis, found(word) + why);
        if (!Double.isNaN(value) || word.matches(NOT_FINITE)) {
            throw new NotFiniteException(problem);
        }
        throw problem;
    }

    private void readPolygon() throws SceneFormatException {
        polygonCount++;
        cornerCount = 0;
        lacksNormals = false;
        skipBlanks();
        while (at < end) {
            readCorner();
            lacksNormals |= cornerNormals[cornerCount - 1] != NONE != (cornerNormals[0] != NONE);
            skipBlanks();
        }
        if (cornerCount < MIN_CORNERS) {
            few.add(lines);
            return;
        }
        for (int i = 0; i < cornerCount && !infinite.isEmpty(); i++) {
            if (infinite.containsKey(corners[i])) {
                throw infinite.get(corners[i]);
            }
        }
        if (lacksNormals) {
            bare.add(lines);
            Arrays.fill(cornerNormals, 0, cornerCount, NONE);
        }
        if (cornerNormals[0] != NONE && triangleNormals == null) {
            triangleNormals = new int[triangles.length];
            Arrays.fill(triangleNormals, 0, triangleEnd, NONE);
        }
        if (cornerCount > MIN_CORNERS + 1) {
            addPolygon();
            return;
        }
        int before = triangleEnd;
        addFan();
        if (triangleEnd == before + 2 * MIN_CORNERS && !facesOneWay()) {
            triangleEnd = before;
            addPolygon();
        }
    }

    private void addFan() {
        for (int i = 2; i < cornerCount; i++) {
            double[] last = cross;
            cross = other;
            other = last;
            addTriangle(0, i - 1, i);
        }
    }

    /** {@return whether the latest two triangles face the same way} */
    private boolean facesOneWay() {
        return cross[0] * other[0] + cross[1] * other[1] + cross[2] * other[2] > 0;
    }

    /** Reads a corner: v, v/vt, v//vn or v/vt/vn. */
    private void readCorner() throws SceneFormatException {
        int word = at;
        int vertex = fromStart(readInteger(), vertexCount);
        int normal = NONE;
        boolean known = vertex != NONE;
        if (known && bytes[at] == '/') {
            at++;
            known = bytes[at] == '/' || readInteger() != 0;
            if (known && bytes[at] == '/') {
                at++;
                normal = fromStart(readInteger(), normalCount);
                known = normal != NONE;
            }
        }
        if (known && (at == end || LineReader.isBlank(bytes[at]))) {
            addCorner(vertex, normal);
        } else {
            readUnusualCorner(word);
        }
    }

    /** Reads an integer of a few digits. {@return it, or 0, which is no index, if there is none} */
    private int readInteger() {
        boolean negative = bytes[at] == '-';
        int begin = negative ? at + 1 : at;
        int i = begin;
        int value = 0;
        while (bytes[i] >= '0' && bytes[i] <= '9') {
            value = 10 * value + bytes[i++] - '0';
        }
        at = i;
        return i - begin > MAX_DIGITS ? 0 : negative ? -value : value;
    }

    /** {@return the index from 0 of one of the things so far; NONE if there is no such thing} */
    private static int fromStart(int index, int count) {
        return index > 0 && index <= count ? index - 1 : index < 0 && index >= -count ? count + index : NONE;
    }

    private void readUnusualCorner(int begin) throws SceneFormatException {
        at = begin;
        skipWord();
        String word = lines.text(begin, at);
        String[] indices = word.split("/", -1);
        int vertex = index(begin, word, indices[0], vertexCount, "vertex");
        if (indices.length > 1 && !indices[1].isEmpty()) {
            if (NumberParser.parseInteger(indices[1], Long.MIN_VALUE, Long.MAX_VALUE) == null) {
                throw error(begin, "texture index", found(word));   // any will do, since no picture needs it
            }
        }
        int normal = indices.length > 2 && !indices[2].isEmpty() ? normalIndex(begin, word, indices[2]) : NONE;
        if (indices.length > 3) {
            throw error(begin, "vertex/texture/normal", found(word));
        }
        addCorner(vertex, normal);
    }

    private int normalIndex(int begin, String word, String index) throws SceneFormatException {
        Long value = NumberParser.parseInteger(index, Long.MIN_VALUE, Long.MAX_VALUE);
        if (value != null && (value == 0 || value < -normalCount || value > normalCount)) {
            lacksNormals = true;
            return NONE;
        }
        return index(begin, word, index, normalCount, "normal");
    }

    private int index(int begin, String word, String index, int count, String what) throws SceneFormatException {
        Long value = NumberParser.parseInteger(index, -count, count);
        if (value == null || value == 0) {
            boolean number = NumberParser.parseInteger(index, Long.MIN_VALUE, Long.MAX_VALUE) != null;
            String range = number ? " among the " + count + " so far" : "";
            throw error(begin, what + " index" + range, found(word));
        }
        return fromStart(value.intValue(), count);
    }

    private SceneFormatException error(int begin, String wanted, String found) {
        return lines.error(begin, "polygon " + polygonCount + "'s " + wanted, found);
    }

    private static String found(String word) {
        return word.isEmpty() ? "the end of the line" : BadNumber.describe(word);
    }

    private void addCorner(int vertex, int normal) {
        if (cornerCount == corners.length) {
            corners = Arrays.copyOf(corners, 2 * cornerCount);
            cornerNormals = Arrays.copyOf(cornerNormals, 2 * cornerCount);
        }
        corners[cornerCount] = vertex;
        cornerNormals[cornerCount++] = normal;
    }

    /** Adds a polygon that may not be convex. */
    private void addPolygon() {
        int[] cut = clipper.cut(vertices, corners, cornerCount);
        if (cut == null || cut == EarClipper.FAN) {
            int before = triangleEnd;
            addFan();
            if (cut == null && triangleEnd > before) {
                crossed.add(lines);
            }
            return;
        }
        for (int i = 0; i < cut.length; i += 3) {
            addTriangle(cut[i], cut[i + 1], cut[i + 2]);
        }
    }

    /** Adds the triangle of three corners of the polygon, unless it is flat. */
    private void addTriangle(int first, int second, int third) {
        if (!Triangles.cross(vertices, 3 * corners[first], 3 * corners[second], 3 * corners[third], cross)) {
            flat.add(lines);
            return;
        }
        if (triangleEnd == triangles.length) {
            triangles = Arrays.copyOf(triangles, larger(triangleEnd));
            triangleNormals = triangleNormals == null ? null : Arrays.copyOf(triangleNormals, triangles.length);
        }
        if (triangleNormals != null) {
            triangleNormals[triangleEnd] = cornerNormals[first];
            triangleNormals[triangleEnd + 1] = cornerNormals[second];
            triangleNormals[triangleEnd + 2] = cornerNormals[third];
        }
        triangles[triangleEnd++] = corners[first];
        triangles[triangleEnd++] = corners[second];
        triangles[triangleEnd++] = corners[third];
    }

    private Triangles triangles(Consumer<Diagnostic> warnings) throws SceneFormatException {
        if (triangleEnd == 0) {
            throw lines.missing("a polygon that has an area");
        }
        for (PassedOver each : new PassedOver[] {flat, few, crossed, aimless, bare, unused, joined}) {
            each.warn(warnings);
        }
        runs.end(triangleEnd / 3);
        return new Triangles(Arrays.copyOf(vertices, 3 * vertexCount), Arrays.copyOf(triangles, triangleEnd),
            Arrays.copyOf(normals, 3 * normalCount), triangleNormals == null ? null : Arrays.copyOf(triangleNormals, triangleEnd), runs);
    }

    /** A number is no number or infinite: an error, unless the picture does not need it. */
    private static final class NotFiniteException extends Exception {
        private static final long serialVersionUID = 1L;
        final transient SceneFormatException problem;

        NotFiniteException(SceneFormatException problem) {
            super(problem);
            this.problem = problem;
        }
    }

    /** {@return an array with room for three more numbers at this index} */
    private static double[] withRoom(double[] array, int place) {
        return place < array.length ? array : Arrays.copyOf(array, larger(place));
    }

    /** {@return a length 1.5 times as large, a multiple of 3 like all lengths here} */
    private static int larger(int length) {
        return (int) Math.min((Integer.MAX_VALUE - 8L) / 3, length / 3 * 3L / 2 + 1) * 3;
    }
}
