package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.nio.file.Path;
import java.util.List;
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

    @Test
    void theNextWindowIsWhereTheLastOneWas() throws InterruptedException {
        Path file = folder.resolve("window.properties");
        ViewerFrame first = show(file);
        OpenWindow.run(() -> first.setBounds(PLACE));
        Screen.until("it is there", () -> first.getBounds().equals(PLACE) && first.picture().getWidth() > 0);
        close(first);

        ViewerFrame second = show(file);
        Screen.until("it is where the first was", () -> second.getBounds().equals(PLACE));
        close(second);
    }

    @Test
    void aWindowThatWasOnAScreenThatIsGoneCanBeSeen() throws InterruptedException {
        Path file = TestScenes.write(folder.resolve("far.properties"),
            "window.x=70000\nwindow.y=-90000\nwindow.width=800000\nwindow.height=600000\n");
        ViewerFrame frame = show(file);
        Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();

        Screen.until("it can be seen", () -> new Rectangle(screen).contains(frame.getBounds()));
        close(frame);
    }

    private static Rectangle seen(Rectangle place) {
        return WindowPlace.seen(place, List.of(LEFT, RIGHT));
    }

    private static ViewerFrame show(Path file) {
        ViewerFrame frame = OpenWindow.ask(() -> {
            ViewerFrame made = new ViewerFrame(SceneSource.NONE, OpenWindow.request(64, 64), Preferences.load(file), Look.LIGHT, () -> { });
            made.setVisible(true);
            return made;
        });
        Screen.until("the window is there", () -> frame.isShowing() && frame.isFocused());
        return frame;
    }

    private static void close(ViewerFrame frame) throws InterruptedException {
        OpenWindow.run(frame::close);
        frame.await();
    }
}
