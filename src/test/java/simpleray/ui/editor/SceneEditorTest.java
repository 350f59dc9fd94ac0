package simpleray.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import org.fife.ui.rtextarea.RTextScrollPane;
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

/** The scene's text beside the picture: read, edited, rendered and saved there. */
class SceneEditorTest {
    private static final int SIDE = 64;
    private static final int PAUSE = 700;                     // milliseconds
    private static final String TEXT = "1\r\n1  0 0 1 -1  0.2 0.4 0.6  0 0 0  0 0 0  0\r\n1 1 1\r\n0\r\n";

    @TempDir
    private Path folder;
    private Path scene;
    private OpenWindow window;

    @BeforeEach
    void open() {
        scene = TestScenes.write(folder.resolve("room.scene"), "\uFEFF" + TEXT);
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        Screen.until("the text has the keys", () -> area() != null && area().isFocusOwner());
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void problemsThatOpenDoNotCoverTheLineThatIsTyped() {
        OpenWindow.run(() -> {
            area().append("# a line\n".repeat(100));
            area().setCaretPosition(area().getDocument().getLength());
        });
        Screen.until("the caret is in the lowest line", this::isCaretSeen);
        int high = OpenWindow.ask(() -> area().getVisibleRect().height);
        assertThat(window.problems()).isNull();
        window.screen.type("7");
        window.untilProblems("error");
        Screen.until("the text is lower", () -> area().getVisibleRect().height < high);
        Screen.until("the caret is in sight", this::isCaretSeen);
        for (String more : List.of(" ", "8", "9")) {
            window.screen.type(more);
            Screen.until("it is typed", () -> text().endsWith(more));
            pause();
            assertThat(OpenWindow.ask(this::isCaretSeen)).as("the caret is in sight after \"" + more + '"').isTrue();
        }
    }

    /** Waits until what was typed is checked, and its errors are shown. */
    private void pause() {
        Screen.pause(PAUSE);
    }

    private boolean isCaretSeen() {
        try {
            return area().getVisibleRect().contains(area().modelToView2D(area().getCaretPosition()).getBounds());
        } catch (BadLocationException e) {
            throw new AssertionError(e);
        }
    }

    @WindowTest
    void controlEShowsTheTextAndHidesIt() {
        assertThat(text()).isEqualTo(TEXT.replace("\r", ""));
        assertThat(OpenWindow.ask(window.item("Scene Text")::isSelected)).isTrue();
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);

        Screen.until("the picture has the keys", () -> window.picture().isFocusOwner());
        assertThat(OpenWindow.ask(() -> area().isShowing())).isFalse();
        assertThat(OpenWindow.ask(window.item("Scene Text")::isSelected)).isFalse();
    }

    @WindowTest
    void afterALongLineTheTextIsBackAtItsMargin() {
        OpenWindow.run(() -> area().setText("# " + "long ".repeat(200) + "\n" + TEXT.replace("\r", "")));
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_HOME);
        window.screen.press(KeyEvent.VK_END);
        Screen.until("it is scrolled", () -> area().getVisibleRect().x > 100);
        window.screen.press(KeyEvent.VK_HOME);

        Screen.until("the margin is seen", () -> area().getVisibleRect().x == 0);
    }

    @WindowTest
    void keysThatTypeAreNoShortcuts() {
        RenderJob before = window.job();
        window.screen.type("123 adsf ");

        Screen.until("all is typed", () -> text().startsWith("123 adsf 1\n"));
        assertThat(window.job()).isSameAs(before);
        assertThat(OpenWindow.ask(window.item("Fit to Window")::isSelected)).isFalse();
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        Screen.until("the picture has the keys", () -> window.picture().isFocusOwner());
        window.screen.press(KeyEvent.VK_2);
        assertThat(OpenWindow.ask(() -> window.picture().request().stage())).isEqualTo(Stage.LIGHTING);
    }

    @WindowTest
    void controlEnterRendersTheTextWithoutSavingIt() throws IOException {
        replace("0.2 0.4 0.6", "0.9 0.1 0.1");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ENTER);

        Path other = TestScenes.plain(folder.resolve("other.scene"), 0.9, 0.1, 0.1);
        window.untilShown("the text's picture", TestScenes.rendered(other, SIDE, SIDE));
        assertThat(scene).hasContent("\uFEFF" + TEXT);
        assertThat(title()).isEqualTo("*room.scene - SimpleRay");
        window.screen.press(KeyEvent.VK_F5);
        window.untilState(RenderJob.State.FINISHED);
        window.untilShown("the text's picture again", TestScenes.rendered(other, SIDE, SIDE));
    }

    @WindowTest
    void meshesOfATextThatIsNotSavedLieBesideTheScene() {
        TestScenes.write(folder.resolve("a.obj"), "v -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 1 2 3\n");
        String mesh = "1\n4 \"a.obj\" 0 0 0 1  1 0 0  0 0 0  0 0 0  0\n1 1 1\n0\n";
        OpenWindow.run(() -> area().setText(mesh));
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ENTER);

        window.untilShown("the mesh", TestScenes.rendered(TestScenes.write(folder.resolve("b.scene"), mesh), SIDE, SIDE));
    }

    @WindowTest
    void saveWritesTheFileAsItWasButForTheEdit() throws IOException {
        replace("0.6", "0.7");
        assertThat(title()).isEqualTo("*room.scene - SimpleRay");
        save();

        Screen.until("it is saved", () -> title().equals("room.scene - SimpleRay"));
        assertThat(Files.readString(scene)).isEqualTo("\uFEFF" + TEXT.replace("0.6", "0.7"));
        window.untilShown("the picture", TestScenes.rendered(scene, SIDE, SIDE));
        assertThat(folder.toFile().list()).containsExactly("room.scene");
    }

    @WindowTest
    void savingWhatIsRenderedDoesNotRenderItAgain() {
        replace("0.6", "0.7");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ENTER);
        window.untilState(RenderJob.State.FINISHED);
        RenderJob rendered = window.job();
        save();

        Screen.until("it is saved", () -> window.status().equals("Saved " + scene));
        assertThat(window.job()).isSameAs(rendered);
    }

    @WindowTest
    void whatCannotBeSavedIsToldAndStays() throws IOException {
        Files.write(scene, "# \u00FC\n1\n1  0 0 1 -1  0.2 0.4 0.6  0 0 0  0 0 0  0\n1 1 1\n0\n".getBytes(StandardCharsets.ISO_8859_1));
        Screen.until("the text is read again", () -> text().startsWith("# \u00FC\n"));
        replace("\u00FC", "\u20AC");
        save();

        JLabel message = OpenWindow.appears("the reason", JLabel.class,
            l -> l.getText() != null && l.getText().startsWith("it is not UTF-8"));
        assertThat(message.getText()).isEqualTo("it is not UTF-8 but ISO 8859-1, which has no such characters as were typed");
        window.screen.press(KeyEvent.VK_ENTER);
        Screen.until("the dialog is gone", () -> !message.isShowing());
        assertThat(title()).startsWith("*");
        assertThat(text()).startsWith("# \u20AC\n");
    }

    @WindowTest
    void undoAndRedoGoBackToWhatIsSaved() {
        window.screen.type("7");
        Screen.until("it is changed", () -> title().startsWith("*"));
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        assertThat(title()).isEqualTo("room.scene - SimpleRay");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_Y);
        assertThat(text()).startsWith("71\n");
    }

    @WindowTest
    void errorsAreMarkedInTheText() {
        replace("0.4", "oops");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ENTER);

        Screen.until("the error is marked", () -> !window.document().marked().isEmpty());
        String message = "expected object 1's ambient green, found 'oops'";
        assertThat(OpenWindow.ask(() -> window.document().marked())).containsExactly("oops: " + message);
        assertThat(OpenWindow.ask(() -> area().getToolTipText(over("oops")))).isEqualTo(message);
        assertThat(OpenWindow.ask(() -> area().getToolTipText(over("1 1 1")))).isNotEqualTo(message);
        assertThat(OpenWindow.ask(() -> signs("oops"))).isEqualTo(1);
        assertThat(OpenWindow.ask(() -> signs("1 1 1"))).isZero();
        replace("oops", "0.5");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ENTER);
        Screen.until("no error is marked", () -> window.document().marked().isEmpty());
    }

    @WindowTest
    void findingGoesFromOneToTheNextAndRoundTheEnd() {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_F);
        JTextField field = OpenWindow.appears("the field", JTextField.class, f -> "find".equals(f.getName()));
        Screen.until("it has the keys", field::isFocusOwner);
        RenderJob before = window.job();
        window.screen.type("1 1");
        Screen.until("it is found", () -> "1 1".equals(area().getSelectedText()));
        int first = OpenWindow.ask(() -> area().getSelectionStart());
        assertThat(first).isEqualTo(text().indexOf("1 1 1"));
        window.screen.press(KeyEvent.VK_BACK_SPACE);
        window.screen.press(KeyEvent.VK_BACK_SPACE);
        window.screen.press(KeyEvent.VK_ENTER);
        assertThat(OpenWindow.ask(() -> area().getSelectionStart())).isEqualTo(first + 2);
        window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_ENTER);
        assertThat(OpenWindow.ask(() -> area().getSelectionStart())).isEqualTo(first);
        window.screen.type("x");
        Screen.until("nothing is found", () -> OpenWindow.seen(JLabel.class, l -> "not found".equals(l.getText())) != null);
        window.screen.press(KeyEvent.VK_ESCAPE);
        Screen.until("the text has the keys", () -> area().isFocusOwner() && !field.isShowing());
        assertThat(window.job()).isSameAs(before);
    }

    @WindowTest
    void theTextHasTheLooksColours() {
        OpenWindow.run(() -> {
            FlatDarkLaf.setup();
            SwingUtilities.updateComponentTreeUI(window.frame);
        });
        try {
            Color dark = OpenWindow.ask(() -> UIManager.getColor("TextArea.background"));
            Screen.until("it is dark", () -> area().getBackground().equals(dark));
            assertThat(OpenWindow.ask(() -> area().getForeground()))
                .isEqualTo(OpenWindow.ask(() -> UIManager.getColor("TextArea.foreground")));
        } finally {
            OpenWindow.run(FlatLightLaf::setup);
        }
    }

    @WindowTest
    void allPartsHaveNames() {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_F);
        List<Component> used = OpenWindow.ask(() -> OpenWindow.all(window.frame).filter(c -> c instanceof JTextComponent
            || c instanceof JButton b && b.isFocusable() && b.isShowing() || c instanceof AbstractButton b && b.isFocusable())
            .collect(Collectors.toList()));

        assertThat(used).hasSizeGreaterThanOrEqualTo(10).allSatisfy(c ->
            assertThat(c.getAccessibleContext().getAccessibleName()).as(c.toString()).isNotBlank());
    }

    /** {@return how many signs are in the gutter beside a word} */
    private int signs(String word) {
        RTextScrollPane scroll = (RTextScrollPane) SwingUtilities.getAncestorOfClass(RTextScrollPane.class, area());
        try {
            return scroll.getGutter().getTrackingIcons(new Point(0, over(word).getY())).length;
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);
        }
    }

    private SceneArea area() {
        return OpenWindow.ask(() -> window.document().editor() == null ? null : window.document().editor().area());
    }

    private String text() {
        return OpenWindow.ask(() -> area().getText());
    }

    private String title() {
        return OpenWindow.ask(window.frame::getTitle);
    }

    private void replace(String old, String other) {
        OpenWindow.run(() -> {
            int at = area().getText().indexOf(old);
            area().replaceRange(other, at, at + old.length());
        });
    }

    private void save() {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_S);
    }

    private MouseEvent over(String word) {
        try {
            Rectangle place = area().modelToView2D(text().indexOf(word) + 1).getBounds();
            return new MouseEvent(area(), MouseEvent.MOUSE_MOVED, 0, 0,
                place.x, place.y + place.height / 2, 0, false);
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);
        }
    }
}
