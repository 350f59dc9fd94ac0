package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Each scene in scenes/ still gives the picture that was once looked at: docs/golden-images.md. */
class GoldenImagesTest {
    private static final String REMEDY = "look at the new pictures, then run: gradle goldens";

    static List<String> scenes() {
        return Project.scenes();
    }

    @Test
    void eachSceneHasAGoldenImageAndEachGoldenImageAScene() {
        assertThat(Project.names(GoldenImages.folder(), ".png")).as(REMEDY).isEqualTo(scenes());
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void theSceneLooksAsBefore(String name) throws IOException {
        assertThat(GoldenImages.file(name)).as(REMEDY).exists();

        PictureComparison.assertClose(name, Rendered.decoded(Files.readAllBytes(GoldenImages.file(name))), GoldenImages.png(name),
            Project.build().resolve("golden-failures"));
    }
}
