package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import simpleray.ui.picture.RenderJob;

/** The window while the upper half of a picture is finished and of the lower half the last pass is held at a gate. */
class MidRenderTest {
    private static final int SIDE = 240;
    private static final int HALF = SIDE / 2;

    private final TestScenes.Gate gate = new TestScenes.Gate(0, SIDE);
    private OpenWindow window;

    @BeforeEach
    void renderTheUpperHalf() {
        window = new OpenWindow(TestScenes.watched(TestScenes.THESIS, gate), SIDE, SIDE);
        Screen.until("the upper half is finished",
            () -> window.picture().job().snapshot().progress() != null && window.picture().job().snapshot().progress().finished() == HALF);
    }

    @AfterEach
    void close() {
        gate.open();
        window.close();
    }

    @WindowTest
    void finishedRowsAreOnTheScreenAndTheOthersInBlocksOfTwoByTwo() throws IOException {
        BufferedImage expected = TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE);
        for (int y = HALF; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                expected.setRGB(x, y, expected.getRGB(x / 2 * 2, y / 2 * 2));
            }
        }
        window.untilShown("both halves", expected);

        Path captures = Files.createDirectories(Path.of(System.getProperty("simpleray.build"), "captures"));
        Rectangle all = OpenWindow.ask(window.frame::getBounds);
        ImageIO.write(window.screen.capture(all), "png", captures.resolve("mid-render.png").toFile());
    }

    @WindowTest
    void theStatusLineHasRaysDoneTimeGoneTimeLeftAndTheSize() {
        Screen.until("the status line counts the upper half and a quarter of the lower",
            () -> window.status().contains("36,000 of 57,600 rays"));

        assertThat(window.status()).matches("Rendering: 36,000 of 57,600 rays, [\\d.:]+ (s|min), [\\d.:]+ (s|min) left");
        assertThat(window.label("size")).isEqualTo("240 × 240, final");
    }

    @WindowTest
    void thePictureCannotBeSavedAndTheRenderingCanBeCancelled() {
        assertThat(window.canDo("Save Picture As…")).isFalse();
        assertThat(window.canDo("Cancel")).isTrue();
    }

    @WindowTest
    void escapeCancelsAndWhatIsFinishedStays() {
        window.screen.press(KeyEvent.VK_ESCAPE);
        gate.open();

        window.untilState(RenderJob.State.CANCELLED);
        assertThat(window.status()).matches("Cancelled: 36,000 of 57,600 rays, [\\d.:]+ (s|min)");
        assertThat(window.canDo("Save Picture As…")).isFalse();
        assertThat(window.canDo("Cancel")).isFalse();
        window.untilShown("the upper half", TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE), 0, HALF);
    }

    @WindowTest
    void itGoesOnToTheEndOnceItIsNotHeldAnyMore() {
        gate.open();

        window.untilShown("the whole picture", TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE));
        window.untilState(RenderJob.State.FINISHED);
        assertThat(window.canDo("Save Picture As…")).isTrue();
    }
}
