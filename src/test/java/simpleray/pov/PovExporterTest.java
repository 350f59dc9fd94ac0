package simpleray.pov;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.material;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import simpleray.math.Bounds;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.DirectionalLight;
import simpleray.scene.Material;
import simpleray.scene.ParallelCamera;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.Scenes;
import simpleray.scene.SimpleCamera;
import simpleray.scene.Sphere;
import simpleray.scene.StandIn;
import simpleray.scene.Triangle;
import simpleray.text.SceneWriter;

/** What is written for POV-Ray, word for word. */
class PovExporterTest {
    private static final int DEPTH = 5;

    private static String text(Scene scene, PovChannel shown) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        SceneWriter os = new SceneWriter(bytes);
        new PovExporter(scene, new SimpleCamera(400, 200), DEPTH, shown).write(os);
        os.flush();
        return bytes.toString(StandardCharsets.UTF_8);
    }

    private static PovExporter pov(Scene scene, PovChannel shown) {
        return new PovExporter(scene, new SimpleCamera(), DEPTH, shown);
    }

    private static Material glass(double ks, double kt, double index) {
        Material glass = material(grey(0), grey(0), grey(ks), DEPTH);
        glass.transmission = grey(kt);
        glass.index = index;
        return glass;
    }

    @Test
    void sceneOfOneChannelIsGrey() throws IOException {
        Scene scene = Scenes.of(
            new Sphere(material(new Colour(0.5, 0, 0), new Colour(0.25, 1, 1), new Colour(0.75, 1, 1), 8), new Point(1, 2, 3), 0.5),
            new Plane(material(new Colour(1, 0, 0), new Colour(0.5, 0, 0), grey(0), 2), new Vector(0, 2, 0), -4));
        scene.ambient = new Colour(0.5, 0, 0);
        scene.settings.background = new Colour(0.125, 0, 0);
        PointLight lamp = new PointLight(new Point(0, 4, 0));
        lamp.intensity = new Colour(0.875, 0, 0);
        Scenes.light(scene, lamp, new DirectionalLight(new Vector(0, -2, 0)));

        assertThat(text(scene, PovChannel.R)).isEqualTo("""
            // Written by SimpleRay for POV-Ray 3.7 (channels shown: r). Render it with:
            // povray +IFILE.pov +OFILE.png +W400 +H200 -A -D +FN8 File_Gamma=1.0
            #version 3.7;
            global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 ambient_light rgb 1 }
            background { rgb <0.125,0.125,0.125> }
            camera { perspective location <0.0,0.0,2.0> direction <0.0,0.0,-2.0> right <8.0,0.0,0.0> up <0.0,4.0,0.0> }
            light_source { <0.0,4.0,0.0>, rgb <0.875,0.875,0.875> }
            light_source { <0.0,1000000.0,0.0>, rgb <1.0,1.0,1.0> parallel point_at <0,0,0> }
            #declare M1 = material { texture { pigment { rgb <1.0,1.0,1.0> } finish { ambient rgb <0.25,0.25,0.25> diffuse 0.25 \
            specular 0.75 roughness 0.125 reflection { rgb <0.75,0.75,0.75> } } } }
            sphere { <1.0,2.0,3.0>, 0.5 material { M1 } }
            #declare M2 = material { texture { pigment { rgb <1.0,1.0,1.0> } finish { ambient rgb <0.5,0.5,0.5> diffuse 0.5 } } }
            plane { <0.0,1.0,0.0>, -2.0 material { M2 } }
            """);
        assertThat(pov(scene, PovChannel.R).warnings()).isEmpty();
    }

    @Test
    void glassCastsTheShadowOfATwin() throws IOException {
        Scene scene = Scenes.of(new Sphere(glass(0.25, 0.5, 1.5), new Point(), 1));
        assertThat(text(scene, PovChannel.G)).endsWith("""
            #declare M1 = material { texture { pigment { rgb <1.0,1.0,1.0> filter 0.5 } finish { ambient rgb <0.0,0.0,0.0> diffuse 0.0 \
            specular 0.25 roughness 0.2 reflection { rgb <0.25,0.25,0.25> } } } \
            interior_texture { pigment { rgb <1.3333333333333333,1.3333333333333333,1.3333333333333333> filter 0.5 } \
            finish { ambient rgb <0.0,0.0,0.0> diffuse 0.0 specular 0.25 roughness 0.2 reflection { rgb <0.25,0.25,0.25> } } } \
            interior { ior 1.5 fade_distance 1e-6 fade_power 2 fade_color rgb <0.75,0.75,0.75> } }
            #declare M2 = material { texture { pigment { rgbt <0,0,0,1> } } interior_texture { pigment { rgb <0.5,0.5,0.5> filter 1 } } }
            sphere { <0.0,0.0,0.0>, 1.0 material { M2 } no_image no_reflection }
            sphere { <0.0,0.0,0.0>, 1.0 material { M1 } no_shadow }
            """);
    }

    @Test
    void perfectGlassCastsNoShadow() throws IOException {
        assertThat(text(Scenes.of(new Sphere(glass(0, 1, 1), new Point(), 1)), PovChannel.B)).endsWith("""
            #declare M1 = material { texture { pigment { rgb <2.0,2.0,2.0> filter 0.5 } finish { ambient rgb <0.0,0.0,0.0> diffuse 0.0 } } \
            interior { ior 1.0000001 } }
            sphere { <0.0,0.0,0.0>, 1.0 material { M1 } no_shadow }
            """);
    }

    @Test
    void coloursAreKeptWhereTheyAreOne() throws IOException {
        Material matt = material(new Colour(0.25, 0.5, 0.75), new Colour(0.5, 0.25, 0), grey(0), 0);
        Scene scene = Scenes.of(new Sphere(matt, new Point(), 1));
        scene.ambient = new Colour(1, 1, 0);
        assertThat(text(scene, PovChannel.ALL)).contains("pigment { rgb <1.0,0.5,0.0> } finish { ambient rgb <0.25,1.0,0.0> diffuse 0.5 }");
        assertThat(pov(scene, PovChannel.ALL).warnings()).isEmpty();
    }

    @Test
    void perspectiveCameraIsWrittenAsItLooks() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        SceneWriter os = new SceneWriter(bytes);
        PovWriter.camera(os, new PerspectiveCamera(new PerspectiveCamera.Pose(1, 2, 3, 1, 2, -3, 90), 2, 1));
        os.flush();
        String rounded = bytes.toString(StandardCharsets.UTF_8).replaceAll("1\\.9{9}\\d*", "2.0").replaceAll("3\\.9{9}\\d*", "4.0");
        assertThat(rounded).matches(
            "camera \\{ perspective location <1.0,2.0,3.0> direction <0.0,0.0,-1.0> right <4.0,0.0,0.0> up <0.0,2.0,0.0> }\n");
    }

    @Test
    void parallelCameraIsOrthographic() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        SceneWriter os = new SceneWriter(bytes);
        PovWriter.camera(os, new ParallelCamera(new ParallelCamera.View(1, 2, 3, 1, 2, -3, 6), new Vector(1, 0, 0), 2, 1));
        os.flush();
        assertThat(bytes.toString(StandardCharsets.UTF_8)).isEqualTo(
            "camera { orthographic location <1.0,2.0,3.0> direction <0.0,0.0,-1.0> right <0.0,-12.0,0.0> up <6.0,0.0,0.0> }\n");
    }

    @Test
    void oneDepthForAllIsTakenIfThereIsOne() throws IOException {
        Material three = material(grey(0), grey(0), grey(1), 3.5);
        Material none = material(grey(0), grey(0), grey(1), 0.5);
        Scene scene = Scenes.of(new Sphere(three, new Point(), 1), new Sphere(none, new Point(5, 0, 0), 1));
        assertThat(text(scene, PovChannel.R)).contains("max_trace_level 4 ").contains("specular 1.0 roughness 2.0 }");
        assertThat(pov(scene, PovChannel.R).warnings()).isEmpty();
    }

    @Test
    void depthsThatDifferAreToldOf() {
        Scene scene = Scenes.of(new Sphere(material(grey(0), grey(0), grey(1), 3), new Point(), 1),
            new Sphere(material(grey(0), grey(0), grey(1), 4), new Point(5, 0, 0), 1));
        assertThat(pov(scene, PovChannel.R).warnings()).containsExactly("object 1 grants 3 reflections by shininess, "
            + "and other materials 4: POV-Ray has one depth for all. With --depth 3 both make the same picture");
    }

    @Test
    void depthsBeyondPovraysAreToldOf() {
        Scene scene = Scenes.of(new Sphere(material(grey(0), grey(0), grey(1), 900), new Point(), 1));
        assertThat(new PovExporter(scene, new SimpleCamera(), 300, PovChannel.R).warnings())
            .containsExactly("POV-Ray follows 255 reflections at most, and here are 300");
    }

    @Test
    void colouredHighlightsAreToldOfUnlessAChannelIsAlone() {
        Sphere[] many = new Sphere[10];
        for (int i = 0; i < many.length; i++) {
            many[i] = new Sphere(material(grey(0), grey(0), new Colour(1, 0, 0), DEPTH), new Point(), 1);
        }
        Scene scene = Scenes.of(many);
        assertThat(pov(scene, PovChannel.G).warnings()).isEmpty();
        assertThat(pov(scene, PovChannel.ALL).warnings()).singleElement().asString()
            .startsWith("objects 1, 2, 3, 4, 5, 6, 7, 8 and 2 more have a coloured highlight");
    }

    @Test
    void glassInGlassAndLightInGlassAreToldOf() {
        Scene scene = Scenes.of(new Sphere(glass(0, 0.5, 1.5), new Point(), 1), new Sphere(glass(0, 0.5, 1.5), new Point(), 0.5));
        Scenes.light(scene, new PointLight(new Point(0, 0.75, 0)));
        assertThat(pov(scene, PovChannel.R).warnings()).satisfiesExactly(
            line -> assertThat(line).startsWith("object 1 may hold a light inside"),
            line -> assertThat(line).startsWith("objects 1, 2 lie in or across other glass, maybe: "));
    }

    /** Something that POV-Ray has no form of. */
    private static final class Blob extends StandIn {
        private Blob(Material material) {
            super(material);
        }

        @Override
        public Bounds bounds() {
            return Bounds.of(new Point());
        }
    }

    @Test
    void objectWithoutAFormIsNamed() {
        Scene scene = Scenes.of(new Sphere(), new Blob(new Material()));
        assertThatThrownBy(() -> text(scene, PovChannel.R)).isInstanceOf(UnsupportedOperationException.class)
            .hasMessage("object 2: no form for POV-Ray is known of a Blob");
    }

    /** {@return half a square} */
    private static Triangle pane(Material material) {
        return new Triangle(material, new Point(), new Point(0, 1, 0), new Point(1, 0, 0));
    }

    @Test
    void panesOfOneGlassAreOneBody() throws IOException {
        Scene scene = Scenes.of(pane(glass(0, 1, 1.5)), pane(glass(0, 1, 1.5)), pane(glass(0, 1, 1)));
        assertThat(text(scene, PovChannel.R)).endsWith("""
            triangle { <0.0,0.0,0.0>, <1.0,0.0,0.0>, <0.0,1.0,0.0> material { M2 } no_shadow }
            union {
            triangle { <0.0,0.0,0.0>, <1.0,0.0,0.0>, <0.0,1.0,0.0> }
            triangle { <0.0,0.0,0.0>, <1.0,0.0,0.0>, <0.0,1.0,0.0> }
            material { M1 } no_shadow }
            """);
    }

    @Test
    void openGlassThatBendsIsToldOf() {
        assertThat(pov(Scenes.of(new Blob(glass(0, 1, 1))), PovChannel.R).warnings()).isEmpty();
        assertThat(pov(Scenes.of(new Blob(glass(0, 1, 1.5))), PovChannel.R).warnings()).singleElement().asString()
            .startsWith("object 1 is open glass, maybe: ");
    }
}
