package simpleray.ui.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.render.Explainer;
import simpleray.render.PreparedScene;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.RayTree;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.text.SceneFormatException;

class ModelSceneTest {
    private static final int SIDE = 40;

    @TempDir
    private Path folder;

    /** A box that is flat, tall, far off or tiny. */
    @ParameterizedTest
    @CsvSource({"0,0,0, 4,1,3", "0,0,0, 1,9,1", "5e6,-2e6,1e6, 5.0003e6,-1.9998e6,1.0002e6", "-1e-4,0,0, 1e-4,3e-4,2e-4"})
    void theWholeModelIsSeenAndFillsAPartOfThePicture(double x, double y, double z, double toX, double toY, double toZ) throws IOException {
        Path model = box(x, y, z, toX, toY, toZ);
        SceneFile scene = SceneSource.file(model).read();
        assertThat(scene.warnings()).isEmpty();

        SceneSettings settings = new SceneSettings();
        settings.resolution = new SceneSettings.Resolution(SIDE, SIDE);
        Explainer explainer = new PreparedScene(scene.scene()).renderer(new RenderRequest(settings, Stage.FINAL, false, 1)).explainer();
        int seen = 0;
        for (int row = 0; row < SIDE; row++) {
            for (int column = 0; column < SIDE; column++) {
                RayTree.Thing thing = explainer.objectAt(column, row);
                boolean isModel = thing != null && thing.number() == 1;
                boolean edge = row == 0 || column == 0 || row == SIDE - 1 || column == SIDE - 1;
                assertThat(isModel && edge).as("the model at the edge, %d, %d", column, row).isFalse();
                seen += isModel ? 1 : 0;
            }
        }
        assertThat(seen).isGreaterThan(SIDE * SIDE / 25);
    }

    @Test
    void itsTextIsThatOfASceneBesideTheModel() throws IOException {
        SceneSource source = SceneSource.file(box(0, 0, 0, 1, 1, 1));

        assertThat(source.path()).isNull();
        assertThat(source.home()).isEqualTo(folder.resolve("box.scene"));
        String text = new String(source.text(), StandardCharsets.UTF_8);
        assertThat(text).contains("\n4   \"box.obj\"   -1 0.002 -1   2.0   ").doesNotContain("mtl");
        Path saved = Files.writeString(folder.resolve("other.scene"), text);
        assertThat(SceneFile.read(saved).scene().getNumberObjects()).isEqualTo(2);
    }

    @Test
    void aModelsOwnMaterialsAreTaken() throws IOException {
        Path model = box(0, 0, 0, 1, 1, 1);
        Files.writeString(model, "mtllib box.mtl\n" + Files.readString(model));
        Files.writeString(folder.resolve("box.mtl"), "newmtl red\nKd 1 0 0\n");

        assertThat(new String(SceneSource.file(model).text(), StandardCharsets.UTF_8)).contains("   mtl\n");
    }

    @Test
    void whatIsWrongWithTheModelIsToldAtItsPlace() throws IOException {
        Path model = Files.writeString(folder.resolve("bad.obj"), "v 1 2\n");

        assertThatThrownBy(SceneSource.file(model)::read).isInstanceOf(SceneFormatException.class).hasMessageContaining(model + ":1:");
        assertThatThrownBy(SceneSource.file(folder.resolve("none.obj"))::read).isInstanceOf(IOException.class)
            .isNotInstanceOf(NoSuchFileException.class).hasMessageContaining("no such file");
    }

    private Path box(double x, double y, double z, double toX, double toY, double toZ) throws IOException {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 8; i++) {
            text.append(String.format(Locale.ROOT, "v %.17g %.17g %.17g%n", (i & 1) == 0 ? x : toX, (i & 2) == 0 ? y : toY,
                (i & 4) == 0 ? z : toZ));
        }
        text.append("f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
        return Files.writeString(folder.resolve("box.obj"), text);
    }
}
