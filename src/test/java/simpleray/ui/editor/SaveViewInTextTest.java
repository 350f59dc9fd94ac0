package simpleray.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.ui.FileDialog;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** The camera, saved while the scene's text is open beside the picture: nothing that was typed is lost. */
class SaveViewInTextTest {
    private static final String SCENE = "1\n1  0 0 1 -1  0.2 0.4 0.6  0 0 0  0 0 0  0\n1 1 1\n0\n";
    private static final String CAMERA = "camera 0 0 1.7 0 0 -1 90\n";

    @TempDir
    private Path folder;
    private Path scene;
    private OpenWindow window;

    @BeforeEach
    void openTheText() {
        scene = TestScenes.write(folder.resolve("wall.scene"), SCENE);
        window = new OpenWindow(SceneSource.file(scene), 60, 40);
        window.untilState(RenderJob.State.FINISHED);
        OpenWindow.run(() -> window.document().toggle());
        Screen.until("the text is there", () -> SCENE.equals(window.document().text()));
        OpenWindow.run(() -> window.item("Nearer").doClick(0));
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void aTextAsTheFileHasItIsSavedWithTheView() throws IOException {
        save();

        Screen.until("it is in the text, and saved", () -> (SCENE + CAMERA).equals(window.document().text())
            && !window.document().isChanged());
        assertThat(Files.readString(scene)).isEqualTo(SCENE + CAMERA);
        window.untilState(RenderJob.State.FINISHED);
        assertThat(OpenWindow.ask(() -> window.picture().request().settings().camera)).isNull();
        assertThat(OpenWindow.ask(() -> window.banner().message("conflict"))).isNull();
        assertThat(window.status()).isEqualTo("Saved the view in " + scene);
    }

    @WindowTest
    void whatWasTypedStaysUnsavedAndHasTheView() throws IOException {
        String typed = SCENE.replace("0.6", "0.9");
        OpenWindow.run(() -> window.document().editor().area().setText(typed));
        save();

        Screen.until("it is in the text", () -> (typed + CAMERA).equals(window.document().text()));
        assertThat(Files.readString(scene)).isEqualTo(SCENE);
        Screen.until("it is rendered", () -> window.picture().whole() != null && !window.picture().isBusy()
            && window.picture().job().snapshot().settings().camera != null && window.picture().request().settings().camera == null);
        assertThat(OpenWindow.ask(() -> window.document().isChanged())).isTrue();
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_L);
        assertThat(window.status()).isEqualTo("A command line names the scene's file, and this text is not saved: save the scene first");

        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);
        Screen.until("it is saved", () -> !window.document().isChanged());
        assertThat(Files.readString(scene)).isEqualTo(typed + CAMERA);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_L);
        Screen.until("now a command line can name it", () -> copied().contains(" render " + scene));
    }

    @WindowTest
    void savedElsewhereTheTextKeepsItsUndoAndTheViewIsOneStepOfIt() throws IOException {
        String typed = SCENE.replace("0.6", "0.9");
        OpenWindow.run(() -> window.document().editor().area().replaceAll(typed));
        Path other = folder.resolve("other.scene");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_S);
        new FileDialog(window.screen).enter(other);
        Screen.until("it is opened", () -> other.equals(window.picture().source().path()) && !window.picture().isBusy());
        assertThat(Files.readString(other)).isEqualTo(typed + CAMERA);
        assertThat(OpenWindow.ask(() -> window.document().isChanged())).isFalse();
        assertThat(OpenWindow.ask(() -> window.document().text())).isEqualTo(typed + CAMERA);

        OpenWindow.run(() -> window.document().editor().area().undoLastAction());
        assertThat(OpenWindow.ask(() -> window.document().text())).isEqualTo(typed);
        OpenWindow.run(() -> window.document().editor().area().undoLastAction());
        assertThat(OpenWindow.ask(() -> window.document().text())).isEqualTo(SCENE);
        Screen.until("it is rendered", () -> window.picture().source() != null && !window.picture().isBusy()
            && window.picture().whole() != null && window.picture().job().snapshot().settings().camera == null);
        assertThat(OpenWindow.ask(() -> window.document().isChanged())).isTrue();
    }

    private static String copied() {
        try {
            return (String) Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor);
        } catch (UnsupportedFlavorException | IOException | IllegalStateException e) {
            return "";                                        // it is empty, or another has it just now
        }
    }

    private void save() {
        OpenWindow.run(() -> window.item("Save View in Scene").doClick(0));
    }
}
