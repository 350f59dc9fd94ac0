package simpleray.ui.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Dictionary;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.io.TempDir;
import simpleray.render.RenderListener;
import simpleray.scene.SceneFile;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.FileSource;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** A film in the window, with the mouse and with keys. */
class TimeLineTest {
    private static final int WIDTH = 90;
    private static final int HEIGHT = 60;
    private static final int FRAMES = 12;

    @TempDir
    private Path folder;

    private Path film(String end) {
        return TestScenes.write(folder.resolve("film.scene"), "1\n0  -1 0 -2 1  1 1 1  1 1 1  0 0 0  0\n0.3 0.3 0.3\n1\n0 1 1 1  0 0 9\nframes "
            + FRAMES + " 30\nkey 0 object 1 0 0 0\nkey 11 object 1 2 0 0\nkey 4 light 1 3 3 0\n" + end);
    }

    private static BufferedImage frame(Path scene, int frame) throws IOException {
        SceneFile still = SceneFile.read(scene).still(frame);
        return TestScenes.shown(OpenWindow.request(WIDTH, HEIGHT).renderer(still.scene()).render(RenderListener.NONE));
    }

    private static OpenWindow finished(Path scene) {
        OpenWindow window = new OpenWindow(SceneSource.file(scene), WIDTH, HEIGHT);
        window.untilState(RenderJob.State.FINISHED);
        return window;
    }

    private static JSlider slider() {
        return OpenWindow.appears("the slider", JSlider.class, slider -> "frame".equals(slider.getName()));
    }

    private static String number() {
        return OpenWindow.ask(() -> OpenWindow.seen(JLabel.class, label -> "frame number".equals(label.getName())).getText());
    }

    private static boolean hasTimeLine() {
        return OpenWindow.ask(() -> OpenWindow.seen(JPanel.class, panel -> "time line".equals(panel.getName())) != null);
    }

    @WindowTest
    void aSceneWithFramesHasATimeLineWithItsKeysAsMarks() {
        try (OpenWindow window = finished(film(""))) {
            JSlider slider = slider();
            assertThat(OpenWindow.ask(slider::getMaximum)).isEqualTo(FRAMES - 1);
            Dictionary<?, ?> labels = slider.getLabelTable();
            assertThat(new TreeSet<Object>(Collections.list(labels.keys()))).hasToString("[0, 4, 11]");
            assertThat(OpenWindow.ask(() -> slider.getToolTipText())).isEqualTo("Keys: light 1 (1), object 1 (2)");
            assertThat(number()).isEqualTo("Frame 0 of 0\u201311");

            OpenWindow.run(() -> window.open(SceneSource.file(TestScenes.THESIS)));
            window.untilState(RenderJob.State.FINISHED);
            Screen.until("the time line is gone", () -> !hasTimeLine());
            assertThat(window.canDo("Play Film")).isFalse();
            assertThat(window.canDo("First Frame")).isFalse();
        }
    }

    @WindowTest
    void theFrameOfTheSliderIsAPictureAsAnyOther() throws Exception {
        Path film = film("");
        try (OpenWindow window = finished(film)) {
            window.untilShown("the first frame", frame(film, 0));
            JSlider slider = slider();
            OpenWindow.run(() -> slider.setValue(7));
            window.untilShown("frame 7", frame(film, 7));
            window.untilState(RenderJob.State.FINISHED);
            assertThat(window.job().snapshot().frame()).isEqualTo(7);
            assertThat(OpenWindow.ask(() -> window.picture().whole() != null)).isTrue();
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_PAGE_DOWN);
            window.untilShown("frame 8", frame(film, 8));
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_END);
            window.untilShown("the last frame", frame(film, FRAMES - 1));
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_PAGE_DOWN);
            assertThat(number()).isEqualTo("Frame 11 of 0\u201311");
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_PAGE_UP);
            window.untilShown("frame 10", frame(film, 10));
            window.screen.click(OpenWindow.appears("the button", JButton.class,
                button -> "First Frame".equals(button.getAccessibleContext().getAccessibleName())));
            window.untilShown("the first frame again", frame(film, 0));
        }
    }

    @WindowTest
    void aFilmPlaysAgainAndAgainUntilItIsPaused() throws Exception {
        Path film = film("");
        try (OpenWindow window = finished(film)) {
            Set<Integer> seen = Collections.synchronizedSet(new TreeSet<>());
            JSlider slider = slider();
            OpenWindow.run(() -> slider.addChangeListener(e -> seen.add(slider.getValue())));
            window.screen.press(KeyEvent.VK_P);
            Screen.until("every frame was shown", () -> seen.size() == FRAMES);
            assertThat(OpenWindow.ask(() -> window.picture().isPlayed())).isTrue();
            assertThat(window.canDo("Pause Film")).isTrue();
            assertThat(window.canDo("Save Picture As\u2026")).as("of a film that plays").isFalse();
            window.screen.press(KeyEvent.VK_P);
            Screen.until("it stands", () -> !window.picture().isPlayed());
            window.untilState(RenderJob.State.FINISHED);
            int stands = OpenWindow.ask(slider::getValue);
            assertThat(window.job().snapshot().frame()).isEqualTo(stands);
            window.untilShown("the frame at which it stands", frame(film, stands));
        }
        assertThat(OpenWindow.threads()).isEmpty();
    }

    @WindowTest
    void withoutTheLoopItEndsAtTheLastFrame() throws Exception {
        Path film = film("");
        try (OpenWindow window = finished(film)) {
            window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_P);
            window.screen.press(KeyEvent.VK_P);
            Screen.until("it has ended", () -> number().equals("Frame 11 of 0\u201311") && !window.picture().isPlayed());
            window.untilShown("the last frame", frame(film, FRAMES - 1));
            window.screen.press(KeyEvent.VK_P);               // from the first one on
            Screen.until("it plays", () -> window.picture().isPlayed());
        }
    }

    @WindowTest
    void aClickOnThePicturePausesIt() throws Exception {
        try (OpenWindow window = finished(film(""))) {
            window.screen.press(KeyEvent.VK_P);
            Screen.until("it plays", () -> window.picture().isPlayed());
            window.screen.click(window.picture());
            Screen.until("it stands", () -> !window.picture().isPlayed());
            window.untilState(RenderJob.State.FINISHED);
            assertThat(window.job().snapshot().frame()).isEqualTo(OpenWindow.ask(slider()::getValue));
        }
    }

    @WindowTest
    void anotherStageEndsThePlayAtItsFrame() throws Exception {
        Path film = film("");
        try (OpenWindow window = finished(film)) {
            window.screen.press(KeyEvent.VK_P);
            Screen.until("it plays", () -> window.picture().isPlayed());
            window.screen.press(KeyEvent.VK_1);
            Screen.until("it stands", () -> !window.picture().isPlayed());
            window.untilState(RenderJob.State.FINISHED);
            assertThat(window.job().snapshot().frame()).isEqualTo(OpenWindow.ask(slider()::getValue));
        }
    }

    @WindowTest
    void aShorterFilmFromTheDiskStandsAtItsLastFrame() throws Exception {
        Path film = film("");
        try (OpenWindow window = finished(film)) {
            window.screen.press(KeyEvent.VK_ALT, KeyEvent.VK_END);
            window.untilShown("the last frame", frame(film, FRAMES - 1));
            TestScenes.write(film, "0\n1 1 1\n0\nframes 3 30\n");
            Screen.until("it is read", () -> number().equals("Frame 2 of 0\u20132"));
        }
    }

    @WindowTest
    void setCameraKeyWritesTheViewIntoTheFileAsAKeyOfTheFrame() throws Exception {
        Path film = film("camera 0 0 3  0 0 0  50\nkey 9 camera 0 0 3  0 0 0  50\n");
        try (OpenWindow window = finished(film)) {
            JSlider slider = slider();
            OpenWindow.run(() -> slider.setValue(4));
            window.untilShown("frame 4", frame(film, 4));
            window.screen.press(KeyEvent.VK_PAGE_DOWN);
            Screen.until("the camera is moved", () -> window.picture().request().settings().camera != null);
            window.untilState(RenderJob.State.FINISHED);
            double away = OpenWindow.ask(() -> window.picture().request().settings().camera.ez());
            window.screen.press(KeyEvent.VK_K);
            Screen.until("its mark is there", () -> slider.getLabelTable().get(4) != null && slider.getLabelTable().get(9) != null
                && slider.getToolTipText().contains("camera (2)"));
            Matcher key = Pattern.compile("\nkey 4 camera 0 0 (\\S+) 0 0 0 50\n").matcher(Files.readString(film));
            assertThat(key.find()).as("the key").isTrue();
            assertThat(key.group(1)).as("short for " + away).hasSizeLessThan(8);
            assertThat(Double.parseDouble(key.group(1))).isCloseTo(away, within(1e-3));
            assertThat(Files.readString(film)).contains("\nkey 9 camera 0 0 3  0 0 0  50\n");
            window.untilShown("frame 4, with the key", frame(film, 4));
            window.untilState(RenderJob.State.FINISHED);
            assertThat(window.status()).isEqualTo("Set the camera's key at frame 4 in " + film);
            assertThat(OpenWindow.ask(() -> window.picture().request().settings().camera)).isNull();
        }
    }

    @WindowTest
    void whileTheTextIsOpenTheKeyIsWrittenThereWithWhatWasTyped() throws Exception {
        Path film = film("camera 0 0 3  0 0 0  50\nkey 9 camera 0 0 3  0 0 0  50\n");
        String typed = Files.readString(film) + "# typed\n";
        try (OpenWindow window = finished(film)) {
            OpenWindow.run(() -> window.document().show(() -> { }));
            JSlider slider = slider();
            JTextComponent text = OpenWindow.appears("the text", JTextComponent.class,
                area -> "scene-text".equals(area.getName()) && area.isEnabled());
            OpenWindow.run(() -> text.setText(typed));
            Screen.until("it is rendered", () -> window.picture().source().path() != null && !window.picture().isBusy()
                && !(window.picture().source() instanceof FileSource));
            OpenWindow.run(() -> window.item("Farther").doClick(0));
            window.untilState(RenderJob.State.FINISHED);
            assertThat(OpenWindow.ask(() -> button("Save in Scene"))).as("of a camera with keys").isNull();
            window.screen.click(OpenWindow.appears("the button", JButton.class, button -> "Set Camera Key".equals(button.getText())));
            Screen.until("the key is in the text", () -> window.document().text().contains("\nkey 0 camera 0 0 3."));
            assertThat(window.document().text()).contains("# typed\n").contains("\nkey 9 camera 0 0 3  0 0 0  50\n");
            Screen.until("its mark is there", () -> slider.getToolTipText().contains("camera (2)"));
            assertThat(Files.readString(film)).doesNotContain("key 0 camera").doesNotContain("typed");
            Screen.until("the camera is the text's", () -> window.picture().request().settings().camera == null
                && button("Set Camera Key") == null);
            OpenWindow.run(() -> window.item("Save Scene").doClick(0));
            Screen.until("it is saved", () -> !window.document().isChanged());
            assertThat(Files.readString(film)).contains("# typed\n").contains("\nkey 0 camera 0 0 3.");
        }
    }

    private static JButton button(String text) {
        return OpenWindow.seen(JButton.class, button -> text.equals(button.getText()));
    }

    @WindowTest
    void aSceneThatIsNoFilmHasNoKeys() {
        try (OpenWindow window = finished(TestScenes.THESIS)) {
            window.screen.press(KeyEvent.VK_K);
            Screen.until("it is told", () -> window.status().equals("Only a film has keys: frames n fps, in the scene's text, makes one"));
        }
    }
}
