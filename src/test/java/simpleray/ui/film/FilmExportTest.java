package simpleray.ui.film;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.swing.JButton;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.JProgressBar;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.film.FilmOutput;
import simpleray.film.FilmRenderer;
import simpleray.render.Progress;
import simpleray.render.RenderListener;
import simpleray.scene.SceneFile;
import simpleray.ui.FileDialog;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** File > Export Film…, through the dialog and by the keyboard. */
class FilmExportTest {
    @TempDir
    private Path folder;

    private OpenWindow film(int frames) {
        Path scene = TestScenes.write(folder.resolve("ball.scene"), "1\n0  -1 0 -2 1  1 1 1  1 1 1  0 0 0  0\n0.3 0.3 0.3\n1\n0 1 1 1  0 0 9\n"
            + "frames " + frames + " 25\nkey 0 object 1 0 0 0\nkey " + (frames - 1) + " object 1 2 0 0\n");
        OpenWindow window = new OpenWindow(SceneSource.file(scene), 60, 40);
        window.untilState(RenderJob.State.FINISHED);
        return window;
    }

    private static FileDialog export(OpenWindow window) {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_E);
        return new FileDialog(window.screen);
    }

    private static byte[] exported(Path scene, Path out) throws IOException {
        new FilmRenderer(SceneFile.read(scene), OpenWindow.request(60, 40), FilmOutput.of(out.toString()), FilmRenderer.Plan.ALL)
            .write(FilmRenderer.Kept.REFUSED, new FilmRenderer.Listener() {
                @Override
                public void found(int count) {
                    throw new AssertionError("nothing is there");
                }

                @Override
                public RenderListener begins(Progress progress) {
                    return RenderListener.NONE;
                }

                @Override
                public void note(String text) {
                    throw new AssertionError(text);
                }
            });
        return Files.readAllBytes(out);
    }

    @WindowTest
    void theFilmIsThatOfAnimate() throws IOException {
        try (OpenWindow window = film(5)) {
            Path out = folder.resolve("film.gif");
            FileDialog dialog = export(window);
            assertThat(dialog.proposal()).endsWith("ball.gif");
            dialog.enter(out);
            Screen.until("the status line says so", () -> window.status().equals("Exported " + out));

            assertThat(out).hasBinaryContent(exported(folder.resolve("ball.scene"), folder.resolve("other.gif")));
            assertThat(folder.resolve("film.gif.frames")).doesNotExist();
            assertThat(window.canDo("Export Film\u2026")).isTrue();
        }
        assertThat(OpenWindow.threads()).isEmpty();
    }

    @WindowTest
    void oneThatIsCancelledKeepsItsFramesAndGoesOnWithThem() throws IOException {
        try (OpenWindow window = film(4000)) {
            Path out = folder.resolve("film.gif");
            export(window).enter(out);
            JProgressBar bar = OpenWindow.appears("the progress", JProgressBar.class, shown -> "export".equals(shown.getName()));
            Screen.until("a frame is there", () -> bar.getString().matches("[1-9]\\d* of 4000 frames, .* left"));
            assertThat(window.canDo("Export Film\u2026")).as("one at a time").isFalse();
            window.screen.click(OpenWindow.appears("Cancel", JButton.class, button -> "Cancel".equals(button.getText())));
            Screen.until("it has ended", () -> window.status().startsWith("The export was cancelled; "));
            assertThat(window.status()).endsWith(" of 4000 frames are kept: export to the same file to go on");
            assertThat(out).doesNotExist();
            assertThat(folder.resolve("film.gif.frames/000000.png")).exists();

            OpenWindow.later(() -> window.item("Export Film\u2026").doClick());
            new FileDialog(window.screen).enter(out);
            window.screen.click(OpenWindow.appears("Cancel", JButton.class, button -> "Cancel".equals(button.getText())
                && SwingUtilities.getAncestorOfClass(JOptionPane.class, button) != null));
        }
        assertThat(OpenWindow.threads()).isEmpty();
    }

    @WindowTest
    void aNameWithoutAnEndingGetsTheOneOfTheChosenFormat() {
        try (OpenWindow window = film(5)) {
            export(window).enter(folder.resolve("film"));
            Screen.until("the status line tells the name", () -> window.status().equals("Exported " + folder.resolve("film.gif")));

            OpenWindow.later(() -> window.item("Export Film\u2026").doClick());
            FileDialog dialog = new FileDialog(window.screen);
            choose("Animated PNG (*.apng)");
            assertThat(dialog.proposal()).isEqualTo("ball.apng");
            choose("Numbered pictures (film.%04d.png)");
            assertThat(dialog.proposal()).isEqualTo("ball.%04d.png");
            choose("Animated PNG (*.apng)");
            OpenWindow.run(() -> dialog.field().requestFocusInWindow());
            Screen.until("the name has the keys", () -> dialog.field().isFocusOwner());
            dialog.enter(folder.resolve("other"));
            Screen.until("the status line tells this one", () -> window.status().equals("Exported " + folder.resolve("other.apng")));
        }
        assertThat(folder.resolve("film.gif")).isNotEmptyFile();
        assertThat(folder.resolve("other.apng")).isNotEmptyFile();
    }

    private static void choose(String format) {
        OpenWindow.run(() -> {
            JFileChooser chooser = OpenWindow.seen(JFileChooser.class, one -> true);
            chooser.setFileFilter(Arrays.stream(chooser.getChoosableFileFilters())
                .filter(filter -> filter.getDescription().equals(format)).findFirst().orElseThrow());
        });
    }

    @ParameterizedTest
    @CsvSource({"film, png, film.%04d.png", "film%d, png, film%d.png", "film, webm, film.webm",
        "film.mp4, gif, film.mp4", "a.b/film, gif, a.b/film.gif"})
    void anEndingIsAddedOnlyWhereThereIsNone(String name, String format, String expected) {
        assertThat(FilmExport.named(new File(name), new FileNameExtensionFilter("", format))).isEqualTo(new File(expected));
        assertThat(FilmExport.named(new File("film"), null)).isEqualTo(new File("film.gif"));
    }

    @WindowTest
    void aNameUnderWhichNoFilmCanBeWrittenIsRefused() {
        try (OpenWindow window = film(5)) {
            export(window).enter(folder.resolve("film.avi"));
            OpenWindow.appears("the reason", JOptionPane.class, pane -> pane.getMessage().toString().startsWith("a film is written as numbered PNG"));
            window.screen.press(KeyEvent.VK_ENTER);
            FileDialog again = new FileDialog(window.screen);
            window.screen.press(KeyEvent.VK_ESCAPE);
            again.untilClosed();
        }
        assertThat(folder.resolve("film.avi")).doesNotExist();
    }

    @WindowTest
    void noFrameIsWrittenOverAMeshOfTheScene() throws IOException {
        Path mesh = TestScenes.write(folder.resolve("m1.png"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        String written = Files.readString(mesh);
        Path scene = TestScenes.write(folder.resolve("mesh.scene"), "1\n4 \"m1.png\" 0 0 0 1  1 0 0  0 0 0  0 0 0  0\n1 1 1\n0\nframes 3 25\n");
        try (OpenWindow window = new OpenWindow(SceneSource.file(scene), 60, 40)) {
            window.untilState(RenderJob.State.FINISHED);
            export(window).put(folder.resolve("m%d.png"));
            OpenWindow.appears("the reason", JOptionPane.class, pane -> RenderJob.READ.equals(pane.getMessage()));
            window.screen.press(KeyEvent.VK_ENTER);
            FileDialog again = new FileDialog(window.screen);
            window.screen.press(KeyEvent.VK_ESCAPE);
            again.untilClosed();
        }
        assertThat(mesh).content().isEqualTo(written);
    }

    @WindowTest
    void aSceneThatIsNoFilmIsNotExported() {
        try (OpenWindow window = new OpenWindow(SceneSource.file(TestScenes.THESIS), 60, 40)) {
            window.untilState(RenderJob.State.FINISHED);
            assertThat(window.canDo("Export Film\u2026")).isFalse();
        }
    }
}
