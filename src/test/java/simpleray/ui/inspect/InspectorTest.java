package simpleray.ui.inspect;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTException;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntPredicate;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JTree;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.rays.StoryText;
import simpleray.render.Explainer;
import simpleray.render.PixelStory;
import simpleray.render.RenderListener;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.scene.RayTree;
import simpleray.scene.SceneFile;
import simpleray.scene.SimpleCamera;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** What the window tells of single pixels, with the mouse and with keys. */
class InspectorTest {
    private static final int WIDTH = 90;
    private static final int HEIGHT = 60;
    /** The pane takes more than this. */
    private static final int PANE = 200;

    private final Robot robot;

    InspectorTest() throws AWTException {
        robot = new Robot();
    }

    @WindowTest
    void aPixelOfARowThatIsNotWholeIsToldAsItIsSeen() {
        assertThat(PixelLine.painted(-1, 0)).isEqualTo("not rendered yet");
        assertThat(PixelLine.painted(0, 0xFFE04040)).isEqualTo("failed");
        assertThat(PixelLine.painted(1, 0xFF010203)).isEqualTo("8-bit 1 2 3");
        assertThat(PixelLine.painted(1, 0x80010203)).isEqualTo("8-bit 1 2 3   alpha 128");
        assertThat(PixelLine.painted(1, 0)).isEqualTo("transparent");
        assertThat(PixelLine.painted(4, 0xFF010203)).isEqualTo("8-bit 1 2 3 of a block of 4 × 4, not rendered itself yet");
    }

    @WindowTest
    void aClickDuringTheVeryFirstRenderingIsAnsweredAndABlockIsToldAsThat() throws Exception {
        Explainer explainer = explainer(Stage.FINAL);
        CountDownLatch open = new CountDownLatch(1);
        AtomicInteger free = new AtomicInteger(WIDTH * HEIGHT / 2);   // rays of all kinds: no row is whole by then, and some blocks are
        SceneSource source = TestScenes.watched(TestScenes.THESIS, ray -> {
            if (Thread.currentThread().getName().startsWith("simpleray-worker") && free.decrementAndGet() < 0) {
                await(open);
            }
        });
        try (OpenWindow window = new OpenWindow(source, WIDTH, HEIGHT)) {
            Screen.until("blocks are shown", () -> window.picture().seen() != null);
            assertThat(window.job().snapshot().progress().finished()).isZero();
            Point pixel = OpenWindow.ask(() -> first(window, size -> size > 1));
            click(window, pixel);

            untilStory(window, explainer.story(pixel.x, pixel.y));
            int side = OpenWindow.ask(() -> window.picture().blockAt(pixel));
            Screen.until("the block is told", () -> window.label("pixel").contains(" of a block of " + side + " × " + side + ", "));
            open.countDown();
        } finally {
            open.countDown();
        }
    }

    @WindowTest
    void aClickWhileTheSceneIsReadIsAnsweredOnceItIs() throws Exception {
        CountDownLatch open = new CountDownLatch(1);
        try (OpenWindow window = new OpenWindow(TestScenes.read(() -> await(open)), WIDTH, HEIGHT)) {
            click(window, new Point(45, 36));
            window.screen.press(KeyEvent.VK_SHIFT);           // the click is there before it
            assertThat(OpenWindow.ask(InspectorTest::tree)).isNull();
            open.countDown();

            untilStory(window, explainer(Stage.FINAL).story(45, 36));
        } finally {
            open.countDown();
        }
    }

    @WindowTest
    void aPictureThatStaysWhenItsSceneCannotBeReadAnyMoreStillTellsItsStories() throws Exception {
        AtomicBoolean broken = new AtomicBoolean();
        SceneSource source = TestScenes.read(() -> {
            if (broken.get()) {
                throw new IllegalStateException("an error in the scene");
            }
        });
        try (OpenWindow window = new OpenWindow(source, WIDTH, HEIGHT)) {
            window.untilState(RenderJob.State.FINISHED);
            broken.set(true);
            window.screen.press(KeyEvent.VK_F5);
            window.untilState(RenderJob.State.FAILED);
            click(window, new Point(45, 36));

            untilStory(window, explainer(Stage.FINAL).story(45, 36));
        }
    }

    /** {@return the first pixel that is shown in a block as wanted} For the event thread. */
    private static Point first(OpenWindow window, IntPredicate wanted) {
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            Point pixel = new Point(i % WIDTH, i / WIDTH);
            if (wanted.test(window.picture().blockAt(pixel))) {
                return pixel;
            }
        }
        throw new AssertionError("no pixel is shown so");
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @WindowTest
    void alphaIsToldOfAPictureThatHasIt() {
        Picture picture = new Picture(2, 1, Picture.RGBA);
        picture.setRow(0, new double[] {1, 0.5, 0, 0.75, 0, 0, 0, 0});

        assertThat(PixelLine.colours(picture, new Point(0, 0), null)).isEqualTo("x 0, y 0   linear 1 0.5 0   8-bit 255 128 0   alpha 191");
        assertThat(PixelLine.colours(picture, new Point(1, 0), null)).isEqualTo("x 1, y 0   transparent");
        assertThat(PixelLine.colours(picture, new Point(2, 0), null)).isNull();
    }

    @WindowTest
    void theStatusBarTellsOfThePixelUnderTheMouse() throws Exception {
        Explainer explainer = explainer(Stage.FINAL);
        try (OpenWindow window = finished()) {
            for (Point pixel : List.of(new Point(45, 36), new Point(0, 0), new Point(WIDTH - 1, HEIGHT - 1))) {
                parkMouse(window);
                move(window, pixel);

                untilLine(window, line(explainer, pixel));
            }
            parkMouse(window);
            untilLine(window, " ");
        }
    }

    @WindowTest
    void aSphereOfTheThesisIsNamedWithItsLine() throws Exception {
        try (OpenWindow window = finished()) {
            parkMouse(window);
            move(window, new Point(45, 36));

            Screen.until("the sphere is named", () -> window.label("pixel").endsWith("   object 7 (sphere, line 31)"));
        }
    }

    @WindowTest
    void aClickOpensThePixelsStoryAndAnotherOneThatOfItsPixel() throws Exception {
        Explainer explainer = explainer(Stage.FINAL);
        try (OpenWindow window = finished()) {
            click(window, new Point(45, 36));
            untilStory(window, explainer.story(45, 36));
            Screen.until("the picture keeps the keys", () -> window.picture().isFocusOwner());
            untilPaneIsLaidOut(window);

            click(window, new Point(20, 50));
            untilStory(window, explainer.story(20, 50));
            assertThat(window.label("story title")).isEqualTo("Pixel 20, 50");
        }
    }

    @WindowTest
    void aQuestionBetweenTwoRenderingsIsAnsweredForThePictureThatIsSeen() throws Exception {
        AtomicBoolean held = new AtomicBoolean();
        CountDownLatch open = new CountDownLatch(1);
        SceneSource source = TestScenes.watched(TestScenes.THESIS, ray -> {
            if (held.get() && Thread.currentThread().getName().startsWith("simpleray-worker")) {
                await(open);
            }
        });
        try (OpenWindow window = new OpenWindow(source, WIDTH, HEIGHT)) {
            window.untilState(RenderJob.State.FINISHED);
            window.untilProblems("lights nothing");
            RenderJob first = window.job();
            held.set(true);
            window.screen.press(KeyEvent.VK_2);
            Screen.until("the next has begun", () -> window.picture().job() != first
                && window.picture().job().state() == RenderJob.State.RENDERING);
            Point pixel = new Point(45, 36);
            move(window, pixel);
            untilLine(window, line(explainer(Stage.FINAL), pixel));
            window.screen.press(KeyEvent.VK_I);
            untilStory(window, explainer(Stage.FINAL).story(45, 36));

            open.countDown();
            untilStory(window, explainer(Stage.LIGHTING).story(45, 36));
            assertThat(window.status()).doesNotContain("cannot be told");
        } finally {
            open.countDown();
        }
    }

    @WindowTest
    void keysOpenMoveCopyAndCloseTheStory() throws Exception {
        Explainer explainer = explainer(Stage.FINAL);
        try (OpenWindow window = finished()) {
            parkMouse(window);
            window.screen.press(KeyEvent.VK_I);
            untilStory(window, explainer.story(WIDTH / 2, HEIGHT / 2));
            Screen.until("the story has the keys", () -> tree().isFocusOwner());

            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_RIGHT);
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_RIGHT);
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_LEFT);
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_DOWN);
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_UP);
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_UP);
            PixelStory there = explainer.story(WIDTH / 2 + 1, HEIGHT / 2 - 1);
            untilStory(window, there);
            untilLine(window, line(explainer, new Point(there.x(), there.y())));

            window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_I);
            Screen.until("it is copied", () -> window.status().equals("Copied the story of pixel " + there.x() + ", " + there.y()));
            assertThat(Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor)).isEqualTo(
                StoryText.of(there, SceneFile.read(TestScenes.THESIS).scene(), new SimpleCamera(WIDTH, HEIGHT)));

            window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_I);
            Screen.until("the story is gone", () -> tree() == null && window.picture().isFocusOwner());
            window.untilShown("the picture without a cursor", TestScenes.rendered(TestScenes.THESIS, WIDTH, HEIGHT));
        }
    }

    @WindowTest
    void thePixelCursorStaysInThePictureAndFramesItsPixel() throws Exception {
        try (OpenWindow window = finished()) {
            click(window, new Point(0, 0));
            untilStory(window, explainer(Stage.FINAL).story(0, 0));
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_LEFT);
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_UP);
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_RIGHT);
            untilStory(window, explainer(Stage.FINAL).story(1, 0));
            untilPaneIsLaidOut(window);
            Screen.until("the frame is on the screen", () -> {
                Rectangle place = window.picture().place();
                BufferedImage capture = window.screen.capture(window.picture(), new Rectangle(place.x + 1 - 4, place.y - 4, 9, 9));
                return capture.getRGB(0, 0) == 0xFF000000 && capture.getRGB(8, 8) == 0xFF000000
                    && capture.getRGB(1, 1) == 0xFFFFFFFF && capture.getRGB(7, 7) == 0xFFFFFFFF;
            });
        }
    }

    @WindowTest
    void theButtonClosesTheStory() throws Exception {
        try (OpenWindow window = finished()) {
            parkMouse(window);
            window.screen.press(KeyEvent.VK_I);
            untilStory(window, explainer(Stage.FINAL).story(WIDTH / 2, HEIGHT / 2));
            untilPaneIsLaidOut(window);

            JButton close = OpenWindow.appears("the button", JButton.class, b -> "Close".equals(b.getText()));
            assertThat(OpenWindow.ask(() -> close.getAccessibleContext().getAccessibleName())).isEqualTo("Close Story");
            assertThat(OpenWindow.ask(() -> tree().getAccessibleContext().getAccessibleName())).isEqualTo("Story of the pixel");
            window.screen.click(close);

            Screen.until("the story is gone", () -> tree() == null);
        }
    }

    @WindowTest
    void theStoryFollowsTheStage() throws Exception {
        try (OpenWindow window = finished()) {
            parkMouse(window);
            window.screen.press(KeyEvent.VK_I);
            untilStory(window, explainer(Stage.FINAL).story(WIDTH / 2, HEIGHT / 2));

            window.screen.press(KeyEvent.VK_2);

            untilStory(window, explainer(Stage.LIGHTING).story(WIDTH / 2, HEIGHT / 2));
        }
    }

    @WindowTest
    void theEventThreadIsFreeWhileAStoryIsToldAndTheWindowCanBeClosed() {
        AtomicBoolean held = new AtomicBoolean();
        CountDownLatch asked = new CountDownLatch(1);
        CountDownLatch never = new CountDownLatch(1);
        SceneSource source = held(held, asked, never);
        try (OpenWindow window = new OpenWindow(source, WIDTH, HEIGHT)) {
            window.untilState(RenderJob.State.FINISHED);
            held.set(true);
            window.screen.press(KeyEvent.VK_I);
            Screen.until("a ray of the story is on its way", () -> asked.getCount() == 0);

            assertThat(OpenWindow.ask(() -> "an answer")).isEqualTo("an answer");
            assertThat(OpenWindow.threads()).contains("simpleray-inspector");
        }
        assertThat(OpenWindow.threads()).isEmpty();
    }

    /** {@return the thesis's scene, whose rays are held if that is wanted: each tells so, and waits until it may go on} */
    private static SceneSource held(AtomicBoolean wanted, CountDownLatch asked, CountDownLatch open) {
        return TestScenes.watched(TestScenes.THESIS, ray -> {
            if (wanted.get()) {
                asked.countDown();
                try {
                    open.await();
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        });
    }

    private static OpenWindow finished() {
        OpenWindow window = new OpenWindow(SceneSource.file(TestScenes.THESIS), WIDTH, HEIGHT);
        window.untilState(RenderJob.State.FINISHED);
        window.untilShown("the picture", TestScenes.rendered(TestScenes.THESIS, WIDTH, HEIGHT));
        window.untilProblems("lights nothing");               // its pane moves the picture
        return window;
    }

    private static Explainer explainer(Stage stage) throws IOException {
        return new Renderer(SceneFile.read(TestScenes.THESIS).scene(), new SimpleCamera(WIDTH, HEIGHT), new RenderSettings().with(stage))
            .explainer();
    }

    private static String line(Explainer explainer, Point pixel) throws IOException {
        double[] row = new Renderer(SceneFile.read(TestScenes.THESIS).scene(), new SimpleCamera(WIDTH, HEIGHT), new RenderSettings())
            .render(RenderListener.NONE).row(pixel.y);
        Colour colour = new Colour(row[3 * pixel.x], row[3 * pixel.x + 1], row[3 * pixel.x + 2]);
        return "x " + pixel.x + ", y " + pixel.y + "   linear " + StoryText.colour(colour) + "   8-bit " + StoryText.levels(colour) + "   "
            + StoryText.object(explainer.objectAt(pixel.x, pixel.y));
    }

    private static void untilLine(OpenWindow window, String line) {
        Screen.until("the status bar says: " + line, () -> window.label("pixel").equals(line));
    }

    /** {@return the tree of the story; null if there is none} For the event thread. */
    private static JTree tree() {
        return OpenWindow.seen(JTree.class, tree -> "story".equals(tree.getName()));
    }

    /** Waits until a story is shown, with the hit of the ray from the eye open, and its lights that arrive. */
    private static void untilStory(OpenWindow window, PixelStory story) throws IOException {
        RayTree primary = story.samples().get(0).tree();
        List<String> open = StoryText.lines(story, SceneFile.read(TestScenes.THESIS).scene(), new SimpleCamera(WIDTH, HEIGHT)).stream()
            .filter(line -> line.level() <= 2 || line.ray() == primary && line.lamp() != null && line.lamp().verdict().isLit())
            .map(StoryText.Line::text).collect(Collectors.toList());
        Screen.until("the story of " + story.x() + ", " + story.y() + " is shown", () -> {
            JTree tree = tree();
            if (tree == null || tree.getRowCount() != open.size()) {
                return false;
            }
            for (int i = 0; i < open.size(); i++) {
                if (!tree.getPathForRow(i).getLastPathComponent().toString().equals(open.get(i))) {
                    return false;
                }
            }
            return true;
        });
    }

    /** Waits until the picture is where it stays, beside the pane. */
    private static void untilPaneIsLaidOut(OpenWindow window) {
        Screen.until("the pane is laid out", () -> tree().getWidth() > 0 && window.picture().getWidth() < window.frame.getWidth() - PANE);
    }

    /** Takes the mouse off the picture, but not off its component. */
    private void parkMouse(OpenWindow window) {
        move(window, new Point(-20, -20));
    }

    private void move(OpenWindow window, Point pixel) {
        Point place = window.onScreen(pixel);
        robot.mouseMove(place.x, place.y);
    }

    private void click(OpenWindow window, Point pixel) {
        move(window, pixel);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }
}
