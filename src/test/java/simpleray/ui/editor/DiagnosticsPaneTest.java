package simpleray.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.render.Stage;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** Scenes that change on the disk, and scenes with errors. */
class DiagnosticsPaneTest {
    private static final int SIDE = 64;
    private static final String BAD = "1\n1  0 0 1 -1  0.2 0.4 oops  0 0 0  0 0 0  0\n1 1 1\n0\n";
    private static final String ODD = "1\nWALL\n1  0 0 1 -1  0.2 0.4 0.6  0 0 0  0 0 0  0\n1 1 1\n0\n";

    @TempDir
    private Path folder;
    private Path scene;
    private OpenWindow window;

    @BeforeEach
    void nameTheScene() {
        scene = folder.resolve("room.scene");
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void f5ShowsTheSceneAsItIsNow() {
        openGoodScene();
        TestScenes.plain(scene, 1, 0.5, 0);
        window.screen.press(KeyEvent.VK_F5);

        window.untilShown("the new picture", TestScenes.rendered(scene, SIDE, SIDE));
    }

    @WindowTest
    void anErrorIsShownWithItsPlaceAndTheLastGoodPictureStays() {
        BufferedImage good = openGoodScene();
        TestScenes.write(scene, BAD);
        window.screen.press(KeyEvent.VK_F5);

        untilTold();
        assertThat(window.problems().getText()).isEqualTo(scene + ":2:22: error: expected object 1's ambient blue, found 'oops'\n"
            + "1  0 0 1 -1  0.2 0.4 oops  0 0 0  0 0 0  0\n" + " ".repeat(21) + "^");
        window.untilShown("the good picture", good);
    }

    @WindowTest
    void theErrorGoesOnceTheSceneIsRepaired() {
        openGoodScene();
        TestScenes.write(scene, BAD);
        window.screen.press(KeyEvent.VK_F5);
        window.untilState(RenderJob.State.FAILED);
        TestScenes.plain(scene, 0, 0, 1);
        window.screen.press(KeyEvent.VK_F5);

        window.untilShown("the new picture", TestScenes.rendered(scene, SIDE, SIDE));
        Screen.until("the error is gone", () -> window.problems() == null);
    }

    @WindowTest
    void keysWorkWhileTheTextOfAnErrorHasThem() {
        TestScenes.write(scene, BAD);
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);
        window.untilState(RenderJob.State.FAILED);
        window.screen.click(window.problems());
        Screen.until("the text has the keys", window.problems()::isFocusOwner);
        TestScenes.plain(scene, 0, 1, 0);
        window.screen.press(KeyEvent.VK_2);

        window.untilShown("the stage", TestScenes.rendered(scene, SIDE, SIDE, Stage.LIGHTING));
    }

    @WindowTest
    void theMeshesOfASceneAreProtectedWhileItHasAnError() {
        Path mesh = TestScenes.write(folder.resolve("mesh.png"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        String good = "1\n4 \"mesh.png\" 0 0 0 1  1 0 0  0 0 0  0 0 0  0\n1 1 1\n0\n";
        TestScenes.write(scene, good);
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
        TestScenes.write(scene, good.replace("1 1 1", "1 oops 1"));
        window.screen.press(KeyEvent.VK_F5);
        window.untilState(RenderJob.State.FAILED);

        assertThat(OpenWindow.ask(() -> window.job().reads(mesh))).isTrue();
        assertThat(OpenWindow.ask(() -> window.job().reads(folder.resolve("other.png")))).isFalse();
    }

    @WindowTest
    void anErrorInTheFirstSceneIsShown() {
        TestScenes.write(scene, BAD);
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);

        window.untilState(RenderJob.State.FAILED);
        assertThat(window.problems().getText()).startsWith(scene + ":2:22: error: ");
        assertThat(window.canDo("Save Picture As…")).isFalse();
        assertThat(window.canDo("Reload")).isTrue();
    }

    @WindowTest
    void aFirstSceneThatIsMissingIsTold() {
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);

        window.untilState(RenderJob.State.FAILED);
        assertThat(window.problems().getText()).isEqualTo(scene + ": no such file");
    }

    @WindowTest
    void aWarningIsShownBesideThePicture() {
        TestScenes.write(scene, ODD);
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);

        window.untilShown("the picture", TestScenes.rendered(scene, SIDE, SIDE));
        assertThat(window.problems().getText()).startsWith(scene + ":2:1: warning: ");
    }

    @WindowTest
    void anErrorThatIsKnownBeforeTheWindowShrinksIsInSight() {
        TestScenes.write(scene, BAD);
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE, frame -> {
            try {
                frame.frame().setSize(frame.frame().getWidth(), 800);
                frame.picture().job().await();
                frame.picture().run();
                frame.frame().setSize(frame.frame().getWidth(), 400);
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        });

        Screen.until("the problems are in sight", () -> window.problems().getVisibleRect().height > 0);
    }

    @WindowTest
    void aWarningThatIsKnownBeforeAnythingIsLaidOutLeavesRoomForThePicture() {
        TestScenes.write(scene, ODD);
        window = new OpenWindow(SceneSource.file(scene), 2 * SIDE, 2 * SIDE, frame -> {
            try {
                frame.picture().job().await();
                frame.picture().run();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        });

        window.untilShown("the picture", TestScenes.rendered(scene, 2 * SIDE, 2 * SIDE));
    }

    /** Waits until errors are shown: those of a file that was found changed are, once it does not change any more. */
    private void untilTold() {
        Screen.until("the errors are shown", () -> window.problems() != null && window.problems().isShowing()
            && window.status().equals("The scene was not read: see above"));
    }

    private BufferedImage openGoodScene() {
        TestScenes.plain(scene, 0.2, 0.4, 0.6);
        BufferedImage picture = TestScenes.rendered(scene, SIDE, SIDE);
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);
        window.untilShown("the first picture", picture);
        assertThat(window.problems()).isNull();
        return picture;
    }
}
