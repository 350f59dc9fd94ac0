package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

/** The size, the samples and the depth in the Render menu. */
class PictureSettingsTest {
    /** The place of the menu Render. */
    private static final int RENDER = 4;
    private static final String SCENE = "1\n1  0 0 1 -1  0.2 0.4 0.6  0 0 0  0 0 0  0\n1 1 1\n0\n";

    @TempDir
    private Path folder;
    private Path scene;
    private OpenWindow window;

    @BeforeEach
    void finishThePicture() {
        scene = TestScenes.write(folder.resolve("wall.scene"), SCENE + "depth 3   # few\n");
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
        choose("Depth", "10");
        window.untilState(RenderJob.State.FINISHED);
        OpenWindow.run(window.item("Write into the Scene")::doClick);

        String expected = SCENE + "depth 10   # few\nresolution 90 60\nsamples 3\n";
        Screen.until("the file has them", () -> read().equals(expected));
        window.untilState(RenderJob.State.FINISHED);
        assertThat(OpenWindow.ask(() -> window.picture().request().settings().samples)).as("asked for beside the scene").isNull();
        assertThat(window.job().snapshot().settings().samples).isEqualTo(3);
    }

    @WindowTest
    void asInTheSceneTakesBackWhatWasChosen() {
        choose("Depth", "0");
        choose("Size", "320 \u00D7 240");
        OpenWindow.run(window.item("As in the Scene")::doClick);

        Screen.until("it has the scene's depth", () -> window.job().snapshot().settings() != null
            && Integer.valueOf(3).equals(window.job().snapshot().settings().depth));
        window.untilState(RenderJob.State.FINISHED);
        assertThat(OpenWindow.ask(() -> window.picture().request().settings().lines())).as("what is asked for beside the scene").isEmpty();
        assertThat(OpenWindow.ask(window.picture()::imageSize)).isNotEqualTo(new Dimension(320, 240));
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
