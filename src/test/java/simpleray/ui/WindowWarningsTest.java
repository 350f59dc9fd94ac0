package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** What is odd about a picture is told below it. */
class WindowWarningsTest {
    private static final int SIDE = 64;

    @TempDir
    private Path folder;
    private OpenWindow window;

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void ofAFilmTheFirstFrameIsShownAndAnObjectThatComesLaterIsNoWarning() {
        String room = "2\n1  0 0 1 -1  0.2 0.4 0.6  0 0 0  0 0 0  0\n0  0 0 %s  1  0.2 0.4 0.6  0 0 0  0 0 0  0\n1 1 1\n0\ncamera 0 0 %s  0 0 0  50\n";
        Path scene = folder.resolve("film.scene");
        TestScenes.write(scene, room.formatted("9", "2") + "frames 9 25\nkey 0 object 2  0 0 1\nkey 8 object 2  0 0 -8.5\nkey 3 camera 0 0 3  0 0 0  50\n");
        Path first = folder.resolve("first.scene");
        TestScenes.write(first, room.formatted("10", "3"));
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);

        window.untilState(RenderJob.State.FINISHED);
        window.untilShown("the picture", TestScenes.rendered(first, SIDE, SIDE));
        assertThat(window.problems()).isNull();
    }

    @WindowTest
    void anObjectThatIsNotSeenIsToldOnceThePictureIsWhole() {
        Path scene = folder.resolve("room.scene");
        TestScenes.write(scene, "2\n1  0 0 1 -1  0.2 0.4 0.6  0 0 0  0 0 0  0\n0  0 0 9  1  0.2 0.4 0.6  0 0 0  0 0 0  0\n1 1 1\n0\n");
        window = new OpenWindow(SceneSource.file(scene), SIDE, SIDE);

        window.untilState(RenderJob.State.FINISHED);
        Screen.until("the warning is shown", () -> window.problems() != null);
        assertThat(window.problems().getText()).isEqualTo(scene + ":3:1: warning: object 2 was not seen by any of 18496 rays");
        window.untilShown("the picture", TestScenes.rendered(scene, SIDE, SIDE));
    }
}
