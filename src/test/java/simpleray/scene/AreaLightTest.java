package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.material;
import static simpleray.scene.Scenes.seen;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;

class AreaLightTest {
    private static final double ROUNDING = 1e-15;
    private static final String NUMBER = "expected number of points along each edge from 1 to 64";

    private static AreaLight light(int n) {
        AreaLight light = new AreaLight(new Point(1, 2, 3), new Vector(8, 0, 0), new Vector(0, 4, -8), n);
        light.intensity = new Colour(1, 0.5, 0.25);
        return light;
    }

    @Test
    void aNewAreaLightIsAWhitePointInTheMiddleOfALevelSquare() {
        assertThat(written(new AreaLight()::print)).isEqualTo("Area light with colour: (1.0,1.0,1.0) and corner: [-0.5,0.0,-0.5]"
            + " and edges: [1.0,0.0,0.0] and [0.0,0.0,1.0] and points along each: 1");
        PointLight lamp = new PointLight();
        new AreaLight().point(0, lamp);
        assertThat(lamp.origin).hasToString("[0.0,0.0,0.0]");
        assertThat(lamp.intensity).hasToString("(1.0,1.0,1.0)");
    }

    @Test
    void anAreaLightKeepsWhatItIsMadeOfAndCopiesNothing() {
        Point corner = new Point();
        Vector u = new Vector(1, 0, 0);
        Vector v = new Vector(0, 1, 0);
        AreaLight light = new AreaLight(corner, u, v, 7);
        assertThat(light.corner).isSameAs(corner);
        assertThat(light.u).isSameAs(u);
        assertThat(light.v).isSameAs(v);
        assertThat(light.side).isEqualTo(7);
        assertThat(light.points()).isEqualTo(49);
        assertThat(light.origin()).isNull();
    }

    @Test
    void itsPointsAreTheCentresOfItsCellsRowByRow() {
        List<String> points = new ArrayList<>();
        PointLight lamp = new PointLight();
        for (int i = 0; i < 4; i++) {
            light(2).point(i, lamp);
            points.add(lamp.origin.toString());
            assertThat(lamp.intensity).hasToString("(0.25,0.125,0.0625)");
        }
        // a fourth and three fourths of the edges (8,0,0) and (0,4,-8) from the corner (1,2,3)
        assertThat(points).containsExactly("[3.0,3.0,1.0]", "[7.0,3.0,1.0]", "[3.0,5.0,-3.0]", "[7.0,5.0,-3.0]");
    }

    @Test
    void itIsTowardsItsMiddle() {
        // the middle of the parallelogram is (5,4,-1), 5 from (5,0,-4)
        Vector l = new Vector();
        assertThat(light(3).towards(new Point(5, 0, -4), l)).isEqualTo(5);
        assertThat(l.x).isZero();
        assertThat(l.y).isEqualTo(0.8, within(ROUNDING));
        assertThat(l.z).isEqualTo(0.6, within(ROUNDING));
    }

    @Test
    void anAreaLightReadsBackBitForBit() throws IOException {
        AreaLight before = new AreaLight(new Point(-0.0, 1e23, 1.0 / 3), new Vector(1e100, 0, 0.1), new Vector(0, -1e100, 3), 64);
        before.intensity = new Colour(0.1, Double.MIN_VALUE, 7);
        String text = written(before::write);
        AreaLight after = new AreaLight();
        after.read(reader(text));

        assertThat(text).isEqualTo("0.1 4.9E-324 7.0  -0.0 1.0E23 0.3333333333333333  1.0E100 0.0 0.1  0.0 -1.0E100 3.0  64");
        assertThat(SceneBits.of(after)).isEqualTo(SceneBits.of(before));
    }

    @Test
    void readingMakesAnAreaLightItsOwnPlace() throws IOException {
        AreaLight light = new AreaLight();
        Point corner = light.corner;
        Vector u = light.u;
        Vector v = light.v;
        light.read(reader("1 1 1  5 5 5  2 0 0  0 2 0  3"));
        assertThat(corner).hasToString("[-0.5,0.0,-0.5]");
        assertThat(u).hasToString("[1.0,0.0,0.0]");
        assertThat(v).hasToString("[0.0,0.0,1.0]");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1 0 0 2 0 0", "1 2 3 -2 -4 -6", "0.1 0.2 0.3 0.3 0.6 0.9", "0 0 0 1 0 0", "1 0 0 0 0 0", "1e-200 0 0 1e-200 0 0",
        "1e90 1e90 0 1e90 1e90 0"})
    void itsEdgesSpanAnArea(String edges) {
        String line = "1 1 1  0 0 0  " + edges + " 4";
        assertThatThrownBy(() -> new AreaLight().read(reader(line))).hasMessage(
            "<stdin>:1:15: error: expected edges u and v that span an area, found '" + edges + "'\n" + line + "\n              ^");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1 0 0 1 1e-9 0", "1e-200 0 0 0 1e-200 0", "1e100 0 0 0 0 1e-100"})
    void theyMayBeOfAnyLengthAndAngle(String edges) throws IOException {
        new AreaLight().read(reader("1 1 1  0 0 0  " + edges + " 4"));
    }

    @ParameterizedTest
    @CsvSource({"0, ''", "65, ''", "-1, ''", "4.0, ' (an integer has only digits)'", "2.5, ' (an integer has only digits)'",
        "NaN, ' (numbers must be finite)'"})
    void theNumberOfPointsIsWholeAndFrom1To64(String n, String why) {
        String line = "1 1 1  0 0 0  1 0 0  0 1 0  " + n;
        assertThatThrownBy(() -> new AreaLight().read(reader(line))).hasMessage(
            "<stdin>:1:29: error: " + NUMBER + ", found '" + n + '\'' + why + '\n' + line + "\n                            ^");
    }

    @Test
    void bothEndsOfThatRangeAreRead() throws IOException {
        for (int n : new int[] {1, 64}) {
            AreaLight light = new AreaLight();
            light.read(reader("1 1 1  0 0 0  1 0 0  0 1 0  " + n));
            assertThat(light.side).isEqualTo(n);
        }
    }

    @Test
    void noNumberIsBeyond1e100AndNoColourBelowZero() {
        assertThatThrownBy(() -> new AreaLight().read(reader("1 1 -1  0 0 0  1 0 0  0 1 0  2"))).hasMessageStartingWith(
            "<stdin>:1:5: error: expected colour blue of 0 or more, found '-1'\n");
        assertThatThrownBy(() -> new AreaLight().read(reader("1 1 1  0 2e100 0  1 0 0  0 1 0  2"))).hasMessageStartingWith(
            "<stdin>:1:8: error: expected corner of numbers from -1e100 to 1e100, found '0 2e100 0'\n");
        assertThatThrownBy(() -> new AreaLight().read(reader("1 1 1  0 0 0  1 0 0  0 0 2e100  2"))).hasMessageStartingWith(
            "<stdin>:1:15: error: expected edges of numbers from -1e100 to 1e100, found '1 0 0  0 0 2e100'\n");
    }

    @Test
    void eachMissingPartIsNamed() {
        assertMissing("1 *", "<stdin>:1:3: error: expected colour green, found '*'");
        assertMissing("1 1 1  0 *", "<stdin>:1:10: error: expected corner y, found '*'");
        assertMissing("1 1 1  0 0 0  0 0 *", "<stdin>:1:19: error: expected edge u z, found '*'");
        assertMissing("1 1 1  0 0 0  0 0 1  *", "<stdin>:1:22: error: expected edge v x, found '*'");
        assertMissing("1 1 1  0 0 0  0 0 1  0 1 0", "<stdin>:1:27: error: " + NUMBER + ", found the end of the file");
    }

    private static void assertMissing(String text, String message) {
        assertThatThrownBy(() -> new AreaLight().read(reader(text))).hasMessageStartingWith(message + '\n');
    }

    /** Its points as lights of their own make the same picture, up to the order of the sum. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void itShinesAsSoManyPointLights(int n) {
        Material shiny = material(grey(0.1), new Colour(0.5, 0.6, 0.7), new Colour(0.3, 0.2, 0.1), 5);
        AreaLight area = light(n);
        PointLight[] alone = new PointLight[n * n];
        for (int i = 0; i < alone.length; i++) {
            alone[i] = new PointLight();
            area.point(i, alone[i]);
        }
        Scene scene = Scenes.lit(Scenes.wall(shiny, -5), new Sphere(shiny, new Point(2, 1.5, -2), 1.2),
            new Sphere(Scenes.glass(0, 0.5, 1), new Point(1, 1, -1), 1));
        Scene same = Scenes.lit(scene.getObject(0), scene.getObject(1), scene.getObject(2));
        PointLight other = Scenes.pointLight(-3, 1, 2);
        Scenes.light(scene, other, area, other);
        List<Light> lights = new ArrayList<>(List.of(alone));
        lights.add(0, other);
        lights.add(other);
        Scenes.light(same, lights.toArray(new Light[0]));
        for (Terms terms : List.of(Terms.ALL, Scenes.LIGHTING, new Terms(false, true, false, false, false),
                new Terms(false, false, true, true, false))) {
            for (double x = -0.9; x < 1; x += 0.17) {
                Colour one = seen(scene, Scenes.ray(0, 0, 2, x, x / 2, -1), 2, terms);
                Colour many = seen(same, Scenes.ray(0, 0, 2, x, x / 2, -1), 2, terms);
                assertThat(one.r).isEqualTo(many.r, within(1e-14));
                assertThat(one.g).isEqualTo(many.g, within(1e-14));
                assertThat(one.b).isEqualTo(many.b, within(1e-14));
            }
        }
    }

    /** The sum of its points is added to that of the lights before it, which rounds otherwise than adding point by point. */
    @Test
    void itsPointsAreSummedBeforeTheyAreAdded() {
        double tiny = 0x1p-53;                                // 1 + tiny is 1, and 1 + 4 tiny is not
        AreaLight area = new AreaLight(new Point(-1e-9, -1e-9, 8), new Vector(2e-9, 0, 0), new Vector(0, 2e-9, 0), 2);
        area.intensity = grey(4 * tiny);
        Scene scene = Scenes.of(Scenes.wall(material(grey(0), grey(1), grey(0), 0), 0));
        Scenes.light(scene, Scenes.pointLight(0, 0, 8), area);
        assertThat(seen(scene, Scenes.ahead(), 0, Terms.ALL).r).isEqualTo(1 + 4 * tiny);
    }

    /** A lamp's surface does not shadow a light that lies in it. */
    @Test
    void aSurfaceInWhichItLiesIsNotInItsWay() {
        AreaLight area = new AreaLight(new Point(-1, -1, 4), new Vector(2, 0, 0), new Vector(0, 2, 0), 3);
        Material matt = material(grey(0), grey(1), grey(0), 0);
        Triangle lamp = new Triangle(matt, new Point(-9, -9, 4), new Point(9, -9, 4), new Point(0, 9, 4));
        Scene scene = Scenes.of(Scenes.wall(matt, 0), lamp);
        Scenes.light(scene, area);
        Colour lit = seen(scene, Scenes.ahead(), 0, Scenes.LIGHTING);
        assertThat(seen(scene, Scenes.ahead(), 0, Terms.ALL)).hasToString(lit.toString());
        assertThat(lit.r).isBetween(0.9, 1.0);
    }
}
