package simpleray.ui.film;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;

class FilmPlayerTest {
    private static final RenderRequest REQUEST = OpenWindow.request(40, 30);

    private final ExecutorService worker = Executors.newSingleThreadExecutor();
    private final List<String> failures = Collections.synchronizedList(new ArrayList<>());

    @AfterEach
    void end() throws InterruptedException {
        worker.shutdownNow();
        assertThat(worker.awaitTermination(Screen.SECONDS, TimeUnit.SECONDS)).isTrue();
    }

    private FilmPlayer player(Scene scene) {
        return new FilmPlayer(worker, scene, REQUEST, new Resolution(40, 30), failures::add);
    }

    @WindowTest
    void eachFrameBecomesThePictureThatRenderMakesOfIt() throws Exception {
        Scene scene = SceneFile.parse("1\n0 0 0 -2 1  1 1 1  1 1 1  0 0 0  0\n0.3 0.3 0.3\n1\n0 1 1 1  0 0 9\n"
            + "frames 4 30\nkey 0 object 1 -1 0 0\nkey 3 object 1 1 0 0\n").scene();
        FilmPlayer player = player(scene);
        player.play(2, true);
        for (int frame = 0; frame < 4; frame++) {
            int wanted = frame;
            Screen.until("frame " + frame + " is fine", () -> player.cache().get(wanted) != null && player.cache().get(wanted).divisor() == 1);
            BufferedImage expected = TestScenes.shown(REQUEST.renderer(scene.still(frame)).render(RenderListener.NONE));
            assertThat(TestScenes.sameAs(player.cache().get(frame).image(), expected)).isTrue();
        }
        player.pause();

        assertThat(player.isPlaying()).isFalse();
        assertThat(failures).isEmpty();
    }

    @WindowTest
    void aFailureIsTold() throws Exception {
        Scene scene = SceneFile.parse("0\n1 1 1\n0\nframes 4 30\n").scene();
        FilmPlayer player = player(scene);
        player.play(-1, true);                                // there is no such frame

        Screen.until("it is told", () -> !failures.isEmpty());
        assertThat(failures.get(0)).startsWith("The film cannot be played: ");
        assertThat(player.isPlaying()).isFalse();
    }
}
