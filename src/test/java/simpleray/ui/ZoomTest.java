package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Dimension;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The picture's size on the screen. */
class ZoomTest {
    private static final int WIDTH = 600;
    private static final int HEIGHT = 300;
    private static final Dimension SMALL = new Dimension(400, 250);
    private static final Dimension LARGE = new Dimension(1100, 900);

    private final BufferedImage whole = TestScenes.rendered(TestScenes.THESIS, WIDTH, HEIGHT);
    private OpenWindow window;

    @BeforeEach
    void finishThePicture() {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), WIDTH, HEIGHT);
        window.untilState(Rendering.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @Test
    void theFinishedPictureIsOnTheScreenPixelForPixelAndInTheMiddle() {
        window.untilShown("the picture", whole);

        Rectangle place = OpenWindow.ask(() -> window.picture().place());
        Dimension room = OpenWindow.ask(window.picture()::getSize);
        assertThat(place).isEqualTo(new Rectangle((room.width - WIDTH) / 2, (room.height - HEIGHT) / 2, WIDTH, HEIGHT));
        assertThat(window.status()).matches("Finished: 300 of 300 rows, [\\d.:]+ (s|min)");
        assertThat(window.label("size")).isEqualTo("600 × 300, final");
    }

    @Test
    void aLargerWindowShowsThePictureAt100PerCentAndNoScrollBars() {
        resize(LARGE);

        window.untilShown("the picture", whole);
        assertThat(scrollBars()).isEqualTo("none");
    }

    @Test
    void aSmallerWindowShowsAPieceAt100PerCentAndScrolls() {
        resize(SMALL);
        Screen.until("there are scroll bars", () -> scrollBars().equals("both"));
        untilPieceIsShown(0, 0);

        OpenWindow.run(() -> {
            window.scroll().getHorizontalScrollBar().setValue(70);
            window.scroll().getVerticalScrollBar().setValue(50);
        });
        untilPieceIsShown(70, 50);
    }

    @Test
    void fitToWindowScalesThePictureAndActualSizeBringsItBack() {
        resize(SMALL);
        window.screen.press(KeyEvent.VK_F);
        Screen.until("the picture is as high as the window", () -> window.picture().place().height == window.picture().getHeight());
        assertThat(scrollBars()).isEqualTo("none");
        Rectangle place = OpenWindow.ask(() -> window.picture().place());
        assertThat(place.getWidth() / place.getHeight()).isCloseTo(2, within(0.01));

        resize(LARGE);
        Screen.until("it grows with the window", () -> window.picture().place().width > WIDTH);

        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_0);
        window.untilShown("the picture", whole);
    }

    @Test
    void anEnlargedPictureReachesFromCornerToCorner() {
        resize(LARGE);
        window.screen.press(KeyEvent.VK_F);
        Rectangle place = OpenWindow.ask(() -> window.picture().place());
        Screen.until("its four corners are on the screen", () -> {
            BufferedImage capture = window.screen.capture(window.picture(), place);
            int right = place.width - 1;
            int bottom = place.height - 1;
            return capture.getRGB(0, 0) == whole.getRGB(0, 0) && capture.getRGB(right, 0) == whole.getRGB(WIDTH - 1, 0)
                && capture.getRGB(0, bottom) == whole.getRGB(0, HEIGHT - 1)
                && capture.getRGB(right, bottom) == whole.getRGB(WIDTH - 1, HEIGHT - 1);
        });
    }

    /** While it is rendered only strips of the screen are painted anew. */
    @ParameterizedTest
    @CsvSource({"400, 250", "1100, 900"})
    void aFittedPictureHasNoSeamsWhereRowsCameLater(int width, int height) {
        resize(new Dimension(width, height));
        window.screen.press(KeyEvent.VK_F);
        OpenWindow.run(() -> window.picture().paintImmediately(window.picture().getVisibleRect()));
        BufferedImage inOneGo = OpenWindow.ask(() -> window.screen.capture(window.picture(), window.picture().place()));
        window.screen.press(KeyEvent.VK_F5);
        window.untilState(Rendering.State.FINISHED);

        Screen.until("the same is on the screen", () -> Screen.shows(
            window.screen.capture(window.picture(), window.picture().place()), 0, 0, inOneGo, 0, inOneGo.getHeight()));
    }

    private void resize(Dimension size) {
        OpenWindow.run(() -> window.frame.setSize(size));
        Screen.until("the window has that size", () -> {
            Insets edges = window.frame.getInsets();
            Dimension inside = new Dimension(size.width - edges.left - edges.right, size.height - edges.top - edges.bottom);
            return window.frame.getRootPane().getSize().equals(inside);
        });
    }

    private String scrollBars() {
        boolean across = OpenWindow.ask(window.scroll().getHorizontalScrollBar()::isShowing);
        boolean down = OpenWindow.ask(window.scroll().getVerticalScrollBar()::isShowing);
        return across && down ? "both" : across || down ? "one" : "none";
    }

    private void untilPieceIsShown(int left, int top) {
        Screen.until("the piece from " + left + ", " + top + " is on the screen", () -> {
            Rectangle piece = window.picture().getVisibleRect();
            BufferedImage capture = window.screen.capture(window.picture(), piece);
            for (int y = 0; y < piece.height; y++) {
                for (int x = 0; x < piece.width; x++) {
                    if (capture.getRGB(x, y) != whole.getRGB(left + x, top + y)) {
                        return false;
                    }
                }
            }
            return piece.x == left && piece.y == top;
        });
    }
}
