package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Sample;

/** Outputs that are no files: open ones by their names, pipes, sockets, devices. */
@Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class OpenFilesTest {
    private static final String START = "J=(\"$@\"); R() { \"${J[@]}\" \"$@\"; }; ";

    @TempDir
    static Path made;

    @TempDir
    Path folder;

    @BeforeAll
    static void makeWhatIsRead() throws IOException {
        assumeTrue(Files.exists(Path.of("/proc/self/fd")) && Files.isExecutable(Path.of("/bin/bash")), "no Linux with bash");
        EveryOutputTest.makeWhatIsRead(made);
    }

    /** {@return what bash says when it runs a script, in which R stands for the program} */
    private Program.Result bash(String script) throws IOException, InterruptedException {
        ProcessBuilder program = Program.program(folder, List.of());
        program.command().addAll(0, List.of("/bin/bash", "-c", START + script.replace(" @", " " + made + '/'), "bash"));
        return Program.finish(program.start(), new byte[0]);
    }

    private static Stream<String> commands() {
        return Sample.of(EveryOutputTest.files(), 2).stream().map(line -> line.replace("--progress plain", "-q --size 20x20"));
    }

    private byte[] expected(String line) throws IOException {
        Path file = folder.resolve("expected");
        InProcess.run((line.replace("@", made + "/") + ' ' + file).split(" "));
        return Files.readAllBytes(file);
    }

    @ParameterizedTest
    @MethodSource("commands")
    void anOpenFileIsWrittenToAsStandardOutputIs(String line) throws IOException, InterruptedException {
        byte[] expected = expected(line);

        Program.Result result = bash("R " + line + " /dev/fd/3 3>three >/dev/null; R " + line + " /proc/self/fd/4 4>four >/dev/null; "
            + "R " + line + " >(cat >process) >/dev/null; R " + line + " /dev/stderr 2>err >/dev/null; mkfifo pipe; cat pipe >piped & R " + line
            + " pipe >/dev/null; wait; R " + line + " /dev/null >/dev/null; for i in {1..100}; do [ -s process ] || sleep 0.05; done");

        assertThat(result.err()).isEmpty();
        for (String name : List.of("three", "four", "process", "err", "piped")) {
            assertThat(folder.resolve(name)).as(name).hasBinaryContent(expected);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"})
    void standardOutputByNameIsPipeOrFileAndKeepsWhatItHolds(String name) throws IOException, InterruptedException {
        byte[] expected = expected("render @ball.scene -q --size 20x20 -o");

        Program.Result result = bash("echo old >file; R render @ball.scene -q --size 20x20 -o " + name + " >>file; "
            + "R render @ball.scene -q --size 20x20 -o " + name + " | cat");

        assertThat(result.err()).isEmpty();
        assertThat(result.out()).isEqualTo(expected);
        assertThat(Files.readAllBytes(folder.resolve("file"))).hasSize(expected.length + 4).endsWith(expected);
    }

    @Test
    void whatIsPrintedBesideThePictureGoesToStandardError() throws IOException, InterruptedException {
        Program.Result result = bash("R render @ball.scene --size 20x20 -o /dev/fd/1 --stats text");

        assertThat(result.out()).isEqualTo(expected("render @ball.scene -q --size 20x20 -o"));
        assertThat(result.err()).startsWith("/dev/fd/1: 20x20, ").contains("primary rays");
    }

    @Test
    void aSocketWithANameIsConnectedTo() throws Exception {
        Path path = folder.resolve("socket");
        try (ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            server.bind(UnixDomainSocketAddress.of(path));
            CompletableFuture<Integer> length = CompletableFuture.supplyAsync(() -> lengthOf(server));

            Program.Result result = InProcess.run("convert", made.resolve("ball.scene").toString(), path.toString());

            assertThat(result.err()).isEmpty();
            assertThat(length.get()).isEqualTo(expected("convert @ball.scene").length);
        }
        Program.Result nobody = InProcess.run("convert", made.resolve("ball.scene").toString(), path.toString());
        assertThat(nobody.err()).isEqualTo("simpleray: " + path + ": cannot be created: No such device or address\n");
        assertThat(nobody.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
    }

    private static int lengthOf(ServerSocketChannel server) {
        try (SocketChannel client = server.accept()) {
            ByteBuffer all = ByteBuffer.allocate(1 << 20);
            while (client.read(all) >= 0) {
                Thread.onSpinWait();
            }
            return all.position();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    @ParameterizedTest
    @MethodSource("commands")
    void whatCannotBeOpenedIs73(String line) throws IOException, InterruptedException {
        assertCannotBeCreated(bash("R " + line + " /dev/fd/9"), "/dev/fd/9", "is no open file");
        for (String name : List.of(folder + "/none/", folder + "/")) {
            assertCannotBeCreated(InProcess.run((line.replace("@", made + "/") + ' ' + name).split(" ")), name,
                name.contains("none") ? "there is no folder " + folder + "/none" : "is a folder");
        }
        assertThat(folder).isEmptyDirectory();
    }

    private static void assertCannotBeCreated(Program.Result result, String name, String reason) {
        assertThat(result.err()).isEqualTo("simpleray: " + name + ": cannot be created: " + reason + '\n');
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
    }

    @Test
    void aFileThatIsOpenForReadingOnlyIsNotWritten() throws IOException, InterruptedException {
        Path file = Files.writeString(folder.resolve("file"), "old");
        String line = "render @ball.scene -q --size 20x20 -o ";

        assertCannotBeCreated(bash("R " + line + "/dev/fd/3 3<file"), "/dev/fd/3", "is open for reading only");
        assertCannotBeCreated(bash("R " + line + "/dev/stdin <file"), "/dev/stdin", "is open for reading only");
        assertThat(file).hasContent("old");
        assertThat(bash("R " + line + "/dev/fd/3 3<>file").exitCode()).isZero();
    }

    @Test
    void standardOutputMayBeNoInputEither() throws IOException, InterruptedException {
        Path obj = Files.writeString(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Path scene = Files.writeString(folder.resolve("a.scene"), "1\n4 \"a.obj\" 0 0 0 1  1 1 1  1 1 1  0 0 0  1\n0.5 0.5 0.5\n0\n");
        byte[] before = Files.readAllBytes(scene);
        String usage = " (see simpleray render --help)\n";

        assertThat(bash("R render a.scene -q -o - >>a.scene").err()).isEqualTo("simpleray render: the output - is the scene itself" + usage);
        assertThat(bash("R render a.scene -q -o - >>a.obj").err()).isEqualTo("simpleray render: the output - is read by the scene" + usage);
        assertThat(scene).hasBinaryContent(before);
        assertThat(obj).content().endsWith("f 1 2 3\n");
    }

    @Test
    void rowsOfAPictureThatIsNoFileAreKeptOnlyUnderAName() throws IOException, InterruptedException {
        Program.Result result = bash("R render @ball.scene -o /dev/null --resume");

        assertThat(result.err()).isEqualTo("simpleray render: --resume needs --checkpoint FILE where the picture goes to /dev/null "
            + "(see simpleray render --help)\n");
        assertThat(bash("R render @ball.scene -q -o /dev/null --checkpoint rows --resume").err()).isEmpty();
        assertThat(bash("R render @ball.scene -q -o a.png --checkpoint rows/").err()).isEqualTo("simpleray: rows/: there is no folder rows\n");
    }
}
