package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.image.Picture;
import simpleray.image.PictureText;
import simpleray.image.png.PictureFormatException;
import simpleray.image.png.PngWriter;
import simpleray.scene.PictureScene;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;

class ProvenanceTest {
    private static final String GREY = "1  1 0 0 1 -2  1 1 1  0 0 0  0 0 0  1   0.5 0.5 0.5  0\n";

    @TempDir
    Path folder;

    private static SceneFile scene(String text) throws IOException {
        return SceneFile.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
    }

    private static String text(List<PictureText> texts, String keyword) {
        return texts.stream().filter(text -> text.keyword().equals(keyword)).findFirst().orElseThrow().string();
    }

    private PictureScene told(List<PictureText> texts) throws IOException {
        Picture picture = new Picture(1, 1);
        picture.setRow(0, new double[3]);
        picture.tell(texts);
        Path file = folder.resolve("a.png");
        try (var out = Files.newOutputStream(file)) {
            PngWriter.write(picture, out);
        }
        return PictureScene.read(file);
    }

    @Test
    void theVersionIsThatOfTheBuild() throws IOException {
        assertThat(Files.readString(Project.root().resolve("build.gradle"))).contains("\nversion = '" + Provenance.VERSION + "'\n");
    }

    @Test
    void aPictureTellsVersionOptionsDigestAndScene() throws IOException {
        RenderRequest request = new RenderRequest(new SceneSettings(), Stage.FINAL, false, 7);
        SceneFile file = scene(GREY);
        request.renderer(file.scene());

        List<PictureText> texts = Provenance.of(request, file);

        assertThat(texts).extracting(PictureText::keyword).containsExactly("Software", "simpleray.options", "simpleray.sha256",
            "simpleray.scene");
        assertThat(text(texts, "Software")).isEqualTo("SimpleRay 0.1.0");
        assertThat(text(texts, "simpleray.options")).isEqualTo("stage final\nresolution 200 200\ndepth 10\nsamples 1\n");
        assertThat(text(texts, "simpleray.sha256")).matches("[0-9a-f]{64}  stdin\n");
        assertThat(text(texts, "simpleray.scene")).isEqualTo(GREY);
    }

    @Test
    void theOptionsAreThoseThatHeldWhetherTheSceneOrTheCommandLineSaidThem() throws IOException {
        SceneSettings asked = new SceneSettings();
        asked.resolution = new Resolution(30, 20);
        RenderRequest request = new RenderRequest(asked, Stage.DIFFUSE, true, 1);
        SceneFile file = scene(GREY + "samples 3\ndepth 4\ncamera 0 0 5 0 0 0 40\nbackground 0.1 0.2 0.3\n");
        request.renderer(file.scene());

        assertThat(text(Provenance.of(request, file), "simpleray.options")).isEqualTo("stage diffuse\nsamples adaptive\n"
            + "background 0.1 0.2 0.3\ncamera 0.0 0.0 5.0 0.0 0.0 0.0 40.0\nresolution 30 20\ndepth 4\n");
    }

    @Test
    void aSceneThatWasNotReadHasNothingToTell() {
        assertThat(Provenance.of(new RenderRequest(new SceneSettings(), Stage.FINAL, false, 1), new SceneFile(new Scene(), List.of())))
            .isEmpty();
    }

    @Test
    void whatIsToldCanBeAskedForAgain() throws IOException {
        SceneSettings asked = new SceneSettings();
        asked.resolution = new Resolution(30, 20);
        asked.window = new SceneSettings.Window(-0.1, 1.0 / 3, -2, 2);
        RenderRequest request = new RenderRequest(asked, Stage.SPECULAR, true, 1);
        SceneFile file = scene(GREY);
        request.renderer(file.scene());

        RenderRequest again = Provenance.request(told(Provenance.of(request, file)), Accel.NONE, 3);

        assertThat(again.stage()).isEqualTo(Stage.SPECULAR);
        assertThat(again.adaptive()).isTrue();
        assertThat(again.accel()).isEqualTo(Accel.NONE);
        assertThat(again.threads()).isEqualTo(3);
        assertThat(again.settings().resolution).isEqualTo(asked.resolution);
        assertThat(again.settings().window).isEqualTo(asked.window);
        assertThat(again.settings().depth).isEqualTo(10);
        assertThat(again.settings().samples).isNull();
    }

    @Test
    void aRegionIsToldAndCanBeAskedForAgain() throws IOException {
        Region region = new Region(3, 0, 7, 20);
        RenderRequest request = new RenderRequest(new SceneSettings(), Stage.FINAL, false, 1).with(region);
        SceneFile file = scene(GREY);
        request.renderer(file.scene());

        List<PictureText> texts = Provenance.of(request, file);

        assertThat(text(texts, "simpleray.options")).isEqualTo("stage final\nregion 3,0,7,20\nresolution 200 200\ndepth 10\nsamples 1\n");
        assertThat(Provenance.request(told(texts), Accel.AUTO, 1).region()).isEqualTo(region);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1,2,3", "1,2,3,4,5", "1,2,3,", "a,2,3,4", "1,2,0,4", "-1,2,3,4", "1,2,3,99999999999", ""})
    void aRegionThatIsNoneIsAnError(String region) throws IOException {
        PictureScene told = told(PictureScene.texts("SimpleRay 9", "stage final\nregion " + region + '\n', scene(GREY).text()));

        assertThatThrownBy(() -> Provenance.request(told, Accel.AUTO, 1)).isInstanceOf(PictureFormatException.class)
            .hasMessage(folder.resolve("a.png") + ": was made of a region that is none: '" + region + "'");
    }

    @Test
    void aBandIsToldAndCanBeAskedForAgain() throws IOException {
        RenderRequest request = new RenderRequest().with(new Region(3, 0, 7, 20)).with(new Band(2, 3));

        List<PictureText> texts = Provenance.of(request, scene(GREY));

        assertThat(text(texts, "simpleray.options"))
            .isEqualTo("stage final\nregion 3,0,7,20\nband 2/3\nresolution 200 200\ndepth 10\nsamples 1\n");
        assertThat(Provenance.request(told(texts), Accel.AUTO, 1).band()).isEqualTo(new Band(2, 3));
    }

    @ParameterizedTest
    @ValueSource(strings = {"0/3", "2/1", "2", "2/3/4", "a/b", ""})
    void aBandThatIsNoneIsAnError(String band) throws IOException {
        PictureScene told = told(PictureScene.texts("SimpleRay 9", "stage final\nband " + band + '\n', scene(GREY).text()));

        assertThatThrownBy(() -> Provenance.request(told, Accel.AUTO, 1)).isInstanceOf(PictureFormatException.class)
            .hasMessage(folder.resolve("a.png") + ": was made of a band that is none: '" + band + "'");
    }

    @ParameterizedTest
    @CsvSource({"stage first, was made with an option that this version does not know: 'stage first'",
        "stage final|lens 5, was made with an option that this version does not know: 'lens 5'",
        "stage final|stage final, was made with an option that this version does not know: 'stage final'",
        "band 1/2|band 1/2|stage final, was made with an option that this version does not know: 'band 1/2'",
        "region 1;2;3;4|region 1;2;3;4|stage final, was made with an option that this version does not know: 'region 1;2;3;4'",
        "depth 4, does not tell the stage that it shows"})
    void whatCannotBeAskedForIsAnError(String options, String message) throws IOException {
        PictureScene told = told(PictureScene.texts("SimpleRay 9", options.replace('|', '\n').replace(';', ','), scene(GREY).text()));

        assertThatThrownBy(() -> Provenance.request(told, Accel.AUTO, 1)).isInstanceOf(PictureFormatException.class)
            .hasMessage(folder.resolve("a.png") + ": " + message.replace(';', ','));
    }
}
