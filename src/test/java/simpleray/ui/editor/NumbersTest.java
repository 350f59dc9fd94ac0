package simpleray.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JColorChooser;
import javax.swing.JLabel;
import javax.swing.JSpinner;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.text.BadLocationException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.image.Picture;
import simpleray.scene.SceneFile;
import simpleray.ui.Mouse;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** The numbers of the scene's text: what each is, and how the mouse changes them while the picture follows. */
class NumbersTest {
    private static final int SIDE = 200;
    /** A ball to the left and one to the right, before nothing. */
    private static final String TEXT = "# \u00E4 balls\n2\n0 -1 0 0  0.50  0.2 0.4 0.6  0 0 0  0 0 0  1\n"
        + "0 1 0 0  .75  0.6 0.4 0.2  0 0 0  0 0 0  1 # right\n\n1 1 1\n\n1\n0 0.3 0.3 0.3  0 9 9\nsamples 1\n";

    @TempDir
    private Path folder;
    private Path scene;
    private OpenWindow window;
    private Mouse mouse;

    @BeforeEach
    void open() {
        scene = TestScenes.write(folder.resolve("balls.scene"), TEXT);
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        Screen.until("the text has the keys", () -> area() != null && area().isFocusOwner());
        untilNamed();
        mouse = new Mouse(area());
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void theStatusLineTellsWhatTheNumberAtTheCaretIs() {
        caret("0.50");
        assertThat(window.label("pixel")).isEqualTo("object 1 of 2, sphere: radius");
        caret("0.3 0.3 0.3");
        assertThat(window.label("pixel")).isEqualTo("light 1 of 1, point light: colour red");
        caret("# right");
        assertThat(window.label("pixel")).isBlank();
    }

    @WindowTest
    void theToolTipTellsWhatTheNumberUnderTheMouseIs() {
        assertThat(OpenWindow.ask(() -> tip(".75"))).isEqualTo("object 2 of 2, sphere: radius");
        assertThat(OpenWindow.ask(() -> tip("# right"))).isNull();
    }

    @WindowTest
    void namesFollowTheText() {
        OpenWindow.run(() -> area().insert("# another\n", 0));
        caret("0.50");
        assertThat(window.label("pixel")).isEqualTo("object 1 of 2, sphere: radius");
        OpenWindow.run(() -> area().insert("12", area().getText().indexOf(".75")));
        assertThat(OpenWindow.ask(() -> tip("12.75"))).isEqualTo("object 2 of 2, sphere: radius");
    }

    @WindowTest
    void anObjectAndItsNumbersLightUpTogether() {
        caret("0.50");
        assertThat(OpenWindow.ask(() -> area().lit())).startsWith("0", "-1", "0", "0", "0.50", "0.2").hasSize(15);
        Screen.until("the left ball is lit up", () -> isLit(new Point(24, 100)));
        assertThat(OpenWindow.ask(() -> isLit(new Point(112, 100)))).isFalse();

        new Mouse(window.picture()).move(OpenWindow.ask(() -> inPicture(new Point(150, 100))));
        Screen.until("the right ball's numbers are", () -> area().lit().contains(".75"));
        Screen.until("the right ball is", () -> isLit(new Point(112, 100)));
        assertThat(OpenWindow.ask(() -> isLit(new Point(24, 100)))).isFalse();
        mouse.move(OpenWindow.ask(() -> over("0.4 0.6")));
        Screen.until("the left one's are, under the mouse in the text", () -> area().lit().contains("0.50"));
    }

    @WindowTest
    void altAndADragChangeANumberInOneStep() throws IOException {
        String larger = TEXT.replace("0.50", "0.90");
        Point from = OpenWindow.ask(() -> over("0.50"));
        mouse.holding(KeyEvent.VK_ALT, () -> mouse.drag(InputEvent.BUTTON1_DOWN_MASK, from, new Point(from.x + 30, from.y - 10)));

        assertThat(text()).isEqualTo(larger.replace("0.90", "0.54"));
        untilPicture(TEXT.replace("0.50", "0.54"));
        OpenWindow.run(() -> area().undoLastAction());
        assertThat(text()).isEqualTo(TEXT);
        untilPicture(TEXT);
        assertThat(scene).hasContent(TEXT);
    }

    @WindowTest
    void altAndTheWheelChangeANumberInOneStep() {
        mouse.move(OpenWindow.ask(() -> over(".75")));
        mouse.holding(KeyEvent.VK_ALT, () -> {
            mouse.wheel(-1);
            mouse.wheel(-1);
            mouse.wheel(-1);
        });

        assertThat(text()).isEqualTo(TEXT.replace(".75", "0.78"));
        untilPicture(TEXT.replace(".75", ".78"));
        OpenWindow.run(() -> area().undoLastAction());
        assertThat(text()).isEqualTo(TEXT);
    }

    @WindowTest
    void aNumberThatIsOutOfRangeIsToldAndThePictureStays() {
        BufferedImage before = TestScenes.rendered(scene, SIDE, SIDE);
        mouse.move(OpenWindow.ask(() -> over("1\n0 0.3")));
        mouse.holding(KeyEvent.VK_ALT, () -> mouse.wheel(-1));

        window.untilProblems("light");
        assertThat(text()).contains("\n2\n0 0.3");
        window.untilShown("the picture before", before);
    }

    @WindowTest
    void whatIsTypedIsRenderedByItself() {
        caret("0.50");
        window.screen.press(KeyEvent.VK_DELETE);
        window.screen.type("1");

        Screen.until("it is typed", () -> text().equals(TEXT.replace("0.50", "1.50")));
        untilPicture(TEXT.replace("0.50", "1.50"));
        assertThat(scene).hasContent(TEXT);
    }

    @WindowTest
    void problemsAreThoseOfTheTextAsItIs() {
        RenderJob before = window.job();
        OpenWindow.run(() -> area().replaceRange("x", area().getText().indexOf("0.50"), area().getText().indexOf("0.50") + 4));
        window.untilProblems("expected object 1's radius, found 'x'");
        assertThat(OpenWindow.ask(() -> window.document().marked())).containsExactly("x: expected object 1's radius, found 'x'");
        assertThat(window.job()).as("the picture stays").isSameAs(before);
        OpenWindow.run(() -> area().undoLastAction());

        Screen.until("there are none", () -> window.problems() == null);
        assertThat(OpenWindow.ask(() -> window.document().marked())).isEmpty();
    }

    @WindowTest
    void withoutRenderingProblemsAreTold() {
        OpenWindow.run(window.item("Render While Typing")::doClick);
        RenderJob before = window.job();
        OpenWindow.run(() -> area().replaceRange("-1", area().getText().indexOf("0.50"), area().getText().indexOf("0.50") + 4));
        window.untilProblems("radius");
        OpenWindow.run(() -> area().replaceRange("2", area().getText().indexOf("-1  0.2"), area().getText().indexOf("-1  0.2") + 2));
        Screen.until("there are none", () -> window.problems() == null);

        assertThat(window.job()).isSameAs(before);
        OpenWindow.run(window.item("Render While Typing")::doClick);
        Screen.until("it is rendered", () -> window.picture().job() != before);
    }

    @WindowTest
    void coloursHaveASwatchAndAPicker() throws BadLocationException {
        Point bar = OpenWindow.ask(() -> {
            Point place = over("0.4 0.6");
            return new Point(place.x, place.y + area().getLineHeight() / 2 - 2);
        });
        Color shown = new Color(window.screen.capture(area(), new Rectangle(bar.x, bar.y, 1, 1)).getRGB(0, 0));
        assertThat(shown).isEqualTo(new Color(51, 102, 153));

        caret("0.4 0.6");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_P);
        JColorChooser chooser = OpenWindow.appears("the picker", JColorChooser.class, c -> true);
        assertThat(OpenWindow.ask(chooser::getColor)).isEqualTo(new Color(51, 102, 153));
        assertThat(OpenWindow.ask(() -> OpenWindow.all(chooser).filter(c -> c instanceof JSpinner && c.isShowing())
            .map(c -> ((JSpinner) c).getValue().toString()).limit(3).toList()))
            .as("hue, saturation, value").containsExactly("210", "66", "60");
        assertThat(text()).isEqualTo(TEXT);
        OpenWindow.run(() -> chooser.setColor(new Color(51, 255, 128)));
        untilPicture(TEXT.replace("0.2 0.4 0.6", "0.2 1 0.502"));
        OpenWindow.run(OpenWindow.appears("OK", JButton.class, b -> b.getText().equals("OK"))::doClick);
        Screen.until("it is closed", () -> !chooser.isShowing());

        assertThat(text()).isEqualTo(TEXT.replace("0.2 0.4 0.6", "0.2 1 0.502"));
        OpenWindow.run(() -> area().undoLastAction());
        assertThat(text()).isEqualTo(TEXT);
    }

    @WindowTest
    void aPickedColourIsGivenUp() {
        caret("0.4 0.6");
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_P);
        JColorChooser chooser = OpenWindow.appears("the picker", JColorChooser.class, c -> true);
        assertThat(OpenWindow.ask(() -> OpenWindow.all(chooser).filter(c -> c.isVisible() && c instanceof JLabel label
            && label.getText() != null && label.getText().matches("Transparency.*|Alpha.*")).toList())).isEmpty();
        OpenWindow.run(() -> chooser.setColor(Color.RED));
        Screen.until("the text follows", () -> text().contains("1 0 0  0 0 0"));
        OpenWindow.run(OpenWindow.appears("Cancel", JButton.class, b -> b.getText().equals("Cancel"))::doClick);

        Screen.until("the text is as before", () -> text().equals(TEXT));
    }

    @WindowTest
    void insertingRaisesTheCount() throws IOException {
        for (String name : List.of("Sphere", "Plane", "Triangle", "Cylinder", "Cone", "Point Light", "Directional Light", "Area Light")) {
            OpenWindow.run(() -> insert(name));
            String named = (name.endsWith("Light") ? "light " : "object ") + ".*" + name.toLowerCase(Locale.ROOT) + ": type .*";
            Screen.until("the new line is read", () -> window.document().valueLine().matches(named));
        }

        SceneFile read = SceneFile.parse(text());
        assertThat(read.scene().getNumberObjects()).isEqualTo(7);
        assertThat(read.scene().getNumberLights()).isEqualTo(4);
        assertThat(text()).contains("# right\n0  0 0 0").startsWith("# \u00E4 balls\n7\n");
        for (int i = 0; i < 8; i++) {
            OpenWindow.run(() -> area().undoLastAction());
        }
        assertThat(text()).isEqualTo(TEXT);
    }

    private void insert(String name) {
        Stream.of(window.item("Insert")).map(JMenu.class::cast).flatMap(menu -> Stream.of(menu.getMenuComponents()))
            .filter(item -> item instanceof JMenuItem it && it.getText().equals(name)).map(JMenuItem.class::cast).findFirst()
            .orElseThrow().doClick();
    }

    private SceneArea area() {
        SceneEditor editor = window.document().editor();
        return editor == null ? null : editor.area();
    }

    private String text() {
        return OpenWindow.ask(() -> area().getText());
    }

    /** Waits until the numbers of the text as it is have names. */
    private void untilNamed() {
        Screen.until("the numbers have names", () -> {
            ValueTable values = area().values();
            int last = values.size() - 1;
            return last >= 0 && values.end(last) == area().getText().stripTrailing().length() && values.value(last).name().startsWith("samples")
                && values.value(values.count("object")).name().equals("the number of objects")
                && area().getText().substring(values.start(values.count("object")), values.end(values.count("object")))
                    .equals(String.valueOf(values.value(values.last("object")).thing().number()));
        });
    }

    private void caret(String at) {
        OpenWindow.run(() -> area().setCaretPosition(area().getText().indexOf(at)));
    }

    /** {@return the middle of the first character of a piece of the text} */
    private Point over(String piece) {
        try {
            Rectangle place = area().modelToView2D(area().getText().indexOf(piece)).getBounds();
            return new Point(place.x + 3, place.y + place.height / 2);
        } catch (BadLocationException e) {
            throw new AssertionError(e);
        }
    }

    private String tip(String piece) {
        Point at = over(piece);
        return area().getToolTipText(new MouseEvent(area(), MouseEvent.MOUSE_MOVED, 0, 0, at.x, at.y, 0, false));
    }

    private Point inPicture(Point pixel) {
        Rectangle place = window.picture().place();
        return new Point(place.x + pixel.x, place.y + pixel.y);
    }

    /** {@return whether the screen shows the colour of an outline there} */
    private boolean isLit(Point pixel) {
        Point at = inPicture(pixel);
        Rectangle around = new Rectangle(at.x - 6, at.y, 13, 1);
        BufferedImage seen = window.screen.capture(window.picture(), around);
        for (int x = 0; x < around.width; x++) {
            if ((seen.getRGB(x, 0) & 0xFFFFFF) == 0xFFC800) {
                return true;
            }
        }
        return false;
    }

    private void untilPicture(String text) {
        BufferedImage expected = TestScenes.rendered(TestScenes.write(folder.resolve("other.scene"), text), SIDE, SIDE);
        Screen.until("the picture follows", () -> {
            Picture whole = window.picture().whole();
            return whole != null && TestScenes.sameAs(TestScenes.shown(whole), expected);
        });
    }
}
