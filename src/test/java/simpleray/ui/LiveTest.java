package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import javax.swing.JButton;
import javax.swing.Timer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.SceneSettings;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.Zoom;
import simpleray.ui.widget.Banner;

/** A window whose scene is changed, broken and deleted by other programs. */
class LiveTest {
    private static final int SIDE = 64;
    private static final String BAD = "1\n1  0 0 1 -1  0.2 0.4 oops  0 0 0  0 0 0  0\n1 1 1\n0\n";

    @TempDir
    private Path folder;
    private Path scene;
    private OpenWindow window;

    @BeforeEach
    void open() {
        scene = TestScenes.plain(folder.resolve("room.scene"), 0.2, 0.4, 0.6);
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);
        window.untilShown("the first picture", TestScenes.rendered(scene, SIDE, SIDE));
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aSavedSceneIsRendered(boolean inPlace) throws IOException {
        double best = Double.POSITIVE_INFINITY;               // told, not judged: 250 ms on a quiet machine
        for (int i = 1; i <= 3; i++) {
            RenderJob before = window.job();
            long begin = System.nanoTime();
            if (inPlace) {
                TestScenes.plain(scene, 0, 1, 0.25 * i);
            } else {
                Files.move(TestScenes.plain(folder.resolve("room.new"), 0, 1, 0.25 * i), scene, StandardCopyOption.ATOMIC_MOVE);
            }
            Screen.until("another rendering is there", () -> window.job() != before);
            best = Math.min(best, (System.nanoTime() - begin) / 1e9);
            window.untilShown("the new picture", TestScenes.rendered(scene, SIDE, SIDE));
        }
        System.out.println("a saved scene is rendered after " + best + " s");
    }

    @WindowTest
    void aSavedMeshIsRendered() throws IOException {
        Path mesh = TestScenes.write(folder.resolve("a b.obj"), "v -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 1 2 3\n");
        TestScenes.write(scene, "1\n4 \"a b.obj\" 0 0 0 1  1 0 0  0 0 0  0 0 0  0\n1 1 1\n0\n");
        window.untilShown("the mesh", TestScenes.rendered(scene, SIDE, SIDE));
        TestScenes.write(mesh, "v -9 -9 0\nv 1 -9 0\nv 0 9 0\nf 1 2 3\n");

        window.untilShown("the other mesh", TestScenes.rendered(scene, SIDE, SIDE));
    }

    @WindowTest
    void aBadSaveKeepsThePictureAndShowsTheErrorUntilTheSceneIsRepaired() throws IOException {
        BufferedImage good = TestScenes.rendered(scene, SIDE, SIDE);
        TestScenes.write(scene, BAD);
        window.untilProblems("oops");

        assertThat(window.problems().getText()).isEqualTo(scene + ":2:22: error: expected object 1's ambient blue, found 'oops'\n"
            + "1  0 0 1 -1  0.2 0.4 oops  0 0 0  0 0 0  0\n" + " ".repeat(21) + "^");
        Screen.until("the status bar says so", () -> window.status().equals("The scene was not read: see above"));
        window.untilShown("the good picture", good);
        TestScenes.plain(scene, 1, 0, 0);
        window.untilShown("the new picture", TestScenes.rendered(scene, SIDE, SIDE));
        Screen.until("the error is gone", () -> window.problems() == null);
    }

    @WindowTest
    void theSceneThatWasLastReadCanBeSeenOtherwiseWhileItsFileHasErrors() {
        BufferedImage original = TestScenes.rendered(scene, SIDE, SIDE, Stage.ORIGINAL);
        RenderRequest request = window.job().request();
        TestScenes.write(scene, BAD);
        window.untilProblems("found 'oops'");
        OpenWindow.run(() -> {
            window.picture().setRequest(request.with(Stage.ORIGINAL));
            window.picture().restart();
        });

        window.untilShown("the scene at another stage", original);
        window.untilProblems("found 'oops'");
    }

    @WindowTest
    void aHalfWrittenFileShowsNoError() {
        int minute = 60_000;
        OpenWindow.run(() -> window.viewer().setPatience(minute));
        RenderJob before = window.job();
        TestScenes.write(scene, "");
        Screen.until("half a scene was read", () -> window.job() != before
            && window.job().state() == RenderJob.State.FAILED && !window.picture().isBusy());
        assertThat(window.problems()).isNull();
        assertThat(window.status()).doesNotContain("not read");
        TestScenes.plain(scene, 1, 1, 0);

        window.untilShown("the picture", TestScenes.rendered(scene, SIDE, SIDE));
        assertThat(window.problems()).isNull();
    }

    @WindowTest
    void aDeletedSceneLeavesThePictureAndABannerUntilItIsBack() throws IOException {
        BufferedImage good = TestScenes.rendered(scene, SIDE, SIDE);
        Files.delete(scene);
        Screen.until("the banner is there", () -> OpenWindow.seen(Banner.class, b -> b.message("gone") != null) != null);

        assertThat(OpenWindow.ask(() -> window.banner().message("gone")))
            .isEqualTo("room.scene was deleted; the picture is the last one read");
        assertThat(window.problems()).isNull();
        window.untilShown("the picture", good);
        TestScenes.plain(scene, 0, 0, 1);
        window.untilShown("the new picture", TestScenes.rendered(scene, SIDE, SIDE));
        Screen.until("the banner is gone", () -> window.banner().message("gone") == null);
    }

    @WindowTest
    void readingASceneThatIsDeletedMeanwhileEnds() throws IOException {
        OpenWindow.run(() -> window.viewer().setPatience(Screen.SECONDS * 2 * 1000));
        TestScenes.write(scene, BAD);
        Screen.until("it is not read", () -> window.picture().job().state() == RenderJob.State.FAILED);
        Files.delete(scene);

        Screen.until("it is told", () -> window.status().equals("The scene was not read: see above"));
        assertThat(window.problems()).isNull();
    }

    @WindowTest
    void aBannerMovesNothingAndRendersNothing() throws IOException {
        OpenWindow.run(() -> {
            window.picture().setRequest(window.picture().request().with(new SceneSettings()));   // without a size
            window.picture().setZoom(new Zoom(true, 1), null);
            window.picture().restart();
            window.document().show(() -> { });
        });
        Screen.until("the picture has the size of its pane", () -> !window.picture().isBusy() && window.picture().imageSize().height > SIDE
            && window.picture().placed().scale() == 1 && window.document().text() != null);
        RenderJob before = window.job();
        List<Rectangle> places = places();
        Files.delete(scene);
        Banner banner = OpenWindow.appears("the banner", Banner.class, b -> b.message("gone") != null);
        CountDownLatch settled = new CountDownLatch(1);
        OpenWindow.run(() -> {
            Timer later = new Timer(600, e -> settled.countDown());   // longer than a resized picture waits
            later.setRepeats(false);
            later.start();
        });
        Screen.until("a resized picture would be rendered by now", () -> settled.getCount() == 0);

        assertThat(places()).isEqualTo(places);
        assertThat(window.job()).isSameAs(before);
        Rectangle tools = OpenWindow.ask(() -> window.frame.getContentPane().getComponent(0).getBounds());
        assertThat(OpenWindow.ask(banner::getHeight)).as("it lies over the tools alone").isLessThanOrEqualTo(tools.height);
        window.screen.click(OpenWindow.appears("a button", JButton.class, button -> "Hide".equals(button.getText())));
        Screen.until("it is hidden", () -> !banner.isShowing());
        assertThat(places()).isEqualTo(places);
    }

    /** {@return where the window's parts are on the screen} */
    private List<Rectangle> places() {
        return OpenWindow.ask(() -> OpenWindow.all(window.frame.getContentPane()).filter(Component::isShowing)
            .map(part -> new Rectangle(part.getLocationOnScreen(), part.getSize())).toList());
    }

    @WindowTest
    void anotherSceneIsWatchedOnceItIsOpened() {
        Path other = TestScenes.plain(folder.resolve("other.scene"), 1, 0, 0);
        OpenWindow.run(() -> window.open(SceneSource.file(other)));
        window.untilShown("the other", TestScenes.rendered(other, SIDE, SIDE));
        TestScenes.plain(scene, 0, 0, 0);
        TestScenes.plain(other, 0, 1, 1);

        window.untilShown("the other as it is now", TestScenes.rendered(other, SIDE, SIDE));
        Screen.until("one thread watches", () -> OpenWindow.threads().stream().filter("simpleray-watcher"::equals).count() == 1);
    }

    @WindowTest
    void stagesAreThoseOfTheSceneAsItIsNow() {
        window.screen.press(KeyEvent.VK_1);
        TestScenes.plain(scene, 0.5, 0, 0);

        window.untilShown("the stage", TestScenes.rendered(scene, SIDE, SIDE, Stage.ORIGINAL));
    }
}
