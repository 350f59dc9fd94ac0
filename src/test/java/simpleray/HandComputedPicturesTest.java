package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.render.RenderSettings;
import simpleray.render.Stage;
import simpleray.scene.SimpleCamera;

/**
 * Pictures whose every pixel follows from arithmetic, through the whole path from a scene's text to a decoded PNG file. The eye is at
 * (0, 0, 2) and looks through the window [-2,2] × [-2,2] on z = 0.
 */
class HandComputedPicturesTest {
    private static final int SIDE = 41;
    private static final int BLACK = 0x000000;

    @Test
    void underAmbientLightAloneAWallHasOneColour() throws IOException {
        // 0.5, 0.25 and 1 times 0.8 = 0.4, 0.2 and 0.8; times 255 = 102, 51, 204
        BufferedImage picture = picture("1   1 0 0 1 -2   0.5 0.25 1   1 1 1   1 1 1   5   0.8 0.8 0.8   0", Stage.FINAL);

        assertEachPixel(picture, (x, y) -> rgb(102, 51, 204));
    }

    @Test
    void aSphereIsADiscAndAllAroundItIsBlack() throws IOException {
        // from the eye, 2 away, a sphere of radius 0.5 covers an angle of asin(0.25); Ka GA = 1 0.6 0.2
        BufferedImage picture = picture("1   0 0 0 0 0.5   1 0.6 0.2   0 0 0   0 0 0   1   1 1 1   0", Stage.FINAL);
        double edge = 2 * Math.tan(Math.asin(0.25));

        assertEachPixel(picture, (x, y) -> Math.hypot(x, y) < edge ? rgb(255, 153, 51) : BLACK);
    }

    @Test
    void inAWidePictureASphereIsStillADisc() throws IOException {
        // 40 × 20 pixels: the window is [-4,4] × [-2,2], and a pixel 0.2 wide and high
        byte[] png = Rendered.png(Rendered.scene("1   0 0 0 0 0.5   1 1 1   0 0 0   0 0 0   1   1 1 1   0"), new SimpleCamera(40, 20),
            new RenderSettings());
        int[] levels = Rendered.levels(png);
        double edge = 2 * Math.tan(Math.asin(0.25));

        for (int y = 0; y < 20; y++) {
            for (int x = 0; x < 40; x++) {
                boolean hit = Math.hypot(-4 + (x + 0.5) * 0.2, 2 - (y + 0.5) * 0.2) < edge;
                assertThat(levels[3 * (40 * y + x)]).as("%d,%d", x, y).isEqualTo(hit ? 255 : 0);
            }
        }
    }

    @Test
    void aWallWithTheLightInTheEyeIsLitByTheCosine() throws IOException {
        // N·L is the cosine of the angle at the eye, 2/|(x,y,2)|; so is N·H; Kd = 0.5, Ks = 0.25 with exponent 3
        BufferedImage picture = picture(
            "1   1 0 0 1 -2   0 0 0   0.5 0.5 0.5   0.25 0.25 0.25   3   1 1 1   1   0 1 1 1 0 0 2", Stage.FINAL);

        assertEachPixel(picture, (x, y) -> {
            double cosine = 2 / Math.sqrt(x * x + y * y + 4);
            return grey(0.5 * cosine + 0.25 * cosine * cosine * cosine);
        });
        assertThat(picture.getRGB(SIDE / 2, SIDE / 2) & 0xFFFFFF).as("255 (0.5 + 0.25) = 191.25").isEqualTo(rgb(191, 191, 191));
    }

    @ParameterizedTest
    @CsvSource({"1, 10, 0x663300", "1, 1, 0x663300", "1, 0, 0x000000", "0.9, 10, 0x000000"})
    void aMirrorShowsTheWallBehindTheEyeIfShininessAndDepthGrantAReflection(double shininess, int depth, int expected) throws IOException {
        // Ks = 0.4 of the wall's 1, 0.5, 0 = 0.4, 0.2, 0; times 255 = 102, 51, 0
        String scene = "2   1 0 0 1 -2   0 0 0   0 0 0   0.4 0.4 0.4   " + shininess
            + "   1 0 0 1 10   1 0.5 0   0 0 0   0 0 0   1   1 1 1   0";

        BufferedImage picture = Rendered.decoded(Rendered.png(Rendered.scene(scene), new SimpleCamera(SIDE, SIDE),
            new RenderSettings(Stage.FINAL, depth, 1, 2)));

        assertEachPixel(picture, (x, y) -> expected);
    }

    @Test
    void lightIsClampedOnceWhenThePixelIsStored() throws IOException {
        // the mirrored wall is 1.5 bright: half of it is 0.75, not half of 1
        BufferedImage picture = picture(
            "2   1 0 0 1 -2   0 0 0   0 0 0   0.5 0.5 0.5   1   1 0 0 1 10   3 3 3   0 0 0   0 0 0   1   0.5 0.5 0.5   0", Stage.FINAL);

        assertEachPixel(picture, (x, y) -> grey(0.75));
    }

    @Test
    void twoLightsAddUpAndWhatIsTooBrightIsWhite() throws IOException {
        // both shine straight at the wall: 0.25 + 0.5 = 0.75 red, 0.75 + 0.5 = 1.25 green, 0.5 + 0 blue
        BufferedImage picture = picture(
            "1   1 0 0 1 -2   0 0 0   1 1 1   0 0 0   1   1 1 1   2   1 0.25 0.75 0.5 0 0 -1   1 0.5 0.5 0 0 0 -3", Stage.FINAL);

        assertEachPixel(picture, (x, y) -> rgb(191, 255, 128));
    }

    @ParameterizedTest
    @CsvSource({"LIGHTING, 0.6", "DIFFUSE, 0.6", "FINAL, 0", "ORIGINAL, 0", "AMBIENT, 0", "SPECULAR, 0"})
    void aPlaneFarAwayShadowsADirectionalLightInTheFinalStageAlone(Stage stage, double expected) throws IOException {
        // the light travels (4,0,-3)/5, and so N·L = 3/5; the plane x = -50 stands in its way
        BufferedImage picture = picture(
            "2   1 0 0 1 -2   0 0 0   1 1 1   0 0 0   1   1 1 0 0 -50   0 0 0   0 0 0   0 0 0   1   1 1 1   1   1 1 1 1 4 0 -3", stage);

        assertEachPixel(picture, (x, y) -> grey(expected));
    }

    /** The colour expected where the ray passes through (x, y, 0). */
    private interface Expected {
        int at(double x, double y);
    }

    private static void assertEachPixel(BufferedImage picture, Expected expected) {
        for (int row = 0; row < SIDE; row++) {
            for (int column = 0; column < SIDE; column++) {
                int colour = expected.at(-2 + (column + 0.5) * 4 / SIDE, 2 - (row + 0.5) * 4 / SIDE);
                assertThat(picture.getRGB(column, row) & 0xFFFFFF).as("pixel %d,%d", column, row).isEqualTo(colour);
            }
        }
    }

    private static BufferedImage picture(String scene, Stage stage) throws IOException {
        return Rendered.decoded(Rendered.png(Rendered.scene(scene), new SimpleCamera(SIDE, SIDE), Rendered.stage(stage)));
    }

    private static int rgb(int red, int green, int blue) {
        return red << 16 | green << 8 | blue;
    }

    /** {@return the grey that is stored for this light, which is at most 1} */
    private static int grey(double light) {
        int level = (int) Math.floor(255 * light + 0.5);
        return rgb(level, level, level);
    }
}
