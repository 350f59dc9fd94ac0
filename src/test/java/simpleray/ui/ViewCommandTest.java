package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.io.TempDir;
import simpleray.render.Stage;

/** {@code java -jar simpleray.jar view}, as a program of its own. */
class ViewCommandTest {
    private static final int SIGTERM = 128 + 15;

    private final Screen screen = new Screen();

    @WindowTest
    void itTakesTheOptionsOfRenderAndShowsThePictureUntilItIsEnded() throws Exception {
        BufferedImage expected = TestScenes.rendered(TestScenes.THESIS, 300, 200, Stage.LIGHTING);
        Path java = Path.of(System.getProperty("java.home"), "bin", "java");
        Process process = new ProcessBuilder(java.toString(), "-jar", System.getProperty("simpleray.jar"), "view",
            TestScenes.THESIS.toString(), "--size", "300x200", "--stage", "lighting", "--look", "dark").inheritIO().start();
        try {
            Screen.until("the picture is somewhere on the screen", () -> {
                screen.send(KeyEvent.VK_CONTROL, KeyEvent.VK_0);          // at first it fits its pane
                return isShown(expected);
            });
            Screen.until("something dark is around it", this::isDark);
            process.destroy();

            assertThat(process.waitFor(20, TimeUnit.SECONDS)).isTrue();
            assertThat(process.exitValue()).isEqualTo(SIGTERM);
            Screen.until("the picture is gone", () -> !isShown(expected));
        } finally {
            process.destroyForcibly();
        }
    }

    /** Java's fonts keep a list in the user's home, which is {@code ?} for a user who is not in /etc/passwd. */
    @WindowTest
    void aUserWithoutAHomeGetsNoFolder(@TempDir Path folder) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Duser.home=?",
            "-Dsimpleray.rehearsal=true", "-jar", System.getProperty("simpleray.jar"), "view", TestScenes.THESIS.toString())
            .directory(folder.toFile()).inheritIO();
        builder.environment().keySet().removeAll(List.of("HOME", "XDG_CONFIG_HOME", "SIMPLERAY_PREFERENCES"));

        assertThat(builder.start().waitFor()).isZero();

        assertThat(folder).isEmptyDirectory();
    }

    /** {@return whether no large part of the screen is nearly white} */
    private boolean isDark() {
        BufferedImage capture = screen.capture();
        int bright = 0;
        for (int y = 0; y < capture.getHeight(); y += 4) {
            for (int x = 0; x < capture.getWidth(); x += 4) {
                bright += (capture.getRGB(x, y) & 0xFF) > 0xE0 ? 1 : 0;
            }
        }
        return bright < capture.getWidth() * capture.getHeight() / 16 / 100;
    }

    private boolean isShown(BufferedImage expected) {
        BufferedImage capture = screen.capture();
        for (int y = 0; y <= capture.getHeight() - expected.getHeight(); y++) {
            for (int x = 0; x <= capture.getWidth() - expected.getWidth(); x++) {
                if (Screen.shows(capture, x, y, expected, 0, expected.getHeight())) {
                    return true;
                }
            }
        }
        return false;
    }
}
