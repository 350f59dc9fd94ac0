package simpleray.pov;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.material;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Bounds;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.AreaLight;
import simpleray.scene.DirectionalLight;
import simpleray.scene.Material;
import simpleray.scene.Plane;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.scene.Scenes;
import simpleray.scene.SimpleCamera;
import simpleray.scene.Sphere;
import simpleray.scene.Triangle;

/** What one is told that POV-Ray shows otherwise. */
class PovWarningsTest {
    private static final int DEPTH = 5;
    private static final String MEAN = "a coloured highlight, or glass that scatters light: POV-Ray takes a mean of the colours. "
        + "With --channel r, g and b it is exact";
    private static final String ACROSS = "in or across other glass, maybe: in POV-Ray a ray then goes from glass to glass, "
        + "here always to or from air";
    private static final String LIGHT_INSIDE = "a light inside: in POV-Ray glass dims only light from outside";

    private static List<String> warnings(Scene scene, int depth, PovChannel shown) {
        return new PovExporter(scene, new SimpleCamera(), depth, shown).warnings();
    }

    private static Material glass(Colour diffuse, Colour transmission) {
        Material glass = material(grey(0), diffuse, grey(0), DEPTH);
        glass.transmission = transmission;
        glass.index = 1.5;
        return glass;
    }

    private static Sphere clear(double x, double y, double z) {
        return new Sphere(glass(grey(0), grey(1)), new Point(x, y, z), 1);
    }

    private static Sphere dim(double radius) {
        Material dim = glass(grey(0), grey(0.5));
        dim.index = 1;
        return new Sphere(dim, new Point(), radius);
    }

    @Test
    void withoutABackgroundGlassIsTransparentForPovRay() {
        Scene scene = Scenes.of(clear(0, 0, -5));
        assertThat(warnings(scene, DEPTH, PovChannel.ALL)).isEmpty();

        scene.settings.background = SceneSettings.TRANSPARENT;

        assertThat(warnings(scene, DEPTH, PovChannel.ALL)).containsExactly("object 1 lets light through: POV-Ray's picture is transparent where "
            + "nothing is behind, and here the surface itself is seen");
    }

    /** Highlights, then diffuse, then transmission; only glass that is seen through and scatters needs the last two grey. */
    @ParameterizedTest
    @CsvSource({"1 1 1, 1 0 0, 0 0 0, true", "1 0 1, 1 1 1, 0 0 0, false", "1 1 0, 0 0 0, 0 0 0, false", "0 1 1, 0 0 0, 0 0 0, false",
        "0 0 0, 1 0 0, 1 1 1, false", "0 0 0, 1 1 1, 1 1 0, false", "0 0 0, 0 0 0, 1 1 0, true", "0 0 0, 1 1 1, 1 1 1, true"})
    void aMeanOfColoursIsToldOf(String specular, String diffuse, String transmission, boolean exact) {
        Material material = material(grey(0), colour(diffuse), colour(specular), DEPTH);
        material.transmission = colour(transmission);
        Scene scene = Scenes.of(new Sphere(material, new Point(), 1));

        assertThat(warnings(scene, DEPTH, PovChannel.ALL)).isEqualTo(exact ? List.of() : List.of("object 1 has " + MEAN));
        assertThat(warnings(scene, DEPTH, PovChannel.R)).isEmpty();
    }

    @Test
    void glassThatNoRayIsFollowedThroughIsNoneForTheEye() {
        Scene scene = Scenes.of(new Sphere(glass(new Colour(1, 0, 0), grey(1)), new Point(), 1));

        assertThat(warnings(scene, 1, PovChannel.ALL)).containsExactly("object 1 has " + MEAN);
        assertThat(warnings(scene, 0, PovChannel.ALL)).isEmpty();
    }

    @Test
    void ofManyObjectsEightAreNamed() {
        Sphere[] many = new Sphere[9];
        for (int i = 0; i < many.length; i++) {
            many[i] = new Sphere(material(grey(0), grey(0), new Colour(1, 0, 0), DEPTH), new Point(), 1);
        }
        assertThat(warnings(Scenes.of(many), DEPTH, PovChannel.ALL))
            .containsExactly("objects 1, 2, 3, 4, 5, 6, 7, 8 and 1 more have " + MEAN);
        many[0].surfaceMaterial.specular = grey(1);
        assertThat(warnings(Scenes.of(many), DEPTH, PovChannel.ALL)).containsExactly("objects 2, 3, 4, 5, 6, 7, 8, 9 have " + MEAN);
    }

    /** The first is about the origin, and all have a radius of 1. */
    @ParameterizedTest
    @CsvSource({"1.5, 0, 0, true", "2, 0, 0, true", "-2, 0, 0, true", "0, 2, 0, true", "0, -2, 0, true", "0, 0, 2, true", "0, 0, -2, true",
        "2.5, 0, 0, false", "-2.5, 0, 0, false", "0, 2.5, 0, false", "0, -2.5, 0, false", "0, 0, 2.5, false", "0, 0, -2.5, false"})
    void glassWhoseBoxesMeetIsToldOf(double x, double y, double z, boolean meet) {
        Scene scene = Scenes.of(clear(0, 0, 0), new Sphere(), clear(x, y, z));

        assertThat(warnings(scene, DEPTH, PovChannel.ALL)).isEqualTo(meet ? List.of("objects 1, 3 lie " + ACROSS) : List.of());
    }

    @Test
    void anEndlessGlassMeetsAllOther() {
        Scene scene = Scenes.of(clear(0, 0, 0), new Plane(glass(grey(0), grey(1)), new Vector(0, 1, 0), -50), clear(9, 0, 0));

        assertThat(warnings(scene, DEPTH, PovChannel.ALL)).containsExactly("objects 1, 2, 3 lie " + ACROSS);
    }

    @Test
    void aPointLightInGlassThatDimsIsToldOf() {
        Scene inside = Scenes.of(dim(1));
        Scenes.light(inside, new DirectionalLight(), Scenes.pointLight(0.5, 0.5, -0.5));
        Scene outside = Scenes.of(dim(1));
        Scenes.light(outside, new DirectionalLight(), Scenes.pointLight(0, 1.5, 0));
        Scene clear = Scenes.of(clear(0, 0, 0));
        Scenes.light(clear, Scenes.pointLight(0, 0, 0));
        Scene reachingIn = Scenes.of(dim(1));
        Scenes.light(reachingIn, new AreaLight(new Point(0.5, 1.5, 0), new Vector(0, -1, 0), new Vector(0.1, 0, 0.1), 2));
        Scene beside = Scenes.of(dim(1));
        Scenes.light(beside, new AreaLight(new Point(0.5, 2.5, 0), new Vector(0, -1, 0), new Vector(0.1, 0, 0.1), 2));
        assertThat(warnings(reachingIn, DEPTH, PovChannel.ALL)).containsExactly("object 1 may hold " + LIGHT_INSIDE);
        assertThat(warnings(beside, DEPTH, PovChannel.ALL)).isEmpty();

        assertThat(warnings(inside, DEPTH, PovChannel.ALL)).containsExactly("object 1 may hold " + LIGHT_INSIDE);
        assertThat(warnings(outside, DEPTH, PovChannel.ALL)).isEmpty();
        assertThat(warnings(clear, DEPTH, PovChannel.ALL)).as("it dims nothing").isEmpty();
    }

    @Test
    void openGlassHoldsNoLight() {
        Scene scene = Scenes.of(new Triangle(dim(1).surfaceMaterial, new Point(), new Point(1, 0, 0), new Point(0, 1, 0)));
        Scenes.light(scene, Scenes.pointLight(0, 0, 0));

        assertThat(warnings(scene, DEPTH, PovChannel.ALL)).isEmpty();
    }

    @Test
    void depthsThatDifferAreToldOfForEachThatIsLess() {
        Scene scene = Scenes.of(mirror(2), mirror(7), mirror(3), mirror(2), mirror(9));

        assertThat(warnings(scene, DEPTH, PovChannel.ALL)).containsExactly(
            "objects 1, 4 grant 2 reflections by shininess, and other materials 5: POV-Ray has one depth for all. With --depth 2 both "
                + "make the same picture",
            "object 3 grants 3 reflections by shininess, and other materials 5: POV-Ray has one depth for all. With --depth 2 both "
                + "make the same picture");
        assertThat(warnings(scene, 2, PovChannel.ALL)).isEmpty();
    }

    @Test
    void asManyReflectionsAsPovRayFollowsAreNoMatter() {
        assertThat(warnings(Scenes.of(mirror(900)), 255, PovChannel.ALL)).isEmpty();
        assertThat(warnings(Scenes.of(mirror(900)), 256, PovChannel.ALL))
            .containsExactly("POV-Ray follows 255 reflections at most, and here are 256");
    }

    @Test
    void aSphereHasTheBoxByWhichGlassMeets() {
        assertThat(clear(1, 2, 3).bounds()).isEqualTo(new Bounds(0, 1, 2, 2, 3, 4));
    }

    private static Sphere mirror(double shininess) {
        return new Sphere(material(grey(0), grey(0), grey(1), shininess), new Point(), 1);
    }

    private static Colour colour(String text) {
        String[] parts = text.split(" ");
        return new Colour(Double.parseDouble(parts[0]), Double.parseDouble(parts[1]), Double.parseDouble(parts[2]));
    }
}
