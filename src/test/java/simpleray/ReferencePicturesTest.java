package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.render.Stage;
import simpleray.scene.SimpleCamera;

/** The thesis's three pictures (chapter 6, figures 12 to 14) are those that another program made from the same description. */
class ReferencePicturesTest {
    private static final Path REFERENCE = Project.resources("reference");

    @ParameterizedTest
    @CsvSource({
        "thesis, ORIGINAL", "thesis, LIGHTING", "thesis, FINAL",
        "thesis-as-printed, ORIGINAL", "thesis-as-printed, LIGHTING", "thesis-as-printed, FINAL"})
    void theThesisPictureIsTheReferences(String scene, Stage stage) throws IOException {
        byte[] reference = Files.readAllBytes(REFERENCE.resolve("thesis-" + stage + "-200.png"));

        byte[] png = Rendered.png(Project.scene(scene), new SimpleCamera(200, 200), Rendered.stage(stage));

        PictureComparison.assertClose(scene + "-" + stage, Rendered.decoded(reference), png, Project.build().resolve("golden-failures"));
    }

    @Test
    void theSceneIsTheThesisLetterForLetter() {
        assertThat(Project.scene("thesis-as-printed")).hasSameBinaryContentAs(REFERENCE.resolve("thesis-as-printed.scene"));
    }
}
