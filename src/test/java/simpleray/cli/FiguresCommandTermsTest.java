package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;

/** The thesis's figure 10: ambient, diffuse and specular light are the lighting. */
class FiguresCommandTermsTest {
    private static final Resolution SIZE = new Resolution(41, 37);

    static List<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of(System.getProperty("simpleray.scenes")))) {
            return files.filter(file -> file.toString().endsWith(".scene")).sorted().toList();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void theSumOfTheTermsIsTheLightingToTheLastBit(Path file) throws IOException {
        assertSumIsLighting(SceneFile.read(file).scene(), new SceneSettings());
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void soItIsBeforeABackground(Path file) throws IOException {
        SceneSettings asked = new SceneSettings();
        asked.background = new Colour(0.1, 0.7, 1.3);
        assertSumIsLighting(SceneFile.read(file).scene(), asked);
    }

    private static void assertSumIsLighting(Scene scene, SceneSettings asked) {
        asked.resolution = SIZE;
        asked.samples = 1;
        Picture lighting = render(scene, asked, Stage.LIGHTING);

        Picture sum = Picture.sum(List.of(render(scene, asked, Stage.AMBIENT), render(scene, asked, Stage.DIFFUSE),
            render(scene, asked, Stage.SPECULAR)));

        assertThat(sum.height()).isEqualTo(SIZE.height());
        for (int y = 0; y < SIZE.height(); y++) {
            assertThat(bits(sum.row(y))).as("row %d", y).isEqualTo(bits(lighting.row(y)));
        }
    }

    private static Picture render(Scene scene, SceneSettings asked, Stage stage) {
        return new RenderRequest(asked, stage, false, 1).renderer(scene).render(RenderListener.NONE);
    }

    private static long[] bits(double[] row) {
        long[] bits = new long[row.length];
        for (int i = 0; i < bits.length; i++) {
            bits[i] = Double.doubleToRawLongBits(row[i]);
        }
        return bits;
    }
}
