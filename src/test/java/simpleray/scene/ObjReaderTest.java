package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.io.Sha256;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/** OBJ files, right and wrong. */
class ObjReaderTest {
    private static final String THREE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

    @TempDir
    private Path folder;
    private final List<Diagnostic> warnings = new ArrayList<>();

    private Triangles read(String text) throws IOException {
        return ObjReader.read(Files.writeString(folder.resolve("a.obj"), text), warnings::add);
    }

    /** Checks the error at a place, the source line that it shows being the text's. */
    private void assertError(String text, int line, int column, String message) {
        String source = text.split("\n", -1)[line - 1];
        assertThatThrownBy(() -> read(text)).isInstanceOf(SceneFormatException.class).hasMessage(folder.resolve("a.obj") + ":" + line + ':'
            + column + ": error: expected " + message + '\n' + source + '\n' + " ".repeat(column - 1) + '^');
    }

    /** Checks that there is one warning, of a line. */
    private void assertWarning(int line, String message) {
        assertThat(warnings).hasSize(1).allSatisfy(warning -> assertThat(warning.toString())
            .startsWith(folder.resolve("a.obj") + ":" + line + ":1: warning: expected " + message + '\n'));
    }

    @Test
    void aPolygonBecomesAFan() throws IOException {
        assertThat(read(THREE + "v 0 0 1\nv 1 1 1\nf 1 2 3 4 5\n").corners()).containsExactly(0, 1, 2, 0, 2, 3, 0, 3, 4);
    }

    /** Of the fan from the first corner both triangles would lie where there is no polygon if the dent is at the second or fourth. */
    @Test
    void aConcavePolygonIsCutWhereItsDentIs() throws IOException {
        String dart = "v 0 0 0\nv 4 -2 0\nv 1 0 0\nv 4 2 0\n";

        assertThat(read(dart + "f 1 2 3 4\n").corners()).containsExactly(0, 1, 2, 0, 2, 3);
        assertThat(read(dart + "f 2 3 4 1\n").corners()).containsExactly(2, 3, 0, 2, 0, 1);
        assertThat(read(dart + "f 3 4 1 2\n").corners()).containsExactly(2, 3, 0, 2, 0, 1);
        assertThat(read(dart + "f 2 1 4 3\n").corners()).containsExactly(0, 3, 2, 0, 2, 1);
        assertThat(warnings).isEmpty();
    }

    @Test
    void cutCornersKeepTheirNormals() throws IOException {
        Triangles triangles = read("v 0 0 0\nv 4 -2 0\nv 1 0 0\nv 4 2 0\nvn 1 0 1\nvn 2 0 1\nvn 3 0 1\nvn 4 0 1\n"
            + "f 1/7/1 2/7/2 3/7/3\nf 2/7/2 3/7/3 4/7/4 1/7/1\nf 3 4 1 2\n");

        assertThat(triangles.corners()).containsExactly(0, 1, 2, 2, 3, 0, 2, 0, 1, 2, 3, 0, 2, 0, 1);
        assertThat(triangles.cornerNormals()).containsExactly(0, 1, 2, 2, 3, 0, 2, 0, 1, -1, -1, -1, -1, -1, -1);
    }

    @Test
    void aPolygonThatCrossesItselfIsAFanWithAWarning() throws IOException {
        String five = "v 1 0 0\nv -0.8 0.6 0\nv 0.3 -0.95 0\nv 0.3 0.95 0\nv -0.8 -0.6 0\nf 1 2 3\n";

        assertThat(read(five + "f 1 2 3 4 5\n").corners()).containsExactly(0, 1, 2, 0, 1, 2, 0, 2, 3, 0, 3, 4);
        assertWarning(7, "polygons that do not cross themselves, found 1 that does, which becomes a fan of triangles");
        warnings.clear();
        assertThat(read(five + "f 1 4 2 5\n\nf 1 2 4 5 # of four\nf 3 1 2 4 5\nf 1 1 2 1").count()).isEqualTo(8);
        assertThat(warnings).extracting(Diagnostic::message).containsExactly("expected triangles that have an area, found 2 without, which are skipped",
            "expected polygons that do not cross themselves, found 2 that do, which become fans of triangles");
        assertThat(warnings.get(1).line()).isEqualTo(9);
    }

    @ParameterizedTest
    @ValueSource(strings = {"f 1 2 3", "f -3 -2 -1", "f 1/1 2/2 3/3", "f 1/4/ 2/4/ 3/4/", "F 1/ 2/ 3/",
        "\tf\t1\t2  3 # corner", "f 1 \\\n2 \\\n 3", "f 1 2\\\n3",
        "s off\nl 1 2 3\ng x # y\nusemtl \"q\nmtllib a b\nhello\n\nf 1 2 3\r", "# C:\\\nf 1 2 3"})
    void aTriangleMayBeWrittenInManyWays(String face) throws IOException {
        Triangles triangles = read(THREE + face + "\n");
        assertThat(triangles.corners()).containsExactly(0, 1, 2);
        assertThat(triangles.cornerNormals()).isNull();
        assertThat(warnings).isEmpty();
    }

    @Test
    void weightsAndColoursBehindAVertexArePassedOver() throws IOException {
        assertThat(read("\uFEFFv 0.5 1 2 0.5\nV 1 0 0 0.1 0.2 0.3\nv 0 1e0 0 # top\nf 1 2 3").vertices())
            .containsExactly(0.5, 1, 2, 1, 0, 0, 0, 1, 0);
    }

    /** They mean what they mean in a scene file, whether they are usual or not. */
    @ParameterizedTest
    @ValueSource(strings = {"0.1", "-0.1", "+0.1", ".5", "5.", "-.5e-3", "1E5", "1e+5", "3.141592653589793", "0.30000000000000004",
        "123456789012345678901234567890", "0.00000000000000000000000000000000000001234567890123456789", "9007199254740993", "1e23", "-1e100",
        "4.35", "2.2250738585072011e-308", "4.9e-324", "1e-400", "0e999999", "-0", "8.41e21", "1.7976931348623157e99"})
    void coordinatesAreDoubles(String number) throws IOException {
        for (String behind : List.of("", " ", "\t# top", "\\\n", "\u3000")) {
            double[] vertices = read(THREE + "f 1 2 3\nv 1 " + number + " -2\nv 1 2 " + number + behind).vertices();

            assertThat(vertices[10]).isEqualTo(Double.parseDouble(number));
            assertThat(vertices[14]).isEqualTo(Double.parseDouble(number));
        }
    }

    @ParameterizedTest
    @CsvSource({"3e-200, 4e-200", "3e-320, 4e-320", "3e99, 4e99"})
    void aSmallOrLargeNormalHasADirectionToo(String x, String z) throws IOException {
        double[] normals = read(THREE + "vn " + x + " 0 " + z + "\nf 1//1 2//1 3//1").normals();

        assertThat(normals[0]).isEqualTo(0.6, within(1e-3));  // 3e-320 has four digits
        assertThat(normals[2]).isEqualTo(0.8, within(1e-3));
        assertThat(Math.hypot(normals[0], normals[2])).isEqualTo(1, within(1e-15));
    }

    @Test
    void normalsAreMadeOfUnitLength() throws IOException {
        Triangles triangles = read(THREE + "vn 0 0 4\nvn 0 0 0\nvn 3 0 4\nf 1 2 3\nf 1//1 2//-2 3/7/3\nf 3 2 1\n");
        assertThat(triangles.normals()).containsExactly(0, 0, 1, 0, 0, 0, 3 * (1.0 / 5), 0, 4 * (1.0 / 5));
        assertThat(triangles.cornerNormals()).containsExactly(-1, -1, -1, 0, 1, 2, -1, -1, -1);
    }

    @ParameterizedTest
    @CsvSource({"x, ''", "1f, ' (a number ends with a digit)'", "0x1p3, ' (numbers are decimal)'", "'1,5', ' (a decimal point is a ''.'')'",
        "--1, ''", "., ''", "1.#x, ''", "1.2.3, ''"})
    void aVertexConsistsOfNumbers(String word, String why) {
        assertError("v 0 0 0\nv 1 " + word + " 0\n", 2, 5, "vertex 2's y, found '" + word + "'" + why);
        assertError("vn 0 0 " + word + "\n", 1, 8, "normal 1's z, found '" + word + "'" + why);
    }

    @ParameterizedTest
    @CsvSource({"NaN, numbers must be finite", "-nan, numbers must be finite", "Infinity, numbers must be finite", "-inf, numbers must be finite",
        "-1.#IND, numbers must be finite", "1.#INF00, numbers must be finite", "1.#QNAN, numbers must be finite",
        "1.1e100, 'beyond 1e100, the largest coordinate'", "-1e101, 'beyond 1e100, the largest coordinate'",
        "1e309, 'beyond 1.8e308, the largest number'", ".1e+999, 'beyond 1.8e308, the largest number'"})
    void aVertexThatAPolygonNamesIsFinite(String word, String why) throws IOException {
        String vertices = "v 0 0 0\nv 1 " + word + " 0\nv 0 1 0\nv 0 1 1\nf 1 3 4\n";
        assertError(vertices + "f 1 2 3\n", 2, 5, "vertex 2's y, found '" + word + "' (" + why + ')');
        warnings.clear();
        assertThat(read(vertices).count()).isEqualTo(1);
        assertThat(warnings).hasSize(1);
    }

    /** Microsoft's library once wrote numbers so; elsewhere a number sign begins a comment, right behind a number, too. */
    @Test
    void aNumberSignBehindAPointIsNoComment() throws IOException {
        assertError("v 0 0 0\nv 1 0 -1.#IND\nv 0 1 0\nf 1 2 3\n", 2, 7, "vertex 2's z, found '-1.#IND' (numbers must be finite)");
        read(THREE + "vn 0 0 -1.#IND\nvn -1.#QNAN -1.#QNAN -1.#QNAN\nf 1//1 2//1 3//1\n");
        assertWarning(4, "normals of finite length above 0, found 2 that have none, which are passed over");
        assertThat(read("v 0 0 0#\nv 1 0 0#1.#\nv 0 1 0 # 1.\nf 1 2 3#\n").count()).isEqualTo(1);
    }

    @Test
    void aNormalMayBeOfAnyLength() throws IOException {
        assertThat(read(THREE + "vn 0 3e300 4e300\nf 1//1 2//1 3//1\n").normals()).containsExactly(new double[] {0, 0.6, 0.8}, within(1e-15));
        assertThat(warnings).isEmpty();
    }

    @Test
    void verticesThatNoPolygonNamesNeedNotBe() throws IOException {
        assertThat(read(THREE + "v nan 0 0\nv 0 inf 0\nf 1 2 3\n").corners()).containsExactly(0, 1, 2);
        assertWarning(4, "finite coordinates, found 2 vertices without, which no polygon names");
    }

    @ParameterizedTest
    @ValueSource(strings = {"0 0 0", "nan 0 1", "0 -inf 0", "1 2 NaN"})
    void aNormalThatPointsNowhereIsPassedOver(String normal) throws IOException {
        Triangles triangles = read(THREE + "vn " + normal + "\nvn 0 0 1\nf 1//1 2//1 3//2\n");
        assertThat(triangles.normals()).containsExactly(0, 0, 0, 0, 0, 1);
        assertThat(triangles.cornerNormals()).containsExactly(0, 0, 1);
        assertWarning(4, "normals of finite length above 0, found 1 that has none, which is passed over");
    }

    @Test
    void aVertexHasThreeNumbers() {
        assertError("v 0 0 0\n\tv 1 2 # 3\n".replace("\t", " "), 2, 7, "vertex 2's z, found the end of the line");
        assertError("v", 1, 2, "vertex 1's x, found the end of the line");
    }

    @ParameterizedTest
    @CsvSource({"0", "4", "-4", "99999999999"})
    void anIndexIsOneOfTheVerticesSoFar(String index) {
        assertError(THREE + "f 1 2 3\nf 1 " + index + " 2\nv 9 9 9\n", 5, 5,
            "polygon 2's vertex index among the 3 so far, found '" + index + "'");
    }

    @ParameterizedTest
    @ValueSource(strings = {"f 1//3 2//3 3//3", "f 1//0 2//0 3//0", "f 1//1 2//-3 3//1", "f 1//3 2//1 3//1", "f 1//1 2 3//1", "f 1 2//1 3//1",
        "f 1/7/99999999999 2//1 3"})
    void aPolygonThatLacksNormalsIsFlat(String face) throws IOException {
        Triangles triangles = read(THREE + "vn 0 0 1\nvn 0 1 0\n" + face + "\nf 1//1 2//2 3//1\n");
        assertThat(triangles.cornerNormals()).containsExactly(-1, -1, -1, 0, 1, 0);
        assertWarning(6, "polygons with normals at all corners or at none, found 1 that lacks some, which is shaded flat");
    }

    @Test
    void anIndexOfANormalIsAnInteger() {
        assertError(THREE + "vn 0 0 1\nf 1//1 2//x 3//1\n", 5, 8, "polygon 1's normal index, found '2//x'");
    }

    @ParameterizedTest
    @ValueSource(strings = {"x", "1.5", "+", "/1", "\"2\"", "//"})
    void anIndexIsAnInteger(String word) {
        assertError(THREE + "f 1 " + word + " 3\n", 4, 5, "polygon 1's vertex index, found '" + word + "'");
    }

    @Test
    void textureIndicesAreIntegersToo() {
        assertError(THREE + "f 1/x 2/1 3/1\n", 4, 3, "polygon 1's texture index, found '1/x'");
        assertError(THREE + "vn 0 0 1\nf 1/1/1/1 2 3\n", 5, 3, "polygon 1's vertex/texture/normal, found '1/1/1/1'");
    }

    /** The usual ones and the others are read by different methods. */
    @ParameterizedTest
    @ValueSource(strings = {"3", "+3", "003", "0000000000003", "-1", "-01", "3/", "3//", "3/7", "3/-7", "3/0", "3/0/", "3/9000000000", "3/7/",
        "3/0000000000012"})
    void aVertexIndexMayBeWrittenInManyWays(String index) throws IOException {
        for (String behind : List.of("", " ", "\n", "#", "\\\n")) {
            assertThat(read(THREE + "f 1 2 " + index + behind).corners()).as(behind).containsExactly(0, 1, 2);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"3//2", "3//-1", "3/1/2", "3/-4/+2", "3//0000000002", "+3//2"})
    void aNormalIndexMayBeWrittenInManyWays(String index) throws IOException {
        Triangles triangles = read(THREE + "vn 1 0 0\nvn 0 1 0\nf 1//1 2//2 " + index);

        assertThat(triangles.corners()).containsExactly(0, 1, 2);
        assertThat(triangles.cornerNormals()).containsExactly(0, 1, 1);
    }

    @Test
    void polygonsOfFewerCornersThanThreeAreSkipped() throws IOException {
        assertThat(read(THREE + "f 1 2 # 3\nf\nf 1// 2//\nfo 1 2 3\n").corners()).containsExactly(0, 1, 2);
        assertWarning(4, "polygons of at least 3 corners, found 3 of fewer, which are skipped");
    }

    /** The name of a material, a file or a group may end with a backslash, which means that the line goes on. */
    @ParameterizedTest
    @ValueSource(strings = {"usemtl wood\\\n", "usemtl wood\\  \r\n", "mtllib c:\\models\\\n", "g a \\\n", "v 0 0 1 \\\n", "hello\\\r"})
    void aLineThatABackslashJoinsToAnotherIsWarnedOf(String line) throws IOException {
        assertThat(read(THREE + "f 1 2 3\n" + line + "f 1 2 3\nf 1 2 3\n").count()).isEqualTo(2);
        assertWarning(6, "a line of its own for each keyword, found 1 line that the backslash before it joins to another");
        warnings.clear();
        read(THREE + "f 1 2 3\ng a \\\n b\\\n\t usemtl b\n" + line + "usemtl c\nf 1 2 3\nf 1 2 3\n");
        assertWarning(7, "a line of its own for each keyword, found 2 lines that the backslash before them joins to others");
    }

    /** The line that is joined may be what the error is about. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"usemtl wood\\/f 1 2 3/f 1 2 x|4|6:7: error: expected polygon 1's vertex index, found 'x'",
        "v 1 1 1 \\/f 1 2 3|4|5:8: error: expected a polygon that has an area, found the end of the file",
        "f 1 2 3 \\/vn 1 1 x|4|5:1: error: expected polygon 1's vertex index, found 'vn'"})
    void itIsWarnedOfBesideAnErrorToo(String lines, int joined, String error) throws IOException {
        Files.writeString(folder.resolve("a.obj"), THREE + lines.replace('/', '\n'));

        assertThatThrownBy(() -> ObjReader.read(folder.resolve("a.obj"), warnings::add)).isInstanceOfSatisfying(SceneFormatException.class,
            e -> assertThat(e.problems()).extracting(problem -> problem.headline().replace(folder + "/a.obj:", "")).containsExactly(
                joined + 1 + ":1: warning: expected a line of its own for each keyword, found 1 line that the backslash before it joins to another",
                error));
        assertThat(warnings).isEmpty();
    }

    @Test
    void utf16IsNamed() throws IOException {
        for (Charset charset : List.of(StandardCharsets.UTF_16, StandardCharsets.UTF_16LE, StandardCharsets.UTF_16BE)) {
            Path path = Files.writeString(folder.resolve("wide.obj"), "v 0 0 0\n", charset);
            assertThatThrownBy(() -> ObjReader.read(path, warnings::add)).isInstanceOf(SceneFormatException.class)
                .hasMessage(path + ":1:1: error: expected text in UTF-8, found UTF-16");
        }
    }

    @Test
    void anErrorInAContinuedLineIsShownWhereItStands() {
        assertError(THREE + "f 1 2 \\\n  9 3\n", 5, 3, "polygon 1's vertex index among the 3 so far, found '9'");
    }

    @Test
    void columnsAreCountedInCharacters() {
        assertError(THREE + "g \u00e9\n\u00a0\u3000f 1 \u2003 2 \ud83d\ude00 3\n", 5, 11,
            "polygon 1's vertex index, found '\ud83d\ude00'");
    }

    @Test
    void theDigestIsThatOfTheFile() throws IOException {
        for (int length : new int[] {0, 1, 70_000, 3_000_000}) {
            byte[] obj = (THREE + "f 1 2 3\n" + "# \u00e9\r\n".repeat(length / 6)).getBytes(StandardCharsets.UTF_8);
            List<String> digests = new ArrayList<>();

            ObjReader.read(Files.write(folder.resolve("a.obj"), obj), warnings::add, digests::add);

            assertThat(digests).containsExactly(Sha256.of(obj));
        }
    }

    @Test
    void aFileWithoutPolygonsIsAnError() {
        assertError("", 1, 1, "a polygon that has an area, found the end of the file");
        assertError("# nothing", 1, 10, "a polygon that has an area, found the end of the file");
        assertError("v 0 0 0\nv 1 0 0 # x\n", 2, 12, "a polygon that has an area, found the end of the file");
        assertError("v 0 0 0\nv 1 0 0\nf 1 2 1", 3, 8, "a polygon that has an area, found the end of the file");
    }

    @Test
    void aTriangleWithoutAreaIsSkippedWithOneWarning() throws IOException {
        assertThat(read(THREE + "f 1 2 3\nf 1 2 2\nf 1 2 3\n").count()).isEqualTo(2);
        assertThat(warnings).extracting(Diagnostic::toString).containsExactly(folder.resolve("a.obj")
            + ":5:1: warning: expected triangles that have an area, found 1 without, which is skipped\nf 1 2 2\n^");
    }

    @Test
    void bytesThatAreNoTextAreNoObj() throws IOException {
        Path path = Files.write(folder.resolve("a.obj"), new byte[] {(byte) 0x89, 'P', 'N', 'G', 0, (byte) 0xff, '\n', 1});
        assertThatThrownBy(() -> ObjReader.read(path, warnings::add)).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith(path + ":2:2: error: expected a polygon that has an area, found the end of the file");
    }
}
