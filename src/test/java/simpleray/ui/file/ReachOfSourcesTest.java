package simpleray.ui.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Reach;
import simpleray.scene.SceneSettings;
import simpleray.scene.ViewLines;
import simpleray.text.SceneFormatException;
import simpleray.ui.OpenWindow;
import simpleray.ui.WindowTest;
import simpleray.ui.picture.CommandWords;
import simpleray.ui.picture.RenderJob;

/** {@code view SCENE --allow-outside}: what was allowed when the window was opened holds for that scene, and for no other. */
class ReachOfSourcesTest {
    private static final String REFUSED = ":2:3: error: expected object 1's OBJ file within the scene's folder (--allow-outside allows any), "
        + "found '\"../out.obj\"'";

    @TempDir
    private Path all;
    private byte[] text;
    private Path scene;

    @BeforeEach
    void aSceneNamesAFileOutsideItsFolder() throws IOException {
        Files.writeString(all.resolve("out.obj"), "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
        text = "1\n4 \"../out.obj\" 0 0 0 1  1 1 1  1 1 1  0 0 0  2\n1 1 1\n0\n".getBytes(StandardCharsets.UTF_8);
        scene = Files.write(Files.createDirectory(all.resolve("mine")).resolve("a.scene"), text);
    }

    @WindowTest
    void aSceneThatIsOpenedInTheWindowStaysInItsFolder() {
        SceneSource source = SceneSource.file(scene);

        assertThatThrownBy(source::read).isInstanceOf(SceneFormatException.class).hasMessageStartingWith(scene + REFUSED);
        assertThatThrownBy(source.edited(text)::read).isInstanceOf(SceneFormatException.class).hasMessageStartingWith(scene + REFUSED);
    }

    @WindowTest
    void whatIsAllowedForASceneIsAllowedForItsUnsavedText() throws IOException {
        SceneSource source = SceneSource.file(scene, Reach.ANYWHERE);

        assertThat(source.read().scene().getNumberObjects()).isEqualTo(1);
        assertThat(source.edited(text).read().scene().getNumberObjects()).isEqualTo(1);
        assertThat(source.edited(text).edited(text).reach()).isEqualTo(Reach.ANYWHERE);
    }

    @WindowTest
    void itIsAllowedForStandardInputToo() throws IOException {
        byte[] named = new String(text, StandardCharsets.UTF_8).replace("../out.obj", all.resolve("out.obj").toString())
            .getBytes(StandardCharsets.UTF_8);

        assertThatThrownBy(SceneSource.text(named)::read).hasMessageStartingWith("<stdin>:2:3: error: expected object 1's OBJ file within ");
        assertThat(SceneSource.text(named, Reach.ANYWHERE).read().scene().getNumberObjects()).isEqualTo(1);
        assertThat(SceneSource.text(named, Reach.ANYWHERE).edited(named).read().scene().getNumberObjects()).isEqualTo(1);
    }

    @WindowTest
    void theViewOfSuchASceneCanBeSaved() throws IOException {
        FileSource source = new FileSource(scene, Reach.ANYWHERE);
        source.read();
        SceneSettings view = new SceneSettings();
        view.camera = new Pose(0, 0, 3, 0, 0, 0, 40);

        source.save((bytes, file, reach) -> ViewLines.put(bytes, file, view, reach));

        assertThat(source.read().scene().settings.camera).isEqualTo(view.camera);
    }

    @WindowTest
    void theViewOfASceneThatMayNotNameItIsNotSaved() throws IOException {
        FileSource source = new FileSource(scene, Reach.FOLDER);
        assertThatThrownBy(source::read).isInstanceOf(SceneFormatException.class);

        assertThatThrownBy(() -> source.save((bytes, file, reach) -> ViewLines.put(bytes, file, new SceneSettings(), reach)))
            .isInstanceOf(FileSystemException.class)
            .hasMessage(scene + ": It is not readable as a scene: " + scene + REFUSED);
        assertThat(scene).hasBinaryContent(text);
    }

    @WindowTest
    void theCopiedCommandLineAllowsWhatTheWindowWasAllowed() {
        RenderRequest request = new RenderRequest(new SceneSettings(), Stage.FINAL, false, 1);

        assertThat(CommandWords.line(scene, Reach.ANYWHERE, "a.png", 0, request)).endsWith(" -o a.png --allow-outside");
        assertThat(CommandWords.line(scene, Reach.FOLDER, "a.png", 0, request)).endsWith(" -o a.png");
    }

    @WindowTest
    void theWindowShowsTheMeshWhereverItLiesAndOpensNoOtherSceneSo() throws Exception {
        Path other = Files.write(scene.resolveSibling("b.scene"), text);
        try (OpenWindow window = new OpenWindow(SceneSource.file(scene, Reach.ANYWHERE), 60, 60)) {
            window.untilState(RenderJob.State.FINISHED);
            OpenWindow.run(window.picture()::reload);
            window.untilState(RenderJob.State.FINISHED);

            OpenWindow.run(() -> window.open(SceneSource.file(other)));
            window.untilState(RenderJob.State.FAILED);
        }
    }
}
