package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JTree;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.image.Picture;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.ui.Mouse;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

/** The camera, moved by mouse and keys. The wall it looks at is 3 units away, half of what it shows there is 3 high, in 60 pixels. */
class CameraToolTest {
    private static final int WIDTH = 90;
    private static final int HEIGHT = 60;
    private static final Offset<Double> ROUNDING = within(1e-9);
    private static final Point MIDDLE = new Point(45, 30);

    private OpenWindow window;
    private Mouse mouse;
    private BufferedImage own;

    @BeforeEach
    void finishThePicture(@TempDir Path folder) {
        // a wall at z = -1 that gets lighter to the right: a lamp is there
        Path scene = TestScenes.write(folder.resolve("wall.scene"), "1\n1 0 0 1 -1\n"
            + "0.5 0.5 0.5 0.9 0.7 0.4 0 0 0 1\n0.3 0.3 0.3\n1\n0 1 1 1 3 2 1\n");
        window = new OpenWindow(SceneSource.file(scene), WIDTH, HEIGHT);
        window.untilState(RenderJob.State.FINISHED);
        own = TestScenes.rendered(scene, WIDTH, HEIGHT);
        window.untilShown("the scene's own view", own);
        window.untilProblems("clipped");                      // its pane moves the picture
        mouse = new Mouse(window.picture());
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void draggingOrbitsRoundWhatTheMiddleShowsByHalfATurnAcrossThePicture() {
        drag(InputEvent.BUTTON1_DOWN_MASK, -WIDTH / 6, 0);

        assertPose(new Pose(1.5, 0, -1 + 3 * Math.cos(Math.PI / 6), 0, 0, -1, 90));
        assertThat(rendered()).isNotNull();
    }

    @WindowTest
    void draggingDownGoesUp() {
        drag(InputEvent.BUTTON1_DOWN_MASK, 0, WIDTH / 6);

        assertPose(new Pose(0, 1.5, -1 + 3 * Math.cos(Math.PI / 6), 0, 0, -1, 90));
    }

    /** The sixty pixels of the picture's height are six units at the wall. */
    @WindowTest
    void theMiddleButtonPansAndTheWallStaysUnderTheMouse() {
        drag(InputEvent.BUTTON2_DOWN_MASK, 20, -10);

        assertPose(new Pose(-2, -1, 2, -2, -1, -1, 90));
        BufferedImage moved = rendered();
        assertThat(moved.getRGB(45 + 20, 30 - 10)).isEqualTo(own.getRGB(45, 30));
    }

    @WindowTest
    void theLeftButtonPansWhileSpaceIsHeldAndOrbitsAgainAfterwards() {
        mouse.holding(KeyEvent.VK_SPACE, () -> drag(InputEvent.BUTTON1_DOWN_MASK, 20, -10));
        assertPose(new Pose(-2, -1, 2, -2, -1, -1, 90));

        drag(InputEvent.BUTTON1_DOWN_MASK, -WIDTH / 6, 0);
        assertPose(new Pose(-0.5, -1, -1 + 3 * Math.cos(Math.PI / 6), -2, -1, -1, 90));
    }

    @WindowTest
    void theWheelGoesNearerAndBack() {
        mouse.move(at(MIDDLE));
        mouse.wheel(-1);
        assertPose(new Pose(0, 0, -1 + 2.7, 0, 0, -1, 90));
        mouse.wheel(1);
        mouse.wheel(1);
        assertPose(new Pose(0, 0, -1 + 3 / 0.9, 0, 0, -1, 90));
    }

    /** The pixel at 75 shows the wall 3 units to the right of the middle. */
    @WindowTest
    void theWheelGoesNearerToWhatIsUnderTheMouse() {
        mouse.move(at(new Point(75, 30)));
        mouse.wheel(-1);

        assertPose(new Pose(0.3, 0, -1 + 2.7, 0.3, 0, -1, 90));
    }

    @WindowTest
    void theWheelScrollsAPictureThatIsLargerThanItsPaneAndZoomsIfThatIsWanted() {
        OpenWindow.run(() -> window.picture().setZoom(new Zoom(false, 16), null));
        Screen.until("it is larger", () -> window.picture().overflows());
        int before = OpenWindow.ask(() -> window.scroll().getViewport().getViewPosition().y);
        Rectangle seen = OpenWindow.ask(() -> window.picture().getVisibleRect());
        mouse.move(new Point(seen.x + seen.width / 2, seen.y + seen.height / 2));
        mouse.wheel(1);
        Screen.until("it is scrolled", () -> window.scroll().getViewport().getViewPosition().y > before);
        assertThat(pose()).isNull();

        OpenWindow.run(() -> window.item("Wheel Zooms").doClick(0));
        mouse.wheel(1);
        Screen.until("it is smaller", () -> window.picture().zoom().scale() < 16);
        assertThat(pose()).isNull();
    }

    @WindowTest
    void theEyeStopsBeforeTheWall() {
        drag(InputEvent.BUTTON1_DOWN_MASK, -WIDTH / 2 + 5, 0);
        drag(InputEvent.BUTTON1_DOWN_MASK, -WIDTH / 3, 0);
        Screen.until("it is moved", () -> pose() != null);
        window.untilState(RenderJob.State.FINISHED);

        assertThat(pose().ez()).isGreaterThan(-1);
    }

    @WindowTest
    void stepsAreTakenBackAndTakenAgainAndADragIsOne() {
        drag(InputEvent.BUTTON1_DOWN_MASK, -WIDTH / 6, 0);
        Pose dragged = new Pose(1.5, 0, -1 + 3 * Math.cos(Math.PI / 6), 0, 0, -1, 90);
        assertPose(dragged);
        window.screen.press(KeyEvent.VK_HOME);
        Screen.until("it is back", () -> pose() == null);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        assertPose(dragged);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        Screen.until("it is back", () -> pose() == null);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
        assertPose(dragged);
        window.untilState(RenderJob.State.FINISHED);
    }

    @WindowTest
    void homeAndAStageShowAFinishedPictureAgainAndRenderNone() {
        Picture first = OpenWindow.ask(() -> window.picture().whole());
        window.screen.press(KeyEvent.VK_PAGE_UP);
        assertPose(new Pose(0, 0, -1 + 2.7, 0, 0, -1, 90));
        assertThat(rendered()).isNotNull();
        window.screen.press(KeyEvent.VK_HOME);
        assertThat(OpenWindow.ask(() -> window.picture().whole())).isSameAs(first);
        window.untilShown("the scene's own view", own);

        window.screen.press(KeyEvent.VK_1);
        window.untilState(RenderJob.State.FINISHED);
        assertThat(OpenWindow.ask(() -> window.picture().whole())).isNotSameAs(first);
        window.screen.press(KeyEvent.VK_3);
        assertThat(OpenWindow.ask(() -> window.picture().whole())).isSameAs(first);
        assertThat(window.status()).startsWith("Finished: 5,400 rays");
    }

    @WindowTest
    void theLineAtTheFootTellsTheGesturesAndThenHowToGoBack() {
        assertThat(window.label("gestures")).contains("Drag: orbit");
        drag(InputEvent.BUTTON1_DOWN_MASK, -WIDTH / 6, 0);
        Screen.until("it says so", () -> window.label("gestures").equals("Camera moved:"));
        JButton home = OpenWindow.appears("the button", JButton.class, button -> "Home".equals(button.getText()));
        window.screen.click(home);

        Screen.until("it is back", () -> pose() == null && !home.isShowing());
        assertThat(window.label("gestures")).isBlank();
        window.untilState(RenderJob.State.FINISHED);
    }

    @WindowTest
    void inANarrowPaneTheLineHasWholeGesturesAndATipWithAll() {
        String all = window.label("gestures");
        JLabel line = OpenWindow.appears("the line", JLabel.class, label -> "gestures".equals(label.getName()));
        assertThat(OpenWindow.ask(() -> line.getToolTipText())).isNull();
        OpenWindow.run(() -> window.frame.setSize(340, 500));
        Screen.until("it is shorter", () -> line.getText().length() < all.length());

        List<String> gestures = List.of(all.split(" {3}"));
        assertThat(window.label("gestures").split(" {3}")).hasSizeGreaterThan(1).isSubsetOf(gestures).endsWith("F1: help");
        assertThat(OpenWindow.ask(() -> line.getToolTipText())).isEqualTo(all);
        assertThat(OpenWindow.ask(() -> line.getX() + line.getPreferredSize().width <= line.getParent().getWidth())).isTrue();
        OpenWindow.run(() -> window.frame.setSize(900, 500));
        Screen.until("all are told again", () -> line.getText().equals(all) && line.getToolTipText() == null);
    }

    @WindowTest
    void aClickAndTheButtonsOfOthersMoveNothing() {
        drag(InputEvent.BUTTON1_DOWN_MASK, 3, 2);
        OpenWindow.appears("the story of the pixel that was clicked", JTree.class, tree -> "story".equals(tree.getName()));
        drag(InputEvent.BUTTON3_DOWN_MASK, 30, 0);
        window.screen.press(KeyEvent.VK_ESCAPE);              // closes the menu of that pixel
        mouse.holding(KeyEvent.VK_SHIFT, () -> drag(InputEvent.BUTTON1_DOWN_MASK, 30, 0));
        mouse.holding(KeyEvent.VK_CONTROL, () -> drag(InputEvent.BUTTON1_DOWN_MASK, 30, 0));

        assertThat(pose()).isNull();
    }

    @ParameterizedTest
    @CsvSource({"RIGHT, 5, 0", "LEFT, -5, 0", "UP, 0, 5", "DOWN, 0, -5"})
    void arrowsOrbitByFiveDegrees(String key, double right, double up) {
        window.screen.press(code(key));

        double r = Math.toRadians(right);
        double u = Math.toRadians(up);
        assertPose(new Pose(3 * Math.sin(r) * Math.cos(u), 3 * Math.sin(u), -1 + 3 * Math.cos(r) * Math.cos(u), 0, 0, -1, 90));
    }

    /** A twentieth of the six units. */
    @ParameterizedTest
    @CsvSource({"RIGHT, 0.3, 0", "LEFT, -0.3, 0", "UP, 0, 0.3", "DOWN, 0, -0.3"})
    void arrowsWithShiftPan(String key, double dx, double dy) {
        window.screen.press(KeyEvent.VK_SHIFT, code(key));

        assertPose(new Pose(dx, dy, 2, dx, dy, -1, 90));
    }

    @WindowTest
    void pageUpAndPageDownGoNearerAndBack() {
        window.screen.press(KeyEvent.VK_PAGE_UP);
        assertPose(new Pose(0, 0, -1 + 2.7, 0, 0, -1, 90));
        window.screen.press(KeyEvent.VK_PAGE_DOWN);
        assertPose(new Pose(0, 0, 2, 0, 0, -1, 90));
    }

    @WindowTest
    void homeBringsBackExactlyTheScenesOwnPicture() {
        drag(InputEvent.BUTTON1_DOWN_MASK, -40, 20);
        assertThat(rendered()).isNotNull();
        window.screen.press(KeyEvent.VK_HOME);

        assertThat(pose()).isNull();
        window.untilShown("the scene's own view", own);
        window.untilState(RenderJob.State.FINISHED);
    }

    /** The moves come faster than pictures; the last is the one that stays. */
    @WindowTest
    void theLastOfManyMovesIsRenderedToItsEnd() {
        OpenWindow.run(() -> {
            for (int i = 0; i < 16; i++) {
                window.item("Orbit Right").doClick(0);
            }
        });

        double r = Math.toRadians(80);
        Screen.until("the last move is rendered", () -> window.picture().request().settings().camera != null
            && Math.abs(window.picture().request().settings().camera.ez() - (-1 + 3 * Math.cos(r))) < 1e-9);
        assertThat(rendered()).isNotNull();
    }

    @WindowTest
    void anotherStageKeepsTheCameraAndAnotherSceneHasItsOwn(@TempDir Path folder) {
        window.screen.press(KeyEvent.VK_PAGE_UP);
        Screen.until("it is moved", () -> pose() != null);
        window.screen.press(KeyEvent.VK_2);
        assertPose(new Pose(0, 0, -1 + 2.7, 0, 0, -1, 90));

        Path other = TestScenes.plain(folder.resolve("other.scene"), 0, 0, 1);
        OpenWindow.run(() -> window.open(SceneSource.file(other)));
        assertThat(pose()).isNull();
        window.untilState(RenderJob.State.FINISHED);
    }

    private void drag(int button, int right, int down) {
        mouse.drag(button, at(MIDDLE), at(new Point(MIDDLE.x + right, MIDDLE.y + down)));
    }

    /** {@return a point of the component for one of the picture, wherever that is by now} */
    private Point at(Point inPicture) {
        Point corner = OpenWindow.ask(() -> window.picture().place().getLocation());
        return new Point(corner.x + inPicture.x, corner.y + inPicture.y);
    }

    private static int code(String arrow) {
        return switch (arrow) {
            case "LEFT" -> KeyEvent.VK_LEFT;
            case "RIGHT" -> KeyEvent.VK_RIGHT;
            case "UP" -> KeyEvent.VK_UP;
            default -> KeyEvent.VK_DOWN;
        };
    }

    /** {@return the camera that is asked for in place of the scene's own; null for none} */
    private Pose pose() {
        return OpenWindow.ask(() -> window.picture().request().settings().camera);
    }

    /** {@return the picture, once it is the whole one of the camera that is asked for, and on the screen} */
    private BufferedImage rendered() {
        window.untilState(RenderJob.State.FINISHED);
        BufferedImage expected = OpenWindow.ask(() -> TestScenes.shown(window.picture().whole()));
        window.untilShown("the moved view", expected);
        assertThat(TestScenes.sameAs(expected, own)).isFalse();
        return expected;
    }

    private void assertPose(Pose expected) {
        Screen.until("the move is rendered", () -> close(window.picture().request().settings().camera, expected));
        Pose actual = pose();
        assertThat(actual.lx()).isCloseTo(expected.lx(), ROUNDING);
        assertThat(actual.fov()).isCloseTo(expected.fov(), ROUNDING);
    }

    private static boolean close(Pose a, Pose b) {
        return a != null && Math.abs(a.ex() - b.ex()) + Math.abs(a.ey() - b.ey()) + Math.abs(a.ez() - b.ez()) + Math.abs(a.lx() - b.lx())
            + Math.abs(a.ly() - b.ly()) + Math.abs(a.lz() - b.lz()) < 1e-9;
    }
}
