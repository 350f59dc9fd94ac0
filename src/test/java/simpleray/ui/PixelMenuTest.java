package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Point;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.InputEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JTextArea;
import javax.swing.JTree;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.math.Colour;
import simpleray.rays.StoryText;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** The menu on a pixel, by the right mouse button. */
class PixelMenuTest {
    /** On sphere 2 of the thesis's room, object 7, line 31. */
    private static final Point PIXEL = new Point(45, 36);

    private OpenWindow window;

    @BeforeEach
    void finishThePicture() {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), 90, 60, made -> made.frame().setSize(820, 500));
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void itTellsWhyThePixelHasItsColour() throws Exception {
        choose("Why This Colour");

        OpenWindow.appears("the story", JTree.class, tree -> true);
        Screen.until("it is that of the pixel", () -> OpenWindow.seen(JComponent.class, c -> c instanceof JLabel label
            && "Pixel 45, 36".equals(label.getText())) != null);
    }

    @WindowTest
    void itShowsThePixelsRays() throws Exception {
        choose("Rays");

        OpenWindow.appears("the rays", JComponent.class, c -> "rays".equals(c.getName()));
        assertThat(OpenWindow.ask(window.item("Rays")::isSelected)).isTrue();
    }

    @WindowTest
    void itGoesToTheObjectsLine() throws Exception {
        choose("Go to Line");

        JTextArea text = OpenWindow.appears("the text", JTextArea.class, area -> area.getText().contains("#number of objects"));
        Screen.until("the caret is in line 31", () -> lineOfCaret(text) == 31);
    }

    @WindowTest
    void itCopiesTheColourOfATransparentPicture(@TempDir Path folder) throws Exception {
        Path scene = TestScenes.write(folder.resolve("a.scene"), Files.readString(TestScenes.THESIS) + "\nbackground none\n");
        OpenWindow.run(() -> window.open(SceneSource.file(scene)));
        Screen.until("it is rendered", () -> window.job().snapshot().picture() != null && window.job().snapshot().picture().hasAlpha());
        window.untilState(RenderJob.State.FINISHED);
        choose("Copy Colour");

        Screen.until("it is said", () -> window.status().startsWith("Copied: "));
        double[] row = window.job().snapshot().picture().row(PIXEL.y);
        String colour = StoryText.colour(new Colour(row[4 * PIXEL.x], row[4 * PIXEL.x + 1], row[4 * PIXEL.x + 2]));
        assertThat(Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor)).isEqualTo(colour);
    }

    @WindowTest
    void itCopiesTheColour() throws Exception {
        choose("Copy Colour");

        Screen.until("it is said", () -> window.status().startsWith("Copied: "));
        double[] row = window.job().snapshot().picture().row(PIXEL.y);
        String colour = StoryText.colour(new Colour(row[3 * PIXEL.x], row[3 * PIXEL.x + 1], row[3 * PIXEL.x + 2]));
        assertThat(Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor)).isEqualTo(colour);
    }

    @WindowTest
    void lookHereTurnsTheCameraToThatPoint() throws Exception {
        RenderJob before = window.job();
        choose("Look Here");

        Screen.until("the camera moves", () -> window.job() != before);
        window.untilState(RenderJob.State.FINISHED);
        assertThat(OpenWindow.ask(() -> window.job().snapshot().explainer()).objectAt(45, 30).number()).isEqualTo(7);
        assertThat(window.job().snapshot().settings().camera.lz()).isCloseTo(0.4, within(0.1));
    }

    private static int lineOfCaret(JTextArea text) {
        return OpenWindow.ask(() -> text.getDocument().getDefaultRootElement().getElementIndex(text.getCaretPosition()) + 1);
    }

    private void choose(String name) throws Exception {
        Point at = window.onScreen(PIXEL);
        Robot robot = new Robot();
        robot.mouseMove(at.x, at.y);
        robot.mousePress(InputEvent.BUTTON3_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON3_DOWN_MASK);
        window.screen.click(OpenWindow.appears(name, JMenuItem.class, item -> name.equals(item.getText())
            && item.getParent() instanceof JPopupMenu));
    }
}
