package simpleray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The yardstick of the golden images itself: of 1000 pixels two may differ. */
class PictureComparisonTest {
    private static final int WIDTH = 50;
    private static final int HEIGHT = 20;
    private static final int GREY = 0x808080;

    @TempDir
    Path folder;

    @Test
    void aLevelMoreOrLessEverywhereIsClose() {
        assertThat(PictureComparison.of(grey(), changed(1000, 0x010000)).isClose()).isTrue();
        assertThat(PictureComparison.of(grey(), changed(1000, -0x000001)).isClose()).isTrue();
    }

    @Test
    void twoLevelsOfAnyColourInThreePixelsAreNot() {
        assertThat(PictureComparison.of(grey(), changed(3, 0x020000)).isClose()).isFalse();
        assertThat(PictureComparison.of(grey(), changed(3, 0x000200)).isClose()).isFalse();
        assertThat(PictureComparison.of(grey(), changed(3, -0x000002)).isClose()).isFalse();
    }

    @Test
    void twoPixelsMayBeWhateverTheyAre() {
        assertThat(PictureComparison.of(grey(), changed(2, 0x7F7F7F)).isClose()).isTrue();
    }

    @Test
    void aFailureLeavesTheActualPictureAndTheDifferences() throws IOException {
        byte[] png = png(changed(3, 0x000003));

        assertThatThrownBy(() -> PictureComparison.assertClose("pond", grey(), png, folder.resolve("failures")))
            .isInstanceOf(AssertionError.class)
            .hasMessage("pond differs from what it should be in 3 of 1000 pixels by more than 1 level: see %s and %s",
                folder.resolve("failures/pond-actual.png"), folder.resolve("failures/pond-difference.png"));

        assertThat(folder.resolve("failures/pond-actual.png")).hasBinaryContent(png);
        BufferedImage difference = ImageIO.read(folder.resolve("failures/pond-difference.png").toFile());
        assertThat(difference.getRGB(2, 0) & 0xFFFFFF).isEqualTo(16 * 3);
        assertThat(difference.getRGB(3, 0) & 0xFFFFFF).isZero();
    }

    @Test
    void aPictureOfAnotherSizeFails() {
        BufferedImage small = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);

        assertThatThrownBy(() -> PictureComparison.assertClose("pond", small, png(grey()), folder)).isInstanceOf(AssertionError.class)
            .hasMessage("pond is 50x20 and should be 1x1: see %s", folder.resolve("pond-actual.png"));
    }

    @Test
    void aSuccessLeavesNothing() {
        Path failures = folder.resolve("failures");

        assertThatCode(() -> PictureComparison.assertClose("pond", grey(), png(grey()), failures)).doesNotThrowAnyException();

        assertThat(failures).doesNotExist();
    }

    private static BufferedImage grey() {
        return changed(WIDTH * HEIGHT, 0);
    }

    /** {@return a grey picture, to whose first pixels something was added} */
    private static BufferedImage changed(int pixels, int by) {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            image.setRGB(i % WIDTH, i / WIDTH, i < pixels ? GREY + by : GREY);
        }
        return image;
    }

    private static byte[] png(BufferedImage image) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(image, "png", bytes);
        return bytes.toByteArray();
    }
}
