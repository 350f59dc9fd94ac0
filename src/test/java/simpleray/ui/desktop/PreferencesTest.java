package simpleray.ui.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.JFrame;
import javax.swing.JLabel;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.WindowTest;
import simpleray.ui.picture.SimpleRay;
import simpleray.ui.picture.ViewerContext;
import simpleray.ui.widget.Look;

/** What windows remember, and files of it that are broken. */
class PreferencesTest {
    private static final Rectangle PLACE = new Rectangle(-30, 40, 800, 600);

    @TempDir
    private Path folder;

    @WindowTest
    void whatIsChangedIsThereInTheNextRun() throws InterruptedException {
        Path file = folder.resolve("new").resolve("window.properties");
        Preferences first = Preferences.load(file);
        first.setPlace(PLACE, true);
        first.setLook(Look.DARK);
        first.setFolder(folder);
        first.opened(folder.resolve("a \u00e9 = # 'b'.scene"));
        end(first);

        Preferences second = Preferences.load(file);
        assertThat(second.place()).isEqualTo(PLACE);
        assertThat(second.isMaximised()).isTrue();
        assertThat(second.look()).isEqualTo(Look.DARK);
        assertThat(second.folder()).isEqualTo(folder);
        assertThat(second.recent()).containsExactly(folder.resolve("a \u00e9 = # 'b'.scene"));
        assertThat(folder.resolve("new")).isDirectoryNotContaining(other -> !other.equals(file));
        end(second);
    }

    @WindowTest
    void aNewUserHasTheDesktopsLookAndNothingElse() {
        assertIsNew(Preferences.load(folder.resolve("none")));
        assertIsNew(Preferences.none());
    }

    @WindowTest
    void theLastTenScenesAreRememberedTheLatestFirstAndEachOnce() {
        Preferences preferences = Preferences.none();
        IntStream.rangeClosed(1, 12).forEach(i -> preferences.opened(folder.resolve(i + ".scene")));
        preferences.opened(folder.resolve("5.scene"));
        assertThat(preferences.recent()).isEqualTo(scenes(5, 12, 11, 10, 9, 8, 7, 6, 4, 3));

        preferences.forget(folder.resolve("12.scene"));
        assertThat(preferences.recent()).isEqualTo(scenes(5, 11, 10, 9, 8, 7, 6, 4, 3));

        preferences.clearRecent();
        assertThat(preferences.recent()).isEmpty();
    }

    @WindowTest
    void whatTheWheelAndTypingDoIsRemembered() throws InterruptedException {
        Path file = folder.resolve("window.properties");
        JFrame first = OpenWindow.ask(() -> OpenWindow.hidden(Preferences.load(file)));
        OpenWindow.run(() -> {
            assertThat(OpenWindow.item(first, "Wheel Zooms").isSelected()).isFalse();
            assertThat(OpenWindow.item(first, "Render While Typing").isSelected()).isTrue();
            OpenWindow.item(first, "Wheel Zooms").doClick(0);
            OpenWindow.item(first, "Render While Typing").doClick(0);
        });
        OpenWindow.end(first);
        assertThat(file).content().contains("\ntyping.renders=false\n").contains("\nwheel.zooms=true\n");

        JFrame next = OpenWindow.ask(() -> OpenWindow.hidden(Preferences.load(file)));
        OpenWindow.run(() -> {
            assertThat(OpenWindow.item(next, "Wheel Zooms").isSelected()).isTrue();
            assertThat(OpenWindow.item(next, "Render While Typing").isSelected()).isFalse();
            SimpleRay picture = ((ViewerContext) next).picture();
            JLabel zoom = (JLabel) OpenWindow.all(next).filter(c -> "zoom".equals(c.getName())).findFirst().orElseThrow();
            String before = zoom.getText();
            picture.dispatchEvent(new MouseWheelEvent(picture, MouseEvent.MOUSE_WHEEL, 0, 0, 5, 5, 0, false,
                MouseWheelEvent.WHEEL_UNIT_SCROLL, 1, -1));
            assertThat(zoom.getText()).isNotEqualTo(before);
        });
        OpenWindow.end(next);
    }

    @WindowTest
    void twoWindowsDoNotForgetEachOthersScenes() throws InterruptedException {
        Path file = folder.resolve("shared.properties");
        Preferences one = Preferences.load(file);
        Preferences other = Preferences.load(file);
        one.opened(folder.resolve("1.scene"));
        end(one);
        other.opened(folder.resolve("2.scene"));
        end(other);

        assertThat(Preferences.load(file).recent()).isEqualTo(scenes(2, 1));
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "look = purple\nwindow.x = left\nwindow.y = 1\nwindow.width = 2\nwindow.height = 3\n"
            + "folder = relative\nrecent.1 =\nrecent.2 = relative",
        "window.x = 99999999999999999999\nwindow.y = 0\nwindow.width = 10\nwindow.height = 10",
        "window.x = 2147483647\nwindow.y = -2147483648\nwindow.width = 2147483647\nwindow.height = 2147483647",
        "window.x = 0\nwindow.y = 0\nwindow.width = 0\nwindow.height = -5",
        "window.x = 1e3\nwindow.y = NaN\nwindow.width = 0x10\nwindow.height = 5.5",
        "window.x = 5\nwindow.maximised = perhaps",
        "recent.1 = /nul\\u0000.scene\nfolder = \\u0000",
        "bad = \\uZZZZ", "===", "\\", ""})
    void nonsenseIsAsIfItWereNotThere(String text) throws IOException {
        assertIsNew(Preferences.load(Files.writeString(folder.resolve("bad.properties"), text)));
    }

    @WindowTest
    void binaryJunkIsAsIfItWereNotThereAndIsReplaced() throws IOException, InterruptedException {
        byte[] junk = new byte[2_000_000];
        new Random(1).nextBytes(junk);
        Path file = Files.write(folder.resolve("junk"), junk);
        Preferences preferences = Preferences.load(file);
        assertIsNew(preferences);

        preferences.setPlace(PLACE, false);
        end(preferences);
        assertThat(Preferences.load(file).place()).isEqualTo(PLACE);
    }

    @WindowTest
    void whatStandsBeforeABrokenLineIsKept() throws IOException {
        Path file = Files.writeString(folder.resolve("half"), "look = dark\nbad = \\uZZZZ\n");

        assertThat(Preferences.load(file).look()).isEqualTo(Look.DARK);
    }

    @WindowTest
    void aFolderInPlaceOfTheFileStaysAsItIs() throws InterruptedException {
        Preferences preferences = Preferences.load(folder);
        assertIsNew(preferences);
        preferences.setLook(Look.DARK);
        end(preferences);

        assertThat(preferences.look()).isEqualTo(Look.DARK);
        assertThat(folder).isEmptyDirectory();
    }

    @WindowTest
    void aFileInPlaceOfTheFolderStaysAsItIs() throws IOException, InterruptedException {
        Path wall = Files.writeString(folder.resolve("wall"), "a file");
        Preferences preferences = Preferences.load(wall.resolve("window.properties"));
        assertIsNew(preferences);
        preferences.opened(folder.resolve("1.scene"));
        end(preferences);

        assertThat(preferences.recent()).isEqualTo(scenes(1));
        assertThat(wall).hasContent("a file");
    }

    @WindowTest
    void whatCannotBeWrittenIsForgottenAtTheEnd() throws InterruptedException {
        Path file = Path.of("/proc/simpleray/window.properties");   // where nobody may write, not even root
        Preferences preferences = Preferences.load(file);
        preferences.setLook(Look.LIGHT);
        end(preferences);

        assertThat(preferences.look()).isEqualTo(Look.LIGHT);
        assertIsNew(Preferences.load(file));
    }

    @WindowTest
    void theFileCanBeReadByPeople() throws IOException, InterruptedException {
        Path file = folder.resolve("window.properties");
        Preferences preferences = Preferences.load(file);
        preferences.setPlace(PLACE, false);
        preferences.setLook(Look.DARK);
        end(preferences);

        assertThat(file).content(StandardCharsets.UTF_8).isEqualTo("# What SimpleRay's window remembers\nlook=dark\n"
            + "window.height=600\nwindow.maximised=false\nwindow.width=800\nwindow.x=-30\nwindow.y=40\n");
    }

    private List<Path> scenes(int... numbers) {
        return IntStream.of(numbers).mapToObj(i -> folder.resolve(i + ".scene")).collect(Collectors.toList());
    }

    private static void assertIsNew(Preferences preferences) {
        assertThat(preferences.place()).isNull();
        assertThat(preferences.isMaximised()).isFalse();
        assertThat(preferences.recent()).isEmpty();
        assertThat(preferences.folder()).isNull();
        assertThat(preferences.look()).isEqualTo(Look.SYSTEM);
    }

    private static void end(Preferences preferences) throws InterruptedException {
        preferences.close();
        preferences.await();
        Screen.until("all is written", () -> !OpenWindow.threads().contains("simpleray-preferences"));
    }
}
