package simpleray.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import javax.swing.JButton;
import javax.swing.JToolBar;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.ui.FileDialog;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** Nothing that was typed is lost without being asked about. */
class UnsavedTest {
    private static final int SIDE = 64;
    private static final String TEXT = "1\n1  0 0 1 -1  0.2 0.4 0.6  0 0 0  0 0 0  0\n1 1 1\n0\n";
    private static final String MINE = TEXT.replace("0.6", "0.9");
    private static final String THEIRS = TEXT.replace("0.2", "0.8");

    @TempDir
    private Path folder;
    private Path scene;
    private OpenWindow window;

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void closingIsCancelled() {
        openChanged();
        quit();
        answer("Cancel");

        assertThat(window.closed).isFalse();
        assertThat(text()).isEqualTo(MINE);
    }

    @WindowTest
    void closingWithoutSavingLeavesTheFile() throws IOException {
        openChanged();
        quit();
        answer("Don\u2019t Save");

        Screen.until("the window is closed", window.closed::get);
        assertThat(Files.readString(scene)).isEqualTo(TEXT);
    }

    @WindowTest
    void closingSavesFirst() throws IOException {
        openChanged();
        quit();
        answer("Save");

        Screen.until("the window is closed", window.closed::get);
        assertThat(Files.readString(scene)).isEqualTo(MINE);
    }

    @WindowTest
    void anotherSceneIsOpenedOnceTheFirstIsSaved() throws IOException {
        openChanged();
        Path other = TestScenes.plain(folder.resolve("other.scene"), 1, 0, 0);
        OpenWindow.later(() -> window.open(SceneSource.file(other)));
        answer("Save");

        window.untilShown("the other", TestScenes.rendered(other, SIDE, SIDE));
        assertThat(Files.readString(scene)).isEqualTo(MINE);
        String text = Files.readString(other);
        Screen.until("the other's text is there", () -> text().equals(text));
        assertThat(OpenWindow.ask(window.frame::getTitle)).isEqualTo("other.scene - SimpleRay");
    }

    @WindowTest
    void whatAnotherProgramWroteIsTakenOnRequestAndUndoBringsBackMine() {
        openChanged();
        writeAsAnother(THEIRS);
        untilBanner();
        assertThat(text()).isEqualTo(MINE);
        click("Reload");

        window.untilShown("their picture", TestScenes.rendered(scene, SIDE, SIDE));
        assertThat(text()).isEqualTo(THEIRS);
        assertThat(banner()).isNull();
        OpenWindow.run(() -> window.document().editor().area().undoLastAction());
        assertThat(text()).isEqualTo(MINE);
    }

    @WindowTest
    void mineIsKeptOnRequestAndThenSavedOverTheirs() throws IOException {
        openChanged();
        writeAsAnother(THEIRS);
        untilBanner();
        click("Keep Mine");
        Screen.until("the banner is gone", () -> banner() == null);
        assertThat(Files.readString(scene)).isEqualTo(THEIRS);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);

        window.untilShown("my picture", TestScenes.rendered(TestScenes.write(folder.resolve("mine.scene"), MINE), SIDE, SIDE));
        assertThat(Files.readString(scene)).isEqualTo(MINE);
    }

    @WindowTest
    void savingNeverOverwritesWhatWasNotSeen() throws IOException {
        openChanged();
        writeAsAnother(THEIRS);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);

        untilBanner();
        assertThat(Files.readString(scene)).isEqualTo(THEIRS);
        assertThat(text()).isEqualTo(MINE);
    }

    @WindowTest
    void aTextWithoutChangesFollowsTheFileAndKeepsItsCaret() {
        open(SceneSource.file(write(TEXT)));
        OpenWindow.run(() -> window.document().editor().area().setCaretPosition(TEXT.indexOf("1 1 1")));
        String other = "# more\n" + THEIRS;
        writeAsAnother(other);

        Screen.until("the text is the file's", () -> text().equals(other));
        assertThat(OpenWindow.ask(() -> window.document().editor().area().getCaretPosition())).isEqualTo(other.indexOf("1 1 1"));
        assertThat(banner()).isNull();
    }

    @WindowTest
    void aDeletedSceneIsThereAgainOnceItIsSaved() throws IOException {
        open(SceneSource.file(write(TEXT)));
        Files.delete(scene);
        Screen.until("the banner is there", () -> window.banner().message("gone") != null);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);

        Screen.until("the banner is gone", () -> window.banner().message("gone") == null);
        assertThat(Files.readString(scene)).isEqualTo(TEXT);
        window.untilState(RenderJob.State.FINISHED);
        assertThat(window.status()).isEqualTo("Saved " + scene);
    }

    @WindowTest
    void theTextOfADeletedSceneGivesWayToAnotherFileOfItsNameOnlyIfOneSaysSo() throws IOException {
        open(SceneSource.file(write(TEXT)));
        Files.delete(scene);
        Screen.until("the banner is there", () -> window.banner().message("gone") != null);
        Files.write(scene, new byte[] {1, -1, 0, 2, -2});

        untilBanner();
        assertThat(text()).isEqualTo(TEXT);
        assertThat(window.frame.getTitle()).startsWith("*");
        click("Keep Mine");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);
        Screen.until("it is told", () -> window.status().equals("Saved " + scene));
        assertThat(Files.readString(scene)).isEqualTo(TEXT);
    }

    @WindowTest
    void whatIsSavedAtOnceAfterTypingIsTold() {
        openChanged();
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);

        Screen.until("it is told", () -> window.status().equals("Saved " + scene));
        window.untilShown("my picture", TestScenes.rendered(scene, SIDE, SIDE));
        window.untilState(RenderJob.State.FINISHED);
        assertThat(window.status()).isEqualTo("Saved " + scene);
    }

    @WindowTest
    void ofADeletedSceneTheTextThatWasReadIsShown() throws IOException {
        openAndDelete();
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);

        Screen.until("the text is there", () -> TEXT.equals(window.document().text()));
    }

    @WindowTest
    void ofADeletedSceneThatCouldNotBeReadAgainTheTextIsSavedElsewhere() throws IOException {
        openAndDelete();
        window.screen.press(KeyEvent.VK_F5);
        window.untilState(RenderJob.State.FAILED);
        Path saved = saveAs("saved.scene");

        Screen.until("it is the window's scene", () -> window.frame.getTitle().equals("saved.scene - SimpleRay"));
        window.untilShown("its picture", TestScenes.rendered(saved, SIDE, SIDE));
        assertThat(Files.readString(saved)).isEqualTo(TEXT);
    }

    @WindowTest
    void ofASceneThatWasNeverThereNothingIsWritten() {
        write(TEXT);
        window = new OpenWindow(SceneSource.file(folder.resolve("never.scene")), SIDE, SIDE);
        window.untilState(RenderJob.State.FAILED);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_S);

        Screen.until("it is told", () -> "never.scene is not there, and its text is not known".equals(window.banner().message("text")));
    }

    @WindowTest
    void aTextOfNothingIsNotWritten() throws IOException {
        open(SceneSource.file(write(TEXT)));
        OpenWindow.run(() -> window.document().editor().area().setText(""));
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);

        answer("OK");
        assertThat(Files.readString(scene)).isEqualTo(TEXT);
    }

    @WindowTest
    void aTextThatIsOnNoDiskIsRenderedAndAskedFor() throws IOException {
        openChanged();
        writeAsAnother(THEIRS);
        untilBanner();
        BufferedImage theirs = TestScenes.rendered(scene, SIDE, SIDE);
        Files.delete(scene);
        Screen.until("it is told", () -> window.banner().message("gone") != null);
        click("Reload");

        window.untilShown("their picture", theirs);
        assertThat(text()).isEqualTo(THEIRS);
        quit();
        answer("Save");
        Screen.until("the window is closed", window.closed::get);
        assertThat(Files.readString(scene)).isEqualTo(THEIRS);
    }

    private void openAndDelete() throws IOException {
        window = new OpenWindow(SceneSource.file(write(TEXT)), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
        Files.delete(scene);
        Screen.until("the banner is there", () -> window.banner().message("gone") != null);
    }

    private Path saveAs(String name) {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_S);
        Path saved = folder.resolve(name);
        FileDialog dialog = new FileDialog(window.screen);
        dialog.enter(saved);
        dialog.untilClosed();
        return saved;
    }

    @WindowTest
    void aTextFromStandardInputIsSavedWhereTheUserSays() throws IOException {
        open(SceneSource.text(TEXT.getBytes(StandardCharsets.UTF_8)));
        OpenWindow.run(() -> window.document().editor().area().setText(MINE));
        Path saved = folder.resolve("saved.scene");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);
        FileDialog dialog = new FileDialog(window.screen);
        dialog.enter(saved);
        dialog.untilClosed();

        Screen.until("it is a file's scene", () -> window.frame.getTitle().equals("saved.scene - SimpleRay"));
        window.untilShown("its picture", TestScenes.rendered(saved, SIDE, SIDE));
        assertThat(Files.readString(saved)).isEqualTo(MINE);
    }

    @WindowTest
    void aTextFromStandardInputReplacesAFileIfTheUserSaysSo() throws IOException {
        saveOverTheirs("OK");

        Screen.until("it is a file's scene", () -> window.frame.getTitle().equals("room.scene - SimpleRay"));
        assertThat(Files.readString(scene)).isEqualTo(MINE);
    }

    @WindowTest
    void aTextFromStandardInputReplacesNoFileIfTheUserRatherWouldNot() throws IOException {
        saveOverTheirs("Cancel");

        assertThat(Files.readString(scene)).isEqualTo(THEIRS);
        assertThat(text()).isEqualTo(MINE);
        assertThat(OpenWindow.ask(window.frame::getTitle)).isEqualTo("*<stdin> - SimpleRay");
    }

    /** Another program saves the scene, as a whole. */
    private void writeAsAnother(String text) {
        try {
            Files.move(TestScenes.write(folder.resolve("another.scene"), text), scene, StandardCopyOption.ATOMIC_MOVE);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void saveOverTheirs(String answer) {
        open(SceneSource.text(TEXT.getBytes(StandardCharsets.UTF_8)));
        OpenWindow.run(() -> window.document().editor().area().setText(MINE));
        write(THEIRS);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);
        FileDialog dialog = new FileDialog(window.screen);
        dialog.enter(scene);
        dialog.untilClosed();
        answer(answer);
    }

    @WindowTest
    void aTextThatIsTooLargeIsNotShown() throws IOException {
        write(TEXT);
        Files.writeString(scene, TEXT + ("# " + "x".repeat(1021) + '\n').repeat(9 << 10));
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);

        Screen.until("it is told", () -> window.banner().message("text") != null);
        assertThat(OpenWindow.ask(() -> window.banner().message("text")))
            .isEqualTo("room.scene is too large to be edited here: 9 MiB");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        Screen.until("it is no longer told", () -> window.banner().message("text") == null);
    }

    private Path write(String text) {
        scene = TestScenes.write(folder.resolve("room.scene"), text);
        return scene;
    }

    private void open(SceneSource source) {
        window = new OpenWindow(source, SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        Screen.until("the text has the keys", () -> window.document().editor() != null
            && window.document().editor().area().isFocusOwner());
    }

    private void openChanged() {
        open(SceneSource.file(write(TEXT)));
        OpenWindow.run(() -> window.document().editor().area().setText(MINE));
        assertThat(OpenWindow.ask(window.frame::getTitle)).isEqualTo("*room.scene - SimpleRay");
    }

    private void quit() {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
    }

    private void answer(String button) {
        JButton found = OpenWindow.appears("the question", JButton.class, b -> isButton(b, button));
        window.screen.click(found);
        Screen.until("the question is gone", () -> !found.isShowing());
    }

    private void click(String button) {
        window.screen.click(OpenWindow.appears(button, JButton.class, b -> isButton(b, button)));
    }

    /** {@return whether a button has this text and is not one of the row below the menus} */
    private static boolean isButton(JButton button, String text) {
        return text.equals(button.getText()) && SwingUtilities.getAncestorOfClass(JToolBar.class, button) == null;
    }

    private void untilBanner() {
        String message = "room.scene was changed by another program, and has unsaved changes here";
        Screen.until("the banner is there", () -> message.equals(banner()));
    }

    private String banner() {
        return OpenWindow.ask(() -> window.banner().message("conflict"));
    }

    private String text() {
        return OpenWindow.ask(() -> window.document().editor().text());
    }
}
