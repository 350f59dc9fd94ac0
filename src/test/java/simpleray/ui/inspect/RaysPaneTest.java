package simpleray.ui.inspect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JSplitPane;
import javax.swing.JTree;
import simpleray.rays.RayDrawing;
import simpleray.rays.RaySegment;
import simpleray.rays.RaySegment.Kind;
import simpleray.render.Explainer;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SimpleCamera;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.widget.SidePanes;

/** The rays of a pixel in the window, with the mouse and with keys. */
class RaysPaneTest {
    private static final int WIDTH = 90;
    private static final int HEIGHT = 60;

    private final Robot robot;

    RaysPaneTest() throws AWTException {
        robot = new Robot();
    }

    @WindowTest
    void theRaysOfTheStorysPixelAreShownBesideThePictureAndGoAway() throws Exception {
        try (OpenWindow window = finished()) {
            click(window, new Point(45, 36));
            Screen.until("the story is there", () -> tree() != null);
            window.screen.press(KeyEvent.VK_V);
            untilRays(45, 36);
            assertThat(label("ray")).isEqualTo(segments(45, 36).size() + " rays");
            assertThat(OpenWindow.ask(() -> tree() != null)).isTrue();
            assertThat(OpenWindow.ask(() -> window.scroll().getWidth() / (double) window.frame.getWidth())).isGreaterThan(0.4);
            assertThat(OpenWindow.threads()).contains("simpleray-rays");

            window.screen.press(KeyEvent.VK_V);
            Screen.until("the rays are gone", () -> view() == null && tree() != null);
            window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_I);
            Screen.until("the story is gone", () -> tree() == null);
        }
        assertThat(OpenWindow.threads()).isEmpty();
    }

    @WindowTest
    void anIdleWindowPreparesItsFirstRaysAndShowsNoneOfThem() throws Exception {
        try (OpenWindow window = finished()) {
            Screen.until("they are prepared", () -> OpenWindow.threads().contains("simpleray-rays"));
            assertThat(OpenWindow.ask(() -> view())).isNull();
            window.screen.press(KeyEvent.VK_V);
            untilRays(WIDTH / 2, HEIGHT / 2);
            assertThat(label("ray")).isEqualTo(segments(WIDTH / 2, HEIGHT / 2).size() + " rays");
        }
        assertThat(OpenWindow.threads()).isEmpty();
    }

    @WindowTest
    void nextAndBackWalkTheRecursionAndTheStoryFollows() throws Exception {
        try (OpenWindow window = finished()) {
            Point pixel = mirrored();
            click(window, pixel);
            window.screen.press(KeyEvent.VK_V);
            untilRays(pixel.x, pixel.y);
            List<RaySegment> segments = segments(pixel.x, pixel.y);
            assertThat(segments).hasSizeGreaterThan(3);
            for (int i = 0; i < segments.size(); i++) {
                window.screen.press(KeyEvent.VK_PERIOD);
                untilRay(i, segments);
            }
            window.screen.press(KeyEvent.VK_PERIOD);
            untilRay(segments.size() - 1, segments);
            window.screen.press(KeyEvent.VK_COMMA);
            untilRay(segments.size() - 2, segments);
            window.screen.click(OpenWindow.appears("Back", JButton.class, button -> "Back".equals(button.getText())));
            untilRay(segments.size() - 3, segments);
        }
    }

    @WindowTest
    void aLineOfTheStoryChoosesItsRay() throws Exception {
        try (OpenWindow window = finished()) {
            Point pixel = mirrored();
            click(window, pixel);
            window.screen.press(KeyEvent.VK_V);
            untilRays(pixel.x, pixel.y);
            JTree tree = OpenWindow.ask(RaysPaneTest::tree);
            int row = OpenWindow.ask(() -> row(tree, "light 1 "));
            window.screen.click(tree, () -> {
                tree.scrollRowToVisible(row);
                Rectangle place = tree.getRowBounds(row);
                return new Point(place.x + 10, (int) place.getCenterY());
            });
            Screen.until("its ray is chosen", () -> label("ray").endsWith(", light 1"));
        }
    }

    @WindowTest
    void aClickOnARayChoosesItAndItsLine() throws Exception {
        try (OpenWindow window = finished()) {
            Point pixel = mirrored();
            click(window, pixel);
            window.screen.press(KeyEvent.VK_V);
            untilRays(pixel.x, pixel.y);
            RaysView view = OpenWindow.ask(RaysPaneTest::view);
            Point on = OpenWindow.ask(() -> on(view, Kind.MIRROR));
            window.screen.click(view, () -> new Point(on));
            Screen.until("the ray is chosen", () -> label("ray").contains("mirror ray"));
            Screen.until("so is its line", () -> selected().startsWith("Mirror ray: ") && tree().getSelectionPath().getPathCount() == 3);
        }
    }

    @WindowTest
    void theMouseGoesRoundTheRaysAndHomeBringsThemBack() throws Exception {
        try (OpenWindow window = finished()) {
            click(window, new Point(45, 36));
            window.screen.press(KeyEvent.VK_V);
            untilRays(45, 36);
            RaysView view = OpenWindow.ask(RaysPaneTest::view);
            Pose first = OpenWindow.ask(view::pose);
            double away = distance(first);
            drag(view, InputEvent.BUTTON1_DOWN_MASK);
            Screen.until("it turned", () -> !view.pose().equals(first) && view.pose().lx() == first.lx());
            assertThat(distance(OpenWindow.ask(view::pose))).isCloseTo(away, within(1e-9));
            Pose turned = OpenWindow.ask(view::pose);
            drag(view, InputEvent.BUTTON3_DOWN_MASK);
            Screen.until("it went aside", () -> view.pose().lx() != turned.lx());
            robot.mouseWheel(-2);
            Screen.until("it is nearer", () -> distance(view.pose()) < 0.82 * away);
            window.screen.press(KeyEvent.VK_HOME);
            Screen.until("it is back", () -> view.pose().equals(first));
            assertThat(OpenWindow.ask(() -> window.picture().request().settings().hasCamera())).isFalse();
        }
    }

    @WindowTest
    void anotherWidthFramesTheRaysAnewUntilTheEyeIsMoved() throws Exception {
        try (OpenWindow window = finished()) {
            window.screen.press(KeyEvent.VK_V);
            untilRays(WIDTH / 2, HEIGHT / 2);
            RaysView view = OpenWindow.ask(RaysPaneTest::view);
            Pose first = OpenWindow.ask(view::pose);
            JSplitPane sides = OpenWindow.ask(() -> OpenWindow.seen(JSplitPane.class, pane -> pane instanceof SidePanes));
            int wide = OpenWindow.ask(view::getWidth);
            RayDrawing before = OpenWindow.ask(view::drawing);
            OpenWindow.run(() -> sides.setDividerLocation(sides.getWidth() - 370));
            Screen.until("all of them are seen from farther away", () -> view.getWidth() < wide
                && distance(view.pose()) > 1.2 * distance(first) && view.drawing() != before);
            Point corner = OpenWindow.ask(view::getLocationOnScreen);
            robot.mouseMove(corner.x + 50, corner.y + 100);
            Pose narrow = OpenWindow.ask(view::pose);
            robot.mouseWheel(-2);
            Screen.until("it is nearer", () -> distance(view.pose()) < 0.9 * distance(narrow));
            Pose moved = OpenWindow.ask(view::pose);
            OpenWindow.run(() -> sides.setDividerLocation(sides.getWidth() - 500));
            Screen.until("the view has another size", () -> view.getWidth() > 400);
            assertThat(OpenWindow.ask(view::pose)).isEqualTo(moved);
        }
    }

    @WindowTest
    void aPixelThatIsDraggedTakesItsRaysAndItsStoryAlong() throws Exception {
        try (OpenWindow window = finished()) {
            click(window, new Point(45, 36));
            Screen.until("its story is there", () -> "Pixel 45, 36".equals(label("story title")));
            window.screen.press(KeyEvent.VK_V);
            untilRays(45, 36);
            mouse(window, new Point(45, 36));
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            move(window, new Point(40, 34));
            untilRays(40, 34);
            move(window, new Point(30, 20));
            untilRays(30, 20);
            Screen.until("the story is that of the pixel", () -> "Pixel 30, 20".equals(label("story title")));
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
            assertThat(OpenWindow.ask(() -> window.picture().request().settings().hasCamera())).isFalse();
        }
    }

    @WindowTest
    void normalsAndHalfwayVectorsAreShownOnRequest() throws Exception {
        try (OpenWindow window = finished()) {
            click(window, new Point(45, 36));
            window.screen.press(KeyEvent.VK_V);
            untilRays(45, 36);
            int rays = OpenWindow.ask(() -> view().segments().size());
            window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_V);
            Screen.until("there are more", () -> view().segments().stream().anyMatch(segment -> segment.kind() == Kind.NORMAL)
                && view().segments().size() > rays);
            window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_V);
            Screen.until("there are as many as before", () -> view().segments().size() == rays);
        }
    }

    private static OpenWindow finished() {
        OpenWindow window = new OpenWindow(SceneSource.file(TestScenes.THESIS), WIDTH, HEIGHT, made -> made.frame().setSize(1100, 800));
        window.untilState(RenderJob.State.FINISHED);
        window.untilShown("the picture", TestScenes.rendered(TestScenes.THESIS, WIDTH, HEIGHT));
        window.untilProblems("lights nothing");               // its pane moves the picture
        return window;
    }

    /** {@return the rays that are expected of a pixel, without vectors} */
    private static List<RaySegment> segments(int x, int y) throws Exception {
        Scene scene = SceneFile.read(TestScenes.THESIS).scene();
        Explainer explainer = new Renderer(scene, new SimpleCamera(WIDTH, HEIGHT), new RenderSettings()).explainer();
        return RaySegment.of(explainer.story(x, y), scene).stream().filter(segment -> !segment.kind().isVector()).toList();
    }

    /** {@return a pixel whose ray is mirrored, with lights that are told} */
    private static Point mirrored() throws Exception {
        for (int y = 0; y < HEIGHT; y += 3) {
            for (int x = 0; x < WIDTH; x += 3) {
                List<RaySegment> segments = segments(x, y);
                if (segments.size() > 4 && segments.size() < 12 && segments.get(1).kind() == Kind.ARRIVING
                    && segments.stream().anyMatch(segment -> segment.kind() == Kind.MIRROR)) {
                    return new Point(x, y);
                }
            }
        }
        throw new AssertionError("no such pixel");
    }

    /** Waits until the rays of a pixel are on the screen, which are those of its story bit for bit. */
    private static void untilRays(int x, int y) throws Exception {
        List<RaySegment> expected = segments(x, y);
        Screen.until("the rays of " + x + ", " + y + " are drawn", () -> view() != null && view().drawing() != null
            && ("Pixel " + x + ", " + y).equals(label("rays title")) && same(view().drawing().segments(), expected));
    }

    private static boolean same(List<RaySegment> some, List<RaySegment> others) {
        boolean same = some.size() == others.size();
        for (int i = 0; same && i < some.size(); i++) {
            RaySegment a = some.get(i);
            RaySegment b = others.get(i);
            same = a.kind() == b.kind() && a.from().equals(b.from()) && a.to().equals(b.to());
        }
        return same;
    }

    private static void untilRay(int index, List<RaySegment> segments) {
        RaySegment segment = segments.get(index);
        String line = segment.lamp() != null ? "light " + segment.lamp().light().number() + " "
            : segment.kind() == Kind.PRIMARY ? "" : "Mirror ray: ";
        Screen.until("ray " + index + " is chosen", () -> label("ray").startsWith(index + 1 + " of " + segments.size() + ": "
            + segment.kind().label()) && selected().startsWith(line) && !selected().startsWith("pixel "));
    }

    private static String selected() {
        return tree().getSelectionPath() == null ? "" : tree().getSelectionPath().getLastPathComponent().toString();
    }

    private static int row(JTree tree, String begin) {
        for (int i = 0; i < tree.getRowCount(); i++) {
            if (tree.getPathForRow(i).getLastPathComponent().toString().startsWith(begin)) {
                return i;
            }
        }
        throw new AssertionError("no line begins with " + begin);
    }

    /** {@return a place where a ray of that kind is the nearest} */
    private static Point on(RaysView view, Kind kind) {
        for (int y = 0; y < view.getHeight(); y += 2) {
            for (int x = 0; x < view.getWidth(); x += 2) {
                RaySegment at = view.drawing().at(x, y, 2);
                if (at != null && at.kind() == kind) {
                    return new Point(x, y);
                }
            }
        }
        throw new AssertionError("no " + kind);
    }

    private static double distance(Pose pose) {
        return Math.hypot(Math.hypot(pose.ex() - pose.lx(), pose.ey() - pose.ly()), pose.ez() - pose.lz());
    }

    private static RaysView view() {
        return OpenWindow.seen(RaysView.class, view -> true);
    }

    private static JTree tree() {
        return OpenWindow.seen(JTree.class, tree -> "story".equals(tree.getName()));
    }

    private static String label(String name) {
        return OpenWindow.ask(() -> {
            JLabel label = OpenWindow.seen(JLabel.class, one -> name.equals(one.getName()));
            return label == null ? "" : label.getText();
        });
    }

    private void drag(Component view, int button) {
        Point corner = OpenWindow.ask(view::getLocationOnScreen);
        robot.mouseMove(corner.x + 200, corner.y + 100);
        robot.mousePress(button);
        robot.mouseMove(corner.x + 220, corner.y + 110);
        robot.mouseMove(corner.x + 240, corner.y + 120);
        robot.mouseRelease(button);
    }

    private void move(OpenWindow window, Point pixel) {
        Point place = window.onScreen(pixel);
        robot.mouseMove(place.x, place.y);
    }

    /** Moves the mouse until it is there, though the picture may be moved meanwhile. */
    private void mouse(OpenWindow window, Point pixel) {
        Screen.until("the mouse is over the pixel", () -> {
            move(window, pixel);
            Point now = window.picture().getMousePosition();
            Rectangle all = window.picture().place();
            return now != null && now.equals(new Point(all.x + pixel.x, all.y + pixel.y));
        });
    }

    private void click(OpenWindow window, Point pixel) {
        move(window, pixel);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }
}
