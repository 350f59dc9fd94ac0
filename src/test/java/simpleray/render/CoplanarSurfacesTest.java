package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.scene.SceneFile;
import simpleray.text.Diagnostic;

/** Surfaces that overlap in one plane are told with both lines; neighbours are not. */
class CoplanarSurfacesTest {
    private static final String MATT = "  0.5 0.5 0.5  0.4 0.4 0.4  0 0 0  1";
    private static final String GLASS = "  0 0 0  0 0 0  0.1 0.1 0.1  9  transmit 0.9 0.9 0.9 1.5";
    private static final String SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    private static final String CUBE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

    @TempDir
    Path folder;

    private SceneFile read(String... objects) throws IOException {
        StringBuilder text = new StringBuilder(objects.length + "\n");
        for (String object : objects) {
            text.append(object).append(object.contains("  ") ? "" : MATT).append('\n');
        }
        return SceneFile.read(Files.writeString(folder.resolve("a.scene"), text + "0.5 0.5 0.5\n0\ncamera 0.1 0.2 9  0.3 0.1 0  90\n"));
    }

    /** {@return what is said of overlaps in a scene of objects, a line each from line 2 on} */
    private List<String> warnings(String... objects) throws IOException {
        return overlaps(SceneLint.all(read(objects), "a"));
    }

    private static List<String> overlaps(List<Diagnostic> all) {
        return all.stream().map(Diagnostic::toString).filter(text -> text.contains("overlap")).toList();
    }

    private static String overlap(String place) {
        return overlap("", "", place);
    }

    /** {@return what is said of objects of which one or both are meshes, with their polygons} */
    private static String overlap(String first, String second, String place) {
        return "a:3:1: warning: objects 1 (line 2" + first + ") and 2 (line 3" + second + ") overlap in one plane, as at " + place
            + ": rounding decides which is seen, so leave a gap or drop one";
    }

    private String in(String file, String line) {
        return ", " + folder.resolve(file) + ':' + line;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "1 0 0 1 -3 | 1 0 0 1 -3 | (0 0 -3)", "1 0 0 1 -3 | 1 0 0 -2 6 | (0 0 -3)", "1 1 2 2 9 | 1 -2 -4 -4 -18 | (1 2 2)",
        "1 0 0 1 0 | 2 0 0 0 3 0 0 0 3 0 | (1 1 0)", "2 0 0 0 0 3 0 3 0 0 | 1 0 0 -1 0 | (1 1 0)",
        "2 0 0 0 3 0 0 0 3 0 | 2 0 0 0 3 0 0 0 3 0 | (1 1 0)", "2 0 0 0 3 0 0 0 3 0 | 2 3 0 0 0 3 0 0 0 0 | (1 1 0)",
        "2 0 0 0 9 0 0 0 9 0 | 2 1 1 0 2 1 0 1 2 0 | (1.33333 1.33333 0)", "2 1 1 0 2 1 0 1 2 0 | 2 0 0 0 9 0 0 0 9 0 | (1.33333 1.33333 0)",
        "2 0 0 0.3 3 0 0.3 0 3 0.3 | 2 0 0 0.30000000000000004 3 0 0.3 0 3 0.3 | (1 1 0.3)",
        "4 \"square.obj\" 0 0 0 1 | 1 0 0 1 0 | (0.666667 0.333333 0)", "4 \"square.obj\" 0 0 0 1 | 2 -9 0.5 0 9 0.5 0 0 9 0 | (0.833333 0.666667 0)",
        "4 \"square.obj\" 0.1 0.2 0 3 | 4 \"square.obj\" 1.4 1.5 0 -1 | *",
        "3 0 0 0 0 0 -1 0.5 | 1 0 0 1 0 | (0 0 0)", "3 0 0 0 0 0 -1 0.5 | 3 0.5 0 0 0.5 0 -2 0.5 | (0.25 0 0)",
        "3 0 0 -1 0 0 0 0.5 | 2 -9 -9 0 9 -9 0 0 9 0 | (0 0 0)", "3 0 0 0 0 0 -1 0.5 | 4 \"square.obj\" -0.5 -0.5 0 1 | *"})
    void twoOfAnyKindAreTold(String one, String other, String place) throws IOException {
        Files.writeString(folder.resolve("square.obj"), SQUARE);
        List<String> warnings = warnings(one, other);

        assertThat(warnings).hasSize(1);
        if (!place.equals("*")) {
            assertThat(warnings).containsExactly(overlap(one.startsWith("4") ? in("square.obj", "5") : "", "", place));
        }
        assertThat(warnings(other, one)).hasSize(1);
        assertThat(overlaps(SceneLint.striking(read(one, other), "a"))).as("the window").isEqualTo(warnings);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "1 0 0 1 -3 | 1 0 0 1 -3.000001", "1 0 0 1 -3 | 1 0 1e-6 1 -3", "1 0 0 1 -3 | 1 0 0 1 3", "1 0 0 1 -3 | 1 0 0 -1 -3",
        "1 0 0 1 0 | 2 0 0 1e-6 3 0 1e-6 0 3 1e-6", "1 0 0 1 0 | 2 0 0 0 3 0 0 0 3 1e-6",
        "2 0 0 0 3 0 0 0 3 0 | 2 3 0 0 3 3 0 0 3 0", "2 0 0 0 3 0 0 0 3 0 | 2 3 0 0 0 0 0 1 -5 0", "2 0 0 0 3 0 0 0 3 0 | 2 1 0 0 0 0 0 1 -5 0",
        "2 0 0 0 3 0 0 0 3 0 | 2 4 0 0 5 0 0 4 3 0", "2 0 0 0 3 0 0 0 3 0 | 2 3 0 0 5 0 0 5 3 0", "2 0 0 0 3 0 0 0 3 0 | 2 0 0 0 3 0 0 0 0 3",
        "2 0.1 0.7 0.3 0.3333333 0.2 0.9 0.2 0.1 0.4 | 2 0.3333333 0.2 0.9 0.1 0.7 0.3 0.9 0.8 0.7",
        "0 0 1 0 1 | 1 0 1 0 0", "0 0 0 -1 1 | 1 0 0 1 0", "3 0 0 0 0 0 -1 0.5 | 3 1 0 0 1 0 -1 0.5", "3 0 0 0 0 0 -1 0.5 | 3 1.1 0 0 1.1 0 -1 0.5",
        "3 0 1 0 0 1 -9 1 | 1 0 1 0 0", "3 0 0 0 0 0 -1 0.5 | 2 0.6 -9 0 9 -9 0 0.6 9 0", "3 0 0 0 0 0 -1 0.5 | 1 0 0 1 0.000001",
        "4 \"square.obj\" 0 0 0 1 | 4 \"square.obj\" 1 0 0 1", "4 \"square.obj\" 0 0 0 1 | 4 \"square.obj\" 0 0 0 -1",
        "4 \"square.obj\" 0 0 0 1 | 2 0 0 0 1 0 0 0.3 -1 0"})
    void neighboursAndWhatIsAHairApartAreNot(String one, String other) throws IOException {
        Files.writeString(folder.resolve("square.obj"), SQUARE);

        assertThat(warnings(one, other)).isEmpty();
        assertThat(warnings(other, one)).isEmpty();
    }

    /** Any slanted plane, any scale and any place: rounding may tell the two apart, and is no gap. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 1e-3, 1, 1e3, 1e6, 1e9})
    void slantedOnesAreToldAtEachScaleAndTheirNeighboursNot(double scale) throws IOException {
        for (int i = 0; i < 40; i++) {
            double[] plane = {Math.sin(i), Math.cos(5 * i), Math.sin(7 * i + 1), Math.cos(3 * i + 2)};
            String near = triangle(scale, plane, 0, 0, 3, 0, 2, 3);
            String within = triangle(scale, plane, 0.5, 0.25, 1.5, 0.25, 1.5, 0.75);
            String beside = triangle(scale, plane, 0, 0, 3, 0, 2, -3);

            assertThat(warnings(near, within)).as(near + " and " + within).hasSize(1);
            assertThat(warnings(near, beside)).as(near + " and " + beside).isEmpty();
        }
    }

    /** {@return a triangle in the plane of (a, b, c) + u (b, d, -a) + v (-c, a, d), of these three u and v} */
    private static String triangle(double scale, double[] abcd, double... uv) {
        StringBuilder text = new StringBuilder("2");
        for (int i = 0; i < uv.length; i += 2) {
            text.append(' ').append(scale * (abcd[0] + uv[i] * abcd[1] - uv[i + 1] * abcd[2]))
                .append(' ').append(scale * (abcd[1] + uv[i] * abcd[3] + uv[i + 1] * abcd[0]))
                .append(' ').append(scale * (abcd[2] - uv[i] * abcd[0] + uv[i + 1] * abcd[3]));
        }
        return text.toString();
    }

    @Test
    void aFloorOfTilesIsNotTold() throws IOException {
        List<String> tiles = new ArrayList<>();
        for (int i = 0; i < 20; i++) {
            for (int j = 0; j < 20; j++) {
                String from = String.format(Locale.ROOT, "%.6f %.6f %.6f", i / 3.0, j / 7.0, (i + j) / 3.0);
                String to = String.format(Locale.ROOT, "%.6f %.6f %.6f", (i + 1) / 3.0, (j + 1) / 7.0, (i + j + 2) / 3.0);
                tiles.add(String.format(Locale.ROOT, "2 %s %.6f %.6f %.6f %s", from, (i + 1) / 3.0, j / 7.0, (i + j + 1) / 3.0, to));
                tiles.add(String.format(Locale.ROOT, "2 %s %s %.6f %.6f %.6f", from, to, i / 3.0, (j + 1) / 7.0, (i + j + 1) / 3.0));
            }
        }
        assertThat(warnings(tiles.toArray(new String[0]))).isEmpty();

        tiles.add(tiles.get(123));
        assertThat(warnings(tiles.toArray(new String[0]))).singleElement().asString()
            .startsWith("a:802:1: warning: objects 124 (line 125) and 801 (line 802) overlap");
    }

    @Test
    void aMeshWithADoubledFaceOverlapsItself() throws IOException {
        Files.writeString(folder.resolve("square.obj"), SQUARE + "v 5 5 5\nf 2 3 5\nf 4 3 2\n");
        Files.writeString(folder.resolve("cube.obj"), CUBE);

        assertThat(warnings("0 0 0 0 1", "4 \"square.obj\" 0 0 0 1")).containsExactly(
            "a:3:1: warning: faces of object 2 (line 3" + in("square.obj", "5 and " + folder.resolve("square.obj") + ":8")
            + ") overlap in one plane, as at (0.875 0.375 0)"
            + ": rounding decides which is seen, so leave a gap or drop one");
        assertThat(warnings("4 \"cube.obj\" 0 0 0 1")).isEmpty();
        Files.writeString(folder.resolve("square.obj"), SQUARE + "f 4 3 2 1\n");
        assertThat(overlaps(SceneLint.striking(read("4 \"square.obj\" 0 0 0 1"), "a"))).as("of either winding").singleElement().asString()
            .startsWith("a:2:1: warning: faces of object 1 (line 2" + in("square.obj", "5 and " + folder.resolve("square.obj") + ":6")
                + ") overlap in one plane");
    }

    @Test
    void meshesAreToldWithTheLinesOfTheirPolygons() throws IOException {
        Files.writeString(folder.resolve("cube.obj"), CUBE);
        Files.writeString(folder.resolve("square.obj"), "# a\r\nv 0 0 0\rv 1 0 0\nv 1 1 0\nf 1 2 3\\\n 3\n\nv 0 1 0\nf 1 \\\n3 -1\n");

        assertThat(warnings("4 \"square.obj\" 0.2 0.2 1 0.5", "4 \"cube.obj\" 0 0 0 1")).containsExactly(
            overlap(in("square.obj", "5"), in("cube.obj", "10"), "(0.533333 0.366667 1)"));
        SceneFile without = read("4 \"square.obj\" 0.2 0.2 1 0.5", "4 \"cube.obj\" 0 0 0 1");
        Files.writeString(folder.resolve("square.obj"), "v 0 0 0\n");
        Files.delete(folder.resolve("cube.obj"));
        assertThat(overlaps(SceneLint.all(without, "a"))).as("files that are gone").containsExactly(overlap("(0.533333 0.366667 1)"));
    }

    @Test
    void aPolygonThatCoversItselfIsToldOnce() throws IOException {
        Files.writeString(folder.resolve("star.obj"), "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 1 -2 0\nv 0 4 0\nf 1 2 3 4 5\n");

        assertThat(warnings("4 \"star.obj\" 0 0 0 1")).singleElement().asString()
            .startsWith("a:2:1: warning: faces of object 1 (line 2" + in("star.obj", "6") + ") overlap in one plane");
    }

    @Test
    void ofManyTheFirstTenAreToldAndTheRestIsCounted() throws IOException {
        String[] walls = new String[6];
        for (int i = 0; i < walls.length; i++) {
            walls[i] = "1 0 0 " + (i + 1) + " 0";
        }
        List<String> warnings = warnings(walls);

        assertThat(warnings).hasSize(11);
        assertThat(warnings.get(9)).startsWith("a:6:1: warning: objects 4 (line 5) and 5 (line 6) overlap in one plane");
        assertThat(warnings.get(10)).isEqualTo("a:7:1: warning: 5 more pairs of objects overlap in one plane");
    }

    /** An opaque body that stands on an opaque floor looks right; of these, {@code check} tells one, and the window none. */
    @Test
    void whereOpaqueBodiesHideItOneLineIsSaid() throws IOException {
        Files.writeString(folder.resolve("cube.obj"), CUBE);
        String[] opaque = {"1 0 1 0 -1", "3 0 -1 0 0 0 0 0.5", "3 0 0 0 0 1 0 0.3", "4 \"cube.obj\" 2 -1 0 0.5"};
        String[] glass = {"1 0 1 0 -1", "3 0 -1 0 0 0 0 0.5" + GLASS};

        assertThat(warnings(opaque)).containsExactly("a:3:1: warning: objects 1 (line 2) and 2 (line 3) overlap in one plane, as at (0 -1 0), "
            + "where opaque bodies hide it; so do 2 more pairs of objects");
        assertThat(overlaps(SceneLint.striking(read(opaque), "a"))).isEmpty();
        assertThat(warnings(glass)).containsExactly(overlap("(0 -1 0)"));
        assertThat(overlaps(SceneLint.striking(read(glass), "a"))).hasSize(1);
    }

    /** The underside of a table is seen in a mirror below it, if nothing endless is between. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "2 -9 -1 9 9 -1 9 0 -1 -9 | 1 0 1 0 -2  0 0 0 0 0 0 0.9 0.9 0.9 1 | true",
        "2 -9 -1 9 9 -1 9 0 -1 -9 | 1 0 1 0 -2  0 0 0 0 0 0 0.9 0.9 0.9 0.9 | false",
        "2 -9 -1 9 9 -1 9 0 -1 -9 | 1 0 1 0 -2  0 0 0 0 0 0 0.9 0.9 0.9 9 mirror 0 0 0 | false",
        "2 -9 -1 9 9 -1 9 0 -1 -9 | 0 3 -2 0 0.5  0 0 0 0 0 0 0 0 0 9 mirror 0 0.1 0 | true",
        "2 -9 -1 9 9 -1 9 0 -1 -9 | 0 3 -2 0 0.5  0 0 0 0 0 0 0 0 0 9 transmit 0 0.1 0 1 | true",
        "2 -9 -1 9 9 -1 9 0 -1 -9 | 0 3 -0.5 0 0.5  0 0 0 0 0 0 0.9 0.9 0.9 1 | false",
        "2 -9 -1 9 9 -1 9 0 -1 -9 | 0 3 -0.6 0 0.5  0 0 0 0 0 0 0.9 0.9 0.9 1 | true",
        "2 -9 -1 -9 9 -1 -9 0 -1 9 | 0 3 -0.6 0 0.5  0 0 0 0 0 0 0.9 0.9 0.9 1 | true",
        "1 0 1 0 -1 | 0 3 -2 0 0.5  0 0 0 0 0 0 0.9 0.9 0.9 1 | false",
        "1 0 -1 0 1 | 1 0 1 0 -2  0 0 0 0 0 0 0.9 0.9 0.9 1 | false",
        "4 \"cube.obj\" -0.5 -2 -0.5 1 | 1 0 1 0 -9  0 0 0 0 0 0 0.9 0.9 0.9 1 | false",
        "4 \"tile.obj\" -0.5 -1 -0.5 1 | 4 \"tile.obj\" -5 -2 -5 10  0 0 0 0 0 0 0.9 0.9 0.9 1 | true"})
    void whatOnlyAMirrorShowsIsSeen(String table, String mirror, boolean seen) throws IOException {
        Files.writeString(folder.resolve("cube.obj"), CUBE);
        Files.writeString(folder.resolve("tile.obj"), "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 1 2 3 4\n");
        String[] scene = {table, "3 0 -1 0 0 0 0 0.25", mirror};

        assertThat(warnings(scene)).singleElement().asString().startsWith("a:3:1: warning: objects 1 (line 2")
            .contains(seen ? ": rounding decides" : ", where opaque bodies hide it");
        assertThat(overlaps(SceneLint.striking(read(scene), "a"))).hasSize(seen ? 1 : 0);
    }

    @Test
    void whatIsGlassByAnMtlFileIsGlass() throws IOException {
        Files.writeString(folder.resolve("ice.mtl"), "newmtl ice\nd 0.1\n");
        Files.writeString(folder.resolve("ice.obj"), "mtllib ice.mtl\nusemtl ice\n" + CUBE);
        String[] ice = {"1 0 1 0 -1", "4 \"ice.obj\" 2 -1 0 0.5" + MATT + " mtl"};

        assertThat(warnings(ice)).singleElement().asString().contains("objects 1 (line 2) and 2 (line 3" + in("ice.obj", "13") + ')', ": rounding decides");
        assertThat(overlaps(SceneLint.striking(read(ice), "a"))).hasSize(1);
        assertThat(warnings(ice[0], "4 \"ice.obj\" 2 -0.99999995 0 0.5" + MATT + " mtl")).hasSize(1);
    }

    @Test
    void bodiesWithOneTopAreSeenFromAbove() throws IOException {
        String[] drums = {"3 0 -1 0 0 0 0 0.5", "3 0.3 -2 0 0.3 0 0 0.5"};

        assertThat(warnings(drums)).singleElement().asString().contains("(0.15 0 0): rounding decides");
    }

    /** A ray that leaves glass misses what is nearer than 1e-7. */
    @ParameterizedTest
    @CsvSource({"0.9999999, true", "0.999999, false"})
    void glassNeedsAGapThatRaysSee(String foot, boolean told) throws IOException {
        assertThat(warnings("1 0 1 0 -1", "3 0 -" + foot + " 0 0 0 0 0.5" + GLASS)).hasSize(told ? 1 : 0);
    }

    @Test
    void aHeapOfPlanesIsComparedToo() throws IOException {
        String[] planes = new String[200];
        for (int i = 0; i < planes.length; i++) {
            planes[i] = "1 0 0 1 " + (i == 150 ? 149 : i);
        }
        assertThat(warnings(planes)).singleElement().asString().startsWith("a:152:1: warning: objects 150 (line 151) and 151 (line 152) ");
    }
}
