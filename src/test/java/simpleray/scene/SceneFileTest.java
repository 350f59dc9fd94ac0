package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

class SceneFileTest {
    private static final String LIT = "0\nambient colour\n0.5 0.5 0.5\n0\n";

    @TempDir
    private Path folder;

    @Test
    void aSceneComesWithTheWarningsOfItsFile() throws IOException {
        Path path = Files.writeString(folder.resolve("a.scene"), LIT);

        SceneFile file = SceneFile.read(path);

        assertThat(file.scene().ambient).hasToString("(0.5,0.5,0.5)");
        assertThat(file.warnings()).extracting(Diagnostic::headline).containsExactly(path
            + ":2:1: warning: expected a value or a comment, found the heading 'ambient colour', which is skipped");
    }

    @Test
    void aSceneMayComeFromAStreamThatStaysOpen() throws IOException {
        boolean[] closed = new boolean[1];
        SceneFile file = SceneFile.read(new ByteArrayInputStream(LIT.getBytes(StandardCharsets.UTF_8)) {
            @Override
            public void close() {
                closed[0] = true;
            }
        });

        assertThat(file.scene().ambient).hasToString("(0.5,0.5,0.5)");
        assertThat(file.warnings()).singleElement().extracting(Diagnostic::file).isEqualTo("<stdin>");
        assertThat(closed).containsExactly(false);
    }

    @Test
    void aSceneMayBeAString() throws IOException {
        SceneFile file = SceneFile.parse(LIT);

        assertThat(file.scene().ambient).hasToString("(0.5,0.5,0.5)");
        assertThat(file.warnings()).singleElement().extracting(Diagnostic::file).isEqualTo("scene");
        assertThatThrownBy(() -> SceneFile.parse("none")).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith("scene:1:5: error: expected the number of objects, found the end of the file");
    }

    @Test
    void aTextThatStandsForAFileIsCalledByItsNameAndFindsMeshesBesideIt() throws IOException {
        Path path = folder.resolve("unsaved.scene");
        Files.writeString(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        String text = "1\n4 \"a.obj\" 0 0 0 1  1 1 1  0 0 0  0 0 0  0\n" + LIT.substring(2);

        SceneFile file = SceneFile.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), path, Reach.FOLDER);

        assertThat(file.scene().getObject(0)).isInstanceOfSatisfying(Mesh.class, mesh -> assertThat(mesh.size()).isEqualTo(1));
        assertThat(file.warnings()).singleElement().extracting(Diagnostic::file).isEqualTo(path.toString());
        assertThat(file.text().name()).isEqualTo("unsaved.scene");
        assertThat(file.text().bytes()).asString(StandardCharsets.UTF_8).isEqualTo(text);
        assertThat(file.text().meshes()).extracting(SourceText.MeshFile::name).containsExactly("a.obj");
    }

    @Test
    void aFileThatIsNoSceneSaysWhy() throws IOException {
        Path path = Files.writeString(folder.resolve("a.scene"), "1\n98");

        assertThatThrownBy(() -> SceneFile.read(path)).isInstanceOf(SceneFormatException.class).hasMessage(
            path + ":2:1: error: expected object 1's type (" + Kinds.objects() + "; 1 object announced), found '98'"
                + "\n98\n^");
    }

    @Test
    void aMissingFileSaysSo() {
        Path path = folder.resolve("none.scene");
        assertThatThrownBy(() -> SceneFile.read(path)).isInstanceOf(FileSystemException.class).hasMessage(path + ": no such file");
    }

    @Test
    void aFolderIsNoScene() {
        assertThatThrownBy(() -> SceneFile.read(folder)).isInstanceOf(FileSystemException.class).hasMessage(folder + ": is a folder");
    }
}
