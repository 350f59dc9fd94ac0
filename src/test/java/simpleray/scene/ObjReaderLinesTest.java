package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/** OBJ files of many polygons, long lines and all kinds of line ends. */
class ObjReaderLinesTest {
    private static final String THREE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    private static final int LONGEST = 1 << 20;

    private final List<Diagnostic> warnings = new ArrayList<>();

    private Triangles read(String obj) throws IOException {
        return ObjReader.read(new ByteArrayInputStream(obj.getBytes(StandardCharsets.UTF_8)), "a.obj", warnings::add);
    }

    private String headline(String obj) {
        return catchThrowableOfType(SceneFormatException.class, () -> read(obj)).problems().get(0).headline();
    }

    /** Every other one has normals, from the first on or from the one given. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1500, 4001})
    void ofThousandsOfTrianglesNoneIsLostOrMixedUp(int firstWithNormals) throws IOException {
        int many = 5000;
        StringBuilder obj = new StringBuilder();
        for (int i = 0; i < many; i++) {
            obj.append("v ").append(i + 1).append(" 0 0\nv 0 1 ").append(i).append("\nv 0 0 1\nvn 0 ").append(i % 7 + 1).append(" 0\nvn 0 0 -2\n");
            obj.append(i >= firstWithNormals && i % 2 == 0 ? "f -3//-2 -2//-1 -1//-2\n" : "f -3 -2 -1\n");
        }
        Triangles all = read(obj.toString());

        assertThat(all.count()).isEqualTo(many);
        assertThat(all.vertices()).hasSize(9 * many);
        assertThat(all.normals()).hasSize(6 * many);
        assertThat(warnings).isEmpty();
        for (int i = 0; i < many; i++) {
            assertThat(Arrays.copyOfRange(all.corners(), 3 * i, 3 * i + 3)).containsExactly(3 * i, 3 * i + 1, 3 * i + 2);
            assertThat(Arrays.copyOfRange(all.vertices(), 9 * i, 9 * i + 9)).containsExactly(i + 1, 0, 0, 0, 1, i, 0, 0, 1);
            assertThat(Arrays.copyOfRange(all.normals(), 6 * i, 6 * i + 6)).containsExactly(0, 1, 0, 0, 0, -1);
            assertThat(Arrays.copyOfRange(all.cornerNormals(), 3 * i, 3 * i + 3)).containsExactly(i >= firstWithNormals && i % 2 == 0
                ? new int[] {2 * i, 2 * i + 1, 2 * i} : new int[] {-1, -1, -1});
        }
    }

    @Test
    void aSkippedTriangleLeavesNoGap() throws IOException {
        Triangles some = read(THREE + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1//1 1//1 2//1\nf 3 2 1\n");

        assertThat(some.corners()).containsExactly(0, 1, 2, 2, 1, 0);
        assertThat(some.cornerNormals()).containsExactly(0, 0, 0, -1, -1, -1);
    }

    /** The line end lies at each place about the end of the buffer, which has 65536 bytes, and of a piece that the file gives. */
    @ParameterizedTest
    @CsvSource({"'\n', 6", "'\r', 6", "'\r\n', 6"})
    void linesAreCountedAlikeWhereverTheyEnd(String end, int line) {
        for (int length = 65536 - 44; length < 65536 + 4; length++) {
            for (String first : List.of("#", "g ")) {
                String obj = first + "x".repeat(length) + end + "v 0 0 0" + end + "v 1 0 0" + end + end + "v 0 1 0" + end + "f 1 2 x" + end;
                assertThat(headline(obj)).as(length + " characters")
                    .isEqualTo("a.obj:" + line + ":7: error: expected polygon 1's vertex index, found 'x'");
            }
        }
    }

    @Test
    void aContinuedLineMayLieAnywhereInTheBuffer() throws IOException {
        for (int length = 65536 - 70; length < 65536 + 4; length++) {
            String obj = "g " + "x".repeat(length) + "\nv 0 0 0\nv 1 \\\r\n0 0\r\nv 0 1 0\nvn 0 0 2 # up\nf 1//1 \\\n2//1 \\ # \u00e9\r 3//1";
            Triangles one = read(obj);
            assertThat(one.vertices()).as(length + " characters").containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
            assertThat(one.cornerNormals()).as(length + " characters").containsExactly(0, 0, 0);
            assertThat(headline(obj + "//")).isEqualTo("a.obj:9:2: error: expected polygon 1's vertex/texture/normal, found '3//1//'");
        }
    }

    /** A file gives as many bytes at a time as it likes. */
    @Test
    void aFileMayComeByteByByte() throws IOException {
        byte[] obj = ("\uFEFF" + THREE + "# \u00e9\r\nf 1 \\\r\n2 3\r\nf 1 1 1").getBytes(StandardCharsets.UTF_8);
        Triangles one = ObjReader.read(new ByteArrayInputStream(obj) {
            @Override
            public synchronized int read(byte[] bytes, int from, int most) {
                return super.read(bytes, from, Math.min(1, most));
            }
        }, "a.obj", warnings::add);

        assertThat(one.corners()).containsExactly(0, 1, 2);
        assertThat(warnings).extracting(Diagnostic::line).containsExactly(7);
    }

    @Test
    void manyContinuationsAreOneLineThatIsTooLong() {
        assertThat(headline("\\\n".repeat(LONGEST + 1)))
            .isEqualTo("a.obj:1048577:1: error: expected a line of at most 1048576 characters, found a longer one");
    }

    @Test
    void theCharactersOfALineAreCountedNotItsBytes() throws IOException {
        String name = "g " + "\u3042".repeat(LONGEST - 2) + "\n";

        assertThat(read(THREE + name + "f 1 2 3").count()).isEqualTo(1);
        assertThat(headline(THREE + "g" + name + "f 1 2 3"))
            .isEqualTo("a.obj:4:1: error: expected a line of at most 1048576 characters, found a longer one");
    }

    @Test
    void linesMayEndInDifferentWays() {
        assertThat(headline("v 0 0 0\r\rv 1 0 0\n\nv 0 1 0\r\n\r\n\n\rf 1 2 x"))
            .isEqualTo("a.obj:9:7: error: expected polygon 1's vertex index, found 'x'");
    }

    @Test
    void theLongestLineIsReadAndALongerOneIsNot() throws IOException {
        String face = "f 1 2 3 ";
        String long1 = face + "#".repeat(LONGEST - face.length());

        assertThat(read(THREE + long1).count()).isEqualTo(1);
        assertThat(headline(THREE + long1 + "#"))
            .isEqualTo("a.obj:4:1: error: expected a line of at most 1048576 characters, found a longer one");
    }

    @Test
    void aContinuedLineIsAsLongAsItsPieces() throws IOException {
        String half = "f 1 2 3" + " ".repeat(LONGEST / 2 - 9) + "3\\\n";
        String rest = " ".repeat(LONGEST / 2 - 1) + "2";

        assertThat(read(THREE + half + rest + "\n").count()).isPositive();
        assertThat(headline(THREE + half + rest + "  2"))
            .isEqualTo("a.obj:5:1: error: expected a line of at most 1048576 characters, found a longer one");
    }

    @Test
    void ofALineThatIsTooLongTheBeginningIsShown() {
        SceneFormatException e = catchThrowableOfType(SceneFormatException.class, () -> read("v 1 2 3\nv" + " 0".repeat(LONGEST)));

        assertThat(e.problems().get(0).line()).isEqualTo(2);
        assertThat(e.problems().get(0).source()).isEqualTo(("v" + " 0".repeat(LONGEST)).substring(0, 512));
    }

    @Test
    void anErrorInTheSecondPieceOfThreeIsThere() {
        assertThat(headline(THREE + "f 1 \\\n 2 y\\\n 3")).isEqualTo("a.obj:5:4: error: expected polygon 1's vertex index, found 'y'");
        assertThat(headline(THREE + "f 1 \\\n 2 3\\\n  z")).isEqualTo("a.obj:6:3: error: expected polygon 1's vertex index, found 'z'");
        assertThat(headline(THREE + "f 1\\\n2\\\n")).isEqualTo(
            "a.obj:5:3: error: expected a polygon that has an area, found the end of the file");
    }

    @Test
    void aByteOrderMarkBelongsToTheFirstLineAlone() throws IOException {
        assertThat(read("\uFEFF" + THREE + "f 1 2 3").count()).isEqualTo(1);
        assertThat(headline("v 0 0 0\n\uFEFFv 1 0 0\nv 0 1 0\nf 1 2 3"))
            .isEqualTo("a.obj:4:7: error: expected polygon 1's vertex index among the 2 so far, found '3'");
    }
}
