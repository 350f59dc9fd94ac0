package simpleray.render;

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
import simpleray.scene.Material;
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
            pixel 0,0 of 1x1, stage final: 1.25 1.0625 1.8125, levels 255 255 255
              sample at 0.5,0.5: 1.25 1.0625 1.8125
                ray from (0 0 2) along (0 0 -1), depth 10: 1.25 1.0625 1.8125
                  hits object 1 (plane, line 2) at distance 4
                    point (0 0 -2), normal (0 0 1), going in
                  ambient: 0.25 0.25 0.25
                    Ka 0.5 0.5 0.5, GA 0.5 0.5 0.5
                  light 1 (point light, line 7): 0.75 0.75 1.5
                    reaches the point
                    LC 1 1 1, distance 4
                    L (0 0 1), N.L 1
                    H (0 0 1), N.H 1
                    diffuse 0.25 0.5 1, Kd 0.25 0.5 1
                    specular 0.5 0.25 0.5, Ks 0.5 0.25 0.5, shininess 2
                  light 2 (directional light, line 8): 0 0 0
                    the surface is turned away from it
                    LC 1 1 1
                    L (0 0 -1), N.L -1
                    H (0 0 0), N.H 0
                    diffuse 0 0 0, Kd 0.25 0.5 1
                    specular 0 0 0, Ks 0.5 0.25 0.5, shininess 2
                  diffuse of all lights: 0.25 0.5 1
                  specular of all lights: 0.5 0.25 0.5
                  mirror ray: 0.25 0.0625 0.0625, Ks 0.5 0.25 0.5
                    ray from (0 0 -2) along (0 0 1), depth 1: 0.5 0.25 0.125
                      hits object 2 (plane, line 3) at distance 6
                        point (0 0 4), normal (0 0 -1), going out
                      ambient: 0.5 0.25 0.125
                        Ka 1 0.5 0.25, GA 0.5 0.5 0.5
                      light 1 (point light, line 7): 0 0 0
                        reaches the point
                        LC 1 1 1, distance 2
                        L (0 0 -1), N.L 1
                        H (0 0 -1), N.H 1
                        diffuse 0 0 0, Kd 0 0 0
                        specular 0 0 0, Ks 0 0 0, shininess 1
                      light 2 (directional light, line 8): 0 0 0
                        blocked by object 1 (plane, line 2)
                        LC 1 1 1
                        L (0 0 -1), N.L 1
                        H (0 0 -1), N.H 1
                        diffuse 0 0 0, Kd 0 0 0
                        specular 0 0 0, Ks 0 0 0, shininess 1
                      diffuse of all lights: 0 0 0
                      specular of all lights: 0 0 0
                      sum: 0.5 0.25 0.125
                  sum: 1.25 1.0625 1.8125
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

        assertThat(text).contains("\n      mirror ray: 0.125 0.125 0, mirror 0.25 0.5 0\n");
    }

    @Test
    void aLampInASurfaceReachesThePointInStoryAndView() throws IOException {
        String scene = "2\n1 0 0 1 -2  0 0 0  1 1 1  0 0 0  1\n1 0 0 1 4  0 0 0  0 0 0  0 0 0  1\n0 0 0  1  0 1 1 1  0 0 4";

        assertThat(text(scene, Stage.FINAL, 1)).startsWith("pixel 0,0 of 1x1, stage final: 1 1 1,").contains("\n        reaches the point\n");
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

        assertThat(text).contains("\n      refracted ray: 1 0.25 1, Kt 1 0.5 1\n"
            + "        ray from (0 0 0) along (0 0 -1), depth 0: 1 0.5 1\n",
            "reaches the point, dimmed by object 2 (triangle, line 3) with Kt 1 0.5 1 to 1 0.5 1\n");
    }

    @Test
    void samplesAreListedOneAfterAnother() throws IOException {
        assertThat(text("0  1 1 1  0\nbackground 0.125 0.25 2", Stage.FINAL, 2)).isEqualTo("""
            pixel 0,0 of 1x1, stage final: 0.125 0.25 1, levels 32 64 255
              the mean of 4 samples, each brought into 0 to 1
              sample at 0.25,0.25: 0.125 0.25 1
                ray from (0 0 2) along (-0.408248 0.408248 -0.816497), depth 10: 0.125 0.25 2
                  hits nothing: background 0.125 0.25 2
              sample at 0.75,0.25: 0.125 0.25 1
                ray from (0 0 2) along (0.408248 0.408248 -0.816497), depth 10: 0.125 0.25 2
                  hits nothing: background 0.125 0.25 2
              sample at 0.25,0.75: 0.125 0.25 1
                ray from (0 0 2) along (-0.408248 -0.408248 -0.816497), depth 10: 0.125 0.25 2
                  hits nothing: background 0.125 0.25 2
              sample at 0.75,0.75: 0.125 0.25 1
                ray from (0 0 2) along (0.408248 -0.408248 -0.816497), depth 10: 0.125 0.25 2
                  hits nothing: background 0.125 0.25 2
            """);
    }

    @Test
    void aViewHasTheStoryOfTheFinalStage() throws IOException {
        assertThat(text("1 1 0 0 1 -2  1 1 1  0 0 0  0 0 0  1  0.25 0.5 1  0", Stage.DEPTH, 1)).startsWith("""
            pixel 0,0 of 1x1, stage depth: 0.2 0.2 0.2, levels 51 51 51
              sample at 0.5,0.5: 0.2 0.2 0.2
                the view depth shows no light; this is the story of stage final
                ray from (0 0 2) along (0 0 -1), depth 10: 0.25 0.5 1
            """);
    }

    @Test
    void aStageWithoutShadowsMentionsNone() throws IOException {
        assertThat(text("1 1 0 0 1 -2  1 1 1  0 0 0  0 0 0  1  0 0 0  1  0 1 1 1 0 0 0", Stage.LIGHTING, 1))
            .contains("\n        shines, for this stage has no shadows\n");
    }

    /** Of the light's points (-3,0,2), (3,0,2), (-3,0,-6), (3,0,-6) a ball blocks the second; the wall at z = -2 is turned away from the last two. */
    private static final String AREA = "2\n1 0 0 1 -2  0 0 0  1 1 1  0 0 0  1\n0 1.5 0 0 0.5  0 0 0  0 0 0  0 0 0  1%s\n0 0 0\n1\n"
        + "2  1 0.5 0.25  -6 0 6  12 0 0  0 0 -16  2\n";

    @Test
    void anAreaLightHasOneStory() throws IOException {
        assertThat(text(AREA.formatted(""), Stage.FINAL, 1)).contains("""

                  light 1 (area light, line 6): 0.2 0.1 0.05
                    of its 4 points: 1 reach the point, 1 blocked, 2 behind the surface
                    between: object 2 (sphere, line 3)
                    LC 1 0.5 0.25, of each point 0.25 0.125 0.0625
                    diffuse 0.2 0.1 0.05, Kd 1 1 1
                    specular 0 0 0, Ks 0 0 0, shininess 1
                  diffuse of all lights: 0.2 0.1 0.05
            """.indent(0));
        assertThat(text(AREA.formatted("  transmit 0.5 1 1 1"), Stage.FINAL, 1)).contains("1 reach the point, 1 reach it dimmed, 2 behind");
        assertThat(text(AREA.formatted(""), Stage.LIGHTING, 1)).doesNotContain("between: ")
            .contains("of its 4 points: 2 shine, for this stage has no shadows, 2 behind the surface\n");
    }

    @Test
    void itsPointsHaveStoriesOnRequest() throws IOException {
        Scene read = new Scene();
        read.read(reader(AREA.formatted("")));
        Explainer explainer = new Renderer(read, new SimpleCamera(1, 1), new RenderSettings(Stage.FINAL, 10, 1, 1)).explainer();
        String text = StoryText.of(explainer.story(0, 0, true));
        assertThat(text).contains("""
                    specular 0 0 0, Ks 0 0 0, shininess 1
                    point 1: 0.2 0.1 0.05
                      reaches the point
                      LC 0.25 0.125 0.0625, distance 5
                      L (-0.6 0 0.8), N.L 0.8
            """.indent(0)).contains("""
                    point 2: 0 0 0
                      blocked by object 2 (sphere, line 3)
            """.indent(0)).contains("point 4: ").doesNotContain("point 5: ");
    }

    @Test
    void whatIsNotToldOfAnAreaLightIsSaid() {
        Colour black = new Colour();
        RayTree.Area area = new RayTree.Area(new RayTree.Thing(1, "area light", 0), black, 4, true, 0, 0, 4, null, black, black, null);
        RayTree.Hit hit = new RayTree.Hit(new RayTree.Thing(1, "plane", 0), 1, new Point(), new Vector(0, 0, 1), true, new Material(),
            black, black, List.of(area), black, black, null, null);
        RayTree story = new RayTree(new Ray(), 4, true, hit, black);
        PixelStory.Sample sample = new PixelStory.Sample(0, 0, false, true, black, story);
        assertThat(StoryText.of(new PixelStory(0, 0, 1, 1, Stage.FINAL, false, List.of(sample), black, OptionalDouble.empty()))).contains("""
                    of its 4 points: 0 reach the point, 4 blocked
                    too much is between to be told
            """.indent(0)).contains("\n        its points are not told any more: the pixel has too many of them\n");
    }

    @Test
    void aStoryThatIsCutSaysSoAndNumbersHaveSixDigits() {
        Colour odd = new Colour(1.0 / 3, 1e-7, 12345678901.0);
        RayTree story = new RayTree(new Ray(), 4, false, null, odd);

        assertThat(StoryText.of(new PixelStory(1, 2, 3, 4, Stage.FINAL, false,
            List.of(new PixelStory.Sample(1.5, Double.POSITIVE_INFINITY, false, true, odd, story)), odd, OptionalDouble.empty()))).isEqualTo("""
            pixel 1,2 of 3x4, stage final: 0.333333 1E-7 1.23457E+10, levels 85 0 255
              sample at 1.5,Infinity: 0.333333 1E-7 1.23457E+10
                ray from (0 0 0) along (0 0 -1), depth 4: 0.333333 1E-7 1.23457E+10
                  not told any more: the pixel has too many rays
            """);
    }

    private static String text(String scene, Stage stage, int samples) throws IOException {
        Scene read = new Scene();
        read.read(reader(scene));
        return StoryText.of(new Renderer(read, new SimpleCamera(1, 1), new RenderSettings(stage, 10, samples, 1)).explainer().story(0, 0));
    }
}
