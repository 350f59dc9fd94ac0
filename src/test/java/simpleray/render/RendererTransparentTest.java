package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.text.SceneText.reader;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.image.Picture;
import simpleray.rays.StoryText;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;

/** Pictures of scenes without a background. */
class RendererTransparentTest {
    /** In the plane z = 0, of which a pixel sees x and y from -2 to 2: its part with x + y < 0.4, and only its ambient light. */
    private static final String CORNER = "1  2 -9 -2 0  9.4 -9 0  -9 9.4 0  0.5 0.25 0  0 0 0  0 0 0  1  1 1 1  0\n";
    /** A mirroring ball before nothing, and one that is cut off by the picture's edge. */
    private static final String BALLS = "2  0 0 0 0 1  0.2 0.2 0.2  0.5 0.1 0.3  0.4 0.4 0.4  9  0 1.7 1 -1 0.8  0.3 0 0  0 0 0.9  0 0 0  1\n"
        + "1 1 1  1  0 1 1 1 3 4 5\n";
    private static final String NONE = "background none";
    private static final int SIDE = 23;

    private static Scene scene(String text) throws IOException {
        Scene scene = new Scene();
        scene.read(reader(text));
        return scene;
    }

    private static Renderer renderer(String text, int side, Stage stage, int samples, Accel accel, int threads) throws IOException {
        return new Renderer(scene(text), new SimpleCamera(side, side), new RenderSettings(stage, 10, samples, accel, threads, null));
    }

    private static Picture render(String text, int side, int samples) throws IOException {
        return renderer(text, side, Stage.FINAL, samples, Accel.AUTO, 1).render(RenderListener.NONE);
    }

    private static void assertSame(Picture one, Picture other) {
        for (int y = 0; y < one.height(); y++) {
            assertThat(one.row(y)).as("row " + y).isEqualTo(other.row(y));
        }
    }

    @Test
    void alphaIsTheShareOfSamplesThatHitAndTheColourTheirMean() throws IOException {
        Picture picture = render(CORNER + NONE, 1, 2);         // the points (±1, ±1); (1, 1) misses

        assertThat(picture.hasAlpha()).isTrue();
        assertThat(picture.row(0)).containsExactly(0.5, 0.25, 0, 0.75);
        assertThat(picture.levels(0)).containsExactly(128, 64, 0, 191);   // 255 times 0.75 is 191.25
    }

    @Test
    void aTransparentPointCountsWithinAnyGrid() throws IOException {
        // of 3 x 3 points at -4/3, 0 and 4/3 six have a sum below 0.4
        assertThat(render(CORNER + NONE, 1, 3).row(0)[3]).isEqualTo(6 / 9.0);
        // of 4 x 4 points at ±0.5 and ±1.5 ten have a sum of 0 or less
        assertThat(render(CORNER + NONE, 1, 4).row(0)).containsExactly(0.5, 0.25, 0, 10 / 16.0);
        assertThat(render(CORNER + NONE, 1, 1).row(0)).containsExactly(0.5, 0.25, 0, 1);
    }

    @ParameterizedTest
    @EnumSource
    void whereNothingIsHitAllIsNothingInEachStage(Stage stage) throws IOException {
        for (int samples : new int[] {1, 2, RenderSettings.ADAPTIVE}) {
            assertThat(renderer("0  1 1 1  0\n" + NONE, 1, stage, samples, Accel.AUTO, 1).render(RenderListener.NONE).row(0))
                .containsExactly(0, 0, 0, 0);
        }
    }

    @ParameterizedTest
    @EnumSource
    void eachStageHasTheAlphaOfTheFinalOne(Stage stage) throws IOException {
        Picture last = render(BALLS + NONE, SIDE, 3);
        Picture picture = renderer(BALLS + NONE, SIDE, stage, 3, Accel.AUTO, 1).render(RenderListener.NONE);

        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                assertThat(picture.row(y)[4 * x + 3]).isEqualTo(last.row(y)[4 * x + 3]);
            }
        }
    }

    /** Put on black, it is the picture of a scene whose background is black: mirrors and glass see black, too. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void onBlackItIsThePictureOfABlackBackground(int samples) throws IOException {
        Picture transparent = render(BALLS + NONE, SIDE, samples);
        Picture black = render(BALLS, SIDE, samples);

        assertThat(black.hasAlpha()).isFalse();
        int partly = 0;
        for (int y = 0; y < SIDE; y++) {
            double[] over = transparent.over(y, 0);
            for (int i = 0; i < over.length; i++) {
                assertThat(over[i]).isEqualTo(black.row(y)[i], within(1e-15));
                double alpha = transparent.row(y)[i / 3 * 4 + 3];
                partly += alpha > 0 && alpha < 1 ? 1 : 0;
            }
        }
        assertThat(partly > 0).isEqualTo(samples > 1);
    }

    @ParameterizedTest
    @CsvSource({"1, AUTO", "2, AUTO", "1, NONE", "2, NONE"})
    void allWaysOfRenderingAgree(int threads, Accel accel) throws IOException {
        for (Stage stage : new Stage[] {Stage.FINAL, Stage.NORMALS, Stage.BOUNCES}) {
            for (int samples : new int[] {1, 2, RenderSettings.ADAPTIVE}) {
                Picture expected = renderer(BALLS + NONE, SIDE, stage, samples, Accel.AUTO, 1).render(RenderListener.NONE);

                assertSame(renderer(BALLS + NONE, SIDE, stage, samples, accel, threads).render(RenderListener.NONE), expected);
                assertSame(renderer(BALLS + NONE, SIDE, stage, samples, accel, threads).renderPasses(Told.NONE, null, false), expected);
            }
        }
    }

    /** Receives the passes, and does nothing. */
    private static final class Told implements PassListener {
        static final Told NONE = new Told();

        @Override
        public void runFinished(PixelRun run, double[] light) {
            assertThat(light).hasSize(4 * run.count());
        }

        @Override
        public void coarseFinished() {
        }

        @Override
        public void rowFailed(int y, Throwable fault) {
            throw new AssertionError(fault);
        }

        @Override
        public void rowFinished(int y) {
        }
    }

    @Test
    void aRegionIsThatPartOfThePicture() throws IOException {
        Picture whole = render(BALLS + NONE, SIDE, 2);
        Picture part = new Renderer(scene(BALLS + NONE), new SimpleCamera(SIDE, SIDE),
            new RenderSettings(Stage.FINAL, 10, 2, Accel.AUTO, 1, new Region(9, 4, 11, 13))).render(RenderListener.NONE);

        assertThat(part.channels()).isEqualTo(4);
        for (int y = 0; y < 13; y++) {
            assertThat(part.row(y)).containsExactly(Arrays.copyOfRange(whole.row(4 + y), 4 * 9, 4 * 20));
        }
    }

    /** A black triangle differs from nothing by its alpha alone. */
    @Test
    void adaptiveSamplingSeesAnEdgeOfAlpha() throws IOException {
        String black = "1  2 -9 -2 0  9.4 -9 0  -9 9.4 0  0 0 0  0 0 0  0 0 0  1  1 1 1  0\n" + NONE;
        Picture adaptive = render(black, 8, RenderSettings.ADAPTIVE);
        Picture full = render(black, 8, 4);

        assertSame(adaptive, full);
        assertThat(full.row(2)).contains(0, 1).containsAnyOf(0.375, 0.625, 0.5625);
    }

    @Test
    void theWindowAndLibrariesGetAnImageWithAlpha() throws IOException {
        BufferedImage image = render(CORNER + NONE, 1, 2).toBufferedImage();

        assertThat(image.getType()).isEqualTo(BufferedImage.TYPE_INT_ARGB);
        assertThat(image.getRGB(0, 0)).isEqualTo(0xBF804000);
        assertThat(Picture.of(image).levels(0)).containsExactly(128, 64, 0, 191);
        assertThat(render(CORNER, 1, 2).toBufferedImage().getType()).isEqualTo(BufferedImage.TYPE_INT_RGB);
    }

    @Test
    void theTermsAddUpToLightingAndKeepTheirAlpha() throws IOException {
        List<Picture> terms = List.of(one(Stage.AMBIENT), one(Stage.DIFFUSE), one(Stage.SPECULAR));

        assertSame(Picture.sum(terms), one(Stage.LIGHTING));
    }

    private static Picture one(Stage stage) throws IOException {
        return renderer(BALLS + NONE, SIDE, stage, 1, Accel.AUTO, 1).render(RenderListener.NONE);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3, RenderSettings.ADAPTIVE})
    void theStoryOfAPixelHasItsColourAndAlpha(int samples) throws IOException {
        Renderer renderer = renderer(BALLS + NONE, SIDE, Stage.FINAL, samples, Accel.AUTO, 1);
        Picture picture = renderer.render(RenderListener.NONE);
        Explainer explainer = renderer.explainer();

        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                PixelStory story = explainer.story(x, y);
                double[] row = picture.row(y);
                assertThat(new double[] {story.colour().r, story.colour().g, story.colour().b, story.alpha().getAsDouble()})
                    .containsExactly(row[4 * x], row[4 * x + 1], row[4 * x + 2], row[4 * x + 3]);
            }
        }
    }

    @Test
    void theStoryNamesWhatIsTransparent() throws IOException {
        assertThat(story(CORNER + NONE, 2)).startsWith("pixel 0,0 of 1x1, stage final: 0.5 0.25 0, levels 128 64 0, alpha 0.75, level 191\n"
                + "  the mean of 3 of 4 samples, each brought into 0 to 1\n")
            .contains("  sample at 0.75,0.25: hits nothing: transparent\n").doesNotContain("background");
        assertThat(story("0  1 1 1  0\n" + NONE, 1)).isEqualTo("pixel 0,0 of 1x1, stage final: 0 0 0, levels 0 0 0, transparent\n"
            + "  Nothing is hit.\n    ray from (0 0 2) along (0 0 -1), depth 10\n");
    }

    private static String story(String text, int samples) throws IOException {
        PixelStory pixel = renderer(text, 1, Stage.FINAL, samples, Accel.AUTO, 1).explainer().story(0, 0);
        return StoryText.of(pixel, scene(text), new SimpleCamera(1, 1));
    }
}
