package simpleray.ui;

import java.awt.AWTException;
import java.awt.Image;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.widget.Look;

/** Makes the captures of docs/window.md: a program, run by hand where there is a display of 1280 x 1024 that nobody else uses. */
final class WindowCaptures {
    private static final int WIDTH = 400;
    private static final int HEIGHT = 300;

    private final Path folder;
    private final String suffix;

    private WindowCaptures(Path folder, String suffix) {
        this.folder = folder;
        this.suffix = suffix;
    }

    /** Writes the captures into a folder, light or dark: {@code FOLDER [light|dark] [SUFFIX]}. */
    public static void main(String... args) throws Exception {
        boolean dark = args.length > 1 && args[1].equals("dark");
        WindowCaptures captures = new WindowCaptures(Path.of(args[0]), args.length > 2 ? args[2] : "");
        captures.rays(dark);
        captures.coarse(dark);
        captures.finished(dark);
        captures.error(dark);
        System.exit(0);
    }

    private static OpenWindow open(SceneSource source, boolean dark, int width, int height) {
        OpenWindow window = new OpenWindow(source, WIDTH, HEIGHT, made -> made.frame().setSize(width, height));
        OpenWindow.run(() -> {
            Look.install(dark);
            window.viewer().lookChanged();
        });
        return window;
    }

    /** A pixel's rays, above its story. */
    private void rays(boolean dark) throws Exception {
        try (OpenWindow window = open(SceneSource.file(TestScenes.THESIS.resolveSibling("mirror-still-life.scene")), dark, 820, 500)) {
            window.untilState(RenderJob.State.FINISHED);
            new Mouse(window.picture()).move(at(window, 0.46, 0.66));
            window.screen.press(KeyEvent.VK_I);
            window.screen.press(KeyEvent.VK_V);
            Screen.until("the rays are there", () -> OpenWindow.seen(JComponent.class, c -> "rays".equals(c.getName())) != null);
            for (int i = 0; i < 5; i++) {
                window.screen.press(KeyEvent.VK_PERIOD);
            }
            capture(window, "rays");
        }
    }

    /** The first light: the coarse pass is through, and all later rays are held. */
    private void coarse(boolean dark) throws Exception {
        CountDownLatch gate = new CountDownLatch(1);
        AtomicInteger left = new AtomicInteger(WIDTH * HEIGHT / 64 + WIDTH * HEIGHT / 50);
        SceneSource held = TestScenes.watched(TestScenes.THESIS, ray -> {
            boolean fromTheEye = ray.origin.x == 0 && ray.origin.y == 0;
            if (fromTheEye && left.decrementAndGet() < 0) {
                try {
                    gate.await();
                } catch (InterruptedException e) {
                    throw new IllegalStateException(e);
                }
            }
        });
        try (OpenWindow window = open(held, dark, 640, 440)) {
            Screen.until("the coarse picture is there", () -> window.picture().job().runs().isCoarse() && left.get() < 0
                && window.picture().job().runs().isEmpty());
            capture(window, "coarse");
            gate.countDown();
            window.untilState(RenderJob.State.FINISHED);
        }
    }

    private void finished(boolean dark) throws Exception {
        try (OpenWindow window = open(SceneSource.file(TestScenes.THESIS), dark, 640, 440)) {
            window.untilState(RenderJob.State.FINISHED);
            Mouse mouse = new Mouse(window.picture());
            mouse.move(at(window, 0.4, 0.6));
            Screen.until("the pixel is told", () -> window.label("pixel").contains("object"));
            capture(window, "picture");

            window.screen.press(KeyEvent.VK_I);
            JTree tree = OpenWindow.appears("the story", JTree.class, t -> true);
            Screen.until("it is told", () -> tree.getRowCount() > 1);
            OpenWindow.run(() -> {
                window.frame.setSize(1040, 440);
                window.frame.validate();
                ((JSplitPane) SwingUtilities.getAncestorOfClass(JSplitPane.class, tree)).setDividerLocation(520);
            });
            capture(window, "story");
            window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_I);
            OpenWindow.run(() -> window.frame.setSize(640, 440));

            OpenWindow.run(() -> window.picture().requestFocusInWindow());
            mouse.drag(InputEvent.BUTTON1_DOWN_MASK, at(window, 0.5, 0.5), at(window, 0.6, 0.55));
            window.untilState(RenderJob.State.FINISHED);
            capture(window, "camera");
            window.screen.press(KeyEvent.VK_HOME);
            window.untilState(RenderJob.State.FINISHED);

            window.screen.press(KeyEvent.VK_M);
            untilLatest(window, "shadows");
            window.screen.press(KeyEvent.VK_3);
            untilLatest(window, "final");
            window.screen.press(KeyEvent.VK_W);
            OpenWindow.appears("the wipe", JPanel.class, p -> "compare".equals(p.getName()));
            OpenWindow.run(() -> window.frame.setSize(760, 440));
            capture(window, "wipe");
            window.screen.press(KeyEvent.VK_W);
            OpenWindow.run(() -> window.open(SceneSource.file(TestScenes.THESIS.resolveSibling("refraction.scene"))));
            Screen.until("a brighter scene", () -> window.picture().job().source().name().contains("refraction")
                && window.picture().job().state() == RenderJob.State.FINISHED && !window.picture().isBusy());
            window.screen.press(KeyEvent.VK_X);
            window.screen.press(KeyEvent.VK_H);
            window.screen.press(KeyEvent.VK_L);
            OpenWindow.appears("the histogram", JPanel.class, p -> "histogram".equals(p.getName()));
            OpenWindow.run(() -> window.frame.setSize(920, 440));
            capture(window, "histogram");
            window.screen.press(KeyEvent.VK_X);
            window.screen.press(KeyEvent.VK_H);
            OpenWindow.run(() -> window.frame.setSize(640, 640));
            window.screen.press(KeyEvent.VK_SHIFT, KeyEvent.VK_SLASH);
            JTable keys = OpenWindow.appears("the keys", JTable.class, t -> true);
            Screen.until("it has the keys", () -> SwingUtilities.getWindowAncestor(keys).isFocused());
            capture(window, "shortcuts");
            window.screen.press(KeyEvent.VK_ESCAPE);
        }
    }

    /** A good scene, then a bad save of it: the good picture stays, the text has a mark, the errors are links. */
    private void error(boolean dark) throws Exception {
        Path scene = Files.createDirectories(Path.of("build")).resolve("thesis.scene");
        String text = Files.readString(TestScenes.THESIS, StandardCharsets.UTF_8);
        Files.writeString(scene, text);
        try (OpenWindow window = open(SceneSource.file(scene), dark, 960, 560)) {
            window.untilState(RenderJob.State.FINISHED);
            window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
            OpenWindow.appears("the text", RSyntaxTextArea.class, a -> a.isEnabled() && a.getText().equals(text));
            Files.writeString(scene, text.replaceFirst("0\\.\\d+", "0.5x"));
            Screen.until("the error is told", () -> window.problems() != null && window.problems().getText().contains("0.5x")
                && !window.document().marked().isEmpty());
            capture(window, "error");
        }
    }

    private static void untilLatest(OpenWindow window, String stage) {
        Screen.until("the picture of " + stage + " is kept", () -> {
            List<?> kept = window.comparison().pictures();
            return !window.picture().isBusy() && !kept.isEmpty() && kept.get(kept.size() - 1).toString().startsWith(stage + ",");
        });
    }

    private static Point at(OpenWindow window, double x, double y) {
        Rectangle place = OpenWindow.ask(window.picture()::place);
        return new Point(place.x + (int) (x * place.width), place.y + (int) (y * place.height));
    }

    private void capture(OpenWindow window, String name) throws AWTException, IOException {
        for (int i = 0; i < 3; i++) {                         // what was asked for is laid out and painted
            OpenWindow.run(window.frame::validate);
            OpenWindow.run(window.frame::repaint);
        }
        Robot robot = new Robot();
        robot.delay(1500);                                    // nothing tells that the last repaint is on the screen
        robot.waitForIdle();
        List<Image> variants = robot.createMultiResolutionScreenCapture(OpenWindow.ask(window.frame::getBounds)).getResolutionVariants();
        Files.createDirectories(folder);
        ImageIO.write((BufferedImage) variants.get(variants.size() - 1), "png",
            folder.resolve("window-" + name + suffix + ".png").toFile());
    }
}
