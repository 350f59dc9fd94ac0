package simpleray.rays;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.render.Explainer;
import simpleray.render.PixelStory;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.scene.Material;
import simpleray.scene.Plane;
import simpleray.scene.RayTree;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;

/** The text of a story, with numbers that can be checked by hand. */
class StoryTextTest {
    @Test
    void aMirrorsStoryContainsThatOfTheMirrorRay() throws IOException {
        // the eye at (0, 0, 2) looks at a mirror 4 away, which shows the wall behind the eye; a lamp is right above the eye, a ball between
        String text = text("""
            3
            1 0 0 1 -2   0.5 0.5 0.5  0.25 0.5 1  0.5 0.25 0.5  2
            1 0 0 1 4    1 0.5 0.25   0 0 0  0 0 0  1
            0 0 9 9 1    0 0 0  0 0 0  0 0 0  1
            0.5 0.5 0.5
            2
            0  1 1 1  0 0 2
            1  1 1 1  0 0 1
            """, Stage.FINAL, 1);

        assertThat(text).isEqualTo("""
            pixel 0,0 of 1x1, stage final: 1.25 1.06 1.81, levels 255 255 255
              Blue back wall (line 2), lit by light 1; turned away from light 2; it mirrors the orange wall behind the eye (line 3).
                1.25 1.06 1.81 = ambient 0.25 0.25 0.25 + light 1 0.75 0.75 1.5 + mirror 0.25 0.0625 0.0625
                ambient = Ka · GA = (0.5 0.5 0.5) · (0.5 0.5 0.5) = 0.25 0.25 0.25
                light 1 (line 7) reaches the point: 0.75 0.75 1.5
                  diffuse = Kd · LC · (N·L) = (0.25 0.5 1) · (1 1 1) · 1 = 0.25 0.5 1
                  specular = Ks · LC · (N·H)^shininess = (0.5 0.25 0.5) · (1 1 1) · 1^2 = 0.5 0.25 0.5
                  L = (0 0 1), N·L = 1, distance 4
                  H = (0 0 1), N·H = 1
                light 2 (line 8) is behind the surface
                  L = (0 0 -1), N·L = -1
                ray from (0 0 2) along (0 0 -1), depth 10: t = 4, P = (0 0 -2), N = (0 0 1), going in
                Mirror ray: orange wall behind the eye (line 3), lit by light 1; light 2 is hidden by the blue back wall (line 2).
                  mirror = Ks · C = (0.5 0.25 0.5) · (0.5 0.25 0.125) = 0.25 0.0625 0.0625
                  0.5 0.25 0.125 = ambient 0.5 0.25 0.125
                  ambient = Ka · GA = (1 0.5 0.25) · (0.5 0.5 0.5) = 0.5 0.25 0.125
                  light 1 (line 7) reaches the point: 0 0 0
                    diffuse = 0, for Kd is black
                    specular = 0, for Ks is black
                    L = (0 0 -1), N·L = 1, distance 2
                  light 2 (line 8) is hidden by the blue back wall (line 2)
                    L = (0 0 -1), N·L = 1
                  ray from (0 0 -2) along (0 0 1), depth 1: t = 6, P = (0 0 4), N = (0 0 -1), going out
            """);
    }

    @Test
    void aMirrorsOwnShareIsToldByItsName() throws IOException {
        String text = text("""
            2
            1 0 0 1 -2   0 0 0  0 0 0  0.5 0.5 0.5  1  mirror 0.25 0.5 0
            1 0 0 1 4    1 0.5 0.25   0 0 0  0 0 0  1
            0.5 0.5 0.5  0
            """, Stage.FINAL, 1);

        assertThat(text).contains("\n      mirror = mirror · C = (0.25 0.5 0) · (0.5 0.25 0.125) = 0.125 0.125 0\n");
    }

    @Test
    void aLampInASurfaceReachesThePointInStoryAndView() throws IOException {
        String scene = "2\n1 0 0 1 -2  0 0 0  1 1 1  0 0 0  1\n1 0 0 1 4  0 0 0  0 0 0  0 0 0  1\n0 0 0  1  0 1 1 1  0 0 4";

        assertThat(text(scene, Stage.FINAL, 1)).startsWith("pixel 0,0 of 1x1, stage final: 1 1 1,").contains("\n    light 1 (line 4) reaches the point: 1 1 1\n");
        assertThat(text(scene, Stage.SHADOWS, 1)).startsWith("pixel 0,0 of 1x1, stage shadows: 1 1 1,");
    }

    @Test
    void glassAppearsAsDimmingALightAndByItsRefractedRay() throws IOException {
        String text = text("""
            2
            1 0 0 1 -2   0 0 0  1 1 1  0 0 0  1
            2 -9 -9 0  9 -9 0  0 9 0   0 0 0  0 0 0  0 0 0  1  transmit 1 0.5 1 1
            0 0 0  1  0 1 1 1  0 0 2
            background 0.125 0.25 0.5
            """, Stage.FINAL, 1);

        assertThat(text).contains("; through it one sees the white back wall (line 2).\n", """
                Refracted ray: white back wall (line 2), lit by light 1 through the pink transparent triangle (line 3).
                  refracted = Kt · C = (1 0.5 1) · (1 0.5 1) = 1 0.25 1
            """.indent(0), """
                  light 1 (line 4) reaches the point through the pink transparent triangle (line 3): 1 0.5 1
                    arriving = LC · Kt = (1 1 1) · (1 0.5 1) = 1 0.5 1
                    diffuse = Kd · arriving · (N·L) = (1 1 1) · (1 0.5 1) · 1 = 1 0.5 1
            """.indent(0));
    }

    @Test
    void samplesAreListedOneAfterAnother() throws IOException {
        assertThat(text("0  1 1 1  0\nbackground 0.125 0.25 2", Stage.FINAL, 2)).isEqualTo("""
            pixel 0,0 of 1x1, stage final: 0.125 0.25 1, levels 32 64 255
              the mean of 4 samples, each brought into 0 to 1
              sample at 0.25,0.25: 0.125 0.25 1
                Nothing is hit: background 0.125 0.25 2
                  ray from (0 0 2) along (-0.408 0.408 -0.816), depth 10
              sample at 0.75,0.25: 0.125 0.25 1
                Nothing is hit: background 0.125 0.25 2
                  ray from (0 0 2) along (0.408 0.408 -0.816), depth 10
              sample at 0.25,0.75: 0.125 0.25 1
                Nothing is hit: background 0.125 0.25 2
                  ray from (0 0 2) along (-0.408 -0.408 -0.816), depth 10
              sample at 0.75,0.75: 0.125 0.25 1
                Nothing is hit: background 0.125 0.25 2
                  ray from (0 0 2) along (0.408 -0.408 -0.816), depth 10
            """);
    }

    @Test
    void aViewHasTheStoryOfTheFinalStage() throws IOException {
        assertThat(text("1 1 0 0 1 -2  1 1 1  0 0 0  0 0 0  1  0.25 0.5 1  0", Stage.DEPTH, 1)).startsWith("""
            pixel 0,0 of 1x1, stage depth: 0.2 0.2 0.2, levels 51 51 51
              the view depth shows no light; this is the story of stage final
              White back wall (line 1).
                0.25 0.5 1 = ambient 0.25 0.5 1
            """);
    }

    @Test
    void aStageWithoutShadowsMentionsNone() throws IOException {
        assertThat(text("1 1 0 0 1 -2  1 1 1  0 0 0  0 0 0  1  0 0 0  1  0 1 1 1 0 0 0", Stage.LIGHTING, 1))
            .contains("\n    light 1 (line 1) shines, for this stage has no shadows: 0 0 0\n");
    }

    /** Of the light's points (-3,0,2), (3,0,2), (-3,0,-6), (3,0,-6) a ball blocks the second; the wall at z = -2 is turned away from the last two. */
    private static final String AREA = "2\n1 0 0 1 -2  0 0 0  1 1 1  0 0 0  1\n0 1.5 0 0 0.5  0 0 0  0 0 0  0 0 0  1%s\n0 0 0\n1\n"
        + "2  1 0.5 0.25  -6 0 6  12 0 0  0 0 -16  2\n";

    @Test
    void anAreaLightHasOneStory() throws IOException {
        assertThat(text(AREA.formatted(""), Stage.FINAL, 1)).contains(", lit by 1 of the 4 points of light 1.\n", """
                light 1 (line 6): of its 4 points 1 seen from here, 1 hidden, 2 behind the surface: 0.2 0.1 0.05
                  between: the black sphere (line 3)
                  diffuse = sum of Kd · LC/4 · (N·L) over the points = (1 1 1) · (0.25 0.125 0.0625) · … = 0.2 0.1 0.05
                  specular = 0, for Ks is black
            """.indent(0));
        assertThat(text(AREA.formatted("  transmit 0.5 1 1 1"), Stage.FINAL, 1))
            .contains("1 seen from here, 1 dimmed, 2 behind");
        assertThat(text(AREA.formatted(""), Stage.LIGHTING, 1)).doesNotContain("between: ")
            .contains("of its 4 points 2 shining, for this stage has no shadows, 2 behind the surface: ");
    }

    @Test
    void itsPointsHaveStoriesOnRequest() throws IOException {
        Scene read = new Scene();
        read.read(reader(AREA.formatted("")));
        SimpleCamera camera = new SimpleCamera(1, 1);
        Explainer explainer = new Renderer(read, camera, new RenderSettings(Stage.FINAL, 10, 1, 1)).explainer();
        String text = StoryText.of(explainer.story(0, 0, true), read, camera);
        assertThat(text).contains("""
                  specular = 0, for Ks is black
                  point 1 reaches the point: 0.2 0.1 0.05
                    diffuse = Kd · LC · (N·L) = (1 1 1) · (0.25 0.125 0.0625) · 0.8 = 0.2 0.1 0.05
                    specular = 0, for Ks is black
                    L = (-0.6 0 0.8), N·L = 0.8, distance 5
                  point 2 is hidden by the black sphere (line 3)
            """.indent(0)).contains("point 4 is behind the surface").doesNotContain("point 5 ");
    }

    @Test
    void symbolsAndNumbersAreExplainedWithAllDigitsAndAngles() throws IOException {
        Scene read = new Scene();
        read.read(reader("1\n1 0 0 1 -2  0 0 0  1 1 1  0 0 0  1\n0 0 0\n1\n0  1 0.12345 0  4 0 2\n"));
        SimpleCamera camera = new SimpleCamera(1, 1);
        List<StoryText.Part> parts = StoryText.lines(new Renderer(read, camera, new RenderSettings()).explainer().story(0, 0), read, camera)
            .stream().filter(line -> line.text().startsWith("diffuse")).findFirst().orElseThrow().parts();

        assertThat(parts.stream().map(StoryText.Part::text)).contains("Kd", "LC", "(N·L)", "(1 0.123 0)", "0.707", "0.707 0.0873 0");
        assertThat(parts).filteredOn(part -> part.text().equals("(1 0.123 0)")).extracting(StoryText.Part::tip)
            .containsExactly("LC, the light's colour: 1.0 0.12345 0.0");
        assertThat(parts).filteredOn(part -> part.text().equals("0.707")).allSatisfy(part -> assertThat(part.tip())
            .startsWith("N·L, the cosine of the angle between the normal N and the way L to the light: 0.7071067811865").endsWith(", 45.0°"));
        assertThat(parts.get(parts.size() - 1).swatch().r).isGreaterThan(0.7071);
    }

    @Test
    void lightsAreGroupedByWhatHidesThem() throws IOException {
        String lamp = "0  1 1 1  ";
        String text = text("3\n1 0 0 1 -2  0 0 0  1 1 1  0 0 0  1\n0 1 0 0 0.5  0 0 0  0.9 0 0  0 0 0  1\n1 1 0 0 -50  0 0 0  1 1 1  0 0 0  1\n"
            + "0 0 0\n6\n" + lamp + "2 0 2\n" + lamp + "2.1 0 2\n" + lamp + "0 0 2\n" + lamp + "0 1 2\n" + lamp + "0 0 -9\n"
            + lamp + "0 2 -1.9999999\n", Stage.FINAL, 1);

        assertThat(text).contains("White back wall (line 2), lit by lights 3 and 4; grazed by light 6; turned away from light 5; "
            + "lights 1 and 2 are hidden by the red sphere (line 3).\n");
    }

    @Test
    void whatIsNotToldOfAnAreaLightIsSaid() {
        Colour black = new Colour();
        RayTree.Area area = new RayTree.Area(new RayTree.Thing(1, "area light", 0), black, 4, true, 0, 0, 4, null, black, black, null);
        RayTree.Hit hit = new RayTree.Hit(new RayTree.Thing(1, "plane", 0), 1, new Point(), new Vector(0, 0, 1), true, new Material(),
            black, black, List.of(area), black, black, null, null);
        RayTree story = new RayTree(new Ray(), 4, true, hit, black);
        PixelStory.Sample sample = new PixelStory.Sample(0, 0, false, true, black, story);
        Scene plane = new Scene();
        plane.setNumberObjects(1);
        plane.setObject(0, new Plane());
        PixelStory pixel = new PixelStory(0, 0, 1, 1, Stage.FINAL, false, List.of(sample), black, OptionalDouble.empty());
        assertThat(StoryText.of(pixel, plane, new SimpleCamera())).contains("""
                light 1: of its 4 points 0 seen from here, 4 hidden: 0 0 0
                  too much is between to be told
            """.indent(0)).contains("\n      its points are not told any more: the pixel has too many of them\n");
    }

    @Test
    void aStoryThatIsCutSaysSoAndNumbersHaveThreeDigits() {
        Colour odd = new Colour(1.0 / 3, 1e-7, 12345678901.0);
        RayTree story = new RayTree(new Ray(), 4, false, null, odd);

        PixelStory pixel = new PixelStory(1, 2, 3, 4, Stage.FINAL, false,
            List.of(new PixelStory.Sample(1.5, Double.POSITIVE_INFINITY, false, true, odd, story)), odd, OptionalDouble.empty());
        assertThat(StoryText.of(pixel, new Scene(), new SimpleCamera())).isEqualTo("""
            pixel 1,2 of 3x4, stage final: 0.333 1E-7 1.23E+10, levels 85 0 255
              Not told any more, for the pixel has too many rays: 0.333 1E-7 1.23E+10
                ray from (0 0 0) along (0 0 -1), depth 4
            """);
    }

    private static String text(String scene, Stage stage, int samples) throws IOException {
        Scene read = new Scene();
        read.read(reader(scene));
        SimpleCamera camera = new SimpleCamera(1, 1);
        return StoryText.of(new Renderer(read, camera, new RenderSettings(stage, 10, samples, 1)).explainer().story(0, 0), read, camera);
    }
}
