package simpleray.ui.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Queue;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JOptionPane;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.Project;
import simpleray.ui.FileDialog;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** The sample scenes in the window, and saving one as a file of one's own; by mouse and keys. */
class ExamplesTest {
    private static final Path SCENES = TestScenes.THESIS.getParent();
    private static final int SIDE = 64;

    @TempDir
    private Path folder;
    private OpenWindow window;

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void aWindowWithoutASceneShowsEverySampleAsAPicture() throws IOException {
        window = new OpenWindow(SceneSource.NONE, SIDE, SIDE);
        Set<String> names = Project.names(SCENES, ".scene").stream().map(name -> name.replace('-', ' ')).collect(Collectors.toSet());

        List<JButton> all = samples();
        assertThat(all).extracting(button -> button.getText().toLowerCase(Locale.ROOT)).containsExactlyInAnyOrderElementsOf(names);
        assertThat(all.get(0).getText()).isEqualTo("Thesis");
        Screen.until("the first pictures are there", () -> OpenWindow.ask(() -> samples().stream().limit(3)
            .allMatch(button -> ((Thumbnail) button.getIcon()).isRendered())));
    }

    @WindowTest
    void thePicturesComeInReadingOrderAndThoseInSightFirst() {
        Queue<Runnable> tasks = new ArrayDeque<>();
        window = new OpenWindow(SceneSource.file(TestScenes.plain(folder.resolve("blue.scene"), 0, 0, 1)), SIDE, SIDE);
        JDialog dialog = OpenWindow.ask(() -> {
            JDialog made = new JDialog(window.frame);
            made.add(new ExamplesPane(tasks::add, sample -> { }));
            made.setSize(760, 420);
            made.setVisible(true);
            return made;
        });
        for (int i = 0; i < 3; i++) {
            Screen.until("a picture is asked for", () -> tasks.size() == 1);
            assertThat(rendered()).isEqualTo(IntStream.range(0, i).boxed().toList());
            OpenWindow.ask(tasks::remove).run();
        }
        Screen.until("another is asked for", () -> tasks.size() == 1);
        int last = samples().size() - 1;
        OpenWindow.run(() -> samples().get(last).scrollRectToVisible(new Rectangle(1, Thumbnail.HEIGHT)));
        OpenWindow.ask(tasks::remove).run();                  // was asked for before that
        Screen.until("one in sight is asked for", () -> tasks.size() == 1);
        int first = OpenWindow.ask(() -> IntStream.rangeClosed(0, last)
            .filter(i -> !samples().get(i).getVisibleRect().isEmpty()).findFirst().orElseThrow());
        OpenWindow.ask(tasks::remove).run();

        Screen.until("it is there", () -> rendered().size() == 5);
        assertThat(first).isGreaterThan(4);
        assertThat(rendered()).isEqualTo(List.of(0, 1, 2, 3, first));
        OpenWindow.run(dialog::dispose);
    }

    /** {@return the places of the samples whose pictures are there} */
    private List<Integer> rendered() {
        return OpenWindow.ask(() -> IntStream.range(0, samples().size()).filter(i -> ((Thumbnail) samples().get(i).getIcon()).isRendered())
            .boxed().toList());
    }

    @WindowTest
    void aClickOnASampleShowsItAndTheSampleHasNoFile() {
        window = new OpenWindow(SceneSource.NONE, SIDE, SIDE);
        window.screen.click(sample("Ball pyramid"));

        window.untilShown("the sample", TestScenes.rendered(SCENES.resolve("ball-pyramid.scene"), SIDE, SIDE));
        assertThat(OpenWindow.ask(() -> window.picture().source().path())).isNull();
        assertThat(OpenWindow.ask(() -> window.frame.getTitle())).isEqualTo("ball-pyramid.scene - SimpleRay");
        assertThat(OpenWindow.ask(() -> window.frame.getFocusOwner())).isSameAs(window.picture());
    }

    @WindowTest
    void theDialogOfExamplesOpensOneInPlaceOfTheScene() {
        window = new OpenWindow(SceneSource.file(TestScenes.plain(folder.resolve("blue.scene"), 0, 0, 1)), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_O);
        JDialog dialog = OpenWindow.appears("the examples", JDialog.class, d -> "Examples".equals(d.getTitle()));
        Screen.until("it has the keys", dialog::isFocused);
        window.screen.click(sample("Thesis"));

        window.untilShown("the sample", TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE));
        assertThat(dialog.isShowing()).isFalse();
    }

    @WindowTest
    void problemsOfASampleCallItByItsName() {
        openHouse();
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        JTextArea text = OpenWindow.appears("its text", JTextArea.class, area -> "scene-text".equals(area.getName()) && area.isEnabled());
        String before = OpenWindow.ask(text::getText);
        OpenWindow.run(() -> text.setText("1\n4 \"house.obj\" 0 0 0 1  1 1 1  0 0 0  0 0 0  oops\n1 1 1\n0\n"));

        window.untilProblems("oops");
        assertThat(window.problems().getText()).startsWith("house.scene:2:").doesNotContain("house.obj:");
        OpenWindow.run(() -> text.setText("1\n0 0 0 9 1  1 1 1  0 0 0  0 0 0  0\n1 1 1\n0\n"));
        window.untilProblems("house.scene:2:1: warning: ");
        window.screen.press(KeyEvent.VK_F4);
        Screen.until("its place is shown", () -> text.isFocusOwner() && text.getCaretPosition() == 2);
        OpenWindow.run(() -> text.setText(before));           // so that nothing asks whether it is to be saved
    }

    @WindowTest
    void aSampleIsSavedWithItsMeshes() throws IOException {
        openHouse();
        Path own = folder.resolve("mine.scene");
        FileDialog dialog = saveAs();
        assertThat(dialog.proposal()).endsWith("house.scene");
        dialog.enter(own);

        Screen.until("it is said", () -> window.status().startsWith("Saved " + own) || own.equals(window.picture().source().path()));
        window.untilState(RenderJob.State.FINISHED);
        for (String[] pair : new String[][] {{"house.scene", "mine.scene"}, {"house.obj", "house.obj"}, {"house.mtl", "house.mtl"}}) {
            assertThat(folder.resolve(pair[1])).hasSameBinaryContentAs(SCENES.resolve(pair[0]));
        }
    }

    @WindowTest
    void anotherFileWithAMeshesNameIsNotWrittenOver() throws IOException {
        Path other = Files.write(folder.resolve("house.obj"), "another".getBytes(StandardCharsets.US_ASCII));
        openHouse();
        saveAs().enter(folder.resolve("mine.scene"));

        JOptionPane message = OpenWindow.appears("a message", JOptionPane.class, pane -> true);
        assertThat((String) message.getMessage()).endsWith(
            "\nThe scene needs its house.obj beside it, and another file has that name: choose another folder");
        Screen.until("it has the keys", () -> SwingUtilities.getWindowAncestor(message).isFocused());
        window.screen.press(KeyEvent.VK_ENTER);
        Screen.until("the message is gone", () -> !message.isShowing());
        assertThat(other).hasContent("another");
        assertThat(folder).isDirectoryContaining(file -> file.equals(other)).isDirectoryNotContaining(file -> !file.equals(other));
    }

    @WindowTest
    void aNewSceneShowsItsTextAndIsSavedByTheKeyOfItsText() throws IOException {
        window = new OpenWindow(SceneSource.NONE, SIDE, SIDE);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_N);
        Screen.until("its text has the keys", () -> window.frame.getFocusOwner() instanceof JTextArea);
        window.untilState(RenderJob.State.FINISHED);
        assertThat(window.problems()).isNull();
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        FileDialog dialog = new FileDialog(window.screen);
        assertThat(dialog.proposal()).endsWith("untitled.scene");
        dialog.enter(folder.resolve("first"));

        Path own = folder.resolve("first.scene");
        Screen.until("it is the window's scene", () -> own.equals(window.picture().source().path()));
        assertThat(Files.readString(own)).startsWith("# A scene to begin with.");
        window.untilState(RenderJob.State.FINISHED);
    }

    private void openHouse() {
        window = new OpenWindow(SceneSource.NONE, SIDE, SIDE);
        OpenWindow.run(sample("House")::doClick);
        window.untilState(RenderJob.State.FINISHED);
    }

    private FileDialog saveAs() {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_S);
        return new FileDialog(window.screen);
    }

    private List<JButton> samples() {
        return OpenWindow.ask(() -> Arrays.stream(Window.getWindows()).filter(Component::isShowing)
            .flatMap(OpenWindow::all).filter(c -> c instanceof JButton button && button.getIcon() instanceof Thumbnail)
            .map(JButton.class::cast).collect(Collectors.toList()));
    }

    private JButton sample(String name) {
        Screen.until(name + " is there", () -> samples().stream().anyMatch(button -> button.getText().equals(name)));
        return samples().stream().filter(button -> button.getText().equals(name)).findFirst().orElseThrow();
    }
}
