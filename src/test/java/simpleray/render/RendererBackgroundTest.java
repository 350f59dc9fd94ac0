package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simpleray.image.Picture;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;

/** The colour of rays that hit nothing. */
class RendererBackgroundTest {
    private static final String SKY = "background 0.5 0.25 1";
    private static final double[] SKY_SEEN = {0.5, 0.25, 1};
    private static final double[] BLACK = {0, 0, 0};

    @ParameterizedTest
    @EnumSource(names = {"ORIGINAL", "LIGHTING", "FINAL", "AMBIENT"})
    void aPrimaryRayThatMissesShowsTheBackground(Stage stage) throws IOException {
        assertThat(pixel("0  1 1 1  0\n" + SKY, stage)).containsExactly(SKY_SEEN);
    }

    @ParameterizedTest
    @EnumSource(names = {"DIFFUSE", "SPECULAR"})
    void stagesOfALightsTermDoNotShowTheBackground(Stage stage) throws IOException {
        assertThat(pixel("0  1 1 1  0\n" + SKY, stage)).containsExactly(BLACK);
    }

    @ParameterizedTest
    @EnumSource
    void withoutABackgroundARayThatMissesIsBlack(Stage stage) throws IOException {
        assertThat(pixel("0  1 1 1  0", stage)).containsExactly(BLACK);
    }

    @Test
    void aMirrorShowsTheBackgroundTimesKs() throws IOException {
        String mirror = "1  1 0 0 1 -2  0 0 0  0 0 0  0.5 1 0.25  1  0 0 0  0\n" + SKY;

        assertThat(pixel(mirror, Stage.FINAL)).containsExactly(0.25, 0.25, 0.25);
        assertThat(pixel(mirror, Stage.LIGHTING)).containsExactly(BLACK);
    }

    @Test
    void glassShowsTheBackgroundTimesKt() throws IOException {
        String glass = "1  1 0 0 1 -2  0 0 0  0 0 0  0 0 0  1 transmit 0.5 1 0.25 1.5  0 0 0  0\n" + SKY;

        assertThat(pixel(glass, Stage.FINAL)).containsExactly(0.25, 0.25, 0.25);
        assertThat(pixel(glass, Stage.LIGHTING)).containsExactly(BLACK);
    }

    @Test
    void theBackgroundIsNoLight() throws IOException {
        assertThat(pixel("1  1 0 0 1 -2  1 1 1  1 1 1  0 0 0  1  0 0 0  0\n" + SKY, Stage.FINAL)).containsExactly(BLACK);
    }

    @Test
    void theBackgroundMayBeBrighterThanOne() throws IOException {
        assertThat(pixel("0  1 1 1  0\nbackground 2 0 1.5", Stage.FINAL)).containsExactly(2, 0, 1.5);
    }

    @Test
    void theThreeTermsAddUpToLightingOverTheBackground() throws IOException {
        String ball = "1  0 0 0 0 1  0.2 0.2 0.2  0.5 0.1 0.3  0.4 0.4 0.4  9  1 1 1  1  0 1 1 1 3 4 5\n" + SKY;
        Picture sum = Picture.sum(List.of(picture(ball, Stage.AMBIENT, 9), picture(ball, Stage.DIFFUSE, 9),
            picture(ball, Stage.SPECULAR, 9)));
        Picture lighting = picture(ball, Stage.LIGHTING, 9);

        for (int y = 0; y < 9; y++) {
            assertThat(sum.row(y)).containsExactly(lighting.row(y));
        }
        assertThat(lighting.row(0)).startsWith(SKY_SEEN);
    }

    private static double[] pixel(String text, Stage stage) throws IOException {
        return picture(text, stage, 1).row(0);
    }

    private static Picture picture(String text, Stage stage, int side) throws IOException {
        Scene scene = new Scene();
        scene.read(reader(text));
        return new Renderer(scene, new SimpleCamera(side, side), new RenderSettings(stage, 10, 1, 1)).render(RenderListener.NONE);
    }
}
