package simpleray.ui.desktop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JFrame;
import org.junit.jupiter.api.io.TempDir;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;

/** A window comes back where it was, if it can be seen there. */
class WindowPlaceTest {
    private static final Rectangle LEFT = new Rectangle(0, 0, 1000, 800);
    private static final Rectangle RIGHT = new Rectangle(1000, 0, 1000, 800);
    private static final Rectangle PLACE = new Rectangle(70, 90, 800, 600);

    @TempDir
    private Path folder;

    @WindowTest
    void aPlaceOnAnyScreenIsTaken() {
        assertThat(seen(new Rectangle(10, 20, 500, 400))).isEqualTo(new Rectangle(10, 20, 500, 400));
        assertThat(seen(new Rectangle(1500, 20, 800, 400))).isEqualTo(new Rectangle(1500, 20, 800, 400));
        assertThat(seen(new Rectangle(-300, 700, 500, 400))).isEqualTo(new Rectangle(-300, 700, 500, 400));
    }

    @WindowTest
    void aWindowIsNoLargerThanItsScreen() {
        assertThat(seen(new Rectangle(10, 20, 1_000_000, 999_999))).isEqualTo(new Rectangle(10, 20, 1000, 800));
    }

    @WindowTest
    void aPlaceWhereItCannotBeTakenHoldOfIsNotTaken() {
        assertThat(seen(new Rectangle(5000, 20, 500, 400))).isNull();
        assertThat(seen(new Rectangle(-450, 20, 500, 400))).isNull();
        assertThat(seen(new Rectangle(10, -30, 500, 400))).isNull();
        assertThat(seen(new Rectangle(10, 790, 500, 400))).isNull();
        assertThat(seen(null)).isNull();
    }

    /** What the window asks for is looked at, and that before it is shown: without a window manager the toolkit often learns its place wrong. */
    @WindowTest
    void aWindowIsWhereTheLastOneWasAndIsRemembered() throws InterruptedException, IOException {
        Path file = TestScenes.write(folder.resolve("window.properties"),
            "window.x=70\nwindow.y=90\nwindow.width=800\nwindow.height=600\n");

        JFrame frame = OpenWindow.ask(() -> OpenWindow.hidden(Preferences.load(file)));
        try {
            assertThat(frame.getBounds()).isEqualTo(PLACE);
            assertThat(frame.isLocationByPlatform()).isFalse();
        } finally {
            Files.delete(file);
            OpenWindow.end(frame);
            Screen.until("all is written", () -> !OpenWindow.threads().contains("simpleray-preferences"));
        }
        assertThat(Preferences.load(file).place()).isEqualTo(PLACE);
    }

    @WindowTest
    void aWindowThatWasOnAScreenThatIsGoneCanBeSeen() throws InterruptedException {
        Path file = TestScenes.write(folder.resolve("far.properties"),
            "window.x=70000\nwindow.y=-90000\nwindow.width=800000\nwindow.height=600000\n");
        Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();

        JFrame frame = OpenWindow.ask(() -> OpenWindow.hidden(Preferences.load(file)));
        try {
            OpenWindow.run(() -> frame.setVisible(true));
            Screen.until("it can be seen", () -> frame.isShowing() && new Rectangle(screen).contains(frame.getBounds()));
        } finally {
            OpenWindow.end(frame);
            Screen.until("all is written", () -> !OpenWindow.threads().contains("simpleray-preferences"));
        }
    }

    /** A place of the desktop's own choice is not always told to the toolkit, whose menus then open where the window is not. */
    @WindowTest
    void theFirstWindowIsInTheMiddleOfTheScreen() throws InterruptedException {
        Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();

        JFrame frame = OpenWindow.ask(() -> OpenWindow.hidden(Preferences.load(folder.resolve("none.properties"))));
        try {
            assertThat(frame.isLocationByPlatform()).isFalse();
            Rectangle place = frame.getBounds();
            assertThat(place.width).isEqualTo((int) (0.8 * screen.width));
            assertThat(place.getCenterX()).isCloseTo(screen.width / 2.0, within(1.0));
            assertThat(place.getCenterY()).isCloseTo(screen.height / 2.0, within(1.0));
        } finally {
            OpenWindow.end(frame);
            Screen.until("all is written", () -> !OpenWindow.threads().contains("simpleray-preferences"));
        }
    }

    private static Rectangle seen(Rectangle place) {
        return WindowPlace.seen(place, List.of(LEFT, RIGHT));
    }
}
