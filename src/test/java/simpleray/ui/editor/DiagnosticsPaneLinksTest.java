package simpleray.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import javax.swing.text.BadLocationException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** Each problem is a link to its place in the scene's text. */
class DiagnosticsPaneLinksTest {
    private static final String BAD = "2\n1  0 0 1 -1  0.2 0.4 oops  0 0 0  0 0 0  0\n"
        + "1  0 0 1 -1  0.2 0.4 0  0 0 0  0 bad 0  0\n1 1 1\n0\n";

    @TempDir
    private Path folder;
    private OpenWindow window;

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void enterGoesToTheSelectedProblem() {
        open(BAD);
        DiagnosticsPane pane = (DiagnosticsPane) window.problems();
        OpenWindow.run(pane::requestFocusInWindow);
        Screen.until("the problems have the keys", pane::isFocusOwner);
        for (int line = 0; line < 3; line++) {
            window.screen.press(KeyEvent.VK_DOWN);
        }
        assertThat(OpenWindow.ask(() -> pane.selected().message())).isEqualTo("expected object 2's specular green, found 'bad'");
        window.screen.press(KeyEvent.VK_ENTER);

        untilCaretAt("bad");
    }

    @WindowTest
    void aClickOnAPlaceGoesThere() {
        open(BAD);
        DiagnosticsPane pane = (DiagnosticsPane) window.problems();
        window.screen.click(pane, () -> {
            try {
                Rectangle first = pane.modelToView2D(3).getBounds();
                return new Point(first.x, first.y + first.height / 2);
            } catch (BadLocationException e) {
                throw new IllegalStateException(e);
            }
        });

        untilCaretAt("oops");
    }

    @WindowTest
    void f4GoesFromProblemToProblem() {
        open(BAD);
        window.screen.press(KeyEvent.VK_F4);
        untilCaretAt("oops");
        window.screen.press(KeyEvent.VK_F4);
        untilCaretAt("bad");
        window.screen.press(KeyEvent.VK_F4);
        untilCaretAt("oops");
        window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_F4);
        untilCaretAt("bad");
        assertThat(OpenWindow.ask(() -> window.document().marked())).containsExactly(
            "oops: expected object 1's ambient blue, found 'oops'", "bad: expected object 2's specular green, found 'bad'");
    }

    @WindowTest
    void aProblemOfAMeshIsWhereTheSceneNamesIt() {
        Path mesh = TestScenes.write(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
        open("1\n4 \"a.obj\" 0 0 0 1  1 0 0  0 0 0  0 0 0  0\n1 1 1\n0\n");
        window.screen.press(KeyEvent.VK_F4);

        untilCaretAt("\"a.obj\"");
        assertThat(window.status()).isEqualTo("The problem is in " + mesh + ", line 4, column 7");
    }

    private void open(String text) {
        Path scene = TestScenes.write(folder.resolve("room.scene"), text);
        window = new OpenWindow(SceneSource.file(scene), 64, 64);
        Screen.until("the problems are shown", () -> window.problems() != null);
        window.untilState(RenderJob.State.FAILED);
    }

    private void untilCaretAt(String word) {
        Screen.until("the caret is at " + word, () -> {
            SceneEditor editor = window.document().editor();
            return editor != null && editor.area().isFocusOwner() && editor.text().startsWith(word, editor.area().getCaretPosition());
        });
    }
}
