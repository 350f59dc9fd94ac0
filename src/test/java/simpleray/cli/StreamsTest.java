package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.Rendered;
import simpleray.render.RenderSettings;
import simpleray.scene.SimpleCamera;

/** Standard input and standard output, of real processes. */
class StreamsTest {
    private static final File FULL = new File("/dev/full");

    @TempDir
    Path folder;

    @Test
    void aPictureOnStandardOutputIsThePngFileAndNothingElse() throws IOException, InterruptedException {
        byte[] scene = Files.readAllBytes(Project.scene("thesis-as-printed"));

        Program.Result result = Program.runWithInput(folder, scene, "render", "-", "-o", "-", "--progress", "plain");

        assertThat(result.exitCode()).as(result.err()).isZero();
        assertThat(Rendered.levels(result.out()))
            .isEqualTo(Rendered.levels(Rendered.png(Project.scene("thesis"), new SimpleCamera(), new RenderSettings())));
        assertThat(new String(result.out(), StandardCharsets.ISO_8859_1)).endsWith("IEND\u00AE\u0042\u0060\u0082");
        assertThat(result.err()).startsWith("<stdin>:1:1: warning: ").containsPattern("\n<stdout>: 200x200, \\d+\\.\\d s\n$");
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void theInterpretationIsTheThesisByteForByte() throws IOException, InterruptedException {
        Program.Result result = Program.run(folder, "print", Project.scene("thesis").toString());

        assertThat(result.exitCode()).isZero();
        assertThat(result.out()).isEqualTo(Files.readAllBytes(Project.resources("reference").resolve("thesis.interpretation.txt")));
        assertThat(result.err()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"print -", "check -", "render - -o -"})
    void aReaderOfStandardOutputThatGoesAwayIs74WithoutATrace(String line) throws IOException, InterruptedException {
        // the reader is gone before there is a scene to make output of
        Program.Result result = Program.finishUnread(Program.program(folder, List.of(), line.split(" ")).start(),
            SmallScenes.GREY.getBytes(StandardCharsets.UTF_8));

        String what = line.startsWith("render") ? "the picture cannot be written to standard output" : "standard output cannot be written";
        assertThat(result.err()).matches("simpleray: " + what + ": .+\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
    }

    @ParameterizedTest
    @ValueSource(strings = {"print wall.scene", "check wall.scene", "render wall.scene -o -"})
    void aFullDiskBehindStandardOutputIs74(String line) throws IOException, InterruptedException {
        assumeTrue(FULL.exists(), "no " + FULL);
        writeScene();

        Program.Result result = Program.finish(
            Program.program(folder, List.of(), line.split(" ")).redirectOutput(FULL).start(), new byte[0]);

        String what = line.startsWith("render") ? "the picture cannot be written to standard output" : "standard output cannot be written";
        assertThat(result.err()).isEqualTo("simpleray: " + what + ": No space left on device\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
    }

    @Test
    void aFullDiskBehindTheOutputIs74() throws IOException, InterruptedException {
        assumeTrue(FULL.exists(), "no " + FULL);
        writeScene();

        Program.Result result = Program.run(folder, "render", "wall.scene", "-o", FULL.getPath());

        assertThat(result.err()).isEqualTo("simpleray: /dev/full: cannot be written: No space left on device\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
    }

    @Test
    void theExitCodeOfTheProcessIsTheCommands() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("bad.scene"), SmallScenes.BAD);

        Program.Result result = Program.run(folder, "check", "bad.scene");

        assertThat(result.err()).isEqualTo(String.format(SmallScenes.BAD_REPORT, "bad.scene"));
        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
    }

    private void writeScene() throws IOException {
        Files.writeString(folder.resolve("wall.scene"), SmallScenes.GREY);
    }
}
