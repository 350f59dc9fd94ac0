package simpleray.ui.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JComboBox;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.render.Stage;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

/** Comparing the last pictures, clipped pixels and the histogram, by keys and mouse. */
class CompareViewTest {
    private static final int WIDTH = 120;
    private static final int HEIGHT = 90;

    @TempDir
    private Path folder;
    private final BufferedImage lighting = TestScenes.rendered(TestScenes.THESIS, WIDTH, HEIGHT, Stage.LIGHTING);
    private final BufferedImage whole = TestScenes.rendered(TestScenes.THESIS, WIDTH, HEIGHT);
    private OpenWindow window;

    @BeforeEach
    void finishTwoPictures() {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), WIDTH, HEIGHT);
        untilKept(1);
        assertThat(window.canDo("Wipe")).isFalse();
        window.screen.press(KeyEvent.VK_2);
        untilKept(2);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void twoPicturesAreShownSideBySideAndTheKeyEndsIt() throws IOException {
        window.screen.press(KeyEvent.VK_B);
        untilShows("the first picture", () -> view().leftPlace(), whole);
        untilShows("the second picture", () -> view().rightPlace(), lighting);
        capture("side-by-side.png");

        window.screen.press(KeyEvent.VK_B);
        window.untilShown("the picture alone", lighting);
        Screen.until("the picture has the keys", () -> window.picture().isFocusOwner());
    }

    @WindowTest
    void theLineAtTheFootTellsWhatWorksWhilePicturesAreCompared() {
        assertThat(window.label("gestures")).startsWith("Click: why this colour");
        window.screen.press(KeyEvent.VK_B);
        Screen.until("it says how to go back", () -> window.label("gestures").equals("B: back to the picture   F1: help"));
        window.screen.press(KeyEvent.VK_W);
        Screen.until("it tells of the divider", () -> window.label("gestures").startsWith("Drag: move the divider   W: back to"));
        window.screen.press(KeyEvent.VK_W);
        Screen.until("it tells the picture's again", () -> window.label("gestures").startsWith("Click: why this colour"));
    }

    @WindowTest
    void theDividerIsMovedByKeys() throws IOException {
        window.screen.press(KeyEvent.VK_W);
        untilWiped(0.5);
        capture("wipe.png");
        window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_RIGHT);
        window.screen.press(KeyEvent.VK_LEFT);
        untilWiped(0.59);
        window.screen.press(KeyEvent.VK_HOME);
        untilWiped(0);
        window.screen.press(KeyEvent.VK_END);
        untilWiped(1);
        assertThat(OpenWindow.ask(() -> view().getAccessibleContext().getAccessibleDescription())).isEqualTo("Divider at 100 %");
    }

    @WindowTest
    void theDividerIsDraggedByTheMouse() throws Exception {
        window.screen.press(KeyEvent.VK_W);
        untilWiped(0.5);
        Point corner = OpenWindow.ask(() -> {
            Point at = view().getLocationOnScreen();
            at.translate(view().place().x, view().place().y);
            return at;
        });
        Robot robot = new Robot();
        robot.mouseMove(corner.x + WIDTH / 2, corner.y + HEIGHT / 2);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseMove(corner.x + WIDTH / 4, corner.y + HEIGHT / 2);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);

        untilWiped(0.25);
    }

    @WindowTest
    void aFittedPictureIsFittedWhileItIsComparedAndTheLabelTellsTheScale() {
        window.screen.press(KeyEvent.VK_F);
        window.screen.press(KeyEvent.VK_W);
        Screen.until("the pictures fill the room", () -> view() != null && view().place().height == view().getHeight()
            && view().getHeight() > 2 * HEIGHT);
        Screen.until("the label tells it", () -> window.label("zoom").equals(Math.round(1000.0 * view().place().width / WIDTH) / 10.0
            + " %"));
        window.screen.press(KeyEvent.VK_B);
        Screen.until("the label tells the smaller scale", () -> window.label("zoom").equals(
            Math.round(1000.0 * view().leftPlace().width / WIDTH) / 10.0 + " %") && view().leftPlace().width < view().getWidth() / 2);

        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_0);
        untilShows("the first picture at 100 %", () -> view().leftPlace(), whole);
        assertThat(window.label("zoom")).isEqualTo("100 %");
        window.screen.press(KeyEvent.VK_B);
        window.untilShown("the picture alone", lighting);
    }

    @WindowTest
    void theListsBeginWithTheStage() {
        assertThat(OpenWindow.ask(() -> window.comparison().pictures().toString()))
            .matches("\\[final, thesis\\.scene, 120 × 90, .*, lighting, thesis\\.scene, 120 × 90, .*at \\d\\d:\\d\\d:\\d\\d\\]");
    }

    @WindowTest
    void oneModeEndsTheOther() {
        window.screen.press(KeyEvent.VK_W);
        untilWiped(0.5);
        window.screen.press(KeyEvent.VK_B);
        untilShows("the first picture", () -> view().leftPlace(), whole);
        assertThat(OpenWindow.ask(() -> window.item("Wipe").isSelected())).isFalse();
        window.screen.press(KeyEvent.VK_W);
        untilWiped(0.5);
    }

    @WindowTest
    void anyTwoCanBeChosenAndTheLatestIsFollowed() {
        window.screen.press(KeyEvent.VK_B);
        untilShows("the first picture", () -> view().leftPlace(), whole);
        window.screen.press(KeyEvent.VK_1);
        untilKept(3);
        untilShows("the latest picture", () -> view().rightPlace(),
            TestScenes.rendered(TestScenes.THESIS, WIDTH, HEIGHT, Stage.ORIGINAL));

        JComboBox<?> right = OpenWindow.ask(() -> OpenWindow.seen(JComboBox.class, box -> "Right picture".equals(box.getName())));
        OpenWindow.run(() -> right.setSelectedIndex(1));
        untilShows("the chosen picture", () -> view().rightPlace(), lighting);
        untilShows("the first picture", () -> view().leftPlace(), whole);
    }

    @WindowTest
    void clippedPixelsAreMarkedAndCounted() throws IOException {
        Path bright = TestScenes.plain(folder.resolve("bright.scene"), 1.5, 0.5, 0.5);
        OpenWindow.run(() -> window.open(SceneSource.file(bright)));
        untilKept(3);
        window.screen.press(KeyEvent.VK_X);
        window.untilShown("the marks", magenta());
        assertThat(window.status()).isEqualTo("10800 pixels above 1 (magenta), 0 below 0 (cyan), of 10800");

        window.screen.press(KeyEvent.VK_X);
        window.untilShown("the picture without them", TestScenes.rendered(bright, WIDTH, HEIGHT));
    }

    @WindowTest
    void clippedPixelsAreMarkedInBothPicturesThatAreCompared() {
        Path bright = TestScenes.plain(folder.resolve("bright.scene"), 1.5, 0.5, 0.5);
        OpenWindow.run(() -> window.open(SceneSource.file(bright)));
        untilKept(3);
        Path dark = TestScenes.plain(folder.resolve("dark.scene"), 1, 0.5, 0.5);
        OpenWindow.run(() -> window.open(SceneSource.file(dark)));
        untilKept(4);
        window.screen.press(KeyEvent.VK_B);
        untilShows("the bright picture", () -> view().leftPlace(), TestScenes.rendered(bright, WIDTH, HEIGHT));
        window.screen.press(KeyEvent.VK_X);

        untilShows("the marks", () -> view().leftPlace(), magenta());
        untilShows("the picture without any", () -> view().rightPlace(), TestScenes.rendered(dark, WIDTH, HEIGHT));
        JButton swap = OpenWindow.appears("the button", JButton.class, button -> "Swap".equals(button.getText()));
        OpenWindow.run(swap::doClick);
        untilShows("the marks on the other side", () -> view().rightPlace(), magenta());
        window.screen.press(KeyEvent.VK_X);
        untilShows("the bright picture without marks", () -> view().rightPlace(), TestScenes.rendered(bright, WIDTH, HEIGHT));
    }

    private static BufferedImage magenta() {
        BufferedImage magenta = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        int[] all = new int[WIDTH * HEIGHT];
        Arrays.fill(all, Clipped.ABOVE_COLOUR);
        magenta.setRGB(0, 0, WIDTH, HEIGHT, all, 0, WIDTH);
        return magenta;
    }

    @WindowTest
    void theHistogramIsShownBesideThePicture() throws IOException {
        window.screen.press(KeyEvent.VK_H);
        Screen.until("it is shown", () -> chart() != null);
        int plain = OpenWindow.ask(() -> chart().bar(3));
        window.screen.press(KeyEvent.VK_L);
        assertThat(OpenWindow.ask(() -> chart().bar(3))).isGreaterThan(plain);
        window.untilShown("the picture, still at 100 %", lighting);
        capture("histogram.png");

        window.screen.press(KeyEvent.VK_H);
        Screen.until("it is gone", () -> chart() == null);
    }

    private HistogramPane.Chart chart() {
        return OpenWindow.seen(HistogramPane.Chart.class, chart -> "Red".equals(chart.getName()) && chart.getHeight() > 0);
    }

    private CompareView view() {
        return OpenWindow.seen(CompareView.class, view -> true);
    }

    /** Waits until so many pictures can be compared, the last of which is shown. */
    private void untilKept(int count) {
        Screen.until(count + " pictures can be compared", () -> window.comparison().pictures().size() == count);
    }

    private void untilWiped(double divider) {
        Screen.until("the divider is at " + divider, () -> {
            CompareView view = view();
            if (view == null || Math.abs(view.divider() - divider) > 1e-9) {
                return false;
            }
            Rectangle place = view.place();
            int at = (int) Math.round(divider * WIDTH);
            BufferedImage seen = window.screen.capture(view, place);
            return shows(seen, whole, 0, at - 9) && shows(seen, lighting, at + 9, WIDTH);
        });
    }

    private static boolean shows(BufferedImage seen, BufferedImage expected, int from, int to) {
        for (int x = from; x < to; x++) {
            for (int y = 0; y < HEIGHT; y++) {
                if (seen.getRGB(x, y) != expected.getRGB(x, y)) {
                    return false;
                }
            }
        }
        return true;
    }

    private void untilShows(String what, Supplier<Rectangle> place, BufferedImage expected) {
        Screen.until(what + " is shown", () -> view() != null && place.get().width == WIDTH
            && Screen.shows(window.screen.capture(view(), place.get()), 0, 0, expected, 0, HEIGHT));
    }

    private void capture(String name) throws IOException {
        Path captures = Files.createDirectories(Path.of(System.getProperty("simpleray.build"), "captures"));
        ImageIO.write(window.screen.capture(OpenWindow.ask(window.frame::getBounds)), "png", captures.resolve(name).toFile());
    }
}
