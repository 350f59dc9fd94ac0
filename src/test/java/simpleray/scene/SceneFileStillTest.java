package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.io.Sha256;
import simpleray.math.Colour;

/** A frame of a film as if it were a file of its own. */
class SceneFileStillTest {
    private static final String BALL = "0 0 0 0 1  0 0 0 0 0 0 0 0 0 0\n";
    private static final String FILM = "HEADING\n1\n" + BALL + "0 0 0\n0\nframes 3 25\nkey 1 object 1 1 0 0\n\n key 2 object 1 2 0 0 # there\n";

    @Test
    void itHasTheFramesTextAndTheFilmsName() throws IOException {
        SceneFile film = SceneFile.parse(FILM);
        SceneFile still = film.still(2);
        String text = written(film.scene().still(2)::write);

        assertThat(new String(still.text().bytes(), StandardCharsets.UTF_8)).isEqualTo(text).contains("2.0 0.0 0.0 1.0");
        assertThat(still.text().sha256()).isEqualTo(Sha256.of(text.getBytes(StandardCharsets.UTF_8)));
        assertThat(still.text().name()).isEqualTo("scene");
        assertThat(still.text().meshes()).isEmpty();
        assertThat(still.warnings()).isEqualTo(film.warnings()).hasSize(1);
        assertThat(still.lineOfObject(0)).isEqualTo(3);
        assertThat(written(still.scene()::write)).isEqualTo(text);
        assertThat(SceneFile.parse(text).still(0).text().sha256()).isEqualTo(still.text().sha256());
    }

    @Test
    void aSceneThatIsNoFilmStaysAsItIs() throws IOException {
        SceneFile file = SceneFile.parse("0 0 0 0 0\n");

        assertThat(file.still(0)).isSameAs(file);
        assertThatIllegalArgumentException().isThrownBy(() -> file.still(1)).withMessage("the frame must be from 0 to 0, and is 1");
    }

    @Test
    void aFilmOfNoFileHasNoText() throws IOException {
        assertThat(new SceneFile(SceneFile.parse(FILM).scene(), List.of()).still(1).text()).isNull();
    }

    @Test
    void theFilmKnowsTheLinesOfItsKeys() throws IOException {
        SceneFile film = SceneFile.parse(FILM);

        assertThat(film.lineOfKey(0)).isEqualTo(7);
        assertThat(film.lineOfKey(1)).isEqualTo(9);
        assertThat(film.lineOfKey(2)).isZero();
        assertThat(SceneFile.parse("0 0 0 0 0\n").lineOfKey(0)).isZero();
    }

    /** Whether what stays from frame to frame was written for an earlier one or not. */
    @Test
    void allFramesInTurnHaveTheTextsOfEachAlone() throws IOException {
        SceneFile film = SceneFile.parse(FILM + "key 0 camera 0 0 5 0 0 0 40\nkey 1 camera 0 0 6 0 0 0 40\nkey 2 camera 0 0 7 0 0 0 40\n");
        FrameTexts texts = new FrameTexts(film);

        for (double frame : new double[] {0, 0.25, 1, 1, 2, 0}) {
            SceneFile still = texts.of(film.scene().still(frame));
            assertThat(still.text().sha256()).as("frame %s", frame).isEqualTo(film.still(frame).text().sha256())
                .isEqualTo(Sha256.of(still.text().bytes()));
        }
        assertThat(texts.of(film.scene())).isSameAs(film);
    }

    @Test
    void aLightOrAnAmbientLightOfItsOwnIsWrittenAnew() throws IOException {
        SceneFile film = SceneFile.parse("0 0 0 0 1\n0 1 1 1 0 0 0\nframes 2 25\nkey 0 colour 1 1 0 0\nkey 1 colour 1 0 1 0\n");
        FrameTexts texts = new FrameTexts(film);
        Scene other = film.scene().still(1);
        other.ambient = new Colour(1, 0, 0);

        assertThat(texts.of(film.scene().still(0)).text().bytes()).asString().contains("1.0 0.0 0.0");
        assertThat(texts.of(film.scene().still(1)).text().bytes()).asString().contains("0.0 1.0 0.0");
        assertThat(texts.of(other).text().bytes()).asString().contains("# ambient light\n1.0 0.0 0.0");
    }

    @Test
    void itNamesTheSameMeshes(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Files.writeString(folder.resolve("a.scene"), "1\n4 \"a.obj\" 1 2 3 2  0 0 0 0 0 0 0 0 0 5\n0 0 0\n0\nframes 2 1\nkey 0 object 1 1 1 1\n");
        SceneFile film = SceneFile.read(folder.resolve("a.scene"));

        assertThat(film.still(1).text().meshes()).isEqualTo(film.text().meshes()).hasSize(1);
        assertThat(film.still(1).text().name()).isEqualTo("a.scene");
    }

    /** As of a file: the picture carries the digest alone. */
    @Test
    void aTextThatIsTooLongHasOnlyItsDigest() throws IOException {
        SceneFile film = SceneFile.parse(FILM);
        Scene still = film.scene().still(0);
        String text = written(still::write);
        SourceText whole = new FrameTexts(film, text.length()).of(still).text();
        SourceText cut = new FrameTexts(film, text.length() - 1).of(still).text();

        assertThat(whole.bytes()).asString(StandardCharsets.UTF_8).isEqualTo(text);
        assertThat(cut.bytes()).isNull();
        assertThat(new FrameTexts(film, 1).of(still).text().bytes()).as("cut off in what stays").isNull();
        assertThat(cut.sha256()).isEqualTo(Sha256.of(text.getBytes(StandardCharsets.UTF_8)));
    }
}
