package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTree;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.render.RenderRequest;
import simpleray.text.Diagnostic;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.editor.EditorContext;
import simpleray.ui.file.SceneSource;

/** The picture as large as its room, and where it was while panes open. */
class FitTest {
    private static final double SHARE = 0.8;
    private static final int NEAR = 2;                        // pixels
    private static final int PAUSE = 500;                     // milliseconds, longer than a resized picture waits

    @TempDir
    Path folder;

    private OpenWindow window;

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void aSceneWithoutASizeIsRenderedAsLargeAsItsPaneAndAgainWhenThatIsResized() {
        open(TestScenes.plain(folder.resolve("plain.scene"), 0.2, 0.4, 0.6), new RenderRequest());
        untilItFits();
        OpenWindow.run(() -> window.frame.setSize(700, 600));
        untilItFits();
        int small = OpenWindow.ask(() -> window.picture().imageSize().width);
        OpenWindow.run(() -> window.frame.setSize(1000, 900));
        untilItFits();

        assertThat(OpenWindow.ask(() -> window.picture().imageSize().width)).isGreaterThan(small);
        assertThat(window.label("zoom")).isEqualTo("100 %");
        assertThat(OpenWindow.ask(() -> window.picture().job().snapshot().request().settings().resolution.width()))
            .isEqualTo(OpenWindow.ask(() -> window.picture().imageSize().width));
    }

    @WindowTest
    void aZoomedPictureKeepsItsSizeWhateverTheWindowHas() {
        open(TestScenes.plain(folder.resolve("plain.scene"), 0.2, 0.4, 0.6), new RenderRequest());
        untilItFits();
        int side = OpenWindow.ask(() -> window.picture().imageSize().width);
        OpenWindow.run(() -> window.picture().setZoom(Zoom.ACTUAL, null));
        RenderJob job = window.job();
        OpenWindow.run(() -> window.frame.setSize(700, 600));
        Screen.until("its size is noticed", () -> window.frame.getWidth() == 700 && window.picture().isSettled());

        assertThat(window.job()).isSameAs(job);
        assertThat(OpenWindow.ask(() -> window.picture().imageSize())).isEqualTo(new Dimension(side, side));
    }

    @WindowTest
    void aLargePictureWithASizeIsShownWholeUntilTheUserZooms() {
        open(TestScenes.plain(folder.resolve("plain.scene"), 0.2, 0.4, 0.6), OpenWindow.request(1600, 1200));
        OpenWindow.run(() -> window.frame.setSize(1000, 700));
        Screen.until("all of it is shown", () -> {
            Rectangle place = window.picture().place();
            return window.picture().imageSize().equals(new Dimension(1600, 1200)) && window.frame.getWidth() == 1000
                && window.scroll().getViewport().getViewRect().contains(place) && place.height > SHARE * window.scroll().getHeight();
        });
    }

    @WindowTest
    void whatWasClickedStaysUnderTheMouseWhenItsStoryComes() throws Exception {
        open(TestScenes.THESIS, new RenderRequest());
        untilItFits();
        clickStays(new Point(300, 300));
    }

    @ParameterizedTest
    @CsvSource({"1240, 460, true", "1000, 700, false"})
    void aFittedPictureIsSoFarToTheLeftThatTheRaysOrElseAStoryFitBesideIt(int width, int height, boolean rays) throws Exception {
        open(TestScenes.plain(folder.resolve("plain.scene"), 0.2, 0.4, 0.6), new RenderRequest());
        OpenWindow.run(() -> window.frame.setSize(width, height));
        untilItFits();
        Rectangle before = OpenWindow.ask(this::onScreen);
        int left = OpenWindow.ask(() -> window.picture().place().x);
        int whole = OpenWindow.ask(() -> window.picture().getWidth());
        if (rays) {
            assertThat(left + before.width).isCloseTo(whole / 2, within(1));
        } else {
            assertThat(left).isBetween(1, whole - left - before.width - 2);
        }
        clickStays(new Point(before.width - 10, 100));

        assertThat(OpenWindow.ask(this::onScreen)).isEqualTo(before);
        assertThat(OpenWindow.ask(this::isWhole)).as("all of it is seen beside the story").isTrue();
    }

    @ParameterizedTest
    @CsvSource({"1364, 742, 0, 0, true", "1090, 589, 0, 0, true", "1364, 742, 400, 400, true", "1090, 589, 800, 300, false",
        "900, 700, 0, 0, false"})
    void allOfThePictureIsSeenBesideTheRays(int width, int height, int columns, int rows, boolean stays) throws Exception {
        open(TestScenes.THESIS, columns == 0 ? new RenderRequest() : OpenWindow.request(columns, rows));
        OpenWindow.run(() -> window.frame.setSize(width, height));
        window.untilState(RenderJob.State.FINISHED);
        Screen.until("it is as large as fits", () -> window.frame.getWidth() == width && window.picture().isSettled()
            && !window.picture().isBusy() && (columns > 0 || window.picture().placed().scale() == 1));
        RenderJob job = window.job();
        Dimension size = OpenWindow.ask(() -> window.picture().imageSize());
        clickStays(new Point(size.width * 7 / 10, size.height / 2));
        Rectangle before = OpenWindow.ask(this::onScreen);
        window.screen.press(KeyEvent.VK_V);
        Screen.until("the rays are there", () -> OpenWindow.seen(JComponent.class, view -> "rays".equals(view.getName())) != null);
        Screen.until("it is settled", () -> window.picture().isSettled() && !window.picture().isBusy());

        assertThat(OpenWindow.ask(this::isWhole)).isTrue();
        if (stays) {
            assertThat(OpenWindow.ask(this::onScreen)).isEqualTo(before);
            assertThat(window.job()).isSameAs(job);
        } else {
            Rectangle after = OpenWindow.ask(this::onScreen);
            assertThat(after.width).isBetween(width * 2 / 5, before.width - 1).isCloseTo(width / 2, within(20));
        }
    }

    @ParameterizedTest
    @CsvSource({"1364, 742", "1090, 589"})
    void aPaneThatOpensOrClosesMovesNoPictureThatFitsBesideIt(int width, int height) throws Exception {
        open(TestScenes.THESIS, new RenderRequest());
        OpenWindow.run(() -> window.frame.setSize(width, height));
        untilItFits();
        RenderJob job = window.job();
        int side = OpenWindow.ask(() -> window.picture().imageSize().width);
        clickStays(new Point(side * 7 / 10, side / 2));
        Rectangle before = OpenWindow.ask(this::onScreen);
        for (String item : List.of("Scene Text", "Scene Text", "Histogram", "Histogram", "Scene Text", "Rays", "Rays")) {
            toggle(item);
            Rectangle now = OpenWindow.ask(this::onScreen);
            assertThat(now.getSize()).as(item).isEqualTo(before.getSize());
            assertThat(now.getLocation().distance(before.getLocation())).as(item).isLessThanOrEqualTo(NEAR);
            assertThat(OpenWindow.ask(this::isWhole)).as(item).isTrue();
            assertThat(window.job()).as(item).isSameAs(job);
        }
        OpenWindow.run(() -> window.frame.setSize(width - 100, height - 100));
        Screen.until("it fits the smaller window", () -> window.frame.getWidth() == width - 100 && window.picture().isSettled()
            && !window.picture().isBusy() && window.picture().imageSize().width < side
            && window.picture().imageSize().width == window.picture().room());
    }

    @WindowTest
    void aPaneThatClosesBesideTheHistogramMakesThePictureNoSmaller() throws Exception {
        open(TestScenes.THESIS, OpenWindow.request(800, 450));
        OpenWindow.run(() -> window.frame.setSize(1250, 660));
        Screen.until("it is fitted", () -> window.frame.getWidth() == 1250 && window.picture().isSettled() && !window.picture().isBusy());
        clickStays(new Point(400, 225));
        toggle("Rays");
        toggle("Histogram");
        Rectangle before = OpenWindow.ask(this::onScreen);
        toggle("Rays");
        assertThat(OpenWindow.ask(this::onScreen).width).isGreaterThanOrEqualTo(before.width);
        assertThat(OpenWindow.ask(this::isWhole)).isTrue();
    }

    @WindowTest
    void aPictureThatDoesNotFitBesideAPaneIsFittedNearItsPlaceAndGrowsBackWhenThePaneCloses() throws Exception {
        open(TestScenes.THESIS, new RenderRequest());
        OpenWindow.run(() -> window.frame.setSize(900, 700));
        untilItFits();
        Rectangle before = OpenWindow.ask(this::onScreen);
        toggle("Scene Text");
        assertThat(OpenWindow.ask(this::isWhole)).isTrue();
        Rectangle beside = OpenWindow.ask(this::onScreen);
        assertThat(beside.width).isLessThan(before.width);
        assertThat(beside.getCenterY()).as("its middle is where it was").isCloseTo(before.getCenterY(), within(1.0));

        clickStays(new Point(100, 100));
        toggle("Scene Text");                                 // in front again
        toggle("Scene Text");
        window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_I);
        pause();
        assertThat(OpenWindow.ask(this::onScreen)).isEqualTo(before);
    }

    @WindowTest
    void errorsMoveThePictureNoMoreThanWarnings() {
        Path scene = TestScenes.plain(folder.resolve("plain.scene"), 0.2, 0.4, 0.6);
        open(scene, new RenderRequest());
        OpenWindow.run(() -> window.frame.setSize(1090, 589));
        untilItFits();
        RenderJob job = window.job();
        Rectangle before = OpenWindow.ask(this::onScreen);
        Diagnostic wrong = new Diagnostic("a.scene", 1, 1, true, "wrong ".repeat(40), null);   // wider than the window
        for (int errors : new int[] {1, 3, 9, 2}) {
            OpenWindow.run(() -> ((EditorContext) window.frame).showFaults(SceneReport.of(Collections.nCopies(errors, wrong))));
            pause();
            JTextComponent list = window.problems();
            OpenWindow.run(() -> {
                int row = list.getFontMetrics(list.getFont()).getHeight();
                int seen = list.getParent().getHeight() - list.getInsets().top - list.getInsets().bottom;
                assertThat(seen).isGreaterThanOrEqualTo(row);
                assertThat(seen >= errors * row || seen % row == 0).as("no line is cut").isTrue();
            });
            assertThat(OpenWindow.ask(this::onScreen)).isEqualTo(before);
        }
        assertThat(window.job()).isSameAs(job);
    }

    private void toggle(String item) {
        OpenWindow.run(() -> window.item(item).doClick());
        pause();
    }

    /** Waits until a picture would be rendered anew. */
    private void pause() {
        Screen.pause(PAUSE);
        Screen.until("it is settled", () -> window.picture().isSettled() && !window.picture().isBusy());
    }

    private boolean isWhole() {
        Rectangle seen = window.scroll().getViewport().getBounds();
        seen.setLocation(window.scroll().getViewport().getLocationOnScreen());
        return seen.contains(onScreen());
    }

    @WindowTest
    void soItDoesAtTheRightEdgeOfAPictureAsWideAsTheWindow() throws Exception {
        open(TestScenes.THESIS, OpenWindow.request(800, 300));
        window.untilState(RenderJob.State.FINISHED);
        Screen.until("it fits", () -> window.picture().place().width == window.picture().getWidth());
        clickStays(new Point(600, 200));
    }

    @WindowTest
    void thePictureStaysWhereItIsWhenWarningsCome() {
        open(TestScenes.THESIS, OpenWindow.request(400, 400));
        Screen.until("something is shown", () -> window.picture().seen() != null);
        Rectangle before = OpenWindow.ask(this::onScreen);
        window.untilState(RenderJob.State.FINISHED);
        window.untilProblems("light 2");

        assertThat(OpenWindow.ask(this::onScreen)).isEqualTo(before);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void thePictureAt100PerCentStaysWhereItIsWhenWarningsComeAndGo(boolean large) {
        CountDownLatch go = new CountDownLatch(1);
        window = new OpenWindow(TestScenes.watched(TestScenes.THESIS, ray -> {
            try {
                go.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }), large ? 1500 : 200, large ? 1200 : 200, made -> made.frame().setSize(900, 700));
        Rectangle before = OpenWindow.ask(this::onScreen);
        assertThat(window.problems()).isNull();
        go.countDown();
        window.untilProblems("light 2");
        assertThat(OpenWindow.ask(this::onScreen)).isEqualTo(before);

        OpenWindow.run(() -> window.open(SceneSource.file(TestScenes.plain(folder.resolve("plain.scene"), 0.2, 0.4, 0.6))));
        Screen.until("no warnings are left", () -> window.problems() == null);
        assertThat(OpenWindow.ask(this::onScreen)).isEqualTo(before);
    }

    @WindowTest
    void thePixelIsInSightAlsoIfItsRaysAreAskedForAtOnce() throws Exception {
        open(TestScenes.THESIS, OpenWindow.request(800, 300));
        window.untilState(RenderJob.State.FINISHED);
        Screen.until("it fits", () -> window.picture().place().width == window.picture().getWidth());
        click(new Point(700, 200));
        window.screen.press(KeyEvent.VK_V);
        Screen.until("the rays are there", () -> OpenWindow.seen(JComponent.class, view -> "rays".equals(view.getName())) != null);
        OpenWindow.run(() -> {
            Rectangle all = window.picture().place();
            Point pixel = new Point(all.x + 700 * all.width / 800, all.y + 200 * all.height / 300);
            assertThat(window.picture().getVisibleRect().contains(pixel)).isTrue();
        });
    }

    @WindowTest
    void thePixelOfAStoryKeepsItsPlaceInAPictureOfAnotherSize() throws Exception {
        openAtPixel100And30();
        renderAnew(600, 450);
        Screen.until("the story is of the same place", () -> isTold("Pixel 301, 91"));
        renderAnew(200, 150);
        Screen.until("it is the pixel of before", () -> isTold("Pixel 100, 30"));
    }

    /** The shorter side shows the same of the scene: 150 rows, then 150 columns. */
    @WindowTest
    void thePixelOfAStoryShowsTheSamePlaceOfTheSceneInAPictureOfAnotherShape() throws Exception {
        openAtPixel100And30();

        renderAnew(450, 600);

        Screen.until("the story is of the same place", () -> isTold("Pixel 226, 166"));   // 225 + 0.5 * 3, 300 - (75 - 30.5) * 3
    }

    private void openAtPixel100And30() throws Exception {
        open(TestScenes.THESIS, OpenWindow.request(200, 150));
        window.untilState(RenderJob.State.FINISHED);
        window.untilProblems("lights nothing");
        click(new Point(100, 30));
        Screen.until("its story is there", () -> isTold("Pixel 100, 30"));
    }

    private void renderAnew(int width, int height) {
        OpenWindow.run(() -> {
            window.picture().setRequest(OpenWindow.request(width, height));
            window.picture().start();
        });
    }

    private static boolean isTold(String pixel) {
        return OpenWindow.seen(JLabel.class, label -> pixel.equals(label.getText())) != null;
    }

    @WindowTest
    void besidePanesTheWheelMovesTheCameraAndAnotherSceneFits() throws Exception {
        Path scene = TestScenes.plain(folder.resolve("plain.scene"), 0.2, 0.4, 0.6);
        Path other = TestScenes.plain(folder.resolve("other.scene"), 0.6, 0.4, 0.2);
        open(scene, new RenderRequest());
        OpenWindow.run(() -> window.frame.setSize(900, 700));
        untilItFits();
        click(new Point(200, 200));
        Screen.until("the story is there", () -> OpenWindow.seen(JTree.class, tree -> "story".equals(tree.getName())) != null);
        window.screen.press(KeyEvent.VK_V);
        Screen.until("the rays are there", () -> OpenWindow.seen(JComponent.class, view -> "rays".equals(view.getName())) != null);
        new Robot().mouseWheel(-1);
        Screen.until("the camera was moved", () -> window.picture().request().settings().camera != null);

        OpenWindow.run(() -> {
            window.picture().setSource(SceneSource.file(other));
            window.picture().setRequest(new RenderRequest());
            window.picture().start();
        });
        Screen.until("the other one fits", () -> window.job().state() == RenderJob.State.FINISHED && window.picture().isSettled()
            && window.picture().imageSize().width == window.picture().room()
            && window.picture().place().width <= window.scroll().getWidth());
    }

    private void clickStays(Point pixel) throws Exception {
        Point clicked = OpenWindow.ask(() -> under(at(pixel)));
        Point at = click(pixel);
        Screen.until("its story is there", () -> OpenWindow.seen(JTree.class, tree -> "story".equals(tree.getName())) != null);
        OpenWindow.run(() -> {
            assertThat(under(at).distance(clicked)).isLessThanOrEqualTo(NEAR);
            JComponent seen = (JComponent) window.picture().getParent();
            assertThat(seen.getVisibleRect().contains(at.x - seen.getLocationOnScreen().x, at.y - seen.getLocationOnScreen().y)).isTrue();
        });
    }

    /** Clicks on a pixel of the picture; {@return its place on the screen} */
    private Point click(Point pixel) throws Exception {
        Robot robot = new Robot();
        Point at = OpenWindow.ask(() -> at(pixel));
        robot.mouseMove(at.x, at.y);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        return at;
    }

    private Point at(Point pixel) {
        Rectangle all = onScreen();
        Dimension size = window.picture().imageSize();
        return new Point(all.x + (int) ((pixel.x + 0.5) * all.width / size.width),
            all.y + (int) ((pixel.y + 0.5) * all.height / size.height));
    }

    /** {@return the picture's pixel at a point of the screen} For the event thread. */
    private Point under(Point at) {
        Point corner = window.picture().getLocationOnScreen();
        return window.picture().pixelAt(new Point(at.x - corner.x, at.y - corner.y));
    }

    private Rectangle onScreen() {
        Rectangle place = window.picture().place();
        Point corner = window.picture().getLocationOnScreen();
        place.translate(corner.x, corner.y);
        return place;
    }

    private void open(Path scene, RenderRequest request) {
        window = new OpenWindow(SceneSource.file(scene), 1, 1, made -> {
            made.picture().setZoom(Zoom.FIT, null);
            made.picture().setRequest(request);
            made.picture().start();
        });
    }

    private void untilItFits() {
        window.untilState(RenderJob.State.FINISHED);
        Screen.until("the picture has the size of its room", () -> window.picture().job().state() == RenderJob.State.FINISHED
            && window.picture().isSettled() && window.picture().imageSize().width == window.picture().room()
            && window.picture().place().height > SHARE * Math.min(window.scroll().getWidth(), window.scroll().getHeight()));
    }
}
