package simpleray.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.JComponent;
import javax.swing.JTabbedPane;
import javax.swing.JTree;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.ui.Mouse;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** The text, the story and the rays beside the picture. */
class SidePanesTest {
    private static final double MIN_SHARE = 0.4;

    private OpenWindow window;

    @AfterEach
    void close() {
        window.close();
    }

    @ParameterizedTest
    @CsvSource({"760, 560", "1366, 768", "1400, 1000"})
    void textStoryAndRaysAreOnePaneWithTabsThatLeavesThePictureTwoFifths(int width, int height) {
        openAll(width, height);
        assertThat(share()).isGreaterThanOrEqualTo(MIN_SHARE);
        JTabbedPane tabs = OpenWindow.ask(() -> OpenWindow.seen(JTabbedPane.class, pane -> "panes".equals(pane.getName())));
        assertThat(OpenWindow.ask(() -> tabs.getTitleAt(0) + ", " + tabs.getTitleAt(1))).isEqualTo("Text, Pixel");
        assertThat(OpenWindow.ask(() -> text())).isNull();

        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        Screen.until("the text is in front and has the keys", () -> text() != null && text().isFocusOwner());
        assertThat(OpenWindow.ask(() -> story() == null && window.item("Scene Text").isSelected())).isTrue();
        assertThat(share()).isGreaterThanOrEqualTo(MIN_SHARE);
        click();
        Screen.until("the pixel's panes are in front", () -> story() != null && rays() != null && text() == null);

        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        Screen.until("the text is hidden", () -> story() != null && rays() != null && !tabs.isShowing());
        assertThat(OpenWindow.ask(window.item("Scene Text")::isSelected)).isFalse();
        assertThat(share()).isGreaterThanOrEqualTo(MIN_SHARE);
    }

    @WindowTest
    void theTabsFollowTheKeysOfWhatTheyShow() {
        openAll(1000, 700);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        Screen.until("the text is in front", () -> text() != null && rays() == null);
        OpenWindow.run(() -> window.picture().requestFocusInWindow());
        Screen.until("the picture has the keys", () -> window.picture().isFocusOwner());
        window.screen.press(KeyEvent.VK_V);
        Screen.until("the rays are in front", () -> text() == null && rays() != null);
        assertThat(OpenWindow.ask(window.item("Rays")::isSelected)).isTrue();

        window.screen.press(KeyEvent.VK_V);
        Screen.until("the rays are gone", () -> rays() == null && story() != null);
    }

    @WindowTest
    void aWideWindowShowsAllAtOnce() {
        openAll(1700, 700);
        Screen.until("the text is seen, too", () -> text() != null && story() != null && rays() != null);
        assertThat(share()).isGreaterThanOrEqualTo(MIN_SHARE);
        OpenWindow.run(() -> window.frame.setSize(900, 700));
        Screen.until("the picture keeps its share", () -> window.frame.getWidth() == 900 && share() >= MIN_SHARE);
    }

    private void openAll(int width, int height) {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), 90, 60, made -> made.frame().setSize(width, height));
        window.untilState(RenderJob.State.FINISHED);
        window.untilProblems("lights nothing");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        Screen.until("the text is there", () -> text() != null);
        click();
        Screen.until("the story is there", () -> story() != null && window.picture().isFocusOwner());
        window.screen.press(KeyEvent.VK_V);
        Screen.until("the rays are there", () -> rays() != null);
    }

    private void click() {
        Point place = window.onScreen(new Point(45, 36));
        Point corner = OpenWindow.ask(window.picture()::getLocationOnScreen);
        Point at = new Point(place.x - corner.x, place.y - corner.y);
        new Mouse(window.picture()).drag(InputEvent.BUTTON1_DOWN_MASK, at, at);
    }

    private double share() {
        return OpenWindow.ask(() -> window.scroll().getWidth() / (double) window.frame.getContentPane().getWidth());
    }

    private static JTextComponent text() {
        return OpenWindow.seen(JTextComponent.class, area -> "scene-text".equals(area.getName()));
    }

    private static JTree story() {
        return OpenWindow.seen(JTree.class, tree -> "story".equals(tree.getName()));
    }

    private static JComponent rays() {
        return OpenWindow.seen(JComponent.class, view -> "rays".equals(view.getName()));
    }
}
