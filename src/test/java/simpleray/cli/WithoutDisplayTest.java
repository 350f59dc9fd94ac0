package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A machine without a display, or a Java without windows. */
class WithoutDisplayTest {
    private static final Pattern WINDOW = Pattern.compile("(java\\.awt|javax\\.swing|javax\\.imageio|sun\\.awt|com\\.formdev)\\.");

    @TempDir
    Path folder;

    @BeforeEach
    void writeScene() throws IOException {
        Files.writeString(folder.resolve("wall.scene"), SmallScenes.GREY);
    }

    @ParameterizedTest
    @ValueSource(strings = {"wall.scene", "view wall.scene", "view", "nowhere.scene --stage original"})
    void aWindowIs69AndTheMessageNamesTheWayOut(String line) throws IOException, InterruptedException {
        // headless as the property says it: on other systems than X11's there is no taking the display away
        Program.Result result = Program.finish(
            Program.program(folder, List.of("-Djava.awt.headless=true"), line.split(" ")).start(), new byte[0]);

        assertNoDisplay(result);
    }

    @Test
    void withoutTheVariableDisplayThereIsNoWindow() throws IOException, InterruptedException {
        assumeTrue(System.getProperty("os.name").equals("Linux"), "only X11 has the variable DISPLAY");

        assertNoDisplay(Program.run(folder, "wall.scene"));
    }

    private static void assertNoDisplay(Program.Result result) {
        assertThat(result.err()).isEqualTo("simpleray: there is no display for a window; simpleray render works without one\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_DISPLAY);
        assertThat(result.out()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"render wall.scene -o wall.png", "print wall.scene", "check wall.scene"})
    void whatNeedsNoWindowLoadsNoClassOfAwtOrSwing(String line) throws IOException, InterruptedException {
        assertThat(windowClasses(ExitCode.DONE, line)).isEmpty();
    }

    @Test
    void theWindowDoesLoadThem() throws IOException, InterruptedException {
        assertThat(windowClasses(ExitCode.NO_DISPLAY, "view")).contains("java.awt.GraphicsEnvironment");
    }

    /** ImageIO reads pictures for it, and takes no notice of a display, even where there seems to be one. */
    @Test
    void picturesAreComparedWhereNoDisplayAnswers() throws IOException, InterruptedException {
        assertThat(Program.run(folder, "render", "wall.scene", "-o", "wall.png", "-q").err()).isEmpty();
        ProcessBuilder compare = Program.program(folder, List.of(), "compare", "wall.png", "wall.png");
        compare.environment().put("DISPLAY", ":999");

        Program.Result result = Program.finish(compare.start(), new byte[0]);

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isEqualTo(ExitCode.DONE);
    }

    /** {@return the classes for windows and pictures that a command line loads} */
    private List<String> windowClasses(int exitCode, String line) throws IOException, InterruptedException {
        Program.Result result = Program.finish(
            Program.program(folder, List.of("-Xlog:class+load:file=loaded.log:none"), line.split(" ")).start(), new byte[0]);

        assertThat(result.exitCode()).as(result.err()).isEqualTo(exitCode);
        List<String> loaded = Files.readAllLines(folder.resolve("loaded.log")).stream().map(told -> told.split(" ")[0])
            .collect(Collectors.toList());
        assertThat(loaded.contains("simpleray.cli.Main")).as("the log of loaded classes is read well").isTrue();
        return loaded.stream().filter(name -> WINDOW.matcher(name).lookingAt()).collect(Collectors.toList());
    }
}
