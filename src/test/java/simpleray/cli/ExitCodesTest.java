package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What goes wrong is said in one message, and by the exit code. Wrong usage: CommandsUsageTest; streams: BrokenStreamsTest. */
class ExitCodesTest {
    @TempDir
    Path folder;
    private Path scene;
    private Path out;

    @BeforeEach
    void writeScene() throws IOException {
        scene = Files.writeString(folder.resolve("grey.scene"), SmallScenes.GREY);
        out = folder.resolve("grey.png");
    }

    @Test
    void aPictureIsReportedWithItsSizeAndTime() {
        Program.Result result = InProcess.run("render", scene.toString(), "-o", out.toString(), "--size", "7x5");

        assertThat(result.err()).matches("\\Q" + out + "\\E: 7x5, \\d+\\.\\d s\n");
        assertThat(result.exitCode()).isZero();
        assertThat(result.out()).isEmpty();
        assertThat(out).exists();
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "print", "check"})
    void aBadSceneIs65AndEveryErrorIsShown(String command) throws IOException {
        Files.writeString(scene, SmallScenes.BAD);

        assertEnds(ExitCode.BAD_SCENE, String.format(SmallScenes.BAD_REPORT, scene), line(command, scene));
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "print", "check"})
    void aSceneThatIsNotThereIs66(String command) {
        Path missing = folder.resolve("nowhere.scene");

        assertEnds(ExitCode.NO_SCENE, "simpleray: " + missing + ": no such file\n", line(command, missing));
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "print", "check"})
    void aFolderForASceneIs66(String command) {
        assertEnds(ExitCode.NO_SCENE, "simpleray: " + folder + ": is a folder\n", line(command, folder));
    }

    @Test
    void aPictureTooLargeForTheMemoryIs71AndNothingIsBegun() {
        // each of 1024 threads has a row of 65535 × 24 + 24 bytes; twice 4096 rows and 32 of 65535 × 3 + 1 bytes wait to be written; and
        // 16 MiB are for all else
        Program.Result result = InProcess.run("render", scene.toString(), "-o", out.toString(), "--size", "65535x65535",
            "--threads", "1024");

        assertThat(result.err()).matches("simpleray: a picture of 65535x65535 needs 3099 MiB of memory, and Java has \\d+ MiB left: "
            + "make it smaller, or give java more by -Xmx\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_MEMORY);
        assertThat(folder).isDirectoryNotContaining("glob:**.p*");
    }

    @Test
    void anOutputInAFolderThatIsNotThereIs73() {
        Path nowhere = folder.resolve("nowhere");
        String target = nowhere.resolve("a.png").toString();

        assertEnds(ExitCode.NO_OUTPUT, "simpleray: " + target + ": cannot be created: there is no folder " + nowhere + "\n",
            "render", scene.toString(), "-o", target);
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "print", "check"})
    void anEmptyNameForASceneIs66(String command) {
        assertEnds(ExitCode.NO_SCENE, "simpleray: : the name is empty\n", line(command, Path.of("")));
    }

    @Test
    void anEmptyNameForTheOutputIs73() {
        assertEnds(ExitCode.NO_OUTPUT, "simpleray: : cannot be created: the name is empty\n", "render", scene.toString(), "-o", "");
    }

    @Test
    void aFolderForTheOutputIs73() {
        assertEnds(ExitCode.NO_OUTPUT, "simpleray: " + folder + ": cannot be created: is a folder\n",
            "render", scene.toString(), "-o", folder.toString());
    }

    /** {@return a command line with the output that {@code render} wants} */
    private String[] line(String command, Path path) {
        return command.equals("render") ? new String[] {command, path.toString(), "-o", out.toString()}
            : new String[] {command, path.toString()};
    }

    private void assertEnds(int exitCode, String message, String... args) {
        Program.Result result = InProcess.run(args);

        assertThat(result.err()).isEqualTo(message);
        assertThat(result.exitCode()).isEqualTo(exitCode);
        assertThat(result.out()).isEmpty();
        assertThat(out).doesNotExist();
    }
}
