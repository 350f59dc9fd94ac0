package simpleray.ui.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JOptionPane;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.cli.Main;
import simpleray.ui.FileDialog;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** File > Save Picture As… where the name is that of a file which the scene is read from. */
class PictureDialogsInputTest {
    @TempDir
    private Path folder;
    private Path picture;
    private byte[] before;
    private OpenWindow window;

    @BeforeEach
    void openAPictureThatCarriesItsScene() throws IOException {
        picture = folder.resolve("thesis.png");
        String[] command = {"render", TestScenes.THESIS.toString(), "-o", picture.toString(), "--size", "120x90", "-q"};
        assertThat(Main.run(command, InputStream.nullInputStream(), OutputStream.nullOutputStream(), System.err)).isZero();
        before = Files.readAllBytes(picture);
        window = new OpenWindow(SceneSource.file(picture), 120, 90);
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void thePictureThatCarriesTheSceneIsNotReplaced() throws IOException {
        Path link = Files.createLink(folder.resolve("link.png"), picture);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        FileDialog dialog = new FileDialog(window.screen);
        assertThat(dialog.proposal()).endsWith("thesis-new.png");
        dialog.enter(link);

        JOptionPane message = OpenWindow.appears("a message", JOptionPane.class, pane -> true);
        assertThat(message.getMessage()).isEqualTo(link + "\nThe scene is read from it: choose another name");
        Screen.until("it has the keys", () -> SwingUtilities.getWindowAncestor(message).isFocused());
        window.screen.press(KeyEvent.VK_ENTER);
        FileDialog again = new FileDialog(window.screen);
        Path other = folder.resolve("other.png");
        again.enter(other);
        Screen.until("the picture is saved", () -> window.status().equals("Saved " + other));

        assertThat(picture).hasBinaryContent(before);
        assertThat(other).hasBinaryContent(before);
    }
}
