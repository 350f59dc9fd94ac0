package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import simpleray.render.Stage;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** The menus, with the mouse. */
class ViewerMenusTest {
    private OpenWindow window;

    @BeforeEach
    void finishThePicture() {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), 90, 60);
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void theFileMenuOpensSavesAndQuits() {
        assertThat(items(opened("File"))).containsExactly(
            "New ctrl pressed N", "Open… ctrl pressed O", "Examples… shift ctrl pressed O", "Open Recent null",
            "Reload ctrl pressed R",
            "Save Scene As… ctrl alt pressed S", "Save Picture As… ctrl pressed S", "Copy Picture ctrl pressed C", "Copy Command Line shift ctrl pressed L", "Export Film… shift ctrl pressed E",
            "Quit ctrl pressed Q");
    }

    @WindowTest
    void theRenderMenuHasTheThesissThreePicturesItsTermsAndTheViewsAndStopsAndSets() {
        assertThat(items(opened("Render"))).containsExactly("Original Scene pressed 1", "With Lighting pressed 2",
            "With Shadows and Reflections pressed 3", "Ambient Term pressed A", "Diffuse Term pressed D", "Specular Term pressed S",
            "Normals pressed N",
            "Depth pressed Z", "Object Numbers pressed O", "Bounces of Rays pressed R", "Shadows pressed M",
            "Pause pressed SPACE", "Cancel pressed ESCAPE", "Film null", "Size null", "Samples null", "Recursion Depth null", "As in the Scene null",
            "Write into the Scene null");
    }

    @WindowTest
    void theInspectMenuHasTheStoryThePixelCursorAndTheComparison() {
        assertThat(items(opened("Inspect"))).containsExactly("Story of the Pixel pressed I", "Copy Story shift ctrl pressed I",
            "Close Story shift pressed I", "Next Ray pressed PERIOD", "Previous Ray pressed COMMA",
            "Normals and Halfway Vectors shift pressed V", "Pixel Cursor Left alt pressed LEFT", "Pixel Cursor Right alt pressed RIGHT",
            "Pixel Cursor Up alt pressed UP", "Pixel Cursor Down alt pressed DOWN", "Side by Side pressed B", "Wipe pressed W");
    }

    @WindowTest
    void theMenuOfFilmsPlaysThem() {
        JMenu film = (JMenu) window.item("Film");
        opened("Render");
        window.screen.click(film);
        Screen.until("the menu is open", () -> film.getPopupMenu().isShowing());

        assertThat(items(film)).containsExactly("Play Film pressed P",
            "First Frame alt pressed HOME", "Previous Frame alt pressed PAGE_UP", "Next Frame alt pressed PAGE_DOWN",
            "Last Frame alt pressed END", "Loop Film shift pressed P");
    }

    @WindowTest
    void aClickOnAStageShowsIt() {
        opened("Render");
        window.screen.click(window.item("With Lighting"));

        window.untilShown("the stage", TestScenes.rendered(TestScenes.THESIS, 90, 60, Stage.LIGHTING));
    }

    @WindowTest
    void aClickOnReloadRendersAgain() {
        RenderJob before = window.job();
        opened("File");
        window.screen.click(window.item("Reload"));

        Screen.until("another rendering is there", () -> window.job() != before);
        window.untilState(RenderJob.State.FINISHED);
    }

    @WindowTest
    void aClickOnOpenAsksForAFile() {
        opened("File");
        window.screen.click(window.item("Open…"));

        assertThat(new FileDialog(window.screen).proposal()).isEmpty();
    }

    @WindowTest
    void aClickOnQuitClosesTheWindow() {
        opened("File");
        window.screen.click(window.item("Quit"));

        Screen.until("the window is closed", () -> window.closed.get() && !window.frame.isDisplayable());
    }

    private JMenu opened(String name) {
        JMenu menu = OpenWindow.ask(() -> OpenWindow.seen(JMenu.class, m -> m.getText().equals(name)));
        window.screen.click(menu);
        Screen.until("the menu is open", () -> menu.isPopupMenuVisible() && menu.getPopupMenu().isShowing());
        return menu;
    }

    private static List<String> items(JMenu menu) {
        return OpenWindow.ask(() -> Arrays.stream(menu.getMenuComponents()).filter(JMenuItem.class::isInstance)
            .map(c -> ((JMenuItem) c).getText() + ' ' + ((JMenuItem) c).getAccelerator()).collect(Collectors.toList()));
    }
}
