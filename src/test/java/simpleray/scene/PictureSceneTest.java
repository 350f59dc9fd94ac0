package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.image.Picture;
import simpleray.image.PictureText;
import simpleray.image.png.PictureFormatException;
import simpleray.image.png.PngWriter;
import simpleray.io.Sha256;
import simpleray.scene.SourceText.MeshFile;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

class PictureSceneTest {
    private static final byte[] DARK = "0\nambient\n0.5 0.5 0.5\n0\ndepth 3\n".getBytes(StandardCharsets.UTF_8);
    private static final SourceText TEXT = new SourceText("dark.scene", Sha256.of(DARK), DARK, List.of());

    @TempDir
    private Path folder;
    private Path file;

    @BeforeEach
    void nameTheFile() {
        file = folder.resolve("a.png");
    }

    private void write(List<PictureText> texts) throws IOException {
        Picture picture = new Picture(1, 1);
        picture.setRow(0, new double[3]);
        picture.tell(texts);
        try (OutputStream out = Files.newOutputStream(file)) {
            PngWriter.write(picture, out);
        }
    }

    private void assertFault(String fault, ThrowingCallable reading) {
        assertThatThrownBy(reading).isInstanceOf(PictureFormatException.class).hasMessage(file + ": " + fault);
    }

    @Test
    void whatAPictureTellsIsRead() throws IOException {
        SourceText text = new SourceText("dark\n.scene", TEXT.sha256(), DARK, List.of(new MeshFile("a b.obj", "0".repeat(64))));
        write(PictureScene.texts("SimpleRay 1", "stage final\nsamples adaptive\ncop 3.5\nlens 4\n", text));

        PictureScene told = PictureScene.read(file);

        assertThat(told.software()).isEqualTo("SimpleRay 1");
        assertThat(told.settings().cop).isEqualTo(3.5);
        assertThat(told.others()).containsExactly("stage final", "samples adaptive", "lens 4");
        assertThat(told.text().name()).isEqualTo("dark?.scene");
        assertThat(told.text().sha256()).isEqualTo(TEXT.sha256());
        assertThat(told.text().bytes()).isEqualTo(DARK);
        assertThat(told.text().meshes()).isEqualTo(text.meshes());
    }

    @Test
    void openingAPictureOpensItsSceneWithThePicturesSettings() throws IOException {
        write(PictureScene.texts("SimpleRay 1", "stage final\ndepth 7\nresolution 3 2\n", TEXT));

        SceneFile opened = SceneFile.read(file);

        assertThat(opened.scene().ambient).hasToString("(0.5,0.5,0.5)");
        assertThat(opened.scene().settings.depth).isEqualTo(7);
        assertThat(opened.scene().settings.resolution).isEqualTo(new SceneSettings.Resolution(3, 2));
        assertThat(opened.warnings()).extracting(Diagnostic::headline).containsExactly(file
            + ":2:1: warning: expected a value or a comment, found the heading 'ambient', which is skipped");
        assertThat(opened.text().name()).isEqualTo("dark.scene");
        assertThat(opened.text().sha256()).isEqualTo(TEXT.sha256());
    }

    @Test
    void aSceneRemembersItsTextAndNotItsFolder() throws IOException {
        Path scene = Files.write(folder.resolve("dark.scene"), DARK);

        SourceText text = SceneFile.read(scene).text();

        assertThat(text.name()).isEqualTo("dark.scene");
        assertThat(text.sha256()).isEqualTo(Sha256.of(DARK));
        assertThat(text.bytes()).isEqualTo(DARK);
        assertThat(text.meshes()).isEmpty();
    }

    @Test
    void aMeshOfSeveralObjectsIsNamedOnce() throws IOException {
        byte[] obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".getBytes(StandardCharsets.UTF_8);
        Files.write(folder.resolve("a.obj"), obj);
        String mesh = "4 \"a.obj\" 0 0 0 1  1 1 1  0 0 0  0 0 0  1\n";
        Path scene = Files.writeString(folder.resolve("two.scene"), "2\n" + mesh + mesh + "1 1 1 0\n");

        assertThat(SceneFile.read(scene).text().meshes()).containsExactly(new MeshFile("a.obj", Sha256.of(obj)));
    }

    @Test
    void anErrorInTheSceneOfAPictureHasItsPlace() throws IOException {
        byte[] bad = "1\n98".getBytes(StandardCharsets.UTF_8);
        write(PictureScene.texts("SimpleRay 1", "stage final\n", new SourceText("bad.scene", Sha256.of(bad), bad, List.of())));

        assertThatThrownBy(() -> SceneFile.read(file)).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith(file + ":2:1: error: expected object 1's type ");
    }

    @Test
    void aSceneThatIsNotTheOneOfTheDigestIsRefused() throws IOException {
        write(PictureScene.texts("SimpleRay 1", "stage final\n", new SourceText("dark.scene", "1".repeat(64), DARK, List.of())));

        assertFault("carries another scene than it was made of: the digests differ", () -> PictureScene.read(file));
    }

    @Test
    void withoutTheTextTheSceneItselfMustBeOpened() throws IOException {
        write(PictureScene.texts("SimpleRay 1", "stage final\n", new SourceText("dark.scene", TEXT.sha256(), null, List.of())));

        assertThat(PictureScene.read(file).text().bytes()).isNull();
        assertFault("carries only the digest of its scene, which is too long: open dark.scene", () -> SceneFile.read(file));
    }

    @Test
    void eachOfTheTextsIsNeeded() throws IOException {
        for (int i = 0; i < 3; i++) {
            List<PictureText> texts = new ArrayList<>(PictureScene.texts("SimpleRay 1", "stage final\n", TEXT));
            texts.remove(i);
            write(texts);
            assertFault("carries no scene: it is not of SimpleRay, or another program has written it anew", () -> PictureScene.read(file));
        }
    }

    @Test
    void damagedTextsAreErrors() throws IOException {
        List<PictureText> texts = new ArrayList<>(PictureScene.texts("SimpleRay 1", "stage final\n", TEXT));
        for (String sums : List.of("", "abc  dark.scene", "0".repeat(64) + "  ", "0".repeat(65) + " a")) {
            texts.set(2, new PictureText("simpleray.sha256", sums));
            write(texts);
            assertFault(sums.isEmpty() ? "carries no digest of its scene"
                : "carries a digest that cannot be read: " + Diagnostic.quoted(sums), () -> PictureScene.read(file));
        }
        write(PictureScene.texts("SimpleRay 1", "stage final\ndepth many\n", TEXT));
        assertThatThrownBy(() -> PictureScene.read(file)).isInstanceOf(SceneFormatException.class).hasMessage(file
            + " (its options):1:7: error: expected depth's number from 0 to 1000, found 'many'\ndepth many\n      ^");
    }

    @Test
    void aFileThatIsNoPictureIsToldAsSuch() throws IOException {
        Files.write(file, DARK);

        assertFault("is no PNG", () -> PictureScene.read(file));
    }
}
