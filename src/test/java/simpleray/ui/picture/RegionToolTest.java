package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.AWTException;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import simpleray.math.Ray;
import simpleray.render.Region;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

/** A region of the picture, drawn with the mouse, that is rendered first or alone. */
class RegionToolTest {
    private static final int SIDE = 240;
    private static final Region REGION = new Region(130, 150, 61, 41);

    private final TestScenes.Gate gate = new TestScenes.Gate(1, SIDE);
    private final TestScenes.Gate second = new TestScenes.Gate(1, SIDE);
    private OpenWindow window;

    @AfterEach
    void close() {
        gate.open();
        second.open();
        window.close();
    }

    @WindowTest
    void shiftAndADragRenderTheRegionFirst() throws AWTException {
        AtomicReference<Consumer<Ray>> hurdle = new AtomicReference<>(gate);
        window = new OpenWindow(TestScenes.watched(TestScenes.THESIS, ray -> hurdle.get().accept(ray)), SIDE, SIDE);
        Screen.until("it renders", () -> window.picture().job().runs().isCoarse());
        draw(REGION);
        Screen.until("the region is set", () -> REGION.equals(window.picture().regions().region()));
        hurdle.set(ray -> {
            double x = (ray.direction.x / -ray.direction.z + 1) / 2 * SIDE;
            double y = (ray.direction.y / ray.direction.z + 1) / 2 * SIDE;
            boolean inside = x > REGION.x() && x < REGION.right() && y > REGION.y() && y < REGION.bottom();
            if (!inside) {
                second.accept(ray);
            }
        });
        gate.open();                                          // of the rendering before

        BufferedImage whole = TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE);
        Screen.until("the region is there, and of the rest only blocks", () -> window.picture().job().snapshot().region() != null
            && showsRegion(whole) && window.picture().job().snapshot().progress() != null
            && window.picture().job().snapshot().progress().finished() == 0);
        second.open();
        window.untilState(RenderJob.State.FINISHED);
        OpenWindow.run(() -> window.picture().regions().set(null));
        window.untilShown("the whole", whole);
        assertThat(window.canDo("Save Picture As…")).isTrue();
    }

    @WindowTest
    void aFinishedPictureHasTheRegionAlready() throws AWTException {
        gate.open();
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
        RenderJob job = window.job();
        draw(REGION);
        Screen.until("the region is set", () -> REGION.equals(window.picture().regions().region()));

        assertThat(window.job()).isSameAs(job);
    }

    @WindowTest
    void regionOnlyRendersItAloneAndEscapeBringsTheRest() throws AWTException {
        gate.open();
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
        window.screen.press(KeyEvent.VK_G);
        assertThat(OpenWindow.ask(window.item("Region Only")::isSelected)).isTrue();
        draw(REGION);
        Screen.until("the region is set", () -> REGION.equals(window.picture().regions().region()));

        window.untilState(RenderJob.State.FINISHED);
        assertThat(window.job().snapshot().isAlone()).isTrue();
        assertThat(window.status()).startsWith("Finished: 2,501 rays");
        assertThat(window.job().snapshot().picture().row(REGION.y())).isNull();
        assertThat(window.canDo("Save Picture As…")).isFalse();

        window.screen.press(KeyEvent.VK_ESCAPE);
        Screen.until("there is no region", () -> window.picture().regions().region() == null);
        window.untilState(RenderJob.State.FINISHED);
        window.untilShown("the whole", TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE));
        assertThat(window.canDo("Save Picture As…")).isTrue();
    }

    @WindowTest
    void aDragIsClampedToThePictureAndEscapeGivesItUp() throws AWTException {
        gate.open();
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
        RenderJob before = window.job();
        Robot robot = new Robot();
        Point corner = corner();
        robot.keyPress(KeyEvent.VK_SHIFT);
        robot.mouseMove(corner.x + 200, corner.y + 200);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseMove(corner.x + 210, corner.y + 230);
        robot.keyRelease(KeyEvent.VK_SHIFT);
        window.screen.press(KeyEvent.VK_ESCAPE);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        OpenWindow.run(() -> assertThat(window.picture().regions().region()).isNull());
        assertThat(window.job()).isSameAs(before);

        drag(robot, corner, new Point(200, 220), new Point(SIDE + 30, SIDE + 10));
        Screen.until("the region ends with the picture", () -> new Region(200, 220, 40, 20).equals(window.picture().regions().region()));
        drag(robot, corner, new Point(100, 100), new Point(100, 100));
        Screen.until("a click lets go of it", () -> window.picture().regions().region() == null);
    }

    @WindowTest
    void theNumbersOfARegionMayBeTyped() {
        gate.open();
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
        window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_G);
        Screen.until("a dialog asks", () -> OpenWindow.seen(JTextField.class, field -> field.isFocusOwner()) != null);
        JTextField field = OpenWindow.ask(() -> OpenWindow.seen(JTextField.class, JTextField::isFocusOwner));
        OpenWindow.run(() -> field.setText("10,20,30,40"));
        window.screen.press(KeyEvent.VK_ENTER);
        Screen.until("the region is set", () -> new Region(10, 20, 30, 40).equals(window.picture().regions().region()));
        window.untilState(RenderJob.State.FINISHED);
    }

    @WindowTest
    void aPointOfTheComponentIsAPixelOfThePictureOrNone() {
        gate.open();
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
        OpenWindow.run(() -> {
            Rectangle place = window.picture().place();
            assertThat(window.picture().pixelAt(new Point(place.x, place.y))).isEqualTo(new Point(0, 0));
            assertThat(window.picture().pixelAt(new Point(place.x + 7, place.y + SIDE - 1))).isEqualTo(new Point(7, SIDE - 1));
            assertThat(window.picture().pixelAt(new Point(place.x - 1, place.y))).isNull();
            assertThat(window.picture().pixelAt(new Point(place.x, place.y + SIDE))).isNull();
            window.picture().setZoom(Zoom.FIT, null);
        });
        Screen.until("it is fitted", () -> window.picture().place().height == window.picture().getHeight());
        OpenWindow.run(() -> {
            Rectangle place = window.picture().place();
            assertThat(window.picture().pixelAt(new Point(place.x + place.width - 1, place.y + place.height - 1)))
                .isEqualTo(new Point(SIDE - 1, SIDE - 1));
        });
    }

    private boolean showsRegion(BufferedImage whole) {
        BufferedImage there = window.picture().painted();
        for (int y = REGION.y(); y < REGION.bottom(); y++) {
            for (int x = REGION.x(); x < REGION.right(); x++) {
                if (there.getRGB(x, y) != whole.getRGB(x, y)) {
                    return false;
                }
            }
        }
        return true;
    }

    private void draw(Region region) throws AWTException {
        drag(new Robot(), corner(), new Point(region.x(), region.y()), new Point(region.right() - 1, region.bottom() - 1));
    }

    private static void drag(Robot robot, Point corner, Point from, Point to) {
        robot.keyPress(KeyEvent.VK_SHIFT);
        robot.mouseMove(corner.x + from.x, corner.y + from.y);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseMove(corner.x + (from.x + to.x) / 2, corner.y + (from.y + to.y) / 2);
        robot.mouseMove(corner.x + to.x, corner.y + to.y);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        robot.keyRelease(KeyEvent.VK_SHIFT);
    }

    private Point corner() {
        Screen.until("the picture has its place", () -> window.picture().isShowing() && !window.picture().place().isEmpty());
        return window.onScreen(new Point());
    }
}
