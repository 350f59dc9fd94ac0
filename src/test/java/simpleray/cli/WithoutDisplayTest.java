package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A machine without a display, or a Java without windows. */
class WithoutDisplayTest {
    private static final Pattern WINDOW = Pattern.compile("(java\\.awt|javax\\.swing|javax\\.imageio|sun\\.awt|com\\.formdev)\\.");

    private static final String INSTALL = "install openjdk-" + Runtime.version().feature() + "-jre\n";

    /** By the real places of these Java finds the others. */
    private static final Set<String> COPIED = Set.of("java", "libjli.so", "libjvm.so", "libawt.so");

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

    @ParameterizedTest
    @ValueSource(strings = {"wall.scene", "view wall.scene --look dark", "view", "nowhere.scene --stage original"})
    void aJavaOfItsBaseAloneIsNamed(String line) throws IOException, InterruptedException {
        assertNoWindows(onBase(line.split(" ")));
    }

    @Test
    void picturesAreRenderedByAJavaOfItsBaseAloneButNotCompared() throws IOException, InterruptedException {
        assertThat(onBase("render", "wall.scene", "-o", "wall.png", "-q").err()).isEmpty();

        for (String[] line : List.of(new String[] {"verify", "wall.png"}, new String[] {"compare", "wall.png", "wall.png"})) {
            Program.Result result = onBase(line);
            assertThat(result.err())
                .isEqualTo("simpleray: this Java lacks the module java.desktop, which is needed here: " + INSTALL);
            assertThat(result.exitCode()).isEqualTo(ExitCode.UNAVAILABLE);
        }
    }

    private Program.Result onBase(String... line) throws IOException, InterruptedException {
        return Program.finish(Program.program(folder, List.of("--limit-modules", "java.base"), line).start(), new byte[0]);
    }

    @ParameterizedTest
    @ValueSource(strings = {":999", ""})
    void aHeadlessJavaIsNamed(String display) throws IOException, InterruptedException {
        Path java = javaWith(null);
        ProcessBuilder program = Program.program(java, folder, List.of(), "wall.scene");
        program.environment().put("DISPLAY", display);

        assertNoWindows(Program.finish(program.start(), new byte[0]));
    }

    @Test
    void whatAJavaLacksForWindowsIsNamed() throws IOException, InterruptedException {
        Path java = javaWith("no library");
        ProcessBuilder program = Program.program(java, folder, List.of(), "wall.scene");
        program.environment().put("DISPLAY", ":999");
        Program.Result result = Program.finish(program.start(), new byte[0]);

        assertThat(result.err()).contains("simpleray: this Java can open no windows: " + java.toRealPath() + "/lib/libawt_xawt.so: ")
            .endsWith("; simpleray render works without one\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.UNAVAILABLE);
    }

    @AfterEach
    void deleteLinks() throws IOException {                   // JUnit warns of each that leads out of its folder
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path link : files.filter(Files::isSymbolicLink).toList()) {
                Files.delete(link);
            }
        }
    }

    /** {@return the home of a Java like this one, with another file for X11, or without one} */
    private Path javaWith(String x11) throws IOException {
        assumeTrue(System.getProperty("os.name").equals("Linux"), "only Linux has X11's part in that file");
        Path home = Path.of(System.getProperty("java.home")).toRealPath();
        Path made = folder.resolve("java");
        try (Stream<Path> files = Files.walk(home)) {
            for (Path file : files.filter(f -> !Files.isDirectory(f)).toList()) {
                Path copy = made.resolve(home.relativize(file));
                Files.createDirectories(copy.getParent());
                if (COPIED.contains(file.getFileName().toString())) {
                    Files.copy(file, copy);
                } else if (!file.endsWith("libawt_xawt.so")) {
                    Files.createSymbolicLink(copy, file);
                } else if (x11 != null) {
                    Files.writeString(copy, x11);
                }
            }
        }
        return made;
    }

    private static void assertNoWindows(Program.Result result) {
        assertThat(result.err()).isEqualTo("simpleray: this Java can open no windows: " + INSTALL.strip()
            + "; simpleray render works without one\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.UNAVAILABLE);
        assertThat(result.out()).isEmpty();
    }

    private static void assertNoDisplay(Program.Result result) {
        assertThat(result.err()).isEqualTo("simpleray: there is no display for a window; simpleray render works without one\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.UNAVAILABLE);
        assertThat(result.out()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"render wall.scene -o wall.png", "print wall.scene", "check wall.scene"})
    void whatNeedsNoWindowLoadsNoClassOfAwtOrSwing(String line) throws IOException, InterruptedException {
        assertThat(windowClasses(ExitCode.DONE, line)).isEmpty();
    }

    @Test
    void theWindowDoesLoadThem() throws IOException, InterruptedException {
        assertThat(windowClasses(ExitCode.UNAVAILABLE, "view")).contains("java.awt.GraphicsEnvironment");
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
