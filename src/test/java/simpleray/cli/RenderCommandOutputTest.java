package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Rendered;

/** The file that {@code render} writes: there when it is whole, and not before. */
class RenderCommandOutputTest {
    @TempDir
    Path folder;
    private Path scene;
    private Path out;

    @BeforeEach
    void writeOldPicture() throws IOException {
        scene = Files.writeString(folder.resolve("wall.scene"), SmallScenes.WITH_HEADING);
        out = Files.writeString(folder.resolve("wall.png"), "the old picture");
    }

    @Test
    void anOldPictureIsReplaced() throws IOException {
        assertThat(InProcess.run("render", scene.toString(), "-o", out.toString(), "--size", "3x2").exitCode()).isZero();

        assertThat(Rendered.levels(Files.readAllBytes(out))).hasSize(3 * 2 * 3).containsOnly(128);
        assertOnly("wall.png", "wall.scene");
    }

    @Test
    void aBadSceneLeavesAnOldPictureAlone() throws IOException {
        Files.writeString(scene, SmallScenes.BAD);

        assertThat(InProcess.run("render", scene.toString(), "-o", out.toString()).exitCode()).isEqualTo(ExitCode.BAD_SCENE);

        assertThat(out).hasContent("the old picture");
        assertOnly("wall.png", "wall.scene");
    }

    @Test
    void wrongUsageLeavesAnOldPictureAlone() throws IOException {
        assertThat(InProcess.run("render", scene.toString(), "-o", out.toString(), "--depth", "-1").exitCode()).isEqualTo(ExitCode.USAGE);

        assertThat(out).hasContent("the old picture");
        assertOnly("wall.png", "wall.scene");
    }

    @Test
    void quietMeansNotAWord() {
        Program.Result result = InProcess.run("render", scene.toString(), "-o", out.toString(), "-q", "--progress", "plain");

        assertThat(result.err()).isEmpty();
        assertThat(result.out()).isEmpty();
        assertThat(result.exitCode()).isZero();
    }

    @Test
    void quietStillTellsErrors() throws IOException {
        Files.writeString(scene, SmallScenes.BAD);

        Program.Result result = InProcess.run("render", scene.toString(), "-o", out.toString(), "--quiet");

        assertThat(result.err()).isEqualTo(String.format(SmallScenes.BAD_REPORT, scene));
    }

    @ParameterizedTest
    @ValueSource(strings = {"@wall.png", "with space.png", "w\u00E4nd.png", "no-ending", "PNG"})
    void anyNameIsGood(String name) throws IOException {
        Path strange = folder.resolve(name);

        Program.Result result = InProcess.run("render", scene.toString(), "-o", strange.toString(), "--size", "3x2");

        assertThat(result.err()).startsWith(String.format(SmallScenes.HEADING_WARNING, scene) + strange + ": 3x2, ");
        assertThat(Rendered.levels(Files.readAllBytes(strange))).containsOnly(128);
    }

    private void assertOnly(String... names) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files.map(file -> file.getFileName().toString())).containsExactlyInAnyOrder(names);
        }
    }
}
