package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simpleray.io.AtomicFile;

/** Every command that writes a file or to standard output, and each fault of these. */
class EveryOutputTest {
    private static final String SIZE = " --size 20x20";
    private static final int LONGEST_NAME = 255;

    @TempDir
    static Path made;

    @TempDir
    Path folder;

    /** {@return all that writes one file} In a line @ stands for the folder of what is read. */
    static List<String> files() {
        return List.of("render @ball.scene --progress plain -o", "merge @2.png @1.png -q -o", "convert @ball.scene",
            "still @ball.scene -o", "import @ball.rt -o", "export --pov @ball.scene -o", "compare @one.png @other.png --heatmap",
            "explain @ball.scene --pixel 5,5 -q --draw-size 9x9 --draw");
    }

    /** {@return all that writes to standard output} */
    static List<String> streams() {
        return List.of("render @ball.scene -q -o -", "render @ball.scene -q --stats text -o @stats.png", "merge @2.png @1.png -q -o -",
            "convert @ball.scene -", "still @ball.scene -o -", "import @ball.rt -o -",
            "export --pov @ball.scene -o -", "print @ball.scene", "check @ball.scene", "check --errors json @ball.scene",
            "explain @ball.scene --pixel 5,5", "explain @ball.scene --pixel 5,5 --format json", "compare @one.png @other.png",
            "compare @one.png @other.png --format json", "verify @one.png -q", "bench --quick", "generate-completion", "help", "help render",
            "--help", "--version", "render --help");
    }

    /** {@return what writes neither: files of names that it makes up, in a folder, and a window} */
    private static Set<String> others() {
        return Set.of("animate", "figures", "job", "view");
    }

    @BeforeAll
    static void makeWhatIsRead() throws IOException {
        makeWhatIsRead(made);
    }

    /** Makes the files that the lines read, in the folder that @ stands for. */
    static void makeWhatIsRead(Path folder) throws IOException {
        Files.writeString(folder.resolve("ball.scene"), SmallScenes.ROUGH);
        Files.writeString(folder.resolve("ball.rt"), "A 0.2 255,255,255\nC 0,0,5 0,0,-1 70\nL -3,4,2 0.7 255,255,255\nsp 0,0,0 2 255,0,0\n");
        for (String options : List.of("one.png", "other.png --cop 3", "1.png --band 1/2", "2.png --band 2/2")) {
            String line = "render @ball.scene -q -o @" + options + SIZE;
            assertThat(InProcess.run(line.replace("@", folder + "/").split(" ")).exitCode()).isZero();
        }
    }

    @BeforeEach
    void writeTheOldFile() throws IOException {
        Files.writeString(folder.resolve("out"), "the old one");
    }

    private static Program.Result run(String line) {
        return InProcess.run(words(line));
    }

    private static String[] words(String line) {
        return line.replace("@", made + "/").split(" ");
    }

    @Test
    void noCommandIsLeftOut() {
        Set<String> commands = new TreeSet<>(new Commands(new Main(null, null, null)).line("help").getSubcommands().keySet());

        commands.removeAll(others());
        Stream.of(files(), streams()).flatMap(List::stream).forEach(line -> commands.remove(line.split(" ")[0]));

        assertThat(commands).isEmpty();
    }

    private void assertCannotBeCreated(String line, Path target, String reason) {
        assertEnds(ExitCode.NO_OUTPUT, line, target, "simpleray: " + target + ": cannot be created: " + reason);
    }

    private void assertEnds(int exitCode, String line, Path target, String message) {
        Program.Result result = run(line + ' ' + target);

        assertThat(result.err()).isEqualTo(message + '\n');
        assertThat(result.exitCode()).isEqualTo(exitCode);
        assertThat(result.out()).isEmpty();
    }

    @ParameterizedTest
    @MethodSource("files")
    void aFolderThatIsNotThereIs73(String line) {
        assertCannotBeCreated(line, folder.resolve("none/out"), "there is no folder " + folder.resolve("none"));
    }

    @ParameterizedTest
    @MethodSource("files")
    void aFileInPlaceOfTheFolderIs73(String line) {
        assertCannotBeCreated(line, folder.resolve("out/out"), "there is no folder " + folder.resolve("out"));
    }

    @ParameterizedTest
    @MethodSource("files")
    void aFolderInThePlaceOfTheFileIs73(String line) {
        assertCannotBeCreated(line, folder, "is a folder");
    }

    @ParameterizedTest
    @MethodSource("files")
    void aNameThatIsTooLongIs73(String line) {
        assumeTrue(Files.exists(Path.of("/dev/null")), "other systems have other limits, and other words");

        assertCannotBeCreated(line, folder.resolve("x".repeat(LONGEST_NAME + 1)), "File name too long");
    }

    @ParameterizedTest
    @MethodSource("files")
    void aNameThatNoFileCanHaveIs2(String line) {
        String name = folder + "/a\0b";
        Program.Result result = InProcess.run(Stream.concat(Stream.of(words(line)), Stream.of(name)).toArray(String[]::new));

        String command = "simpleray " + line.split(" ")[0];
        assertThat(result.err()).startsWith(command + ": no file can be called '" + name).endsWith(" (see " + command + " --help)\n")
            .contains("' here: Nul character not allowed ").hasLineCount(1);
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
    }

    @ParameterizedTest
    @MethodSource("files")
    void whatAnotherIsWritingIs75(String line) throws IOException {
        Path target = folder.resolve("out");
        try (AtomicFile first = new AtomicFile(target)) {
            assertEnds(ExitCode.BUSY, line, target, "simpleray: " + target + ": is being written by another run of SimpleRay: "
                + "wait until it has ended, or choose another name");
            first.out().write('1');
            first.commit();
        }
        assertThat(target).hasContent("1");
        assertThat(run(line + ' ' + target).err()).doesNotContain("another run");
        assertThat(target).isNotEmptyFile();
        assertOnlyOut();
    }

    @ParameterizedTest
    @MethodSource("files")
    void aFullDiskIs74(String line) {
        Path full = Path.of("/dev/full");
        assumeTrue(Files.exists(full), "no /dev/full here");

        Program.Result result = run(line + ' ' + full);

        assertThat(result.err()).endsWith("simpleray: /dev/full: cannot be written: No space left on device\n").doesNotContain("\tat ");
        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
    }

    @ParameterizedTest
    @MethodSource("streams")
    void standardOutputThatEndsIs74(String line) {
        OutputStream gone = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("nobody reads");
            }
        };

        Program.Result result = InProcess.run(InputStream.nullInputStream(), gone, words(line));

        String[] messages = {"the picture cannot be written to standard output: nobody reads",
            "standard output cannot be written: nobody reads", "standard output cannot be written"};
        assertThat(result.err()).isEqualTo("simpleray: "
            + messages[line.matches("(render|merge).* -o -") ? 0 : line.matches(".*--?(help|version)|(help|gen).*") ? 2 : 1] + '\n');
        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
    }

    @ParameterizedTest
    @MethodSource("streams")
    void standardOutputIsWrittenAsItShould(String line) {
        assumeTrue(!line.startsWith("bench"), "BenchCommandTest has it");

        Program.Result result = run(line);

        assertThat(result.err()).isEmpty();
        assertThat(result.out()).isNotEmpty();
        assertThat(result.exitCode()).isEqualTo(line.startsWith("compare") ? ExitCode.DIFFERENT : ExitCode.DONE);
    }

    @Test
    void ofFiguresNoneIsBegunIfOneIsBeingWritten() throws IOException {
        Path busy = folder.resolve("ball-terms.png");
        try (AtomicFile first = new AtomicFile(busy)) {
            assertEnds(ExitCode.BUSY, "figures @ball.scene --progress plain -d", folder, "simpleray: " + busy
                + ": is being written by another run of SimpleRay: wait until it has ended, or choose another name");
            first.out().flush();
        }
        assertOnlyOut();
    }

    @Test
    void ofFiguresNoneIsMadeIfANameIsTooLong() throws IOException {
        assumeTrue(Files.exists(Path.of("/dev/null")), "other systems have other limits, and other words");
        String name = "x".repeat(LONGEST_NAME - "-stages.png".length());
        Path scene = Files.copy(made.resolve("ball.scene"), folder.resolve(name));

        Program.Result result = run("figures " + scene + " --progress plain --sweep shininess=2 -d " + folder);

        assertThat(result.err()).isEqualTo("simpleray: " + folder.resolve(name + "-shininess.png")
            + ": cannot be created: File name too long\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        Files.delete(scene);
        assertOnlyOut();
    }

    private void assertOnlyOut() throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            assertThat(all.map(file -> file.getFileName().toString()).collect(Collectors.toList())).containsExactly("out");
        }
    }
}
