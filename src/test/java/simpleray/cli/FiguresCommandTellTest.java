package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.Rendered;
import simpleray.io.Sha256;
import simpleray.render.Provenance;
import simpleray.scene.PictureScene;

/** What the sheets of {@code figures} tell of how they were made. */
class FiguresCommandTellTest {
    @TempDir
    Path folder;
    private Path scene;

    @BeforeEach
    void makeSheets() throws IOException {
        scene = Files.writeString(folder.resolve("ball.scene"), "# with a comment\n" + SmallScenes.ROUGH);
        Program.Result result = InProcess.run("figures", scene.toString(), "-d", folder.toString(), "-q", "--size", "20x10", "--depth", "3",
            "--background", "0.1,0.2,0.3", "--sweep", "shininess=2,5");
        assertThat(result.err()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"stages | original, with lighting, with shadows and reflections",
        "terms | ambient, diffuse, specular, their sum", "shininess | shininess 2, shininess 5"})
    void aSheetTellsItsSceneAndWhatItShows(String name, String what) throws IOException {
        PictureScene told = PictureScene.read(folder.resolve("ball-" + name + ".png"));

        assertThat(told.software()).isEqualTo(Provenance.SOFTWARE);
        assertThat(told.others()).containsExactly("sheet " + name + ": " + what);
        assertThat(told.settings().lines().lines()).containsExactlyInAnyOrder("resolution 20 10", "depth 3", "samples 1",
            "background 0.1 0.2 0.3");
        assertThat(told.text().bytes()).isEqualTo(Files.readAllBytes(scene));
        assertThat(told.text().sha256()).isEqualTo(Sha256.of(Files.readAllBytes(scene)));
    }

    @Test
    void aSheetIsOpenedAsItsScene() throws IOException {
        for (String in : List.of("ball.scene", "ball-terms.png", "ball-shininess.png")) {
            List<String> args = List.of("render", folder.resolve(in).toString(), "-o", folder.resolve(in + ".out.png").toString(), "-q");
            List<String> options = in.endsWith(".png") ? List.of() : List.of("--size", "20x10", "--depth", "3", "--background", "0.1,0.2,0.3");
            String[] line = Stream.of(args, options).flatMap(List::stream).toArray(String[]::new);
            assertThat(InProcess.run(line).exitCode()).isZero();
        }

        int[] levels = Rendered.levels(Files.readAllBytes(folder.resolve("ball.scene.out.png")));
        assertThat(Rendered.levels(Files.readAllBytes(folder.resolve("ball-terms.png.out.png")))).isEqualTo(levels);
        assertThat(Rendered.levels(Files.readAllBytes(folder.resolve("ball-shininess.png.out.png")))).isEqualTo(levels);
    }

    @Test
    void verifySaysThatASheetIsNoSinglePicture() {
        Path sheet = folder.resolve("ball-stages.png");

        Program.Result result = InProcess.run("verify", sheet.toString());

        assertThat(result.err()).isEqualTo("simpleray: " + sheet
            + ": is a sheet of several pictures, 'stages': only single pictures can be verified\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
    }

    @Test
    void twoSheetsOfOneSceneAreTheSameFile() throws IOException {
        byte[] before = Files.readAllBytes(folder.resolve("ball-shininess.png"));

        makeSheets();

        assertThat(folder.resolve("ball-shininess.png")).hasBinaryContent(before);
    }
}
