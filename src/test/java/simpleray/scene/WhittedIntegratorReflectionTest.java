package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.LIGHTING;
import static simpleray.scene.Scenes.ahead;
import static simpleray.scene.Scenes.glowing;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.light;
import static simpleray.scene.Scenes.lit;
import static simpleray.scene.Scenes.material;
import static simpleray.scene.Scenes.pointLight;
import static simpleray.scene.Scenes.ray;
import static simpleray.scene.Scenes.seen;
import static simpleray.scene.Scenes.wall;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;

class WhittedIntegratorReflectionTest {
    private static final double ROUNDING = 1e-15;
    private static final int DEPTH = 10;

    @Test
    void aMirrorShowsWhatIsBehindTheViewerTimesItsColour() {
        Scene scene = lit(wall(material(grey(0), grey(0), new Colour(0.5, 0.25, 1), 1), 0), wall(glowing(0.5), 4));

        assertThat(seen(scene, ahead(), DEPTH, Terms.ALL)).hasToString("(0.25,0.125,0.5)");
    }

    @Test
    void theMirrorRayLeavesAtTheAngleAtWhichItCame() {
        // (0.6,0,-0.8) comes from (-3,0,4) to the origin and leaves along (0.6,0,0.8), to the sphere at (6,0,8)
        Scene scene = lit(wall(mirror(0, 0.5, 1), 0), new Sphere(glowing(0.5), new Point(6, 0, 8), 0.1));

        assertThat(seen(scene, ray(-3, 0, 4, 0.6, 0, -0.8), DEPTH, Terms.ALL)).hasToString("(0.25,0.25,0.25)");
    }

    @Test
    void aSurfaceMirrorsOnBothOfItsSides() {
        Scene scene = lit(new Plane(mirror(0, 0.5, 1), new Vector(0, 0, -2), 0),
            new Sphere(glowing(0.5), new Point(6, 0, 8), 0.1));

        assertThat(seen(scene, ray(-3, 0, 4, 0.6, 0, -0.8), DEPTH, Terms.ALL)).hasToString("(0.25,0.25,0.25)");
    }

    @Test
    void aSphereMirrorsWithItsNormalAtThePlace() {
        // at (0.6,0,0.8): D - 2(D·N)N = (0,0,-1) + 1.6 (0.6,0,0.8) = (0.96,0,0.28); 10 of it from there is (10.2,0,3.6)
        Scene scene = lit(new Sphere(mirror(0, 0.5, 1), new Point(), 1), new Sphere(glowing(0.5), new Point(10.2, 0, 3.6), 0.01));

        assertThat(seen(scene, ray(0.6, 0, 5, 0, 0, -1), DEPTH, Terms.ALL)).hasToString("(0.25,0.25,0.25)");
    }

    @Test
    void aMirrorThatShowsNothingAddsBlack() {
        Scene scene = lit(wall(mirror(0.25, 0.5, 1), 0));

        assertThat(seen(scene, ahead(), DEPTH, Terms.ALL)).hasToString("(0.25,0.25,0.25)");
    }

    @Test
    void whatIsMirroredIsLitAndShadowed() {
        // the mirror z = 0 shows the wall z = 4 at (0,0,4), whence L to the light at (3,0,0) is (0.6,0,-0.8): N·L = 0.8
        Scene scene = lit(wall(mirror(0, 0.5, 1), 0), wall(material(grey(0), grey(1), grey(0), 0), 4));
        light(scene, pointLight(3, 0, 0));
        double lit = seen(scene, ahead(), DEPTH, Terms.ALL).r;
        Scene shaded = lit(scene.getObject(0), scene.getObject(1), new Sphere(glowing(0), new Point(1.5, 0, 2), 0.1));
        light(shaded, pointLight(3, 0, 0));

        // the mirror itself is lit at a grazing angle, so not at all
        assertThat(lit).isEqualTo(0.5 * 0.8, within(ROUNDING));
        assertThat(seen(shaded, ahead(), DEPTH, Terms.ALL).r).isZero();
    }

    /**
     * Two mirrors of Ka = 1 and Ks = 0.5 face each other: with n reflections the ray sees 1 + 1/2 + ... + 1/2^n = 2 - 1/2^n, where n
     * is the lesser of depth and floor(shininess).
     */
    @ParameterizedTest
    @CsvSource({"0, 10, 1", "1, 10, 1.5", "2, 10, 1.75", "3, 10, 1.875", "10, 10, 1.9990234375", "10, 0, 1", "10, 0.9, 1",
        "10, 1, 1.5", "10, 1.999, 1.5", "10, 2, 1.75", "10, 3.5, 1.875", "2, 3, 1.75", "3, 2, 1.75", "40, 1000, 1.99999999999909"})
    void theLesserOfDepthAndShininessCountsTheReflections(int depth, double shininess, double expected) {
        Scene scene = lit(wall(mirror(1, 0.5, shininess), 0), wall(mirror(1, 0.5, shininess), 4));

        assertThat(seen(scene, ahead(), depth, Terms.ALL).g).isEqualTo(expected, within(1e-14));
    }

    @Test
    void aMirrorThatGrantsOneReflectionLeavesNoneToTheNext() {
        // the first grants 1, so that nothing is left to the second
        Scene scene = lit(wall(mirror(1, 0.5, 1), 0), wall(mirror(1, 0.5, 10), 4));

        assertThat(seen(scene, ahead(), DEPTH, Terms.ALL).g).isEqualTo(1.5);
    }

    @Test
    void aMirrorThatGrantsManyLeavesTheNextItsOwn() {
        // the first leaves 9, of which the second grants 1, so that nothing is left to the third: 1 + 1/2 + 1/4
        Scene scene = lit(wall(mirror(1, 0.5, 10), 0), wall(mirror(1, 0.5, 1), 4));

        assertThat(seen(scene, ahead(), DEPTH, Terms.ALL).g).isEqualTo(1.75);
    }

    @Test
    void blackSpecularColourMirrorsNothingHoweverShiny() {
        Scene scene = lit(wall(mirror(1, 0, 1000), 0), wall(glowing(1), 4));

        assertThat(seen(scene, ahead(), DEPTH, Terms.ALL)).hasToString("(1.0,1.0,1.0)");
    }

    @Test
    void aMirrorOfOneColourMirrorsThat() {
        Scene scene = lit(wall(material(grey(0), grey(0), new Colour(0, 0, 0.5), 1), 0), wall(glowing(1), 4));

        assertThat(seen(scene, ahead(), DEPTH, Terms.ALL)).hasToString("(0.0,0.0,0.5)");
    }

    @Test
    void lightingLeavesReflectionsOut() {
        Scene scene = lit(wall(mirror(0.25, 0.5, 1), 0), wall(glowing(1), 4));

        assertThat(seen(scene, ahead(), DEPTH, LIGHTING)).hasToString("(0.25,0.25,0.25)");
    }

    private static Material mirror(double ambient, double specular, double shininess) {
        return material(grey(ambient), grey(0), grey(specular), shininess);
    }
}
