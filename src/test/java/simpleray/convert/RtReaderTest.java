package simpleray.convert;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.scene.PerspectiveCamera.Pose;

/** Scenes of miniRT, line by line. */
class RtReaderTest {
    private static final String CAMERA = "A 0 0,0,0\nC 0,0,0 0,0,-1 90\n";
    private static final String MATT = "  0.0 0.0 0.0  2.0  mirror 0.0 0.0 0.0\n";
    private static final String RED = "  1.0 0.0 0.0  1.0 0.0 0.0" + MATT;

    private static String scene(String lines) throws IOException {
        return Imports.scene(ForeignFormat.RT, lines);
    }

    /** {@return the only object of a scene, as it is written} */
    private static String object(String line) throws IOException {
        String text = scene(CAMERA + line);
        return text.substring(text.indexOf("\n1\n") + 3, text.indexOf("# ambient"));
    }

    private static String warning(String line) throws IOException {
        return String.join("\n", Imports.warnings(ForeignFormat.RT, CAMERA + line));
    }

    private static String error(String text) {
        return Imports.error(ForeignFormat.RT, text);
    }

    @Test
    void aWholeSceneBecomesOurs() throws IOException {
        assertThat(scene("""
            # a room
            A  0.2   255,255,0

            C\t-5,0,20  0,0,-1  70      # the camera
            L -4,5,0 0.5 255,0,255
            l 1,2,3 1 51,51,51
            sp 0,0,2.5 12.5 0,51,255
            """)).isEqualTo("""
            # imported by SimpleRay from a.file
            # number of objects
            1
            0  0.0 0.0 2.5 6.25  0.0 0.2 1.0  0.0 0.2 1.0  0.0 0.0 0.0  2.0  mirror 0.0 0.0 0.0
            # ambient light
            0.2 0.2 0.0
            # number of lights
            2
            0  0.5 0.0 0.5  -4.0 5.0 0.0
            0  0.2 0.2 0.2  1.0 2.0 3.0
            camera -5.0 0.0 20.0 -5.0 0.0 19.0 70.0
            """);
    }

    @Test
    void aPlaneGoesThroughItsPointEvenIfItsNormalIsLong() throws IOException {
        assertThat(object("pl 1,2,3 0,2,0 255,0,0\n")).isEqualTo("1  0.0 2.0 0.0 4.0" + RED);
    }

    @ParameterizedTest
    @ValueSource(strings = {"cy 1,2,3 0,5,0 4 6 255,0,0", "cy 1,2,3 0,5,0 255,0,0 4 6"})
    void aCylinderIsAboutItsMiddleWhereverItsColourStands(String line) throws IOException {
        assertThat(object(line)).isEqualTo("3  1.0 -1.0 3.0  1.0 5.0 3.0  2.0" + RED);
    }

    @Test
    void aTriangleOfAnOlderSceneStays() throws IOException {
        assertThat(object("tr 0,0,-3 1,0,-3 0,1,-3 255,0,0")).isEqualTo("2  0.0 0.0 -3.0  1.0 0.0 -3.0  0.0 1.0 -3.0" + RED);
    }

    @Test
    void aConeIsTakenWithAWarningThatTellsHow() throws IOException {
        String line = "co 1,2,3 0,0,2 4 6 255,0,0";

        assertThat(object(line)).isEqualTo("5  1.0 2.0 3.0 2.0  1.0 2.0 9.0 0.0" + RED);
        assertThat(warning(line)).startsWith("3:1: warning: programs differ: taken as the middle of the base, the direction to the apex");
    }

    @Test
    void theAngleFromLeftToRightBecomesThatFromBottomToTop() throws IOException {
        Pose square = Imports.read(ForeignFormat.RT, CAMERA + "R 300 300").scene().settings.camera;
        Pose wide = Imports.read(ForeignFormat.RT, "R 400 200\n" + CAMERA).scene().settings.camera;

        assertThat(square.fov()).isEqualTo(90);
        assertThat(Math.tan(Math.toRadians(wide.fov() / 2))).isCloseTo(0.5, within(1e-14));    // half the height of tan 45 degrees
        assertThat(scene("R 400 200\n" + CAMERA)).contains("\nresolution 400 200\n");
    }

    @Test
    void blanksAboutCommasAndAnyLineBreaksAreNothing() throws IOException {
        String tidy = scene(CAMERA + "sp 0,0,-5 2 255,0,0\nL 1,2,3 0.5\n");

        assertThat(scene((CAMERA + "  sp\t0 ,0, -5   2  255 , 0,0 # red\n\n\nL 1,2,3 0.5  ").replace("\n", "\r\n"))).isEqualTo(tidy);
        assertThat(scene("\uFEFF" + (CAMERA + "sp 0,0,-5 2 255,0,0\nL 1,2,3 0.5 255,255,255").replace('\n', '\r'))).isEqualTo(tidy);
    }

    @Test
    void aLongLineIsRead() throws IOException {
        assertThat(object("sp 0,0,-5" + " ".repeat(100_000) + "2 255,0,0")).isEqualTo("0  0.0 0.0 -5.0 1.0" + RED);
        assertThat(error(CAMERA + "sp 0,0,-5" + " ".repeat(100_000) + "two 255,0,0")).isEqualTo("3:100010: the sphere's diameter, found 'two'");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "sp 0,0,-5 2 255,0,0 checker 0,0,0 | 3:21: warning: left out: what stands here is not in miniRT, and programs that have it differ",
        "pl 0,0,-5 0,1,0 255,0,0 tex.xpm   | 3:25: warning: left out: what stands here is not in miniRT, and programs that have it differ",
        "L 0,0,5 0.7 10                    | 3:13: warning: left out: what stands here is not in miniRT, and programs that have it differ",
        "sq 0,0,-5 0,0,1 3 255,0,0         | 3:1: warning: left out: its line does not tell how a square is turned about its normal",
        "hy 0,0,-5 0,0,1 3 255,0,0         | 3:1: warning: left out: miniRT has no hy, and programs that have it differ",
        "A 0.5 255,0,0                     | 3:1: warning: left out: a scene has one ambient light, the first",
        "C 1,1,1 0,0,1 30                  | 3:1: warning: left out: a scene has one camera, the first",
        "tr 0,0,0 1,1,1 2,2,2 255,0,0      | 3:1: warning: left out: a triangle without area"})
    void whatDialectsHaveBesidesIsLeftOutWithAWarning(String line, String warning) throws IOException {
        assertThat(warning(line)).isEqualTo(warning);
    }

    @Test
    void ofTwoSizesTheFirstCounts() throws IOException {
        assertThat(scene("R 4 4\nR 5 5\n" + CAMERA)).contains("resolution 4 4\n");
        assertThat(warning("R 4 4\nR 5 5")).isEqualTo("4:1: warning: left out: a scene has one size, the first");
    }

    @Test
    void withoutAmbientLightThereIsAWarning() throws IOException {
        assertThat(Imports.warnings(ForeignFormat.RT, "C 0,0,0 0,0,1 70\n")).containsExactly(
            "2:1: warning: without ambient light, since the file has no line A");
    }

    @Test
    void afterAThousandWarningsOneTellsOfTheOthers() throws IOException {
        assertThat(Imports.warnings(ForeignFormat.RT, CAMERA + "hy 1\n".repeat(1002))).hasSize(1001).endsWith("1005:1: warning: 2 more warnings of these kinds");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "sp 0,0,-5 two 255,0,0        | 3:11: the sphere's diameter, found 'two'",
        "sp 0,0,-5 -2 255,0,0         | 3:11: the sphere's diameter above 0, found '-2'",
        "sp 0,0,-5 2 256,0,0          | 3:13: the sphere's red from 0 to 255, found '256'",
        "sp 0,0,-5 2                  | 3:12: the sphere's red from 0 to 255, found the end of the line",
        "sp 0,0 2 255,0,0             | 3:8: a comma and the sphere's z, found '2'",
        "sp 0,,0 2 255,0,0            | 3:6: the sphere's y, found ','",
        "sp 0,0,0,0 2 255,0,0         | 3:9: a blank after the sphere's z, found ',0' (a decimal point is a '.')",
        "sp 0,0,x 2 255,0,0           | 3:8: the sphere's z, found 'x'",
        "sp 0,0,1e101 2 255,0,0       | 3:8: the sphere's z, found '1e101' (beyond 1e100)",
        "sp 0,0,nan 2 255,0,0         | 3:8: the sphere's z, found 'nan' (numbers must be finite)",
        "pl 0,0,0 0,0,0 255,0,0       | 3:10: the plane's normal other than zero, found zero",
        "cy 0,0,0 0,0,1 2 0 255,0,0   | 3:18: the cylinder's height above 0, found '0'",
        "cy 9e99,0,0 1,0,0 1 9e99 0,0,0| 3:1: ends of numbers from -1e100 to 1e100, found '4.5E99 0.0 0.0  1.35E100 0.0 0.0'",
        "co 9e99,0,0 1,0,0 1 9e99 0,0,0| 3:1: second end of numbers from -1e100 to 1e100, found '1.8E100 0.0 0.0'",
        "sp 0,0,0 5e-324 0,0,0        | 3:1: radius above 0, found '0.0'",
        "pl 2,0,0 1e100,0,0 0,0,0     | 3:1: constant from -1e100 to 1e100, found '2.0E100'",
        "cy 9e9,0,0 1,0,0 1 1e-9 0,0,0| 3:1: a height that is not lost beside the point, found a smaller one",
        "R 0 5                        | 3:3: the picture's width from 1 to 65535, found '0'",
        "R 5 65536                    | 3:5: the picture's height from 1 to 65535, found '65536'",
        "L 1,1,1 -1                   | 3:9: the light's brightness of 0 or more, found '-1'",
        "A 0,2 255,255,255            | 3:3: the ambient light's ratio of 0 or more, found '0,2' (a decimal point is a '.')",
        "C 0,0,0 0,0,0 70             | 3:9: the camera's direction other than zero, found zero",
        "C 0,0,0 0,0,1 180            | 3:15: the view's angle above 0 and below 180 degrees, found '180'",
        "hello                        | 3:1: A, C, L, sp, pl or cy, found 'hello'",
        "0 0 0                        | 3:1: A, C, L, sp, pl or cy, found '0'"})
    void anErrorTellsLineAndColumn(String line, String error) {
        assertThat(error(CAMERA + line + '\n')).isEqualTo(error);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', nullValues = "-", value = {"- | 1:1", "A 0 0,0,0 | 1:10", "'A 0 0,0,0\n\n' | 3:1"})
    void aSceneNeedsACamera(String text, String place) {
        assertThat(error(text == null ? "" : text)).isEqualTo(place + ": a camera: C, found the end of the file");
    }

    @Test
    void whatIsNoTextIsAnError() {
        assertThat(error("\0\0\0\0")).isEqualTo("1:1: text in UTF-8, found NUL bytes");
    }

    @Test
    void aDirectionOfAnyLengthIsTheCameras() throws IOException {
        for (String camera : new String[] {"1,2,3 0,0,-1e-300 | 1.0 2.0 3.0 1.0 2.0 0.0", "1,2,3 0,1e-9,0 | 1.0 2.0 3.0 1.0 5.0 3.0",
            "1e50,0,0 0,1,0 | 1.0E50 0.0 0.0 1.0E50 1.0E50 0.0", "1e50,0,0 1,0,0 | 1.0E50 0.0 0.0 2.0E50 0.0 0.0",
            "1,2,3 0,1e100,0 | 1.0 2.0 3.0 1.0 1.0E100 3.0", "1000,0,0 0,0,1 | 1000.0 0.0 0.0 1000.0 0.0 1.0"}) {
            String[] both = camera.split(" \\| ");
            assertThat(scene("A 0 0,0,0\nC " + both[0] + " 90\n")).endsWith("camera " + both[1] + " 90.0\n");
        }
    }

    @Test
    void anAngleThatIsLostInThePicturesShapeIsAnError() {
        assertThat(error("A 0 0,0,0\nR 60000 1\nC 0,0,0 0,0,-1 1e-320\n"))
            .isEqualTo("3:1: camera's field of view above 0 and below 180 degrees, found '0.0'");
    }
}
