package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Reach;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.ViewLines;
import simpleray.ui.FileDialog;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.FileSource;
import simpleray.ui.file.SceneSource;

/** The camera, taken along: to the clipboard, and into the scene's file. */
class SaveViewTest {
    private static final String SCENE = "1 # a wall\r\n1 0 0 1 -1  0.5 0.5 0.5  0.9 0.7 0.4  0 0 0 1\r\n0.3 0.3 0.3\r\n0\r\ndepth 3\r\n";

    @TempDir
    Path folder;
    private Path scene;
    private OpenWindow window;

    @BeforeEach
    void finishThePicture() {
        scene = TestScenes.write(folder.resolve("wall.scene"), SCENE);
        window = new OpenWindow(SceneSource.file(scene), 90, 60);
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void copyCameraPutsTheLineOnTheClipboard() {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_C);
        untilClipboard("camera 0 0 2 0 0 0 90\n");
        assertThat(window.status()).isEqualTo("Copied: camera 0 0 2 0 0 0 90");

        window.screen.press(KeyEvent.VK_PAGE_UP);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_C);
        untilClipboard("camera 0 0 1.7 0 0 -1 90\n");
    }

    @WindowTest
    void aWindowThatNoFreeCameraShowsIsCopiedAsItIs() {
        byte[] framed = (SCENE + "window -1 3 -2 2\r\ncop 4\r\n").getBytes(StandardCharsets.UTF_8);
        OpenWindow.run(() -> window.open(SceneSource.text(framed)));
        window.untilState(RenderJob.State.FINISHED);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_C);

        untilClipboard("window -1 3 -2 2\ncop 4\n");
    }

    @WindowTest
    void saveViewWritesTheLineAndNothingElseAndItIsTheScenesOwnFromThenOn() throws IOException {
        moved();
        save();
        untilSaved();

        assertThat(text()).isEqualTo(SCENE + "camera 0 0 1.7 0 0 -1 90\r\n");
        assertThat(SceneFile.read(scene).scene().settings.camera).isEqualTo(new Pose(0, 0, 1.7, 0, 0, -1, 90));
        Screen.until("it is the scene's own", () -> window.picture().request().settings().camera == null);
        window.untilState(RenderJob.State.FINISHED);

        save();
        Screen.until("there is nothing to save", () -> window.status().equals("The scene has this view already"));
        moved();
        save();
        untilSaved();
        assertThat(text()).isEqualTo(SCENE + "camera 0 0 1.43 0 0 -1 90\r\n");
    }

    @WindowTest
    void saveSceneAsTakesTheViewAlongAndLeavesTheFileThatWasOpen() throws IOException {
        moved();
        Path other = folder.resolve("other.scene");
        saveAs(other);

        Screen.until("it is opened", () -> other.equals(window.picture().source().path()) && !window.picture().isBusy());
        assertThat(text()).isEqualTo(SCENE);
        assertThat(Files.readString(other)).isEqualTo(SCENE + "camera 0 0 1.7 0 0 -1 90\r\n");
        window.untilShown("the moved view", TestScenes.rendered(other, 90, 60));
        assertThat(OpenWindow.ask(() -> window.picture().request().settings().hasCamera())).as("asked for beside the scene").isFalse();
        assertThat(window.status()).isEqualTo("Saved " + other + " with the view on the screen");
        OpenWindow.run(window.item("Reload")::doClick);
        Screen.until("the next rendering is told of", () -> window.status().startsWith("Finished: "));
    }

    @WindowTest
    void aTextWithErrorsIsSavedWithoutTheView() throws IOException {
        moved();
        TestScenes.write(scene, "oops");
        window.untilProblems("oops");
        Path other = folder.resolve("other.scene");
        saveAs(other);

        Screen.until("it is opened", () -> other.equals(window.picture().source().path()));
        assertThat(Files.readString(other)).isEqualTo("oops");
    }

    @WindowTest
    void saveSceneAsOverTheFileThatIsOpenHasTheViewInIt() {
        moved();
        OpenWindow.later(window.item("Save Scene As\u2026")::doClick);
        new FileDialog(window.screen).enter(scene);
        window.screen.click(OpenWindow.appears("a question", JButton.class, b -> "OK".equals(b.getText())));

        Screen.until("the file has the view", () -> read().equals(SCENE + "camera 0 0 1.7 0 0 -1 90\r\n"));
        untilSaved();
    }

    @WindowTest
    void ofACameraWithKeysTheViewIsNotSavedAndThatIsTold() throws IOException {
        String film = SCENE + "camera 0 0 2 0 0 0 90\nframes 9 25\nkey 8 camera 0 0 3 0 0 0 90\n";
        TestScenes.write(scene, film);
        Screen.until("it is a film", () -> window.picture().seen().snapshot().film().scene().settings.frames != null);
        moved();
        Path other = folder.resolve("other.scene");
        saveAs(other);

        Screen.until("it is opened", () -> other.equals(window.picture().source().path()));
        assertThat(Files.readString(other)).isEqualTo(film);
        Screen.until("it is told", () -> window.status().equals("Saved " + other + " without the moved view: its camera has keys"));
    }

    private String read() {
        try {
            return text();
        } catch (IOException e) {
            return "";
        }
    }

    private void saveAs(Path path) {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_S);
        new FileDialog(window.screen).enter(path);
    }

    @WindowTest
    void aFileThatWasChangedMeanwhileStaysAsItIs() throws IOException {
        FileSource source = new FileSource(scene, Reach.FOLDER);   // not the window's, which reads it anew as soon as it hears of it
        source.read();
        TestScenes.write(scene, SCENE + "# by somebody else\r\n");
        SceneSettings view = new SceneSettings();
        view.camera = new Pose(0, 0, 1, 0, 0, 0, 50);

        assertThatThrownBy(() -> source.save((bytes, file, reach) -> ViewLines.put(bytes, file, view, reach)))
            .hasMessage(scene + ": It was changed on the disk since it was read: read it again first (F5)");
        assertThat(text()).isEqualTo(SCENE + "# by somebody else\r\n");
        assertThat(files()).isEqualTo(1);
    }

    @WindowTest
    void aFileThatIsGoneIsNotMadeAnew() throws IOException {
        moved();
        Files.delete(scene);
        save();

        untilRefused("It is no longer there");
        assertThat(files()).isZero();
    }

    @WindowTest
    void aFileThatIsNoSceneAnyMoreIsNotWritten() throws IOException {
        moved();
        TestScenes.write(scene, "oops");
        window.screen.press(KeyEvent.VK_F5);
        window.untilState(RenderJob.State.FAILED);
        save();

        untilRefused("It is not readable as a scene: ");
        assertThat(text()).isEqualTo("oops");
    }

    @WindowTest
    void aSceneWithoutAFileIsRefused() throws IOException {
        OpenWindow.run(() -> window.open(SceneSource.text(SCENE.getBytes(StandardCharsets.UTF_8))));
        window.untilState(RenderJob.State.FINISHED);
        moved();
        save();

        untilRefused("The scene is in no file yet: File > Save Scene As\u2026 writes one");
        assertThat(text()).isEqualTo(SCENE);
    }

    @WindowTest
    void aCameraOfTheCommandLineIsSavedThoughItWasNotMoved() throws IOException {
        SceneSettings asked = new SceneSettings();
        asked.cop = 5.0;
        OpenWindow.run(() -> {
            window.picture().setRequest(window.picture().request().with(asked));
            window.picture().start();
        });
        window.untilState(RenderJob.State.FINISHED);
        save();
        untilSaved();

        assertThat(text()).isEqualTo(SCENE + "cop 5\r\n");
    }

    /** {@return the camera, after a step nearer} */
    private Pose moved() {
        RenderJob before = window.job();
        window.screen.press(KeyEvent.VK_PAGE_UP);
        Screen.until("the move is rendered", () -> window.picture().job() != before);
        window.untilState(RenderJob.State.FINISHED);
        return OpenWindow.ask(() -> window.picture().request().settings().camera);
    }

    private void save() {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_V);
    }

    private void untilSaved() {
        Screen.until("the view is saved", () -> window.picture().request().settings().camera == null
            && window.picture().request().settings().cop == null);
    }

    private void untilRefused(String reason) {
        JLabel label = OpenWindow.appears("the refusal", JLabel.class, l -> l.getText() != null && l.getText().startsWith(reason)
            && SwingUtilities.getAncestorOfClass(JOptionPane.class, l) != null);
        JButton ok = OpenWindow.appears("a button", JButton.class, b -> SwingUtilities.getAncestorOfClass(JOptionPane.class, b) != null);
        window.screen.click(ok);
        Screen.until("the refusal is gone", () -> !label.isShowing());
    }

    private static void untilClipboard(String text) {
        Screen.until("the clipboard has the line", () -> {
            try {
                return text.equals(Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor));
            } catch (Exception e) {
                throw new IllegalStateException(e);
            }
        });
    }

    private String text() throws IOException {
        return Files.readString(scene);
    }

    private long files() throws IOException {
        try (var list = Files.list(folder)) {
            return list.count();
        }
    }
}
