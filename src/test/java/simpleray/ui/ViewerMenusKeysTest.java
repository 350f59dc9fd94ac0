package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.swing.JMenu;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.render.Stage;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** The keys, pressed on a keyboard. */
class ViewerMenusKeysTest {
    /** The elements of the path to a menu's item: bar, menu, its pane, item. */
    private static final int SUBMENU = 4;

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

    @ParameterizedTest
    @CsvSource({"1, ORIGINAL, Original Scene", "2, LIGHTING, With Lighting", "3, FINAL, With Shadows and Reflections",
        "A, AMBIENT, Ambient Term", "D, DIFFUSE, Diffuse Term", "S, SPECULAR, Specular Term", "N, NORMALS, Normals", "Z, DEPTH, Depth",
        "O, OBJECTS, Object Numbers", "R, BOUNCES, Bounces of Rays", "M, SHADOWS, Shadows"})
    void aKeyShowsTheStageAndTicksItInTheMenu(char key, Stage stage, String item) {
        window.screen.press(KeyEvent.getExtendedKeyCodeForChar(Character.toLowerCase(key)));

        window.untilShown("stage " + stage, TestScenes.rendered(TestScenes.THESIS, 90, 60, stage));
        window.untilState(RenderJob.State.FINISHED);
        assertThat(window.label("size")).isEqualTo("90 × 60, " + stage);
        assertThat(OpenWindow.ask(window.item(item)::isSelected)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"F5", "control R"})
    void reloadHasTwoKeys(String key) {
        RenderJob before = window.job();
        if (key.equals("F5")) {
            window.screen.press(KeyEvent.VK_F5);
        } else {
            window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_R);
        }

        assertThat(window.job()).isNotSameAs(before);
        window.untilState(RenderJob.State.FINISHED);
        window.untilShown("the picture", TestScenes.rendered(TestScenes.THESIS, 90, 60));
    }

    @WindowTest
    void escapeDoesNothingToAFinishedPicture() {
        window.screen.press(KeyEvent.VK_ESCAPE);

        assertThat(window.job().state()).isEqualTo(RenderJob.State.FINISHED);
        assertThat(window.status()).startsWith("Finished: 5,400 rays");
    }

    /** From Swing's own sign of the open menu; no rendering starts by these keys, as an orbit would. */
    @WindowTest
    void theArrowKeysWalkThroughAllMenusAndMoveNothingElse() {
        RenderJob before = window.job();
        List<String> all = OpenWindow.ask(() -> Arrays.stream(window.frame.getJMenuBar().getSubElements())
            .map(menu -> ((JMenu) menu.getComponent()).getText()).toList());
        window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_F);
        List<String> seen = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            String expected = all.get(i);
            Screen.until(expected + " is open", () -> expected.equals(openMenu()));
            seen.add(openMenu());
            window.screen.press(KeyEvent.VK_RIGHT);
            Screen.until("it goes on", () -> !expected.equals(openMenu()) || isInSubmenu());
            if (isInSubmenu()) {
                window.screen.press(KeyEvent.VK_RIGHT);
            }
        }
        Screen.until("the first is open again", () -> all.get(0).equals(openMenu()));
        assertThat(seen).isEqualTo(all).hasSize(7);

        window.screen.press(KeyEvent.VK_LEFT);
        Screen.until("the last is open", () -> all.get(all.size() - 1).equals(openMenu()));
        window.screen.press(KeyEvent.VK_LEFT);
        Screen.until("the camera's is open", () -> "Camera".equals(openMenu()));
        window.screen.press(KeyEvent.VK_UP);
        window.screen.press(KeyEvent.VK_DOWN);
        window.screen.press(KeyEvent.VK_DOWN);
        Screen.until("an item is chosen", () -> MenuSelectionManager.defaultManager().getSelectedPath().length == 4);
        window.screen.press(KeyEvent.VK_ESCAPE);
        Screen.until("the menu is closed", () -> openMenu() == null);
        assertThat(window.job()).isSameAs(before);

        window.screen.press(KeyEvent.VK_LEFT);                // and works again
        Screen.until("the camera moves", () -> window.job() != before);
        window.untilState(RenderJob.State.FINISHED);
    }

    private static boolean isInSubmenu() {
        return OpenWindow.ask(() -> MenuSelectionManager.defaultManager().getSelectedPath().length > SUBMENU);
    }

    /** {@return the name of the menu that is open; null for none} */
    private static String openMenu() {
        return OpenWindow.ask(() -> {
            MenuElement[] path = MenuSelectionManager.defaultManager().getSelectedPath();
            return path.length < 2 || !((JMenu) path[1]).isPopupMenuVisible() ? null : ((JMenu) path[1]).getText();
        });
    }

    @WindowTest
    void controlQQuits() {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);

        assertThat(window.closed).isTrue();
        assertThat(OpenWindow.ask(window.frame::isDisplayable)).isFalse();
    }
}
