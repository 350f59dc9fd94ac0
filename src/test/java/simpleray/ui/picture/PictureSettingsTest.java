package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.render.RenderRequest;
import simpleray.scene.SceneSettings;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

/** The size, the samples and the depth in the Render menu. */
class PictureSettingsTest {
    /** The place of the menu Render. */
    private static final int RENDER = 2;
    private static final String SCENE = "1\n1  0 0 1 -1  0.2 0.4 0.6  0 0 0  0 0 0  0\n1 1 1\n0\n";

    @TempDir
    private Path folder;
    private Path scene;
    private OpenWindow window;

    @BeforeEach
    void finishThePicture() {
        scene = TestScenes.write(folder.resolve("wall.scene"), SCENE + "depth 2   # few\n");
        window = new OpenWindow(SceneSource.file(scene), 90, 60);
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void aSizeIsRenderedAndTicked() {
        choose("Size", "320 \u00D7 240");
        Screen.until("it has the size", () -> window.picture().imageSize().equals(new Dimension(320, 240)));
        window.untilState(RenderJob.State.FINISHED);

        window.screen.click(OpenWindow.ask(() -> OpenWindow.seen(JMenu.class, m -> m.getText().equals("Render"))));
        Screen.until("it is ticked", () -> item("Size", "320 \u00D7 240").isSelected());
        assertThat(OpenWindow.ask(() -> item("Size", "640 \u00D7 480").isSelected())).isFalse();
        assertThat(OpenWindow.ask(() -> item("Samples", "1 a pixel").isSelected())).isTrue();
        window.screen.press(KeyEvent.VK_ESCAPE);
    }

    @WindowTest
    void whatIsChosenIsWrittenIntoTheScene() throws IOException {
        choose("Samples", "3 \u00D7 3 a pixel");
        choose("Recursion Depth", "10");
        window.untilState(RenderJob.State.FINISHED);
        OpenWindow.run(window.item("Write into the Scene")::doClick);

        String expected = SCENE + "depth 10   # few\nresolution 90 60\nsamples 3\n";
        Screen.until("the file has them", () -> read().equals(expected));
        window.untilState(RenderJob.State.FINISHED);
        assertThat(OpenWindow.ask(() -> window.picture().request().settings().samples)).as("asked for beside the scene").isNull();
        assertThat(window.job().snapshot().settings().samples).isEqualTo(3);
        assertThat(window.status()).isEqualTo("Set resolution 90 60; depth 10; samples 3 in " + scene);
    }

    @WindowTest
    void whatIsWrittenIsInSight() {
        String much = SCENE + "# a remark\n".repeat(300) + "depth 3\n";
        TestScenes.write(scene, much);
        Screen.until("it is read", () -> window.picture().job().snapshot().film() != null
            && Integer.valueOf(3).equals(window.picture().job().snapshot().film().scene().settings.depth));
        window.untilState(RenderJob.State.FINISHED);
        choose("Samples", "3 \u00D7 3 a pixel");
        window.untilState(RenderJob.State.FINISHED);
        OpenWindow.run(window.item("Write into the Scene")::doClick);

        Screen.until("the file has it", () -> read().equals(much + "resolution 90 60\nsamples 3\n"));
        JTextComponent text = OpenWindow.appears("the text", JTextComponent.class, area -> "scene-text".equals(area.getName()));
        Screen.until("the line is in sight", () -> text.getVisibleRect().contains(center(text, text.getText().indexOf("samples 3"))));
    }

    private static Point2D center(JTextComponent text, int offset) {
        try {
            Rectangle2D letter = text.modelToView2D(offset);
            return new Point2D.Double(letter.getCenterX(), letter.getCenterY());
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);
        }
    }

    @WindowTest
    void asInTheSceneTakesBackWhatWasChosen() {
        choose("Recursion Depth", "0");
        choose("Size", "320 \u00D7 240");
        OpenWindow.run(window.item("As in the Scene")::doClick);

        Screen.until("it has the scene's depth", () -> window.job().snapshot().settings() != null
            && Integer.valueOf(2).equals(window.job().snapshot().settings().depth));
        window.untilState(RenderJob.State.FINISHED);
        assertThat(OpenWindow.ask(() -> window.picture().request().settings().lines())).as("what is asked for beside the scene").isEmpty();
        assertThat(OpenWindow.ask(window.picture()::imageSize)).isNotEqualTo(new Dimension(320, 240));
    }

    @WindowTest
    void withNothingChosenThereIsNothingToTakeBackOrToWrite() {
        OpenWindow.run(() -> {
            RenderRequest asked = window.picture().request();
            window.picture().setRequest(asked.with(new SceneSettings()));   // without the test's size
            window.picture().restart();
        });
        window.untilState(RenderJob.State.FINISHED);
        assertThat(openMenu("As in the Scene")).isFalse();
        assertThat(openMenu("Write into the Scene")).isFalse();
        choose("Recursion Depth", "0");
        assertThat(openMenu("As in the Scene")).isTrue();
        assertThat(openMenu("Write into the Scene")).isTrue();
    }

    @WindowTest
    void theSameChoiceAgainRendersNothing() {
        RenderJob first = window.job();
        choose("Recursion Depth", "2");                                 // the scene's own
        choose("Samples", "1 a pixel");
        assertThat(window.job()).isSameAs(first);
        choose("Recursion Depth", "0");
        Screen.until("another is rendered", () -> window.picture().job() != first);
        window.untilState(RenderJob.State.FINISHED);
        RenderJob second = window.job();
        choose("Recursion Depth", "0");

        assertThat(window.job()).isSameAs(second);
        Object picture = OpenWindow.ask(window.picture()::whole);
        choose("Recursion Depth", "10");
        Screen.until("a third is rendered", () -> window.picture().job() != second);
        window.untilState(RenderJob.State.FINISHED);
        choose("Recursion Depth", "0");
        assertThat(OpenWindow.ask(window.picture()::whole)).as("the picture that was finished before").isSameAs(picture);
    }

    /** {@return whether an item can be chosen once its menu is open} */
    private boolean openMenu(String item) {
        JMenu menu = OpenWindow.ask(() -> window.frame.getJMenuBar().getMenu(RENDER));
        window.screen.click(menu);
        Screen.until("the menu is open", menu::isPopupMenuVisible);
        boolean enabled = window.canDo(item);
        window.screen.press(KeyEvent.VK_ESCAPE);
        Screen.until("the menu is closed", () -> !menu.isPopupMenuVisible());
        return enabled;
    }

    private String read() {
        try {
            return Files.readString(scene);
        } catch (IOException e) {
            return "";
        }
    }

    private void choose(String menu, String name) {
        OpenWindow.run(item(menu, name)::doClick);
    }

    private JMenuItem item(String menu, String name) {
        JMenu found = OpenWindow.ask(() -> Arrays.stream(window.frame.getJMenuBar().getMenu(RENDER).getMenuComponents())
            .filter(part -> part instanceof JMenu one && one.getText().equals(menu)).map(JMenu.class::cast).findFirst().orElseThrow());
        return OpenWindow.ask(() -> Arrays.stream(found.getMenuComponents()).map(JMenuItem.class::cast)
            .filter(item -> item.getText().equals(name)).findFirst().orElseThrow());
    }
}
