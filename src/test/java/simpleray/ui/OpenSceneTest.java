package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.cli.Main;

/** File > Open…, through the dialog and by the keyboard. */
class OpenSceneTest {
    private static final int SIDE = 64;

    @TempDir
    private Path folder;
    private OpenWindow window;

    @AfterEach
    void close() {
        window.close();
    }

    @Test
    void anEmptyWindowSaysHowToGoOnAndHasNothingToSaveOrRender() {
        window = new OpenWindow(SceneSource.NONE, SIDE, SIDE);

        assertThat(window.frame.getTitle()).isEqualTo("SimpleRay");
        assertThat(window.status()).isEqualTo("Open a scene file: File > Open…");
        assertThat(window.canDo("Save Picture As…")).isFalse();
        assertThat(window.canDo("Reload")).isFalse();
        assertThat(window.canDo("Cancel")).isFalse();
    }

    @Test
    void theChosenSceneIsRendered() {
        Path scene = TestScenes.plain(folder.resolve("blue.scene"), 0, 0, 1);
        window = new OpenWindow(SceneSource.NONE, SIDE, SIDE);
        open(scene);

        window.untilShown("the picture", TestScenes.rendered(scene, SIDE, SIDE));
        assertThat(window.frame.getTitle()).isEqualTo("blue.scene - SimpleRay");
    }

    @Test
    void aPictureBringsItsScene() throws IOException {
        Path picture = folder.resolve("thesis.png");
        String[] command = {"render", TestScenes.THESIS.toString(), "-o", picture.toString(), "-q"};
        assertThat(Main.run(command, InputStream.nullInputStream(), OutputStream.nullOutputStream(), System.err)).isZero();
        window = new OpenWindow(SceneSource.NONE, SIDE, SIDE);
        open(picture);

        window.untilShown("the picture", TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE));
        assertThat(window.frame.getTitle()).isEqualTo("thesis.png - SimpleRay");
    }

    @Test
    void aSceneThatCannotBeReadLeavesThePictureBeforeIt() {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), SIDE, SIDE);
        window.untilState(Rendering.State.FINISHED);
        Path missing = folder.resolve("missing.scene");
        open(missing);

        window.untilState(Rendering.State.FAILED);
        assertThat(window.problems().getText()).isEqualTo(missing + ": no such file");
        window.untilShown("the picture before", TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE));
    }

    @Test
    void nothingChangesIfTheDialogIsCancelled() {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), SIDE, SIDE);
        window.untilState(Rendering.State.FINISHED);
        Rendering before = window.rendering();
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_O);
        FileDialog dialog = new FileDialog(window.screen);
        window.screen.press(KeyEvent.VK_ESCAPE);

        dialog.untilClosed();
        assertThat(window.rendering()).isSameAs(before);
        assertThat(window.frame.getTitle()).isEqualTo("thesis.scene - SimpleRay");
    }

    private void open(Path scene) {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_O);
        FileDialog dialog = new FileDialog(window.screen);
        dialog.enter(scene);
        dialog.untilClosed();
    }
}
