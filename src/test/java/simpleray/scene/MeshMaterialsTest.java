package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Colour;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneText;

/** The materials that MTL files give the polygons of a mesh: one triangle for each {@code usemtl}, the first one without. */
class MeshMaterialsTest {
    private static final String OWN = "0.1 0.2 0.3  0.4 0.5 0.6  0.7 0.8 0.9  12";
    private static final String RED = "newmtl red\nKa 0.1 0 0\nKd 0.8 0 0\nKs 0.25 0.5 0.75\nNs 50\n";

    @TempDir
    private Path folder;
    private List<Diagnostic> warnings;

    @BeforeEach
    void thereIsAnMtlFile() throws IOException {
        mtl("a.mtl", RED);
    }

    private void mtl(String name, String text) throws IOException {
        Files.createDirectories(folder.resolve(name).getParent());
        Files.writeString(folder.resolve(name), text);
    }

    /** {@return an OBJ of triangles one after another: one before the first line, and one after each} */
    private static String obj(String... lines) {
        return "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + String.join("\nf 1 2 3\n", lines) + "\nf 1 2 3\n";
    }

    private Mesh read(String obj) throws IOException {
        return read(obj, OWN + " mtl");
    }

    private Mesh read(String obj, String material) throws IOException {
        Files.writeString(folder.resolve("a.obj"), obj);
        SceneFile file = SceneFile.read(Files.writeString(folder.resolve("a.scene"), "1\n4 \"a.obj\" 0 0 0 1  " + material + "\n1 1 1\n0\n"));
        warnings = file.warnings();
        return (Mesh) file.scene().getObject(0);
    }

    private void assertWarnings(String... expected) {
        assertThat(warnings).extracting(warning -> warning.toString().replace(folder + "/", "").lines().findFirst().orElseThrow())
            .containsExactly(expected);
    }

    private static String text(Material material) {
        return SceneText.written(material::write);
    }

    /** {@return the material of the triangle after the only line} */
    private Material material(String mtl) throws IOException {
        mtl("a.mtl", mtl);
        return read(obj("mtllib a.mtl\nusemtl red")).material(1);
    }

    @Test
    void polygonsHaveTheMaterialThatTheyUse() throws IOException {
        mtl("a.mtl", RED + "newmtl blue\nKa 0 0 1\nKd 0 0 0.5\nKs 0 0 0\nNs 3\nillum 1\n");
        Mesh mesh = read(obj("mtllib a.mtl", "usemtl red", "usemtl blue", "g x", "usemtl red", "usemtl"));

        assertThat(mesh.size()).isEqualTo(7);
        String red = "0.1 0.0 0.0  0.8 0.0 0.0  0.25 0.5 0.75  50.0";
        String blue = "0.0 0.0 1.0  0.0 0.0 0.5  0.0 0.0 0.0  3.0  mirror 0.0 0.0 0.0";
        assertThat(List.of(0, 1, 2, 3, 4, 5, 6)).extracting(i -> text(mesh.material(i)))
            .containsExactly(text(mesh.surfaceMaterial), text(mesh.surfaceMaterial), red, blue, blue, red, text(mesh.surfaceMaterial));
        assertThat(mesh.material(2)).isSameAs(mesh.material(5));
        assertThat(mesh.origin(mesh.material(3))).isEqualTo(new RayTree.Mtl("blue", folder.resolve("a.mtl").toString(), 6));
        assertThat(mesh.origin(mesh.surfaceMaterial)).isNull();
        assertThat(warnings).isEmpty();
    }

    @Test
    void withoutTheWordAllHaveTheMeshsOwn() throws IOException {
        Mesh mesh = read(obj("mtllib none.mtl\nusemtl red"), OWN);

        assertThat(mesh.material(1)).isSameAs(mesh.surfaceMaterial);
        assertThat(warnings).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {" mtl", "\nmtl", " # own\n\n  mtl # theirs\n", " mirror 0 0 0 mtl", "\ntransmit 0 0 0 1\nmirror 0 0 0\nmtl"})
    void theWordStandsBehindTheWholeMaterial(String end) throws IOException {
        assertThat(text(read(obj("mtllib a.mtl\nusemtl red"), OWN + end).material(1))).startsWith("0.1 0.0 0.0  0.8");
        assertThat(warnings).isEmpty();
    }

    @Test
    void theWordIsWrittenAndPrinted() throws IOException {
        Mesh mesh = read(obj("mtllib a.mtl\nusemtl red"));

        assertThat(SceneText.written(mesh::write)).endsWith("0.7 0.8 0.9  12.0  mtl");
        assertThat(SceneText.written(mesh::print)).contains(", with the materials of its MTL files\nMaterial: ambient (0.1,0.2,0.3)");
        assertThat(SceneText.written(read(obj("usemtl red"), OWN)::write)).endsWith("12.0");
    }

    /** Of the four that a scene gives each material, what is missing is the mesh's own. */
    @Test
    void whatAMaterialDoesNotSayIsTheMeshsOwn() throws IOException {
        assertThat(text(material("newmtl red\nKd 1 0 0\n"))).isEqualTo("0.1 0.2 0.3  1.0 0.0 0.0  0.7 0.8 0.9  12.0");
        Mesh glass = read(obj("mtllib a.mtl\nusemtl red"), OWN + " mirror 1 1 1 transmit 1 1 1 2 mtl");
        assertThat(text(glass.material(1))).isEqualTo("0.1 0.2 0.3  1.0 0.0 0.0  0.7 0.8 0.9  12.0");
        assertThat(glass.isOpaque()).isFalse();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"d 1|", "Tr 0|", "d 0.25|transmit 0.75 0.75 0.75  1.0", "Tr 0.75 / Ni 1.5|transmit 0.75 0.75 0.75  1.5",
        "d 0.5 / Tf 0.5 1 0 / Ni 1.33|transmit 0.5 1.0 0.0  1.33", "Tf 1 1 1 / Ni 1.5|", "Ni 0.5|", "d 1 / Tr 1|", "Tr 1 / d 0.75|transmit 0.25 0.25 0.25  1.0",
        "d -halo 0.5|transmit 0.5 0.5 0.5  1.0", "illum 0|mirror 0.0 0.0 0.0", "illum 1|mirror 0.0 0.0 0.0", "illum 2|mirror 0.0 0.0 0.0", "illum 3|", "illum 10|",
        "illum 2 / d 0|mirror 0.0 0.0 0.0  transmit 1.0 1.0 1.0  1.0", "d 0.5 / d 1|", "d x / d 1|", "Tf 0.5 / Tr 0.5|transmit 0.5 0.5 0.5  1.0"})
    void transparencyAndIlluminationBecomeTransmitAndMirror(String lines, String end) throws IOException {
        Material material = material("newmtl red\nKa 0 0 0\nKd 0 0 0\nKs 1 1 1\nNs 1\n" + lines.replace(" / ", "\n") + "\n");

        assertThat(text(material)).isEqualTo("0.0 0.0 0.0  0.0 0.0 0.0  1.0 1.0 1.0  1.0" + (end == null ? "" : "  " + end));
    }

    @ParameterizedTest
    @ValueSource(strings = {"newmtl red\r\nKd 0.5 0.25 1 # x\r\n", "# x\n\tNEWMTL  red \n  kd\t0.5 \\\n 0.25 1 7\n", "\uFEFFnewmtl red # not blue\nKd 5e-1 .25 1.",
        "newmtl Red\nKd 1 1 1\nnewmtl red\nKd 0.5 0.25 1\nnewmtl RED\nKd 0 0 0\n", "newmtl red\rKd 0.5 0.25 1\rKe 1 1 1\rPr 0.5\r"})
    void aFileMayBeWrittenInManyWays(String mtl) throws IOException {
        Colour kd = material(mtl).diffuse;

        assertThat(List.of(kd.r, kd.g, kd.b)).containsExactly(0.5, 0.25, 1.0);
        assertThat(warnings).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"dark red wood", "Material #12", "a\tb", "\u00e9t\u00e9 \ud83d\ude00", "(null)", "0", "C:\\wood", "x=1,y"})
    void namesMayHaveBlanksAndSigns(String name) throws IOException {
        mtl("a.mtl", "newmtl Material #1\nKd 0 0 0\nnewmtl " + name + "\nKd 1 0 0\nnewmtl " + name + "x\nKd 0 0 0\n");

        assertThat(read(obj("mtllib a.mtl\nusemtl  " + name + " \r")).material(1).diffuse.r).isEqualTo(1);
        assertThat(read(obj("mtllib a.mtl\nusemtl " + name + " # comment")).material(1).diffuse.r).isEqualTo(1);
        assertThat(warnings).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"a.mtl", "a.mtl # comment", "b.mtl a.mtl", "b.mtl\nmtllib a.mtl", "my house #1.mtl", "my house #1.mtl # x", "b.mtl my house #1.mtl",
        "sub\\c.mtl", "./sub/c.mtl", "sub/../a.mtl", "plain", "b.mtl \\\n a.mtl", "b.mtl plain"})
    void filesAreFoundByTheirNames(String names) throws IOException {
        for (String file : List.of("my house #1.mtl", "sub/c.mtl", "plain")) {
            mtl(file, RED);
        }
        mtl("b.mtl", "newmtl blue\n");

        assertThat(text(read(obj("mtllib " + names + "\nusemtl red")).material(1))).startsWith("0.1 0.0 0.0  0.8");
        assertThat(warnings).isEmpty();
    }

    @Test
    void anMtlFileLiesBesideItsObj() throws IOException {
        mtl("models/a.mtl", "newmtl red\nKd 1 1 1");
        Files.writeString(folder.resolve("models/b.obj"), obj("mtllib a.mtl\nusemtl red"));
        Files.writeString(folder.resolve("models/c.obj"), obj("mtllib ../a.mtl\nusemtl red"));
        SceneFile file = SceneFile.read(Files.writeString(folder.resolve("b.scene"), "2\n4 \"models/b.obj\" 0 0 0 1  " + OWN
            + " mtl\n4 \"models/c.obj\" 0 0 0 1  " + OWN + " mtl\n1 1 1\n0\n"));

        assertThat(file.warnings()).isEmpty();
        assertThat(file.scene().getObject(0).material(1).diffuse.g).isEqualTo(1);
        assertThat(file.scene().getObject(1).material(1).diffuse.g).isEqualTo(0);
        assertThat(file.text().meshes()).extracting(SourceText.MeshFile::name)
            .containsExactly("models/b.obj", "models/a.mtl", "models/c.obj", "models/../a.mtl");
    }

    @Test
    void theFirstDefinitionCounts() throws IOException {
        mtl("b.mtl", "newmtl red\nKd 0 1 0\n");

        assertThat(read(obj("mtllib a.mtl b.mtl\nusemtl red")).material(1).diffuse.g).isEqualTo(0);
        assertThat(read(obj("mtllib b.mtl a.mtl\nusemtl red")).material(1).diffuse.g).isEqualTo(1);
        assertThat(warnings).isEmpty();
        mtl("b.mtl", "newmtl red\nKd 0 1 0\nnewmtl red\nKd 1 0 0\n");
        assertThat(read(obj("mtllib b.mtl\nusemtl red")).material(1).diffuse.g).isEqualTo(1);
        assertWarnings("b.mtl:3:1: warning: expected a name of its own for each material, found 1 that is there before, and of which the first counts");
    }

    @Test
    void meshesOfOneFileShareWhatIsReadAndKeepTheirOwn() throws IOException {
        mtl("a.mtl", "newmtl red\nKd 1 0 0\nmap_Kd x.png\n");
        Files.writeString(folder.resolve("a.obj"), obj("mtllib a.mtl\nusemtl red"));
        SceneFile file = SceneFile.read(Files.writeString(folder.resolve("a.scene"), "3\n4 \"a.obj\" 0 0 0 1  " + OWN + " mtl\n4 \"a.obj\" 0 0 0 1  "
            + OWN + "\n4 \"a.obj\" 0 0 0 1  0 0 0  1 1 1  0 0 0  1 mtl\n1 1 1\n0\n"));

        assertThat(text(file.scene().getObject(0).material(1))).isEqualTo("0.1 0.2 0.3  1.0 0.0 0.0  0.7 0.8 0.9  12.0");
        assertThat(text(file.scene().getObject(1).material(1))).isEqualTo("0.1 0.2 0.3  0.4 0.5 0.6  0.7 0.8 0.9  12.0");
        assertThat(text(file.scene().getObject(2).material(1))).isEqualTo("0.0 0.0 0.0  1.0 0.0 0.0  0.0 0.0 0.0  1.0");
        assertThat(file.warnings()).hasSize(1);
        assertThat(file.text().meshes()).hasSize(2);
    }

    @Test
    void texturesArePassedOverWithOneWarning() throws IOException {
        mtl("a.mtl", "map_Kd a.png\n" + RED + "map_Kd a.png\nbump -bm 1 b.png\nmap_Bump b.png\n");
        mtl("b.mtl", "newmtl blue\nnorm c.png\n");

        read(obj("mtllib a.mtl b.mtl\nusemtl red"));
        assertWarnings("a.mtl:1:1: warning: expected colours, found 5 textures, which are passed over");
    }

    @Test
    void whatIsNotThereIsAWarningAndTheMeshsOwnMaterialHolds() throws IOException {
        Mesh mesh = read(obj("mtllib none.mtl\nusemtl red", "usemtl other", "usemtl unused\nusemtl third"));

        assertThat(mesh.material(1)).isSameAs(mesh.surfaceMaterial);
        assertWarnings("a.obj:5:1: warning: expected MTL file that can be read (none.mtl: no such file), found 'none.mtl'",
            "a.obj:6:1: warning: expected a material of the MTL files, found 'red' and 2 others, in place of which the mesh's own is taken");
        read(obj("mtllib a.mtl\nusemtl RED"));
        assertWarnings("a.obj:6:1: warning: expected a material of the MTL files, found 'RED', in place of which the mesh's own is taken");
        read(obj("g x"));
        assertWarnings("a.obj:1:1: warning: expected mtllib, which names MTL files, found none: the mesh's own material is taken");
    }

    @Test
    void whatIsNoReadableFileIsAWarning() throws IOException {
        Files.createDirectory(folder.resolve("d.mtl"));
        read(obj("mtllib d.mtl\nmtllib \u0000.mtl\nmtllib"));
        assertThat(warnings).extracting(Diagnostic::message).first().asString().contains("is a folder");
        assertThat(warnings).hasSize(3).allMatch(warning -> !warning.error());
        Path locked = Files.writeString(folder.resolve("e.mtl"), RED);
        Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("---------"));
        if (!Files.isReadable(locked)) {
            read(obj("mtllib e.mtl"));
            assertThat(warnings.get(0).message()).contains("may not be read");
        }
    }

    /** It would show a file of somebody else's computer, whether it is there or not. */
    @ParameterizedTest
    @ValueSource(strings = {"../out.mtl", "/etc/passwd", "C:\\models\\a.mtl", "sub\\..\\..\\out.mtl", "link.mtl", "far/out.mtl", "../none.mtl"})
    void filesOutsideTheScenesFolderAreNotRead(String name) throws IOException {
        Path inner = Files.createDirectory(folder.resolve("inner"));
        mtl("out.mtl", "newmtl red\nKd x\n");
        Files.createSymbolicLink(inner.resolve("link.mtl"), folder.resolve("out.mtl"));
        Files.createSymbolicLink(inner.resolve("far"), folder);
        Files.createDirectory(inner.resolve("sub"));
        Files.writeString(inner.resolve("a.obj"), obj("mtllib " + name + "\nusemtl red"));
        Path scene = Files.writeString(inner.resolve("a.scene"), "1\n4 \"a.obj\" 0 0 0 1  " + OWN + " mtl\n1 1 1\n0\n");
        SceneFile file = SceneFile.read(scene);

        assertThat(file.warnings()).extracting(Diagnostic::message).containsExactly("expected MTL file within the scene's folder (--allow-outside allows any), "
            + "found " + Diagnostic.quoted(name), "expected a material of the MTL files, found 'red', in place of which the mesh's own is taken");
        assertThat(file.text().meshes()).hasSize(1);
        if (name.contains("out.mtl") && !name.contains("\\") || name.equals("link.mtl")) {
            assertThatThrownBy(() -> SceneFile.read(scene, Reach.ANYWHERE)).isInstanceOf(SceneFormatException.class).hasMessageContaining(".mtl:2:4: error: ");
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {"Kd x 0 0|4|Kd red of 0 or more in material 'red', found 'x'", "Ka 0 0 -1|8|Ka blue of 0 or more in material 'red', found '-1'",
        "Ks 0 1|7|Ks blue of 0 or more in material 'red', found the end of the line", "kd|3|kd red of 0 or more in material 'red', found the end of the line",
        "Ns nan|4|Ns of 0 or more in material 'red', found 'nan' (numbers must be finite)", "d 1,0|3|d from 0 to 1 in material 'red', found '1,0' (a decimal point is a '.')",
        "Tr 2|4|Tr from 0 to 1 in material 'red', found '2'", "illum 11|7|illum from 0 to 10 in material 'red', found '11'",
        "illum 2.5|7|illum from 0 to 10 in material 'red', found '2.5'"})
    void aWrongValueIsAnErrorWhereItStands(String line, int column, String message) {
        assertThatThrownBy(() -> material("newmtl red\n" + line + "\n")).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith(folder.resolve("a.mtl") + ":2:" + column + ": error: expected " + message + '\n' + line + '\n');
    }

    @ParameterizedTest
    @CsvSource({"d 0.5, Ni 0, of 1 or more", "Tr 1, Tf x 1 1, red of 0 or more"})
    void whatOnlyGlassNeedsIsAnErrorInGlassAlone(String glass, String line, String wanted) throws IOException {
        assertThatThrownBy(() -> material("newmtl red\n" + line + "\n" + glass)).isInstanceOf(SceneFormatException.class).hasMessageContaining(":2:4: error: ");
        assertThat(material("newmtl red\n" + line + "\n").transmission.isBlack()).isTrue();
        assertThat(warnings).singleElement().satisfies(warning -> assertThat(warning.headline()).startsWith(folder.resolve("a.mtl") + ":2:4: warning: ")
            .contains(wanted).endsWith(", which the picture does not need"));
    }

    @Test
    void aWrongValueThatNoPolygonNeedsIsAWarning() throws IOException {
        material(RED + "newmtl blue\nKd 1 0 x\nNs -1\nnewmtl green\nd 7\nKd y\n");

        assertWarnings("a.mtl:7:8: warning: expected Kd blue of 0 or more in material 'blue', found 'x', which the picture does not need (and 3 more)");
    }

    @Test
    void valuesOfAMaterialWithoutANameAreNotThoseOfTheOneBefore() throws IOException {
        assertThat(text(material(RED + "newmtl  \nKd 1 1 1\nnewmtl green\nKd 0 1 0\n"))).startsWith("0.1 0.0 0.0  0.8 0.0 0.0");
        assertWarnings(
            "a.mtl:7:1: warning: expected newmtl with a name before a material's values, found 1 value without, which is passed over");
    }

    @Test
    void valuesWithoutAMaterialAndSpectraArePassedOver() throws IOException {
        assertThat(text(material("Kd 1 1 1\nnewmtl\nKs 1 1 1\n" + RED + "Kd xyz 1 1 1\nKa spectral a.rfl 1\n"))).startsWith("0.1 0.0 0.0  0.8 0.0 0.0");
        assertWarnings("a.mtl:9:1: warning: expected colours as red, green and blue, found 2 as spectra or as xyz, which are passed over",
            "a.mtl:1:1: warning: expected newmtl with a name before a material's values, found 2 values without, which are passed over");
    }

    @Test
    void aLineThatABackslashJoinsToAnotherIsWarnedOf() throws IOException {
        mtl("a.mtl", "newmtl wood\\\nKd 1 0 0\nKa 0 0 0\n");

        assertThat(read(obj("mtllib a.mtl\nusemtl wood\\\nf 1 2 3")).material(1).diffuse.r).isEqualTo(0.4);
        assertThat(warnings).extracting(Diagnostic::message).containsOnly("expected a line of its own for each keyword, "
            + "found 1 line that the backslash before it joins to another").hasSize(2);
    }

    @Test
    void whatIsNoTextIsAnError() throws IOException {
        for (Charset charset : List.of(StandardCharsets.UTF_16, StandardCharsets.UTF_16LE)) {
            Files.writeString(folder.resolve("a.mtl"), "newmtl red\n", charset);
            assertThatThrownBy(() -> read(obj("mtllib a.mtl\nusemtl red"))).isInstanceOf(SceneFormatException.class)
                .hasMessageStartingWith(folder.resolve("a.mtl") + ":1:1: error: expected text in UTF-8, found UTF-16");
        }
        mtl("a.mtl", "x".repeat(2_000_000));
        assertThatThrownBy(() -> read(obj("mtllib a.mtl\nusemtl red"))).hasMessageStartingWith(folder.resolve("a.mtl") + ":1:1: error: expected a line of at most");
    }

    /** It is needed if a polygon's material is in no other file: it may be in this one. */
    @Test
    void aFileThatIsNoTextIsAWarningIfNothingOfItIsNeeded() throws IOException {
        mtl("b.mtl", "\0\0\0\0");
        String warning = "b.mtl:1:1: warning: expected text in UTF-8, found NUL bytes, which the picture does not need";

        for (String lines : List.of("mtllib b.mtl\nmtllib a.mtl\nusemtl red", "mtllib a.mtl b.mtl\nusemtl red", "mtllib b.mtl", "mtllib b.mtl\nusemtl")) {
            read(obj(lines));
            assertWarnings(warning);
        }
        assertThatThrownBy(() -> read(obj("mtllib a.mtl b.mtl\nusemtl red", "usemtl blue"))).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith(folder.resolve("b.mtl") + ":1:1: error: expected text in UTF-8, found NUL bytes");
    }

    @Test
    void eachMeshSaysWhetherItNeedsAFileThatIsNoText() throws IOException {
        mtl("b.mtl", "\0\0\0\0");
        Files.writeString(folder.resolve("a.obj"), obj("mtllib b.mtl"));
        Files.writeString(folder.resolve("b.obj"), obj("mtllib b.mtl\nusemtl red"));
        Files.writeString(folder.resolve("c.obj"), obj("mtllib b.mtl\nusemtl blue"));
        Path scene = folder.resolve("a.scene");
        Files.writeString(scene, "3\n4 \"a.obj\" 0 0 0 1  " + OWN + " mtl\n4 \"b.obj\" 0 0 0 1  " + OWN + " mtl\n4 \"c.obj\" 0 0 0 1  " + OWN
            + " mtl\n1 1 1\n0\n");

        assertThatThrownBy(() -> SceneFile.read(scene)).isInstanceOfSatisfying(SceneFormatException.class,
            e -> assertThat(e.problems()).filteredOn(Diagnostic::error).singleElement().asString().startsWith(folder.resolve("b.mtl") + ":1:1: error: "));
    }

    @ParameterizedTest
    @CsvSource({"mtl mtl, 3:5", "mtl /  mtl, 4:3", "mtl/mtl mtl, 4:1", "mirror 0 0 0 mtl mtl, 3:18"})
    void theWordStandsOnlyOnce(String words, String place) {
        assertThatThrownBy(() -> read(obj("mtllib a.mtl"), OWN + "\n" + words.replace('/', '\n'))).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith(folder.resolve("a.scene") + ":" + place + ": error: expected object 1's keyword mtl only once, found 'mtl'");
    }

    @Test
    void aJoinedLineIsToldWithAnErrorInTheObj() {
        assertThatThrownBy(() -> read(obj("usemtl red\\", "f 1 2 x"))).isInstanceOfSatisfying(SceneFormatException.class, e -> {
            assertThat(e.problems()).extracting(Diagnostic::error).containsExactly(false, true);
            assertThat(e).hasMessageStartingWith(folder.resolve("a.obj") + ":6:1: warning: expected a line of its own for each keyword");
        });
    }

    @Test
    void anErrorInTheObjIsToldAlone() {
        assertThatThrownBy(() -> read("v 0 0 0\nf 1 2 3\n")).isInstanceOf(SceneFormatException.class)
            .satisfies(e -> assertThat(((SceneFormatException) e).problems()).hasSize(1));
        assertThatThrownBy(() -> read(obj("mtllib a.mtl\nusemtl red"), OWN + " transmit 1 1 1 0.5 mtl")).hasMessageContaining("refractive index of 1 or more");
    }

    @Test
    void thePiecesAreTheMeshByMaterials() throws IOException {
        mtl("a.mtl", RED + "newmtl blue\nKd 0 0 1\n");
        Mesh mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nmtllib a.mtl\nf 1 2 3\nusemtl red\nf 1//1 3//1 4//1\nusemtl blue\nf 2 3 4\n"
            + "usemtl red\nf 1 2 4\n");
        List<Mesh> pieces = mesh.pieces();

        assertThat(pieces).extracting(Mesh::size).containsExactly(1, 2, 1);
        assertThat(pieces).extracting(piece -> piece.surfaceMaterial)
            .containsExactly(mesh.surfaceMaterial, mesh.material(1), mesh.material(2));
        assertThat(pieces.get(1).vertex(1, 2)).hasToString(mesh.vertex(3, 2).toString());
        assertThat(pieces.get(1).vertexNormal(0, 1).z).isCloseTo(1, within(0.0));
        assertThat(pieces.get(1).vertexNormal(1, 1)).isNull();
        assertThat(read(obj("g x"), OWN).pieces()).hasSize(1);
    }
}
