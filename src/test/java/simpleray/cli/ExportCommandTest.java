package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code simpleray export}. */
class ExportCommandTest {
    private static final String MIRROR = "1  1 0 0 1 -2  1 1 1  0 0 0  0.5 0.25 0.75  5   0.5 0.5 0.5  0\ndepth 3\n";

    @TempDir
    Path folder;

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private int run(String in, String... args) {
        return Main.run(args, new ByteArrayInputStream(in.getBytes(StandardCharsets.UTF_8)), out,
            new PrintStream(err, true, StandardCharsets.UTF_8));
    }

    @Test
    void optionsWinOverTheSceneFile() {
        assertThat(run(MIRROR, "export", "--pov", "-", "-o", "-", "--channel", "G", "--size", "40x20", "--background", "1,0.5,0",
            "--cop", "4")).isZero();
        assertThat(out.toString(StandardCharsets.UTF_8)).contains("+W40 +H20 ", "max_trace_level 4 ", "background { rgb <0.5,0.5,0.5> }",
            "location <0.0,0.0,4.0>", "reflection { rgb <0.25,0.25,0.25> }");
        assertThat(err.toString(StandardCharsets.UTF_8)).isEmpty();
    }

    @Test
    void whatPovrayShowsOtherwiseIsSaidAndTheFileIsWritten() throws IOException {
        Path pov = folder.resolve("a.pov");
        assertThat(run(MIRROR, "export", "--pov", "-", "-o", pov.toString())).isZero();
        assertThat(Files.readString(pov)).startsWith("// Written by SimpleRay");
        assertThat(err.toString(StandardCharsets.UTF_8)).isEqualTo("-: warning: object 1 has a coloured highlight, or glass that scatters "
            + "light: POV-Ray takes a mean of the colours. With --channel r, g and b it is exact\n".replace("\n", System.lineSeparator()));
    }

    @Test
    void formatMustBeNamedAndStagesAreRefused() {
        assertThat(run(MIRROR, "export", "-", "-o", "-")).isEqualTo(ExitCode.USAGE);
        assertThat(run(MIRROR, "export", "--pov", "-", "-o", "-", "--stage", "lighting")).isEqualTo(ExitCode.USAGE);
        assertThat(run(MIRROR, "export", "--pov", "-", "-o", "-", "--channel", "x")).isEqualTo(ExitCode.USAGE);
        assertThat(out.size()).isZero();
    }

    @Test
    void sceneIsNotOverwritten() throws IOException {
        Path scene = Files.writeString(folder.resolve("a.scene"), MIRROR);
        assertThat(run("", "export", "--pov", scene.toString(), "-o", scene.toString())).isEqualTo(ExitCode.USAGE);
        assertThat(scene).content().isEqualTo(MIRROR);
    }

    @Test
    void folderThatIsNotThereIsExitCode73() {
        assertThat(run(MIRROR, "export", "--pov", "-", "-o", folder.resolve("no/a.pov").toString())).isEqualTo(ExitCode.NO_OUTPUT);
    }
}
