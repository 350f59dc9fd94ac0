package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.render.RenderRequest;
import simpleray.scene.ParallelCamera.View;
import simpleray.scene.SceneSettings;
import simpleray.ui.Mouse;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

/** A camera of parallel rays, moved by mouse and keys. The sixty pixels of its picture's height are six units, and z is up. */
class ParallelCameraToolTest {
    private static final String SCENE = "1\n0 0 0 0 1  0.5 0.5 0.5 0.9 0.7 0.4 0 0 0 1\n0.3 0.3 0.3\n1\n0 1 1 1 3 -5 4\n"
        + "parallel 0 -5 0 0 0 0 6\nup 0 0 2\n";

    private Path scene;
    private OpenWindow window;
    private BufferedImage own;

    @BeforeEach
    void finishThePicture(@TempDir Path folder) {
        scene = TestScenes.write(folder.resolve("ball.scene"), SCENE);
        window = new OpenWindow(SceneSource.file(scene), 90, 60);
        window.untilState(RenderJob.State.FINISHED);
        SceneSettings size = new SceneSettings();
        size.resolution = new SceneSettings.Resolution(90, 60);
        own = TestScenes.rendered(scene, new RenderRequest().with(size));
        window.untilShown("the scene's own view", own);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void aDragOrbitsRoundUpAndHomeBringsTheScenesOwnViewBack() {
        drag(InputEvent.BUTTON1_DOWN_MASK, -45, 0);
        assertView(5, 0, 0, 0, 0, 0, 6);
        assertThat(OpenWindow.ask(() -> window.picture().request().settings()).up).hasToString("[0.0,0.0,2.0]");

        window.screen.press(KeyEvent.VK_HOME);
        Screen.until("no other camera is asked for", () -> !window.picture().request().settings().hasCamera());
        window.untilShown("the scene's own view", own);
    }

    @WindowTest
    void theWheelChangesTheHeightAndNotThePlace() {
        Mouse mouse = new Mouse(window.picture());
        mouse.move(at(45, 30));
        mouse.wheel(-1);
        assertView(0, -5, 0, 0, 0, 0, 5.4);
        mouse.wheel(1);
        mouse.wheel(1);
        assertView(0, -5, 0, 0, -1, 0, 6 / 0.9);         // what is in the middle is the pivot by now
    }

    @WindowTest
    void theMiddleButtonPansByWhatIsUnderTheMouse() {
        drag(InputEvent.BUTTON2_DOWN_MASK, 20, -10);

        assertView(-2, -5, -1, -2, 0, -1, 6);
    }

    @WindowTest
    void anotherStageKeepsItAndTheViewIsSavedAsItIs() throws IOException {
        window.screen.press(KeyEvent.VK_PAGE_UP);
        assertView(0, -5, 0, 0, 0, 0, 5.4);
        window.screen.press(KeyEvent.VK_2);
        assertView(0, -5, 0, 0, 0, 0, 5.4);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_C);
        Screen.until("it is copied", () -> window.status().startsWith("Copied: parallel 0 -5 0 0 0 0 5.4"));
        assertThat(window.status()).endsWith("; up 0 0 2");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_V);
        Screen.until("it is saved", () -> !window.picture().request().settings().hasCamera());

        assertThat(Files.readString(scene)).startsWith(SCENE.replace("0 6\nup 0 0 2\n", "0 5.4")).endsWith("\nup 0 0 2\n").hasLineCount(7);
    }

    private void drag(int button, int right, int down) {
        new Mouse(window.picture()).drag(button, at(45, 30), at(45 + right, 30 + down));
    }

    /** {@return a point of the component for one of the picture, wherever that is by now} */
    private Point at(int x, int y) {
        Point corner = OpenWindow.ask(() -> window.picture().place().getLocation());
        return new Point(corner.x + x, corner.y + y);
    }

    private void assertView(double... n) {
        Screen.until("the move is asked for", () -> {
            SceneSettings asked = window.picture().request().settings();
            View v = asked.parallel;
            return asked.camera == null && v != null && Math.abs(v.ex() - n[0]) + Math.abs(v.ey() - n[1]) + Math.abs(v.ez() - n[2])
                + Math.abs(v.lx() - n[3]) + Math.abs(v.ly() - n[4]) + Math.abs(v.lz() - n[5]) + Math.abs(v.height() - n[6]) < 1e-9;
        });
        window.untilState(RenderJob.State.FINISHED);
    }
}
