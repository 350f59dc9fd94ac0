package simpleray.ui.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.JDialog;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JOptionPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.MenuElement;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** Recent scenes, looks and the help, by mouse and keys. */
class DesktopTest {
    @TempDir
    private Path folder;
    private OpenWindow window;

    @BeforeEach
    void finishThePicture() {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), 90, 60);
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
        OpenWindow.run(FlatLightLaf::setup);
    }

    @WindowTest
    void aRecentSceneIsOpenedByItsNumber() {
        Path blue = TestScenes.plain(folder.resolve("blue.scene"), 0, 0, 1);
        OpenWindow.run(() -> window.open(SceneSource.file(blue)));
        window.untilShown("the other scene", TestScenes.rendered(blue, 90, 60));
        assertThat(recent()).hasSize(3).startsWith("1 " + shortened(blue), "2 " + shortened(TestScenes.THESIS.toAbsolutePath()));

        choose("File", "Open Recent", "2 " + shortened(TestScenes.THESIS.toAbsolutePath()));

        window.untilShown("the first scene", TestScenes.rendered(TestScenes.THESIS, 90, 60));
        assertThat(recent()).startsWith("1 " + shortened(TestScenes.THESIS.toAbsolutePath()), "2 " + shortened(blue));
    }

    @WindowTest
    void aRecentSceneThatIsGoneIsSaidToBeAndDropped() throws IOException {
        Path gone = TestScenes.plain(folder.resolve("gone.scene"), 0, 0, 1);
        OpenWindow.run(() -> window.open(SceneSource.file(gone)));
        window.untilState(RenderJob.State.FINISHED);
        Files.delete(gone);
        RenderJob before = window.job();

        choose("File", "Open Recent", "1 " + shortened(gone));

        Screen.until("it is said", () -> window.status().equals(gone + " is not there any more"));
        assertThat(recent()).containsExactly("1 " + shortened(TestScenes.THESIS.toAbsolutePath()), "Clear");
        assertThat(window.job()).isSameAs(before);
    }

    @WindowTest
    void clearForgetsAllRecentScenes() {
        choose("File", "Open Recent", "Clear");

        Screen.until("they are forgotten", () -> recent().equals(List.of("Clear")));
        assertThat(window.canDo("Open Recent")).isFalse();
    }

    @WindowTest
    void aDarkAndALightLookAreShownAtOnce() throws IOException {
        int light = brightness();
        choose("View", "Look", "Dark");
        Screen.until("the window is dark", () -> FlatLaf.isLafDark() && brightness() < light / 2);
        capture("dark.png");

        choose("View", "Look", "Light");
        Screen.until("the window is light", () -> !FlatLaf.isLafDark() && brightness() == light);
    }

    @WindowTest
    void theDialogOfShortcutsHasEveryKeyOfTheMenus() throws IOException {
        window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_SLASH);
        OpenWindow.appears("the gestures", JTable.class, t -> "Mouse".equals(t.getAccessibleContext().getAccessibleName()));
        JTabbedPane pages = OpenWindow.appears("the pages", JTabbedPane.class, pane -> true);
        OpenWindow.run(() -> pages.setSelectedIndex(1));
        JTable table = OpenWindow.appears("the keys", JTable.class, t -> "Keys".equals(t.getAccessibleContext().getAccessibleName()));
        Screen.until("it has the keys", () -> SwingUtilities.getWindowAncestor(table).isFocused());
        List<String> rows = OpenWindow.ask(() -> IntStream.range(0, table.getRowCount())
            .mapToObj(i -> table.getValueAt(i, 0) + ": " + table.getValueAt(i, 1) + ": " + table.getValueAt(i, 2))
            .collect(Collectors.toList()));

        assertThat(rows).contains("File: Open…: Ctrl+O", "File: Reload: Ctrl+R, F5", "File: Copy Command Line: Ctrl+Shift+L",
            "Render: Original Scene: 1", "Help: Mouse and Keys: F1, ?");
        assertThat(rows).hasSameSizeAs(OpenWindow.ask(() -> keys(window.frame.getJMenuBar()).collect(Collectors.toList())));
        capture("shortcuts.png");
        window.screen.press(KeyEvent.VK_ESCAPE);
        Screen.until("the dialog is gone", () -> !table.isShowing());
    }

    @WindowTest
    void f1ShowsTheGesturesFirst() {
        window.screen.press(KeyEvent.VK_F1);
        JTable table = OpenWindow.appears("the gestures", JTable.class, t -> "Mouse".equals(t.getAccessibleContext().getAccessibleName()));
        Screen.until("it has the keys", () -> SwingUtilities.getWindowAncestor(table).isFocused());

        assertThat(OpenWindow.ask(table::getRowCount)).isEqualTo(Shortcuts.GESTURES.size());
        window.screen.press(KeyEvent.VK_ESCAPE);
        Screen.until("the dialog is gone", () -> !table.isShowing());
    }

    @WindowTest
    void noTwoItemsOfTheMenusHaveTheSameKey() {
        assertThat(OpenWindow.ask(() -> keys(window.frame.getJMenuBar()).collect(Collectors.toList()))).doesNotHaveDuplicates();
    }

    @WindowTest
    void theMouseDialogTellsEveryGesture() {
        assertThat(Shortcuts.GESTURES).extracting(Shortcuts.Shortcut::command).doesNotHaveDuplicates().contains("Open a scene");
        assertThat(Shortcuts.name(KeyStroke.getKeyStroke("control shift L"))).isEqualTo("Ctrl+Shift+L");
    }

    @WindowTest
    void theProgramSaysWhichItIs() {
        OpenWindow.later(window.item("About SimpleRay")::doClick);
        JOptionPane about = OpenWindow.appears("about", JOptionPane.class, pane -> true);
        Screen.until("it has the keys", () -> SwingUtilities.getWindowAncestor(about).isFocused());

        assertThat((String) about.getMessage()).startsWith("SimpleRay (not packaged)\n")
            .contains("\nJava " + System.getProperty("java.version") + ", ");
        assertThat(((JDialog) SwingUtilities.getWindowAncestor(about)).getTitle()).isEqualTo("About SimpleRay");
        window.screen.press(KeyEvent.VK_ESCAPE);
        Screen.until("the dialog is gone", () -> !about.isShowing());
    }

    private static Stream<KeyStroke> keys(MenuElement element) {
        Stream<KeyStroke> own = element.getComponent() instanceof JMenuItem item && item.getAccelerator() != null
            ? Stream.of(item.getAccelerator()) : Stream.empty();
        return Stream.concat(own, Arrays.stream(element.getSubElements()).flatMap(DesktopTest::keys));
    }

    private List<String> recent() {
        JMenu menu = (JMenu) window.item("Open Recent");
        return OpenWindow.ask(() -> Arrays.stream(menu.getMenuComponents()).filter(JMenuItem.class::isInstance)
            .map(c -> ((JMenuItem) c).getText()).collect(Collectors.toList()));
    }

    private static String shortened(Path file) {
        String path = file.toString();
        return path.length() <= 60 ? path : "…" + path.substring(path.length() - 59);
    }

    /** Chooses an item of a menu within a menu by the mouse. */
    private void choose(String menu, String inner, String item) {
        JMenu outer = OpenWindow.ask(() -> OpenWindow.seen(JMenu.class, m -> m.getText().equals(menu)));
        window.screen.click(outer);
        Screen.until("the menu is open", () -> outer.isPopupMenuVisible() && outer.getPopupMenu().isShowing());
        JMenu middle = (JMenu) window.item(inner);
        window.screen.click(middle);
        Screen.until("the inner menu is open", () -> middle.isPopupMenuVisible() && middle.getPopupMenu().isShowing());
        window.screen.click(OpenWindow.ask(() -> (JMenuItem) Arrays.stream(middle.getMenuComponents())
            .filter(c -> c instanceof JMenuItem i && i.getText().equals(item)).findFirst().orElseThrow()));
    }

    /** {@return how bright the empty right end of the menu bar is} */
    private int brightness() {
        Component bar = window.frame.getJMenuBar();
        Dimension size = bar.getSize();
        BufferedImage pixel = window.screen.capture(bar, new Rectangle(size.width - 9, size.height / 2, 1, 1));
        return new Color(pixel.getRGB(0, 0)).getGreen();
    }

    private void capture(String name) throws IOException {
        Path captures = Files.createDirectories(Path.of(System.getProperty("simpleray.build"), "captures"));
        ImageIO.write(window.screen.capture(OpenWindow.ask(window.frame::getBounds)), "png", captures.resolve(name).toFile());
    }
}
