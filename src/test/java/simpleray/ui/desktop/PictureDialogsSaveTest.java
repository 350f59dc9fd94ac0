package simpleray.ui.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
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

/** File > Save Picture As…, through the dialog and by the keyboard. */
class PictureDialogsSaveTest {
    private static final byte[] OLD = "an old picture".getBytes(StandardCharsets.US_ASCII);

    @TempDir
    private Path folder;
    private OpenWindow window;

    @BeforeEach
    void finishThePicture() {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), 120, 90);
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void theSavedFileEqualsThatOfTheCommandRender() throws IOException {
        Path saved = folder.resolve("saved.png");
        save().enter(saved);

        Screen.until("the file is there", () -> Files.exists(saved));
        assertThat(saved).hasBinaryContent(renderedByCommand());
        Screen.until("the status line says so", () -> window.status().equals("Saved " + saved));
        assertThat(folder).isDirectoryNotContaining(file -> !file.equals(saved));
    }

    @WindowTest
    void theSceneGivesTheNameAndPngIsAddedWhereItIsMissing() throws IOException {
        FileDialog dialog = save();
        assertThat(dialog.proposal()).endsWith("thesis.png");
        dialog.enter(folder.resolve("other.name"));

        Path saved = folder.resolve("other.name.png");
        Screen.until("the file is there", () -> Files.exists(saved));
        assertThat(saved).hasBinaryContent(renderedByCommand());
    }

    @WindowTest
    void anOldFileStaysIfTheUserCancelsReplacingIt() throws IOException {
        Path old = Files.write(folder.resolve("old.png"), OLD);
        FileDialog dialog = save();
        dialog.enter(old);
        untilAsked();
        window.screen.press(KeyEvent.VK_ESCAPE);
        FileDialog again = new FileDialog(window.screen);
        window.screen.press(KeyEvent.VK_ESCAPE);

        again.untilClosed();
        assertThat(old).hasBinaryContent(OLD);
    }

    @WindowTest
    void anOldFileIsReplacedIfTheUserAgrees() throws IOException {
        Path old = Files.write(folder.resolve("old.png"), OLD);
        FileDialog dialog = save();
        dialog.enter(old);
        untilAsked();
        window.screen.press(KeyEvent.VK_ENTER);

        Screen.until("the picture is saved", () -> window.status().equals("Saved " + old));
        assertThat(old).hasBinaryContent(renderedByCommand());
    }

    @WindowTest
    void whatCannotBeSavedIsToldWithTheReason() {
        Path lost = folder.resolve("none").resolve("lost.png");
        save().enter(lost);

        JOptionPane message = OpenWindow.appears("a message", JOptionPane.class, pane -> true);
        assertThat(message.getMessage()).isEqualTo(lost + "\nthere is no folder " + folder.resolve("none"));
        Screen.until("it has the keys", () -> SwingUtilities.getWindowAncestor(message).isFocused());
        window.screen.press(KeyEvent.VK_ENTER);
        Screen.until("the message is gone", () -> !message.isShowing());
    }

    private FileDialog save() {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        return new FileDialog(window.screen);
    }

    private void untilAsked() {
        JOptionPane question = OpenWindow.appears("a question", JOptionPane.class, pane -> true);
        assertThat(question.getMessage()).isEqualTo("old.png is there already. Replace it?");
        Screen.until("it has the keys", () -> SwingUtilities.getWindowAncestor(question).isFocused());
    }

    private static byte[] renderedByCommand() {
        ByteArrayOutputStream picture = new ByteArrayOutputStream();
        String[] command = {"render", TestScenes.THESIS.toString(), "-o", "-", "--size", "120x90", "-q"};
        assertThat(Main.run(command, InputStream.nullInputStream(), picture, System.err)).isZero();
        return picture.toByteArray();
    }
}
