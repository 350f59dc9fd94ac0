package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simpleray.SettingSamples;
import simpleray.cli.Main;
import simpleray.math.Colour;
import simpleray.render.Region;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Reach;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

/** The copied command line makes the very picture of the window, whatever the scene's name and options. */
class CommandWordsTest {
    @TempDir
    private Path folder;

    @WindowTest
    void theCopiedLineMakesTheWindowsPicture() throws Exception {
        Path scene = Files.copy(TestScenes.THESIS, folder.resolve("it's a $HOME \"scene\" & `more`; *.scene"));
        SceneSettings asked = new SceneSettings();
        asked.resolution = new SceneSettings.Resolution(90, 60);
        asked.camera = new Pose(0.1, 1.0 / 3, 3, -1e-7, 0, -1, 50);
        asked.background = new Colour(0.1, 0.2, 0.4);
        asked.depth = 3;
        asked.samples = 2;
        try (OpenWindow window = new OpenWindow(SceneSource.file(scene), 90, 60,
                frame -> frame.picture().setRequest(new RenderRequest(asked, Stage.FINAL, false, 2)))) {
            OpenWindow.run(window.picture()::reload);
            window.untilState(RenderJob.State.FINISHED);
            window.screen.press(KeyEvent.VK_2);
            Screen.until("the stage is shown", () -> window.job().request().stage() == Stage.LIGHTING
                && window.picture().whole() != null
                && !window.picture().isBusy());
            window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_C);
            Screen.until("the picture is copied", () -> window.status().equals("Copied the picture"));
            BufferedImage shown = (BufferedImage) contents(DataFlavor.imageFlavor);
            window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_L);
            Screen.until("the line is copied", () -> window.status().equals("Copied the command line"));

            assertThat(pixels(rendered((String) contents(DataFlavor.stringFlavor)))).isEqualTo(pixels(shown));
            window.untilShown("the copied picture", shown);
        }
    }

    @WindowTest
    void theLineOfARegionThatWasRenderedAloneMakesThatRegion() throws Exception {
        try (OpenWindow window = new OpenWindow(SceneSource.file(TestScenes.THESIS), 90, 60)) {
            window.untilState(RenderJob.State.FINISHED);
            OpenWindow.run(() -> {
                window.picture().regions().setAlone(true);
                window.picture().regions().set(new Region(20, 10, 30, 20));
            });
            Screen.until("the region is rendered", () -> window.picture().job().snapshot().isAlone() && !window.picture().isBusy()
                && window.item("Copy Command Line").isEnabled());
            assertThat(window.canDo("Copy Picture")).isFalse();
            window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_L);
            Screen.until("the line is copied", () -> window.status().equals("Copied the command line"));

            String line = (String) contents(DataFlavor.stringFlavor);
            assertThat(line).contains(" --region 20,10,30,20");
            assertThat(pixels(rendered(line)))
            .isEqualTo(pixels(TestScenes.rendered(TestScenes.THESIS, 90, 60).getSubimage(20, 10, 30, 20)));
        }
    }

    @WindowTest
    void onlyWhatWasAskedForIsSaid() {
        RenderRequest request = new RenderRequest(new SceneSettings(), Stage.FINAL, false, 4);

        assertThat(CommandWords.line(Path.of("/s/room.scene"), Reach.FOLDER, "room.png", 0, request)).endsWith(" render /s/room.scene -o room.png");
    }

    @WindowTest
    void aFrameIsSaidUnlessItIsTheFirst() {
        assertThat(CommandWords.line(Path.of("/s/film.scene"), Reach.FOLDER, "film.png", 12, new RenderRequest()))
            .endsWith(" -o film.png --frame 12");
    }

    @WindowTest
    void everyOptionIsSaid() {
        SceneSettings asked = new SceneSettings();
        asked.resolution = new SceneSettings.Resolution(640, 480);
        asked.window = new SceneSettings.Window(-1, 1.5, -0.1, 1e-10);
        asked.cop = 2.5;
        asked.depth = 0;
        asked.background = new Colour(0, 0.5, 1);

        assertThat(CommandWords.render(Path.of("/s/a b.scene"), "-a.png", new RenderRequest(asked, Stage.DIFFUSE, true, 4)))
            .containsExactly("render", "/s/a b.scene", "-o", "./-a.png", "--size", "640x480", "--stage", "diffuse", "--depth", "0",
                "--samples", "adaptive", "--cop", "2.5", "--window", "-1,1.5,-0.1,1.0E-10", "--background", "0,0.5,1");
    }

    @ParameterizedTest
    @MethodSource("settings")
    void everySettingWithAnOptionIsSaid(Setting<?> setting) {
        List<String> words = CommandWords.render(Path.of("/a.scene"), "a.png", new RenderRequest().with(SettingSamples.only(setting)));

        assertThat(words).endsWith(setting.option(), SettingSamples.value(setting)).hasSize(6);
    }

    static List<Setting<?>> settings() {
        return SettingSamples.withOption();
    }

    @WindowTest
    void wordsForAUnixShellAreQuotedWhereTheyMustBe() throws Exception {
        List<String> words = List.of("plain", "/a/b-c_d.scene", "640x480", "two words", "it's", "\"", "$HOME", "a\\b", "`ls`", "~", "*",
            "a;b",
            "line\nbreak", "", "\u00e9", "=x", "-1,2", "#no", "a#b", "!x", "{a,b}", "--size=3");

        assertThat(ShellWords.posix(words)).startsWith("plain /a/b-c_d.scene 640x480 'two words' 'it'\\''s' ");
        assertThat(split(ShellWords.posix(words))).isEqualTo(words);
    }

    @WindowTest
    void wordsForWindowsAreInDoubleQuotes() {
        assertThat(ShellWords.windows(List.of("simpleray", "render", "C:\\My Scenes\\a.scene", "-1,2")))
            .isEqualTo("simpleray render \"C:\\My Scenes\\a.scene\" \"-1,2\"");
    }

    @WindowTest
    void aSceneWithoutAFileHasNoCommandLine() {
        byte[] text = "0  0 0 0  0".getBytes(StandardCharsets.US_ASCII);
        try (OpenWindow window = new OpenWindow(SceneSource.text(text), 16, 16)) {
            window.untilState(RenderJob.State.FINISHED);

            assertThat(window.canDo("Copy Picture")).isTrue();
            window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_L);
            assertThat(window.status()).contains("save the scene first");
        }
    }

    private static Object contents(DataFlavor flavor) throws Exception {
        return Toolkit.getDefaultToolkit().getSystemClipboard().getData(flavor);
    }

    /** {@return the words that a shell makes of a line} */
    private static List<String> split(String line) throws IOException, InterruptedException {
        ProcessBuilder builder = new ProcessBuilder("sh", "-c", "eval \"set -- $LINE\"; printf '%s\\0' \"$@\"");
        builder.environment().put("LINE", line);
        builder.environment().put("LC_ALL", "C.UTF-8");
        Process shell = builder.start();
        String words = new String(shell.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(shell.waitFor()).isZero();
        return Arrays.asList(words.substring(0, words.length() - 1).split("\0", -1));
    }

    /** {@return the picture that a copied line makes} */
    private static BufferedImage rendered(String line) throws IOException, InterruptedException {
        List<String> words = split(line);
        List<String> args = new ArrayList<>(words.subList(words.indexOf("render"), words.size()));
        args.set(args.indexOf("-o") + 1, "-");
        args.add("-q");
        ByteArrayOutputStream picture = new ByteArrayOutputStream();
        assertThat(Main.run(args.toArray(new String[0]), InputStream.nullInputStream(), picture, System.err)).isZero();
        return ImageIO.read(new ByteArrayInputStream(picture.toByteArray()));
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }
}
