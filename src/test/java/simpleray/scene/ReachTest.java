package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A scene names OBJ files in its own folder and below it, and others only where that is allowed. */
class ReachTest {
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    private static final String OUTSIDE = "OBJ file within the scene's folder (--allow-outside allows any), found '\"";

    @TempDir
    private Path all;
    private Path folder;

    @BeforeEach
    void thereAreAFolderForTheSceneAndAnother() throws IOException {
        folder = Files.createDirectories(all.resolve("mine"));
        Files.createDirectories(folder.resolve("sub"));
        Files.writeString(folder.resolve("in.obj"), TRIANGLE);
        Files.writeString(folder.resolve("sub/in.obj"), TRIANGLE);
        Files.createDirectories(all.resolve("other"));
        Files.writeString(all.resolve("other/out.obj"), TRIANGLE);
    }

    private static String text(String name) {
        return "1\n4 \"" + name + "\" 0 0 0 1  1 1 1  1 1 1  0 0 0  2\n0 0 0\n0\n";
    }

    private Path scene(String name) throws IOException {
        return Files.writeString(folder.resolve("a.scene"), text(name));
    }

    private void assertRefused(String name) throws IOException {
        Path scene = scene(name);
        assertThatThrownBy(() -> SceneFile.read(scene)).hasMessageStartingWith(
            scene + ":2:3: error: expected object 1's " + OUTSIDE + name + "\"'\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"in.obj", "./in.obj", "sub/in.obj", "sub/../in.obj", "sub//in.obj"})
    void aFileInTheFolderIsRead(String name) throws IOException {
        assertThat(SceneFile.read(scene(name)).scene().getNumberObjects()).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"../other/out.obj", "../mine/in.obj", "sub/../../other/out.obj", "../other/none.obj", "C:\\out.obj", "c:out.obj",
        "..\\other\\out.obj", "\\\\server\\out.obj", "sub\\..\\..\\out.obj", "..", "/"})
    void aFileOutsideIsRefusedWhetherItIsThereOrNot(String name) throws IOException {
        assertRefused(name);
    }

    @Test
    void aFullPathIsRefusedEvenIfItLeadsIntoTheFolder() throws IOException {
        assertRefused(folder.resolve("in.obj").toString());
    }

    @Test
    void linksThatLeadOutsideAreRefused() throws IOException {
        Files.createSymbolicLink(folder.resolve("link.obj"), Path.of("../other/out.obj"));
        Files.createSymbolicLink(folder.resolve("far"), all.resolve("other"));
        Files.createSymbolicLink(folder.resolve("nowhere.obj"), all.resolve("other/none.obj"));
        Files.createSymbolicLink(folder.resolve("chain.obj"), Path.of("link.obj"));

        assertRefused("link.obj");
        assertRefused("far/out.obj");
        assertRefused("far/none.obj");
        assertRefused("nowhere.obj");
        assertRefused("chain.obj");
    }

    @Test
    void linksWithinTheFolderAreFollowed() throws IOException {
        Files.createSymbolicLink(folder.resolve("link.obj"), Path.of("sub/in.obj"));
        assertThat(SceneFile.read(scene("link.obj")).scene().getNumberObjects()).isEqualTo(1);
    }

    @Test
    void aFolderThatIsReachedThroughALinkIsTheSameFolder() throws IOException {
        scene("in.obj");
        Path link = Files.createSymbolicLink(all.resolve("link"), folder);
        assertThat(SceneFile.read(link.resolve("a.scene")).scene().getNumberObjects()).isEqualTo(1);
    }

    @Test
    void whereItIsAllowedAllAreRead() throws IOException {
        Files.createSymbolicLink(folder.resolve("link.obj"), Path.of("../other/out.obj"));
        for (String name : new String[] {"../other/out.obj", all.resolve("other/out.obj").toString(), "link.obj"}) {
            assertThat(SceneFile.read(scene(name), Reach.ANYWHERE).scene().getNumberObjects()).isEqualTo(1);
        }
    }

    @Test
    void fromAStreamTheFolderIsTheWorkingDirectory() throws IOException {
        byte[] text = text(folder.resolve("in.obj").toString()).getBytes(StandardCharsets.UTF_8);

        assertThatThrownBy(() -> SceneFile.read(new ByteArrayInputStream(text))).hasMessageContaining("<stdin>:2:3: error: ")
            .hasMessageContaining(OUTSIDE);
        assertThat(SceneFile.read(new ByteArrayInputStream(text), Reach.ANYWHERE).scene().getNumberObjects()).isEqualTo(1);
    }
}
