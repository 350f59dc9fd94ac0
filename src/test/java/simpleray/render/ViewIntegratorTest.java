package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simpleray.RandomScenes;
import simpleray.image.Picture;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;

/** The stages that show something other than light, with numbers that follow from their definitions. */
class ViewIntegratorTest {
    private static final String MATT = "  1 1 1  1 1 1  0 0 0  1\n";
    private static final String LIGHT = "0 0 0  1  0  1 1 1  0 0 2\n";

    @TempDir
    Path folder;

    @Test
    void aNormalBecomesAColourAndFacesTheRay() throws IOException {
        assertThat(centre("1  1 0 0 1 -2" + MATT + LIGHT, Stage.NORMALS, 10)).containsExactly(0.5, 0.5, 1);
        assertThat(centre("1  1 0 0 -1 2" + MATT + LIGHT, Stage.NORMALS, 10)).containsExactly(0.5, 0.5, 1);
    }

    @Test
    void depthIsOneOverOnePlusTheDistance() throws IOException {
        assertThat(centre("1  1 0 0 1 -2" + MATT + LIGHT, Stage.DEPTH, 10)).containsExactly(0.2, 0.2, 0.2);
    }

    @Test
    void anObjectsColourDependsOnItsNumberAlone() throws IOException {
        double[] first = centre("1  1 0 0 1 -2" + MATT + LIGHT, Stage.OBJECTS, 10);
        double[] second = centre("2  0 0 0 9 1" + MATT + "1 0 0 1 -2" + MATT + LIGHT, Stage.OBJECTS, 10);

        assertThat(first).containsExactly(0.2 + 0.8 * 0.8191725133961645, 0.2 + 0.8 * 0.6710436067037893, 0.2 + 0.8 * 0.5497004779019703);
        assertThat(centre("2  1 0 0 1 -2" + MATT + "0 0 0 9 1" + MATT + LIGHT, Stage.OBJECTS, 10)).isEqualTo(first);
        assertThat(second).isNotEqualTo(first);
    }

    @Test
    void theFirstHundredObjectsCanBeToldApartInAnEightBitPicture() throws IOException {
        StringBuilder balls = new StringBuilder("100\n");
        for (int i = 0; i < 100; i++) {
            balls.append("0 ").append(-1.8 + 0.4 * (i % 10)).append(' ').append(-1.8 + 0.4 * (i / 10)).append(" 0 0.15").append(MATT);
        }
        Picture picture = picture(scene(balls + LIGHT), Stage.OBJECTS, 100, Accel.AUTO, 2, 1);
        Set<Integer> colours = new HashSet<>();
        for (int y = 0; y < 100; y++) {
            byte[] levels = picture.levels(y);
            for (int x = 0; x < 100; x++) {
                colours.add((levels[3 * x] & 0xFF) << 16 | (levels[3 * x + 1] & 0xFF) << 8 | levels[3 * x + 2] & 0xFF);
            }
        }
        assertThat(colours).hasSize(101).contains(0);
    }

    @Test
    void bouncesAreTheShareOfTheDepthThatIsUsed() throws IOException {
        String mirrors = "2  1 0 0 1 -2  0 0 0  0 0 0  1 1 1  3   1 0 0 1 4  0 0 0  0 0 0  1 1 1  9\n" + LIGHT;

        assertThat(centre("1  1 0 0 1 -2" + MATT + LIGHT, Stage.BOUNCES, 10)).as("nothing mirrors").containsExactly(0, 0, 0);
        assertThat(centre(mirrors, Stage.BOUNCES, 2)).as("the depth ends it").containsExactly(1, 1, 1);
        assertThat(centre(mirrors, Stage.BOUNCES, 4)).as("shininess 3 ends it").containsExactly(0.75, 0.75, 0.75);
        assertThat(centre(mirrors, Stage.BOUNCES, 0)).as("no depth").containsExactly(0, 0, 0);
        // in, and out to where nothing is
        assertThat(centre("1  0 0 0 0 1  0 0 0  0 0 0  0 0 0  9  transmit 1 1 1 1.5   1 1 1  0", Stage.BOUNCES, 4))
            .as("a ball of glass").containsExactly(0.5, 0.5, 0.5);
    }

    @Test
    void shadowsAreTheShareOfLightsThatReachesTheSurface() throws IOException {
        String wall = "1  1 0 0 1 -2" + MATT;
        String four = "0 0 0  4  0 1 1 1  0 0 2   0 0.5 0 0  0 0 5   0 1 1 1  0 0 -9   0 1 1 1  9 0 2\n";

        assertThat(centre(wall + four, Stage.SHADOWS, 10)).as("one is behind the wall").containsExactly(0.75, 0.75, 0.75);
        assertThat(centre("2  1 0 0 1 -2" + MATT + "0 0 0 3 0.5" + MATT + four, Stage.SHADOWS, 10)).as("one is blocked by a ball")
            .containsExactly(0.5, 0.5, 0.5);
        assertThat(centre("2  1 0 0 1 -2" + MATT + "0 0 0 3 0.5  1 1 1  1 1 1  0 0 0  1  transmit 1 0.5 0 1\n" + four, Stage.SHADOWS, 10))
            .as("of one the ball lets some through").containsExactly(0.75, 0.625, 0.5);
        String area = "0 0 0  2  2  9 9 9  -6 0 6  12 0 0  0 0 -16  2  0  1 1 1  0 0 2";
        assertThat(centre("2  1 0 0 1 -2" + MATT + "0 1.5 0 0 0.5" + MATT + area, Stage.SHADOWS, 10))
            .as("of an area light one point in four, and a lamp").containsExactly(0.625, 0.625, 0.625);
        assertThat(centre(wall + "0 0 0  0", Stage.SHADOWS, 10)).as("no light").containsExactly(0, 0, 0);
    }

    @ParameterizedTest
    @EnumSource(names = {"NORMALS", "DEPTH", "OBJECTS", "BOUNCES", "SHADOWS"})
    void aViewOfARayThatMissesIsBlackOnAnyBackground(Stage view) throws IOException {
        assertThat(centre("0  1 1 1  0\nbackground 1 1 1", view, 10)).containsExactly(0, 0, 0);
    }

    @ParameterizedTest
    @EnumSource(names = {"NORMALS", "DEPTH", "OBJECTS", "BOUNCES", "SHADOWS"})
    void aViewDoesNotDependOnThreadsOrAcceleration(Stage view) {
        RandomScenes scenes = new RandomScenes(1980, folder);
        for (int i = 0; i < 60; i++) {
            Scene scene = scenes.next(i % 10 == 0 ? 60 : 15);
            Picture expected = picture(scene, view, 7, Accel.NONE, 1, 1);
            Picture actual = picture(scene, view, 7, Accel.AUTO, 3, 1);
            for (int y = 0; y < 7; y++) {
                assertThat(actual.row(y)).as("scene " + i + ", row " + y).containsExactly(expected.row(y));
            }
        }
    }

    @Test
    void aViewsRaysAreCounted() throws IOException {
        Renderer renderer = new Renderer(scene("1  1 0 0 1 -2" + MATT + LIGHT), new SimpleCamera(4, 3),
            new RenderSettings(Stage.SHADOWS, 1, 1, 1));
        renderer.render(RenderListener.NONE);

        assertThat(renderer.stats().rays().primary).isEqualTo(12);
        assertThat(renderer.stats().rays().shadow).isEqualTo(12);
    }

    private static double[] centre(String text, Stage view, int depth) throws IOException {
        return new Renderer(scene(text), new SimpleCamera(1, 1), new RenderSettings(view, depth, 1, 1)).render(RenderListener.NONE).row(0);
    }

    private static Picture picture(Scene scene, Stage view, int side, Accel accel, int threads, int samples) {
        return new Renderer(scene, new SimpleCamera(side, side), new RenderSettings(view, 3, samples, accel, threads, null))
            .render(RenderListener.NONE);
    }

    private static Scene scene(String text) throws IOException {
        Scene scene = new Scene();
        scene.read(reader(text));
        return scene;
    }
}
