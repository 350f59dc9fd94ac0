package simpleray.pov;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.material;
import static simpleray.text.SceneText.written;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.scene.Material;
import simpleray.scene.Scene;
import simpleray.scene.Scenes;
import simpleray.scene.SimpleCamera;
import simpleray.scene.Sphere;

/** Materials as POV-Ray has them: the numbers follow from its rules, by which a clear pigment scatters half. */
class PovMaterialTest {
    private static final int DEPTH = 5;

    private static String text(Material material, int depth) {
        Scene scene = Scenes.of(new Sphere(material, new Point(), 1));
        scene.ambient = grey(1);
        return written(new PovExporter(scene, new SimpleCamera(), depth, PovChannel.ALL)::write);
    }

    private static Material glass(Colour ambient, Colour diffuse, Colour transmission, double index) {
        Material glass = material(ambient, diffuse, grey(0), DEPTH);
        glass.transmission = transmission;
        glass.index = index;
        return glass;
    }

    @Test
    void whatClearGlassDimsOfItsOwnLightIsMadeUpFor() {
        assertThat(text(glass(grey(0.25), grey(0.375), grey(0.5), 1), DEPTH))
            .contains("{ pigment { rgb <1.0,1.0,1.0> filter 0.5 } finish { ambient rgb <0.5,0.5,0.5> diffuse 0.75 } }");
        assertThat(text(glass(new Colour(0.25, 0.125, 0.5), grey(0.375), grey(0.25), 1), DEPTH))
            .contains("{ pigment { rgb <0.5,0.5,0.5> filter 0.5 } finish { ambient rgb <1.0,0.5,2.0> diffuse 1.5 } }");
    }

    @Test
    void glassThatNoRayIsFollowedThroughIsOpaqueToTheEye() {
        assertThat(text(glass(grey(0), grey(0.375), grey(0.5), 1.5), 0))
            .contains("#declare M1 = material { texture { pigment { rgb <1.0,1.0,1.0> } finish { ambient rgb <0.0,0.0,0.0> diffuse 0.375 } } }");
    }

    /** An ambient light divided by a colour of 0 is none: the colour is next to nothing then. */
    @Test
    void whatOnlyShinesOfItselfKeepsItsColour() {
        assertThat(text(material(new Colour(0.25, 0.5, 0), new Colour(0.5, 0, 0), grey(0), 0), DEPTH))
            .contains("{ pigment { rgb <1.0,1.0E-6,0.0> } finish { ambient rgb <0.25,500000.0,0.0> diffuse 0.5 } }");
        assertThat(text(material(new Colour(0, 0, 0.5), new Colour(0, 0.5, 0), grey(0), 0), DEPTH))
            .contains("{ pigment { rgb <0.0,1.0,1.0E-6> } finish { ambient rgb <0.0,0.0,500000.0> diffuse 0.5 } }");
        assertThat(text(material(new Colour(0.25, 0.5, 0), grey(0), grey(0), 0), DEPTH))
            .contains("{ pigment { rgb <1.0,1.0,1.0> } finish { ambient rgb <0.25,0.5,0.0> diffuse 0.0 } }");
    }

    @ParameterizedTest
    @CsvSource({"0.25, 0.5, 0.75, 0.5", "0.5, 0.5, 0.125, 0.375", "0.125, 0.5, 0.5, 0.375", "0.1, 0.1, 0.1, 0.1"})
    void aHighlightOfManyColoursHasTheirMean(double r, double g, double b, double mean) {
        assertThat(text(material(grey(0), grey(0), new Colour(r, g, b), 4), DEPTH))
            .contains(" specular " + mean + " roughness 0.25 reflection { rgb <" + r + "," + g + "," + b + "> } }");
    }

    @Test
    void aMirrorHasItsOwnShareAndAHighlightTheMeanOfKs() {
        Material varnish = material(grey(0), grey(0), grey(0.5), 4);
        varnish.mirror = new Colour(0.25, 0, 1);
        Material mirror = material(grey(0), grey(0), grey(0), 4);
        mirror.mirror = grey(0.75);
        Material shiny = material(grey(0), grey(0), grey(0.5), 4);
        shiny.mirror = grey(0);

        assertThat(text(varnish, DEPTH)).contains(" diffuse 0.0 specular 0.5 roughness 0.25 reflection { rgb <0.25,0.0,1.0> } }",
            "max_trace_level 5");
        assertThat(text(mirror, DEPTH)).contains(" diffuse 0.0 reflection { rgb <0.75,0.75,0.75> } }", "max_trace_level 5");
        assertThat(text(mirror, 0)).doesNotContain("reflection");
        assertThat(text(shiny, DEPTH)).contains(" diffuse 0.0 specular 0.5 roughness 0.25 }", "max_trace_level 1 ");
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 1, false", "0.5, 1, 1, true", "1, 0.5, 1, true", "1, 1, 0.5, true", "0, 0, 0, false"})
    void whatDimsLightHasATwinThatNobodySees(double r, double g, double b, boolean dims) {
        assertThat(text(glass(grey(0), grey(0), new Colour(r, g, b), 1), DEPTH).contains(" no_image no_reflection }")).isEqualTo(dims);
    }

    /** What is mirrored inside is all of it in POV-Ray, and Ks + Kt here; an index of 1 mirrors nothing. */
    @ParameterizedTest
    @CsvSource({"1, 1, 1, 1.5, false", "0.5, 1, 1, 1.5, true", "1, 0.5, 1, 1.5, true", "1, 1, 0.5, 1.5, true", "0.5, 1, 1, 1, false"})
    void totalReflectionIsDimmedWhereItIsNotAll(double r, double g, double b, double index, boolean dimmed) {
        String text = text(glass(grey(0), grey(0), new Colour(r, g, b), index), DEPTH);

        assertThat(text.contains("fade_color rgb <" + r + "," + g + "," + b + ">")).isEqualTo(dimmed);
        assertThat(text.contains("fade_power")).isEqualTo(dimmed);
    }

    @Test
    void noMoreThanPovRaysDepthIsAskedFor() {
        Material mirror = material(grey(0), grey(0), grey(1), 900);

        assertThat(text(mirror, 300)).contains(" max_trace_level 256 ");
        assertThat(text(mirror, 7)).contains(" max_trace_level 8 ");
        assertThat(text(new Material(), 7)).contains(" max_trace_level 1 ");
    }
}
