package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneReader;

/** Meshes read, written and printed; the OBJ's own errors are in {@link ObjReaderTest}. */
class MeshTextTest {
    private static final String MATERIAL = "1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0";
    private static final String END = MATERIAL + "\n0 0 0\n0\n";

    @TempDir
    private Path folder;
    private Path scene;

    @BeforeEach
    void aCubeLiesBesideTheScene() throws IOException {
        Files.writeString(folder.resolve("cube #1.obj"), MeshTest.CUBE);
        scene = folder.resolve("a.scene");
    }

    private Scene read(String text) throws IOException {
        return SceneFile.read(Files.writeString(scene, text)).scene();
    }

    private String message(String text) {
        return catchThrowableOfType(SceneFormatException.class, () -> read(text)).getMessage();
    }

    @Test
    void aFileIsFoundBesideTheSceneAndItsNameMayHoldBlanksAndHashes() throws IOException {
        Mesh mesh = (Mesh) read("1\n4 \"cube #1.obj\" 1 2 3  -0.5 " + END).getObject(0);

        assertThat(mesh.file).isEqualTo("cube #1.obj");
        assertThat(mesh.size()).isEqualTo(12);
        assertThat(mesh.offset).hasToString("[1.0,2.0,3.0]");
        assertThat(mesh.scale).isEqualTo(-0.5);
        assertThat(mesh.surfaceMaterial.shininess).isEqualTo(2);
    }

    @Test
    void fromAStreamAFileIsFoundByItsFullPath() throws IOException {
        Mesh mesh = new Mesh();
        SceneReader is = reader('"' + folder.resolve("cube #1.obj").toString() + "\" 0 0 0 1 " + MATERIAL);
        is.kept(MeshFiles.class, type -> new MeshFiles(Reach.ANYWHERE));
        mesh.read(is);
        assertThat(mesh.size()).isEqualTo(12);
    }

    @Test
    void aSceneWithMeshesIsWrittenAndReadsBackEqual() throws IOException {
        String text = "# number of objects\n2\n4  \"cube #1.obj\" 0.1 -2.0 1.0E-10 3.5  " + MATERIAL
            + "\n4  \"./cube #1.obj\" 0.0 0.0 0.0 1.0  " + MATERIAL
            + "\n# ambient light\n0.0 0.0 0.0\n# number of lights\n0\n";
        assertThat(written(read(text)::write)).isEqualTo(text);
    }

    @Test
    void aFileUsedTwiceIsReadOnce() throws IOException {
        Scene read = read("2\n4 \"cube #1.obj\" 0 0 0 1 " + MATERIAL + "\n4 \"./cube #1.obj\" 5 0 0 2 " + END);
        assertThat(read.getObject(0)).extracting("mesh").isSameAs(((Mesh) read.getObject(1)).mesh());
        assertThat(read.getObject(1).intersect(Scenes.ray(5.5, 0.5, 9, 0, 0, -1))).isEqualTo(7);
    }

    @Test
    void aMeshPrintsItsFileAndTriangles() throws IOException {
        Mesh mesh = new Mesh(new Material(), folder.resolve("cube #1.obj").toString(), new Point(1, 2, 3), 0.5);
        mesh.file = "cube.obj";
        assertThat(written(mesh::print)).isEqualTo("Mesh of \"cube.obj\" with 12 triangles, moved by [1.0,2.0,3.0], scaled by 0.5, "
            + "from [0.5,1.5,2.5] to [1.5,2.5,3.5]\n"
            + "Material: ambient (1.0,1.0,1.0) diffuse (1.0,1.0,1.0) specular (0.0,0.0,0.0) shininess 2.0");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "a\"b.obj", "a\nb.obj"})
    void aNameThatCannotBeQuotedCannotBeWritten(String name) {
        Mesh mesh = new Mesh();
        mesh.file = name;
        assertThatThrownBy(() -> written(mesh::write)).isInstanceOf(IllegalArgumentException.class);
    }

    @ParameterizedTest
    @ValueSource(strings = {"cube.obj", "\"cube.obj", "\"", "\"\"", "\"cube.obj\"0", "\"cube.obj\"\""})
    void aNameNotBetweenQuotesIsAnError(String name) throws IOException {
        String line = "4 " + name + " 0 0 0 1";
        SceneReader is = reader(line);                        // the 4, for a letter at the beginning of a line would be a heading
        is.readInt();
        assertThatThrownBy(() -> new Mesh().read(is)).hasMessage(
            "<stdin>:1:3: error: expected OBJ file between double quotes, found '" + name + "'\n" + line + "\n  ^");
    }

    @Test
    void anErrorAfterAnUnquotedBlankIsAtTheFirstQuote() {
        assertThat(message("1\n4 \"cube 1.obj 0 0 0 1 " + END)).startsWith(
            scene + ":2:3: error: expected object 1's OBJ file between double quotes, found '\"cube'\n4 \"cube 1.obj 0");
    }

    @Test
    void aMissingFileIsAnErrorAndReadingGoesOn() {
        assertThat(message("1\n4 \"no.obj\" 0 x 0 0 " + END)).isEqualTo(
            scene + ":2:3: error: expected object 1's OBJ file that can be read (" + folder.resolve("no.obj")
            + ": no such file), found '\"no.obj\"'\n4 \"no.obj\" 0 x 0 0 " + MATERIAL + "\n  ^\n"
            + scene + ":2:14: error: expected object 1's offset y, found 'x'\n4 \"no.obj\" 0 x 0 0 " + MATERIAL + "\n             ^\n"
            + scene + ":2:18: error: expected object 1's scale other than 0, found '0'\n4 \"no.obj\" 0 x 0 0 " + MATERIAL
            + "\n                 ^");
    }

    @Test
    void aFolderIsNoFile() throws IOException {
        Files.createDirectory(folder.resolve("sub"));
        assertThat(message("1\n4 \"sub\" 0 0 0 1 " + END)).startsWith(scene + ":2:3: error: expected object 1's OBJ file that can be read ("
            + folder.resolve("sub") + ": is a folder), found '\"sub\"'\n");
    }

    @Test
    void aNameThatNoFileCanHaveIsAnError() {
        assertThat(message("1\n4 \"a\0b\" 0 0 0 1 " + END)).contains(":2:3: error: expected object 1's OBJ file that can be read (")
            .contains("found '\"a\uFFFDb\"'");
    }

    @Test
    void anErrorInTheObjIsReportedOnceAmongThoseOfTheScene() throws IOException {
        Path obj = Files.writeString(folder.resolve("bad.obj"), "v 0 0\n");
        String text = "3\n0 0 0 0 -1 " + MATERIAL + "\n4 \"bad.obj\" 0 0 0 1 " + MATERIAL + "\n4 \"bad.obj\" 0 0 0 1 " + END;
        assertThat(message(text)).isEqualTo(
            scene + ":2:9: error: expected object 1's radius above 0, found '-1'\n0 0 0 0 -1 " + MATERIAL + "\n        ^\n"
            + obj + ":1:6: error: expected vertex 1's z, found the end of the line\nv 0 0\n     ^");
    }

    @Test
    void trianglesWithoutAreaAreAWarningOfTheScene() throws IOException {
        Path obj = Files.writeString(folder.resolve("flat.obj"), "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3 4\nf 1 1 2\n");
        SceneFile file = SceneFile.read(Files.writeString(scene, "1\n4 \"flat.obj\" 0 0 0 1 " + END));
        assertThat(file.warnings()).extracting(Diagnostic::toString).containsExactly(
            obj + ":5:1: warning: expected triangles that have an area, found 2 without, which are skipped\nf 1 2 3 4\n^");
        assertThat(((Mesh) file.scene().getObject(0)).size()).isEqualTo(1);
    }

    @Test
    void theConstructorSaysWhyAFileCannotBeRead() {
        String path = folder.resolve("no.obj").toString();
        assertThatThrownBy(() -> new Mesh(new Material(), path, new Point(), 1)).isInstanceOf(FileSystemException.class)
            .hasMessage(path + ": no such file");
    }
}
