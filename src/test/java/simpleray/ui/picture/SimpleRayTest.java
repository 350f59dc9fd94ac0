package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import javax.swing.JFrame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

/** The thesis's applet in its new clothes: init, start, stop, run, paint and update, in a frame of somebody else. */
class SimpleRayTest {
    private static final int SIDE = 80;

    private final BufferedImage whole = TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE);
    private final Screen screen = new Screen();
    private final TestScenes.Gate gate = new TestScenes.Gate(0);
    private SimpleRay ray;
    private JFrame frame;

    @BeforeEach
    void makeAFrame() {
        frame = OpenWindow.ask(JFrame::new);
    }

    @AfterEach
    void close() {
        gate.open();
        OpenWindow.run(() -> {
            ray.stop();
            frame.dispose();
        });
        Screen.until("all threads end", () -> OpenWindow.threads().isEmpty());
    }

    @WindowTest
    void initMakesAnEmptyPicture() {
        show(SceneSource.file(TestScenes.THESIS));
        OpenWindow.run(ray::init);

        Screen.until("the component is blank", () ->
            screen.capture(ray, ray.getVisibleRect()).getRGB(SIDE / 2, SIDE / 2) == (0xFF000000 | Screen.SURROUND));
        assertThat(OpenWindow.threads()).isEmpty();
    }

    @WindowTest
    void startRendersAndShowsThePicture() {
        show(SceneSource.file(TestScenes.THESIS));
        OpenWindow.run(ray::init);
        OpenWindow.run(ray::start);

        Screen.until("the picture is on the screen", () -> isShown());
        Screen.until("it is whole", () -> ray.whole() != null);
    }

    @WindowTest
    void stopEndsTheThreads() {
        show(TestScenes.slow(TestScenes.THESIS));
        OpenWindow.run(ray::init);
        OpenWindow.run(ray::start);
        Screen.until("it renders", () -> OpenWindow.threads().size() > 1);
        OpenWindow.run(ray::stop);

        Screen.until("all threads end", () -> OpenWindow.threads().isEmpty());
        assertThat(OpenWindow.ask(ray::whole)).isNull();
    }

    @WindowTest
    void startAfterStopRendersAnew() {
        show(TestScenes.watched(TestScenes.THESIS, gate));
        OpenWindow.run(ray::init);
        OpenWindow.run(ray::start);
        OpenWindow.run(ray::stop);
        gate.open();
        OpenWindow.run(ray::start);

        Screen.until("the picture is on the screen", () -> isShown());
    }

    /** The kicker calls run; here somebody else does, in one go with the look at what it did. */
    @WindowTest
    void runTakesFinishedRowsIntoThePictureThatPaintAndUpdatePaint() {
        show(SceneSource.file(TestScenes.THESIS));
        OpenWindow.run(ray::init);
        OpenWindow.run(ray::start);
        Screen.until("all rows are finished", () -> ray.job().state().ended());
        OpenWindow.run(() -> {
            do {                                              // it stops in between where the machine is slow
                ray.run();
            } while (!ray.job().runs().isEmpty());
        });

        assertThat(Screen.shows(painted(ray::paint), 0, 0, whole, 0, SIDE)).isTrue();
        assertThat(Screen.shows(painted(ray::update), 0, 0, whole, 0, SIDE)).isTrue();
    }

    /** A ball of its ambient light alone, which the corners miss; the ground's squares have sides of 8. */
    @WindowTest
    void transparentPartsShowAChequeredGround() {
        show(SceneSource.text("1 0 0 0 0 1  1 0 0  0 0 0  0 0 0 1  1 1 1  0\nbackground none".getBytes(StandardCharsets.UTF_8)));
        OpenWindow.run(ray::init);
        OpenWindow.run(ray::start);
        Screen.until("the picture is whole", () -> ray.whole() != null);

        BufferedImage painted = painted(ray::paint);

        assertThat(ray.whole().hasAlpha()).isTrue();
        assertThat(painted.getRGB(0, 0)).isEqualTo(0xFF999999);
        assertThat(painted.getRGB(8, 0)).isEqualTo(0xFF666666);
        assertThat(painted.getRGB(8, 8)).isEqualTo(0xFF999999);
        assertThat(painted.getRGB(SIDE / 2, SIDE / 2)).isEqualTo(0xFFFF0000);
    }

    private void show(SceneSource source) {
        OpenWindow.run(() -> {
            ray = new SimpleRay(source, OpenWindow.request(SIDE, SIDE));
            frame.add(ray);
            frame.pack();
            frame.setSize(new Dimension(SIDE, SIDE));
            frame.setVisible(true);
        });
        Screen.until("the frame is on the screen", () -> ray.isShowing() && ray.getWidth() > 0);
    }

    private boolean isShown() {
        return Screen.shows(screen.capture(ray, ray.place()), 0, 0, whole, 0, SIDE);
    }

    private BufferedImage painted(Consumer<Graphics> how) {
        return OpenWindow.ask(() -> {
            BufferedImage image = new BufferedImage(ray.getWidth(), ray.getHeight(), BufferedImage.TYPE_INT_RGB);
            Graphics g = image.createGraphics();
            how.accept(g);
            g.dispose();
            return image.getSubimage(ray.place().x, ray.place().y, SIDE, SIDE);
        });
    }
}
