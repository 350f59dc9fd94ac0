package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Dimension;
import java.awt.Insets;
import java.awt.MouseInfo;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.ui.Mouse;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

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
        window.untilState(RenderJob.State.FINISHED);
        window.untilProblems("lights nothing");
        OpenWindow.run(() -> window.picture().setZoom(Zoom.ACTUAL, null));      // in the middle of what the warnings leave
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void theFinishedPictureIsOnTheScreenPixelForPixelAndInTheMiddle() {
        window.untilShown("the picture", whole);

        Rectangle place = OpenWindow.ask(() -> window.picture().place());
        Dimension room = OpenWindow.ask(window.picture()::getSize);
        assertThat(place).isEqualTo(new Rectangle((room.width - WIDTH) / 2, (room.height - HEIGHT) / 2, WIDTH, HEIGHT));
        assertThat(window.status()).matches("Finished: 180,000 rays, [\\d.:]+ (s|min)");
        assertThat(window.label("size")).isEqualTo("600 × 300, final");
    }

    @WindowTest
    void aLargerWindowShowsThePictureAt100PerCentAndNoScrollBars() {
        resize(LARGE);

        window.untilShown("the picture", whole);
        assertThat(scrollBars()).isEqualTo("none");
    }

    @WindowTest
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

    @WindowTest
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

    @WindowTest
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
        window.untilState(RenderJob.State.FINISHED);

        Screen.until("the same is on the screen", () -> Screen.shows(
            window.screen.capture(window.picture(), window.picture().place()), 0, 0, inOneGo, 0, inOneGo.getHeight()));
    }

    @WindowTest
    void theWheelWithControlZoomsAboutTheCursorAndPixelsAreCrisp() {
        window.untilShown("the picture", whole);
        Mouse mouse = new Mouse(window.picture());
        Rectangle place = OpenWindow.ask(() -> window.picture().place());
        // a little right of the middle, lest an edge of the enlarged picture comes into the window
        Point cursor = new Point(place.x + 310, place.y + 140);
        Point pixel = new Point(310, 140);
        assertThat(OpenWindow.ask(() -> window.picture().pixelAt(cursor))).isEqualTo(pixel);
        mouse.move(cursor);
        Point onScreen = OpenWindow.ask(() -> MouseInfo.getPointerInfo().getLocation());
        mouse.holding(KeyEvent.VK_CONTROL, () -> {
            mouse.wheel(-1);
            for (int scale : new int[] {2, 3, 4}) {
                assertThat(OpenWindow.ask(() -> window.picture().zoom().scale())).isEqualTo(scale);
                assertThat(window.label("zoom")).isEqualTo(100 * scale + " %");
                assertThat(OpenWindow.ask(() -> pixelUnder(onScreen))).isEqualTo(pixel);
                mouse.wheel(-1);
            }
            assertThat(OpenWindow.ask(() -> pixelUnder(onScreen))).isEqualTo(pixel);
            assertThat(scrollBars()).isEqualTo("both");
            Screen.until("each pixel is a square of six", () -> isCrisp(6));
            for (int i = 0; i < 4; i++) {
                mouse.wheel(1);
            }
        });
        window.untilShown("the picture", whole);
        assertThat(window.label("zoom")).isEqualTo("100 %");
        assertThat(OpenWindow.ask(() -> window.picture().request().settings().camera)).as("it moves no camera").isNull();
    }

    @WindowTest
    void keysZoomAboutTheMiddle() {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_EQUALS);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_EQUALS);
        assertThat(window.label("zoom")).isEqualTo("300 %");
        Point middle = OpenWindow.ask(() -> {
            Rectangle seen = window.picture().getVisibleRect();
            return window.picture().pixelAt(new Point((int) seen.getCenterX(), (int) seen.getCenterY()));
        });
        assertThat(middle.distance(WIDTH / 2.0, HEIGHT / 2.0)).isLessThan(5);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_MINUS);
        assertThat(window.label("zoom")).isEqualTo("200 %");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_0);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_MINUS);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_MINUS);
        assertThat(window.label("zoom")).isEqualTo("50 %");
        assertThat(OpenWindow.ask(() -> window.picture().place().getSize())).isEqualTo(new Dimension(WIDTH / 2, HEIGHT / 2));
    }

    @WindowTest
    void theMenuTicksTheZoomThatIsShown() {
        window.screen.press(KeyEvent.VK_F);
        assertThat(ticks()).isEqualTo("Fit to Window");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_EQUALS);
        assertThat(ticks()).isEmpty();
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_0);
        assertThat(ticks()).isEqualTo("Actual Size");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_0);
        assertThat(ticks()).isEqualTo("Actual Size");
    }

    @WindowTest
    void controlAndArrowsScroll() {
        resize(SMALL);
        Screen.until("there are scroll bars", () -> scrollBars().equals("both"));
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_RIGHT);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_DOWN);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_DOWN);

        untilPieceIsShown(16, 32);
    }

    private String ticks() {
        return Stream.of("Actual Size", "Fit to Window").filter(name -> OpenWindow.ask(window.item(name)::isSelected))
            .collect(Collectors.joining(", "));
    }

    private Point pixelUnder(Point onScreen) {
        Point inPicture = new Point(onScreen);
        SwingUtilities.convertPointFromScreen(inPicture, window.picture());
        return window.picture().pixelAt(inPicture);
    }

    /** {@return whether all that is on the screen of the picture are squares of its pixels} */
    private boolean isCrisp(int scale) {
        Rectangle piece = window.picture().getVisibleRect();
        BufferedImage capture = window.screen.capture(window.picture(), piece);
        for (int y = 0; y < piece.height; y++) {
            for (int x = 0; x < piece.width; x++) {
                if (capture.getRGB(x, y) != whole.getRGB((piece.x + x) / scale, (piece.y + y) / scale)) {
                    return false;
                }
            }
        }
        return true;
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
