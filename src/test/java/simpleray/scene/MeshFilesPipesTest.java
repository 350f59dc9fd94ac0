package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A pipe or a device in place of an OBJ might never end, or never begin: nobody waits for it. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class MeshFilesPipesTest {
    @TempDir
    private Path folder;

    private Path scene(String name) throws IOException {
        return Files.writeString(folder.resolve("a.scene"), "1\n4 \"" + name + "\" 0 0 0 1  1 1 1  1 1 1  0 0 0  2\n0 0 0\n0\n");
    }

    @Test
    void aPipeInPlaceOfAnObjIsRefused() throws Exception {
        Path pipe = folder.resolve("pipe.obj");
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/mkfifo")), "needs mkfifo");
        assertThat(new ProcessBuilder("/usr/bin/mkfifo", pipe.toString()).inheritIO().start().waitFor()).isZero();

        assertThatThrownBy(() -> SceneFile.read(scene("pipe.obj"))).hasMessageStartingWith(folder.resolve("a.scene")
            + ":2:3: error: expected object 1's OBJ file that can be read (" + pipe + ": is no regular file), found '\"pipe.obj\"'");
    }

    @Test
    void aDeviceInPlaceOfAnObjIsRefused() throws IOException {
        assumeTrue(Files.exists(Path.of("/dev/zero")), "needs /dev/zero");
        Path scene = scene("/dev/zero");

        assertThatThrownBy(() -> SceneFile.read(scene, Reach.ANYWHERE)).hasMessageStartingWith(scene
            + ":2:3: error: expected object 1's OBJ file that can be read (/dev/zero: is no regular file), found '\"/dev/zero\"'");
    }
}
