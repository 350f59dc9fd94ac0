package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.render.Stage;
import simpleray.ui.desktop.Preferences;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** The buttons below the menus, by the mouse. */
class ToolBarTest {
    @TempDir
    private Path folder;
    private OpenWindow window;

    @BeforeEach
    void finishThePicture() {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), 90, 60, made -> made.frame().setSize(820, 500));
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void aStageIsPressedWhileItIsShownWhateverChoseIt() {
        window.screen.click(button("Lighting"));
        window.untilShown("the stage", TestScenes.rendered(TestScenes.THESIS, 90, 60, Stage.LIGHTING));
        assertThat(pressed()).containsExactly("Lighting");
        window.screen.click(button("Lighting"));
        window.untilState(RenderJob.State.FINISHED);
        assertThat(pressed()).containsExactly("Lighting");

        window.screen.press(KeyEvent.VK_1);
        window.untilShown("the first stage", TestScenes.rendered(TestScenes.THESIS, 90, 60, Stage.ORIGINAL));
        assertThat(pressed()).containsExactly("Original");
    }

    @WindowTest
    void theSmallestWindowShowsAllMenusAndButtonsAndAPicture() throws InterruptedException {
        JFrame small = OpenWindow.ask(() -> OpenWindow.hidden(Preferences.none()));
        OpenWindow.run(() -> {
            small.setSize(1, 1);
            small.validate();
            JComponent tools = (JComponent) OpenWindow.all(small).filter(c -> "tools".equals(c.getName())).findFirst().orElseThrow();
            for (JComponent row : List.of(tools, small.getJMenuBar())) {
                assertThat(row.getWidth()).isGreaterThanOrEqualTo(row.getPreferredSize().width);
            }
            assertThat(small.getHeight()).isEqualTo(360);
        });
        OpenWindow.end(small);
    }

    @WindowTest
    void textAndStoryAreOpenedAndTheTextIsHiddenAgain() {
        window.screen.click(button("Story"));
        OpenWindow.appears("the story", JTree.class, tree -> true);
        window.screen.click(button("Text"));
        JTextArea text = OpenWindow.appears("the text", JTextArea.class, area -> area.getText().contains("#number of objects"));
        assertThat(pressed()).containsExactly("Final", "Text");
        window.screen.click(button("Text"));

        Screen.until("the text is gone", () -> !text.isShowing());
        assertThat(pressed()).containsExactly("Final");
    }

    @WindowTest
    void aButtonCanWhenItsItemCanAndTellsItsKey() {
        assertThat(OpenWindow.ask(button("Save")::isEnabled)).isTrue();
        assertThat(OpenWindow.ask(button("Pause")::isEnabled)).isFalse();
        assertThat(button("Save").getToolTipText()).isEqualTo("Save Picture As… (Ctrl+S)");
        assertThat(button("Reload").getToolTipText()).isEqualTo("Reload (Ctrl+R, F5)");
    }

    @WindowTest
    void noButtonTakesTheKeysFromThePicture() {
        window.screen.click(button("Reload"));
        window.untilState(RenderJob.State.FINISHED);

        assertThat(OpenWindow.ask(window.frame::getFocusOwner)).isSameAs(window.picture());
        assertThat(OpenWindow.ask(() -> buttons().stream().noneMatch(AbstractButton::isFocusable))).isTrue();
    }

    @WindowTest
    void withoutASceneNeitherKeyNorButtonOpensAPane() {
        window.close();
        window = new OpenWindow(SceneSource.NONE, 90, 60);
        window.screen.press(KeyEvent.VK_V);
        window.screen.press(KeyEvent.VK_I);
        for (String name : List.of("Rays", "Story", "Text")) {
            assertThat(OpenWindow.ask(button(name)::isEnabled)).as(name).isFalse();
        }
        assertThat(OpenWindow.ask(window.viewer().sides()::isOpen)).isFalse();
        assertThat(window.status()).startsWith("Open a scene file");

        OpenWindow.run(() -> window.open(SceneSource.file(TestScenes.THESIS)));
        window.untilState(RenderJob.State.FINISHED);
        window.screen.press(KeyEvent.VK_V);
        Screen.until("the pane is there", window.viewer().sides()::isOpen);
    }

    @WindowTest
    void ofASceneThatCannotBeReadOnlyTheTextIsOpened() throws IOException {
        window.close();
        Path junk = Files.writeString(folder.resolve("junk.scene"), "junk");
        window = new OpenWindow(SceneSource.file(junk), 90, 60, made -> made.frame().setSize(820, 500));
        window.untilProblems("junk");
        for (int key : new int[] {KeyEvent.VK_V, KeyEvent.VK_I, KeyEvent.VK_H}) {
            window.screen.press(key);
        }
        window.screen.click(window.picture());
        for (String item : List.of("Rays", "Story of the Pixel", "Histogram", "Mark Clipped Pixels")) {
            assertThat(OpenWindow.ask(window.item(item)::isEnabled)).as(item).isFalse();
            assertThat(OpenWindow.ask(window.item(item)::isSelected)).as(item).isFalse();
        }
        assertThat(OpenWindow.ask(window.viewer().sides()::isOpen)).isFalse();
        assertThat(label("gestures")).isEqualTo("F1: help");
        assertThat(label("size")).isNull();
        assertThat(label("zoom")).isNull();

        Files.copy(TestScenes.THESIS, junk, StandardCopyOption.REPLACE_EXISTING);
        window.untilState(RenderJob.State.FINISHED);
        Screen.until("the picture is there", () -> window.item("Histogram").isEnabled() && label("zoom") != null);
        assertThat(label("gestures")).startsWith("Click");
        window.screen.press(KeyEvent.VK_V);
        Screen.until("the pane is there", window.viewer().sides()::isOpen);
    }

    /** {@return the text of a label that is seen; null if it is not} */
    private String label(String name) {
        return OpenWindow.ask(() -> OpenWindow.all(window.frame).filter(c -> name.equals(c.getName()) && c.isShowing())
            .map(c -> ((JLabel) c).getText()).findFirst().orElse(null));
    }

    private List<AbstractButton> buttons() {
        return OpenWindow.ask(() -> OpenWindow.all(window.frame).filter(c -> c instanceof AbstractButton
            && SwingUtilities.getAncestorOfClass(ToolBar.class, c) != null).map(AbstractButton.class::cast).toList());
    }

    private AbstractButton button(String text) {
        return buttons().stream().filter(button -> button.getText().equals(text)).findFirst().orElseThrow();
    }

    private List<String> pressed() {
        return OpenWindow.ask(() -> buttons().stream().filter(AbstractButton::isSelected).map(AbstractButton::getText).toList());
    }
}
