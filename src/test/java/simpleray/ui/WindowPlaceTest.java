package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A window comes back where it was, if it can be seen there. */
class WindowPlaceTest {
    private static final Rectangle LEFT = new Rectangle(0, 0, 1000, 800);
    private static final Rectangle RIGHT = new Rectangle(1000, 0, 1000, 800);
    private static final Rectangle PLACE = new Rectangle(70, 90, 800, 600);

    @TempDir
    private Path folder;

    @Test
    void aPlaceOnAnyScreenIsTaken() {
        assertThat(seen(new Rectangle(10, 20, 500, 400))).isEqualTo(new Rectangle(10, 20, 500, 400));
        assertThat(seen(new Rectangle(1500, 20, 800, 400))).isEqualTo(new Rectangle(1500, 20, 800, 400));
        assertThat(seen(new Rectangle(-300, 700, 500, 400))).isEqualTo(new Rectangle(-300, 700, 500, 400));
    }

    @Test
    void aWindowIsNoLargerThanItsScreen() {
        assertThat(seen(new Rectangle(10, 20, 1_000_000, 999_999))).isEqualTo(new Rectangle(10, 20, 1000, 800));
    }

    @Test
    void aPlaceWhereItCannotBeTakenHoldOfIsNotTaken() {
        assertThat(seen(new Rectangle(5000, 20, 500, 400))).isNull();
        assertThat(seen(new Rectangle(-450, 20, 500, 400))).isNull();
        assertThat(seen(new Rectangle(10, -30, 500, 400))).isNull();
        assertThat(seen(new Rectangle(10, 790, 500, 400))).isNull();
        assertThat(seen(null)).isNull();
    }

    /** The screen is asked: without a window manager the toolkit may take a window that has just been shown for one in the corner. */
    @Test
    void theNextWindowIsWhereTheLastOneWas() throws InterruptedException {
        Path file = folder.resolve("window.properties");
        with(file, first -> {
            OpenWindow.run(() -> first.setBounds(PLACE));
            Screen.until("it is there", () -> first.getBounds().equals(PLACE) && first.picture().getWidth() > 0);
        });
        assertThat(Preferences.load(file).place()).isEqualTo(PLACE);

        Screen screen = new Screen();
        with(file, second -> Screen.until("it is where the first was", () -> lit(screen.capture()).equals(PLACE)));
    }

    @Test
    void aWindowThatWasOnAScreenThatIsGoneCanBeSeen() throws InterruptedException {
        Path file = TestScenes.write(folder.resolve("far.properties"),
            "window.x=70000\nwindow.y=-90000\nwindow.width=800000\nwindow.height=600000\n");
        Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();

        with(file, frame -> Screen.until("it can be seen", () -> new Rectangle(screen).contains(frame.getBounds())));
    }

    /** {@return the least rectangle with all of a capture that is not black, as the empty screen is} */
    private static Rectangle lit(BufferedImage capture) {
        Rectangle lit = new Rectangle();
        for (int y = 0; y < capture.getHeight(); y++) {
            for (int x = 0; x < capture.getWidth(); x++) {
                if ((capture.getRGB(x, y) & 0xFFFFFF) != 0) {
                    lit = lit.isEmpty() ? new Rectangle(x, y, 1, 1) : lit.union(new Rectangle(x, y, 1, 1));
                }
            }
        }
        return lit;
    }

    private static Rectangle seen(Rectangle place) {
        return WindowPlace.seen(place, List.of(LEFT, RIGHT));
    }

    /** Does something with a window that has these preferences, and closes it, come what may: it would be in the way of others. */
    private static void with(Path file, Consumer<ViewerFrame> use) throws InterruptedException {
        ViewerFrame frame = OpenWindow.ask(() -> {
            ViewerFrame made = new ViewerFrame(SceneSource.NONE, OpenWindow.request(64, 64), Preferences.load(file), Look.LIGHT, () -> { });
            made.setVisible(true);
            return made;
        });
        try {
            Screen.until("the window is there", () -> frame.isShowing() && frame.isFocused());
            use.accept(frame);
        } finally {
            OpenWindow.run(frame::close);
            frame.await();
        }
    }
}
