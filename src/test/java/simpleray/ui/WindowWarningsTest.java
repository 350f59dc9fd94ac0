package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
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

    @Test
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
