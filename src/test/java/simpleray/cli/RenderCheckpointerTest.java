package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;

@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RenderCheckpointerTest {
    @TempDir
    Path folder;

    /** The picture is worth more than what would be needed to go on with it. */
    @Test
    void aCheckpointForWhichThereIsNoMemoryIsGivenUp() throws Exception {
        Path path = folder.resolve("picture.part");
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        Renderer renderer = new Renderer(new Scene(), new SimpleCamera(4, 2), new RenderSettings());
        RenderCheckpointer.Notes notes =
            new RenderCheckpointer.Notes(new PrintStream(err, true, StandardCharsets.UTF_8), false, new String[0], null);

        try (RenderCheckpointer checkpointer = new RenderCheckpointer(path, renderer, () -> {
            throw new OutOfMemoryError("made up");
        }, notes)) {
            checkpointer.begin(new CheckpointOptions(), null, 0);
            while (err.size() == 0) {
                Thread.sleep(1);
            }
            checkpointer.row(0, new byte[12], 0);
            checkpointer.finished();
        }

        assertThat(err.toString(StandardCharsets.UTF_8))
            .isEqualToNormalizingNewlines("simpleray: " + path + ": rows are not kept any more: there is no memory left for it\n");
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void theCommandThatGoesOnHasItsOptionBeforeNamesThatBeginWithADash() {
        String[] args = {"render", "--restart", "-o", "my a.png", "--", "-x.scene"};

        assertThat(new RenderCheckpointer.Notes(System.err, false, args, null).command())
            .isEqualTo("simpleray render -o 'my a.png' --resume -- -x.scene");
    }
}
