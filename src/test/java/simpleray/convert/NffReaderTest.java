package simpleray.convert;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Haines' Neutral File Format, entity by entity. */
class NffReaderTest {
    private static final String VIEW = "v from 0 0 5 at 0 0 0 up 0 2 0 angle 45 hither 0 resolution 64 64\n";
    private static final String GREY = "f 1 1 1 0.5 0 1 0 0\n";
    private static final String MATT = "  0.5 0.5 0.5  0.5 0.5 0.5  0.0 0.0 0.0  1.0\n";

    private static String scene(String text) throws IOException {
        return Imports.scene(ForeignFormat.NFF, text);
    }

    /** {@return the objects of a scene, as they are written} */
    private static String objects(String text) throws IOException {
        String scene = scene(VIEW + text);
        return scene.substring(scene.indexOf('\n', scene.indexOf("objects\n") + 8) + 1, scene.indexOf("# ambient"));
    }

    private static String warning(String text) throws IOException {
        return String.join("\n", Imports.warnings(ForeignFormat.NFF, VIEW + text));
    }

    private static String error(String text) {
        return Imports.error(ForeignFormat.NFF, text);
    }

    @Test
    void aWholeSceneBecomesOurs() throws IOException {
        assertThat(scene("""
            # balls
            b 0.1 0.2 0.3
            v
            from 2.1 1.3 1.7
            at 0 0 0
            up 0 0 1
            angle 45
            hither 0.01
            resolution 512 512
            l 4 3 2
            l 1 -4 4
            l -3 1 5 0.1 0.2 0.3
            l 0 0 9
            f 1 0.5 0.25 0.5 0.25 3.5 0 0
            s 0 0 0 0.5
            """)).isEqualTo("""
            # imported by SimpleRay from a.file
            # number of objects
            1
            0  0.0 0.0 0.0 0.5  0.5 0.25 0.125  0.5 0.25 0.125  0.25 0.25 0.25  3.5
            # ambient light
            0.0 0.0 0.0
            # number of lights
            4
            0  0.5 0.5 0.5  4.0 3.0 2.0
            0  0.5 0.5 0.5  1.0 -4.0 4.0
            0  0.1 0.2 0.3  -3.0 1.0 5.0
            0  0.5 0.5 0.5  0.0 0.0 9.0
            background 0.1 0.2 0.3
            camera 2.1 1.3 1.7 0.0 0.0 0.0 45.0
            up 0.0 0.0 1.0
            resolution 512 512
            """);
    }

    @Test
    void anyWhiteSpacePartsWords() throws IOException {
        String text = VIEW + GREY + "s 0 0 0\n\n1 l 1 2 3 # white\nl 4 5 6\n.5 .5 .5";

        assertThat(error(text)).isEqualTo("7:1: v, b, l, f, s, c, p or pp, found '.5'");      // a light's colour is on its line
        String tidy = scene(VIEW + GREY + "s 0 0 0 1\nl 1 2 3\nl 4 5 6 .5 .5 .5\n");
        assertThat(scene((VIEW + GREY + "s\n0 0\t0\n\n1 l 1 2 3 # white\nl 4 5 6 .5\n.5 .5").replace("\n", "\r\n"))).isEqualTo(tidy);
    }

    @Test
    void aSizeAndAHitherPlaneMayBeMissing() throws IOException {
        assertThat(scene("v from 0 0 5 at 0 0 0 up 0 1 0 angle 45")).endsWith("camera 0.0 0.0 5.0 0.0 0.0 0.0 45.0\nup 0.0 1.0 0.0\n");
    }

    @Test
    void aCylinderAndAConeAreOpen() throws IOException {
        assertThat(objects(GREY + "c 0 0 0 2  0 3 0 2\nc 1 1 1 2  1 1 4 0\n")).isEqualTo(
            "5  0.0 0.0 0.0 2.0  0.0 3.0 0.0 2.0" + MATT + "5  1.0 1.0 1.0 2.0  1.0 1.0 4.0 0.0" + MATT);
    }

    @Test
    void glassTransmitsItsShareInAllColours() throws IOException {
        assertThat(objects("f 1 0 0 0.5 0.25 10 0.75 1.5\ns 0 0 0 1\n")).isEqualTo(
            "0  0.0 0.0 0.0 1.0  0.5 0.0 0.0  0.5 0.0 0.0  0.25 0.25 0.25  10.0  transmit 0.75 0.75 0.75  1.5\n");
    }

    @Test
    void aPolygonIsCutIntoTrianglesThatRunRoundAsItDoes() throws IOException {
        assertThat(objects(GREY + "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n")).isEqualTo(
            "2  0.0 0.0 0.0  1.0 0.0 0.0  1.0 1.0 0.0" + MATT + "2  0.0 0.0 0.0  1.0 1.0 0.0  0.0 1.0 0.0" + MATT);
    }

    /** An arrow head: its fan from the first corner would cover what is outside. */
    @Test
    void aConcavePolygonIsCutAlongItsNotch() throws IOException {
        assertThat(objects(GREY + "p 4  4 0 0  0 4 0  1 1 0  0 -4 0\n").lines()).hasSize(2)
            .allSatisfy(triangle -> assertThat(triangle).contains("4.0 0.0 0.0", "1.0 1.0 0.0"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "p 3 0 0 0 1 1 1 2 2 2              | 3:1: warning: left out: a polygon without area",
        "p 2 0 0 0 1 1 1                    | 3:1: warning: left out: a polygon of fewer than three corners",
        "p 5 0 0 0 4 4 0 4 0 0 0 4 0 2 -1 0 | 3:1: warning: changed: crosses itself, and so is the fan from its first corner",
        "s 0 0 0 0                          | 3:1: warning: left out: a sphere of radius 0",
        "s 0 0 0 -1                         | 3:1: warning: changed: seen from both sides, not from inside alone",
        "c 0 0 0 1 0 0 0 2                  | 3:1: warning: left out: a cone without height",
        "c 0 0 0 0 0 1 0 0                  | 3:1: warning: left out: a cone without radius",
        "c 0 0 0 -1 0 1 0 -2                | 3:1: warning: changed: seen from both sides, not from inside alone",
        "b 0 0 0 b 1 1 1                    | 3:9: warning: left out: a scene has one background, the first",
        "v from 0 0 1 at 0 0 0 up 0 1 0 angle 9 | 3:1: warning: left out: a scene has one view, the first",
        "f 1 1 1 1 0 5 0.5 0.9              | 3:1: warning: changed: index of refraction 1, since ours are 1 or more",
        "f 1 1 1 1 0 0.5 0.5 1.5            | 3:1: warning: changed: Shine 10, which no highlight shows; with less than 1 no light would pass through",
        "f 1 1 1 1 1 0.5 0 0                | 3:1: warning: changed: no ray is mirrored or passes through, since Shine below 1 grants none",
        "pp 3 0 0 0 0 0 1 1 0 0 0 0 0 0 1 0 0 0 1 | 3:1: warning: changed: without normals, since one of them is 0 0 0"})
    void whatIsChangedOrLeftOutIsAWarning(String entity, String warning) throws IOException {
        assertThat(warning(GREY + entity)).isEqualTo(warning);
    }

    @Test
    void whatIsSeenFromInsideAloneIsSeenFromBothSides() throws IOException {
        assertThat(objects(GREY + "s 0 0 0 -1 c 0 0 0 -1 0 1 0 -2 s 1 1 1 0")).isEqualTo(
            "0  0.0 0.0 0.0 1.0" + MATT + "5  0.0 0.0 0.0 1.0  0.0 1.0 0.0 2.0" + MATT);
    }

    @Test
    void aWidePictureHasTheAngleOfItsHeight() throws IOException {
        assertThat(Imports.warnings(ForeignFormat.NFF, VIEW.replace("64 64", "64 32"))).containsExactly(
            "1:1: warning: changed: the angle is that from bottom to top, since pixels are square");
    }

    @Test
    void aHitherPlaneIsToldOfWhereItMayCut() throws IOException {
        String view = VIEW.replace("hither 0", "hither 1");
        String behind = "s 0 0 7 1\n";

        assertThat(Imports.warnings(ForeignFormat.NFF, view + GREY + behind + "s 0 0 0 1\n")).isEmpty();
        assertThat(Imports.warnings(ForeignFormat.NFF, view + GREY + behind + "s 0 0 3.5 1\n")).containsExactly(
            "1:41: warning: left out: hither, since rays see from the eye on; what is on line 4 may lie nearer than it");
        assertThat(Imports.warnings(ForeignFormat.NFF, VIEW.replace("hither 0", "hither -1"))).containsExactly(
            "1:41: warning: left out: hither, since rays see from the eye on and nothing behind it");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "s 0 0 0 one        | 3:9: the sphere's radius, found 'one'",
        "s 0 0              | 4:1: the sphere's z, found the end of the file",
        "f 1 1 1 1 1 1 1.5 1| 3:15: T from 0 to 1, found '1.5'",
        "s 0 1e101 0 1      | 3:5: the sphere's y, found '1e101' (beyond 1e100)",
        "c 0 0 0 1 1 0 0 -1 | 3:17: a radius of the same sign as the other, found '-1'",
        "p x                | 3:3: the number of corners, 1 or more, found 'x'",
        "p 1e9              | 3:3: the number of corners, 1 or more, found '1e9'",
        "p 2000000000 1 2 3 | 4:1: the corner's x, found the end of the file",
        "pp 3 0 0 0 0 0 u   | 3:16: the normal's z, found 'u'",
        "f 1 1 1 1 0 -1 0 0 | 3:13: Shine of 0 or more, found '-1'",
        "b 1 1 -1           | 3:7: the background's blue of 0 or more, found '-1'",
        "l 1 1 1 1          | 4:1: the light's green of 0 or more, found the end of the file",
        "t 1 2 3            | 3:1: v, b, l, f, s, c, p or pp, found 't'",
        "s 0 0 0 1 0.5      | 3:11: v, b, l, f, s, c, p or pp, found '0.5'"})
    void anErrorTellsLineAndColumn(String entity, String error) {
        assertThat(error(VIEW + GREY + entity + '\n')).isEqualTo(error);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "v from 0 0 5 at 0 0 5 up 0 1 0 angle 45        | 1:17: a look-at point other than the eye, found the eye",
        "v from 0 0 5 at 0 0 0 up 0 0 3 angle 45        | 1:26: up that is not along the view, found one that is",
        "v from 0 0 5 at 0 0 0 up 0 0 0 angle 45        | 1:26: up that is not along the view, found one that is",
        "v from 0 0 5 at 0 0 0 up 0 1 0 angle 0         | 1:38: an angle above 0 and below 180 degrees, found '0'",
        "v from 0 0 5 at 0 0 0 up 0 1 0 angle 200       | 1:38: an angle above 0 and below 180 degrees, found '200'",
        "v from 0 0 5 at 0 0 0 angle 45                 | 1:23: the view's up, found 'angle'",
        "v                                              | 1:2: the view's from, found the end of the file",
        "v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 resolution 0 1 | 1:52: the picture's width from 1 to 65535, found '0'",
        "s 0 0 0 1                                      | 1:1: a material before the first object: f, found the object",
        "b 0 0 0                                        | 1:8: a view: v, found the end of the file"})
    void aViewAndAMaterialAreNeeded(String text, String error) {
        assertThat(error(text)).isEqualTo(error);
    }

    @Test
    void normalsAndManyPolygonsGoToAnObj() throws IOException {
        String square = "p 4  0 0 0  1 0 0  1 1 0  0 1 0\n";

        assertThat(Imports.read(ForeignFormat.NFF, VIEW + GREY + square.repeat(Facets.MAX_TRIANGLES)).facets().areMesh()).isFalse();
        assertThat(Imports.read(ForeignFormat.NFF, VIEW + GREY + square.repeat(Facets.MAX_TRIANGLES + 1)).facets().areMesh()).isTrue();
        assertThat(Imports.read(ForeignFormat.NFF, VIEW + GREY + "pp 3  0 0 0 0 0 1  1 0 0 0 0 1  0 1 0 0 0 1").facets().areMesh()).isTrue();
    }

    @Test
    void theMeshStandsWhereItsFirstTriangleStood() throws IOException {
        ImportedScene read = Imports.read(ForeignFormat.NFF, VIEW + GREY + "s 0 0 0 1\npp 3  0 0 0 0 0 1  1 0 0 0 0 1  0 1 0 0 1 0\ns 5 0 0 1\np 3 0 0 0 0 1 0 0 0 1\n");

        assertThat(Imports.text(os -> read.write(os, "a.obj"))).contains("\n3\n0  0.0 0.0 0.0 1.0" + MATT + "4  \"a.obj\" 0.0 0.0 0.0 1.0" + MATT
            + "0  5.0 0.0 0.0 1.0" + MATT);
        assertThat(Imports.text(os -> read.writeObj(os, "a.mtl"))).isEqualTo("""
            # imported by SimpleRay from a.file
            v 0.0 0.0 0.0
            v 1.0 0.0 0.0
            v 0.0 1.0 0.0
            v 0.0 0.0 1.0
            vn 0.0 0.0 1.0
            vn 0.0 1.0 0.0
            f 1//1 2//1 3//2
            f 1 3 4
            """);
    }

    @Test
    void polygonsOfManyMaterialsHaveAnMtl() throws IOException {
        ImportedScene read = Imports.read(ForeignFormat.NFF, VIEW + GREY + "pp 3  0 0 0 0 0 1  1 0 0 0 0 1  0 1 0 0 0 1\n"
            + "f 1 0 0 1 0.5 4 0.25 1.5\np 3  0 0 0  1 0 0  0 1 0\n" + GREY + "p 3  0 0 0  1 0 0  0 0 1\n");

        assertThat(Imports.text(os -> read.write(os, "a.obj"))).contains("\n4  \"a.obj\" 0.0 0.0 0.0 1.0" + MATT.replace("\n", "  mtl\n"));
        assertThat(Imports.text(os -> read.writeObj(os, "a.mtl"))).contains("from a.file\nmtllib a.mtl\nv ").endsWith("""
            usemtl m1
            f 1//1 2//1 3//1
            usemtl m2
            f 1 2 3
            usemtl m1
            f 1 2 4
            """);
        assertThat(Imports.text(read::writeMtl)).isEqualTo("""
            # imported by SimpleRay from a.file
            newmtl m1
            Ka 0.5 0.5 0.5
            Kd 0.5 0.5 0.5
            Ks 0.0 0.0 0.0
            Ns 1.0
            newmtl m2
            Ka 1.0 0.0 0.0
            Kd 1.0 0.0 0.0
            Ks 0.5 0.5 0.5
            Ns 4.0
            Tr 0.25
            Ni 1.5
            """);
    }
}
