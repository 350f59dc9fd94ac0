package simpleray.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.RandomAccessFile;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class OutputTargetTest {
    private static final Path OPEN = Path.of("/proc/self/fd");

    @TempDir
    private Path folder;
    private Path file;

    @BeforeEach
    void makeFile() throws IOException {
        file = Files.writeString(folder.resolve("file"), "old ");
    }

    /** {@return the name of an open file} */
    private static Path open(Path file) throws IOException {
        assumeThat(OPEN).exists();
        try (Stream<Path> all = Files.list(OPEN)) {
            return all.filter(fd -> {
                try {
                    return Files.readSymbolicLink(fd).equals(file.toRealPath());
                } catch (IOException e) {
                    return false;                             // it was that of the list
                }
            }).findFirst().orElseThrow();
        }
    }

    private static void write(Path path) throws IOException {
        try (OutputStream out = OutputTarget.open(path)) {
            out.write("new".getBytes(StandardCharsets.US_ASCII));
        }
    }

    private static void assertRefused(Path path, String why) {
        assertThatThrownBy(() -> OutputTarget.open(path)).isInstanceOfSatisfying(FileSystemException.class, e -> {
            assertThat(e.getReason()).isEqualTo(why);
            assertThat(e.getFile()).isEqualTo(path.toString());
        });
    }

    @Test
    void anOpenFileIsAddedTo() throws IOException {
        try (FileOutputStream opened = new FileOutputStream(file.toFile(), true)) {
            assertThat(opened.getFD().valid()).isTrue();
            Path fd = open(file);
            assertThat(OutputTarget.isStream(fd)).isTrue();
            write(fd);
            write(Path.of("/dev/fd").resolve(fd.getFileName()));
            Path link = Files.createSymbolicLink(folder.resolve("link"), Path.of("/dev/fd").resolve(fd.getFileName()));
            assertThat(OutputTarget.isStream(link)).isTrue();
            write(link);
        }
        assertThat(file).hasContent("old newnewnew");
    }

    @ParameterizedTest
    @ValueSource(strings = {"rw", "rws"})
    void aFileThatIsOpenForBothIsToo(String mode) throws IOException {
        try (RandomAccessFile opened = new RandomAccessFile(file.toFile(), mode)) {
            assertThat(opened.length()).isEqualTo(4);
            write(open(file));
        }
        assertThat(file).hasContent("old new");
    }

    @Test
    void aFileThatIsOpenForReadingOnlyIsNot() throws IOException {
        try (FileInputStream opened = new FileInputStream(file.toFile())) {
            assertThat(opened.available()).isEqualTo(4);
            assertRefused(open(file), "is open for reading only");
        }
        assertThat(file).hasContent("old ");
    }

    @Test
    void whatIsNotOpenIsRefused() {
        assumeThat(OPEN).exists();
        assertRefused(OPEN.resolve("987654"), "is no open file");
        assertThat(OutputTarget.isStream(OPEN.resolve("987654"))).isTrue();
    }

    @Test
    void aSocketWithoutANameIsRefused() throws IOException {
        assumeThat(OPEN).exists();
        try (ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            server.bind(UnixDomainSocketAddress.of(folder.resolve("socket")));
            try (Stream<Path> all = Files.list(OPEN)) {
                Path socket = all.filter(fd -> {
                    try {
                        return Files.readSymbolicLink(fd).toString().startsWith("socket:");
                    } catch (IOException e) {
                        return false;
                    }
                }).findFirst().orElseThrow();
                assertRefused(socket, "is a socket that has no name: write to standard output, and add >&" + socket.getFileName());
            }
        }
    }

    @Test
    void aSocketWithANameIsConnectedTo() throws IOException {
        Path path = folder.resolve("socket");
        try (ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            server.bind(UnixDomainSocketAddress.of(path));
            assertThat(OutputTarget.isStream(path)).isTrue();
            write(path);
            ByteBuffer bytes = ByteBuffer.allocate(8);
            try (SocketChannel client = server.accept()) {
                while (client.read(bytes) >= 0) {
                    assertThat(bytes.position()).isLessThanOrEqualTo(3);
                }
            }
            assertThat(new String(bytes.array(), 0, bytes.position(), StandardCharsets.US_ASCII)).isEqualTo("new");
        }
        assertThatThrownBy(() -> OutputTarget.open(path)).isInstanceOf(FileSystemException.class)
            .satisfies(e -> assertThat(e.getSuppressed()).hasSize(1));
    }

    @ParameterizedTest
    @ValueSource(strings = {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "/dev/stderr", "/dev/fd/2", "/proc/self/fd/2"})
    void standardOutputStaysOpen(String name) throws IOException {
        assumeThat(OPEN).exists();
        Path path = Path.of(name);
        assertThat(OutputTarget.isStream(path)).isTrue();
        assertThat(OutputTarget.isStandardOutput(path)).isEqualTo(name.endsWith("1") || name.endsWith("out"));
        OutputTarget.open(path).close();
        try (OutputStream again = OutputTarget.open(path)) {
            again.flush();
        }
        assertThat(FileDescriptor.out.valid() && FileDescriptor.err.valid()).isTrue();
    }

    @Test
    void anotherProcessesStandardOutputIsNotOurs() throws IOException, InterruptedException {
        assumeThat(OPEN).exists();
        assumeThat(Path.of("/bin/sleep")).exists();
        Process sleep = new ProcessBuilder("/bin/sleep", "60").redirectOutput(ProcessBuilder.Redirect.appendTo(file.toFile())).start();
        try {
            write(Path.of("/proc/" + sleep.pid() + "/fd/1"));
        } finally {
            sleep.destroyForcibly().waitFor();
        }
        assertThat(file).hasContent("old new");
    }

    @Test
    void aDeviceIsWrittenTo() throws IOException {
        Path device = Path.of("/dev/null");
        assumeThat(device).exists();
        assertThat(OutputTarget.isStream(device)).isTrue();
        write(device);
        assertThat(OutputTarget.isStream(file)).isFalse();
        assertThat(OutputTarget.isStream(folder.resolve("none"))).isFalse();
    }

    @Test
    void oneFileIsTheSameByAllItsNames() throws IOException {
        Path hard = Files.createLink(folder.resolve("hard"), file);
        Path soft = Files.createSymbolicLink(folder.resolve("soft"), file);
        Path other = Files.writeString(folder.resolve("other"), "old ");

        assertThat(OutputTarget.isSame(hard, file)).isTrue();
        assertThat(OutputTarget.isSame(soft, hard)).isTrue();
        assertThat(OutputTarget.isSame(folder.resolve("./file"), file)).isTrue();
        assertThat(OutputTarget.isSame(other, file)).isFalse();
        assertThat(OutputTarget.isSame(folder.resolve("none"), folder.resolve("none"))).isFalse();
        assertThat(OutputTarget.isSame(file, folder.resolve("none"))).isFalse();
        assertThat(OutputTarget.isSame(folder, folder)).isFalse();
    }

    @Test
    void aNameThatIsTooLongToBeAddedToIsStoodForByItsChecksum() throws IOException {
        String name = "\u00E4".repeat(120);
        Path beside = OutputTarget.beside(folder.resolve(name), ".part");

        assertThat(beside.getFileName().toString()).matches("\\.simpleray-[0-9a-f]+\\.part");
        assertThat(beside.getParent()).isEqualTo(folder.toRealPath());
        assertThat(OutputTarget.beside(folder.resolve("\u00C4".repeat(120)), ".part")).isEqualTo(beside);
        assertThat(OutputTarget.beside(folder.resolve(name + 'x'), ".part")).isNotEqualTo(beside);
        assertThat(OutputTarget.beside(folder.resolve("short"), ".part").getFileName()).hasToString(".simpleray-short.part");
    }

    @Test
    void aFileThatIsNotThereYetIsFoundBehindLinks() throws IOException {
        Path none = folder.toRealPath().resolve("none");
        Path link = Files.createSymbolicLink(folder.resolve("link"), Path.of("none"));

        assertThat(OutputTarget.file(link)).isEqualTo(none);
        assertThat(OutputTarget.file(folder.resolve("file"))).isEqualTo(file.toRealPath());
        assertThatThrownBy(() -> OutputTarget.file(folder.resolve("no/file"))).isInstanceOfSatisfying(FileSystemException.class,
            e -> assertThat(e.getReason()).isEqualTo("there is no folder " + folder.resolve("no")));
        assertThatThrownBy(() -> OutputTarget.file(folder.resolve("x".repeat(300)))).isInstanceOfSatisfying(FileSystemException.class,
            e -> assertThat(e.getReason()).isNotEmpty());
    }

    @Test
    void reasonsNameNoFile() {
        assertThat(OutputTarget.reason(new AccessDeniedException("x"))).isEqualTo("permission denied");
        assertThat(OutputTarget.reason(new IOException("why"))).isEqualTo("why");
        assertThat(OutputTarget.reason(new FileSystemException("x", null, "why"))).isEqualTo("why");
        assertThat(OutputTarget.reason(new NoSuchFileException("x"))).isEqualTo("no such file");
        assertThat(OutputTarget.reason(new DirectoryNotEmptyException("x"))).isEqualTo("directory not empty");
    }

    @Test
    void aNameOf100BytesIsAddedTo() throws IOException {
        assertThat(OutputTarget.beside(folder.resolve("x".repeat(100)), ".part").getFileName()).hasToString(".simpleray-" + "x".repeat(100) + ".part");
        assertThat(OutputTarget.beside(folder.resolve("x".repeat(101)), ".part").getFileName().toString()).hasSizeLessThan(40);
    }

    @Test
    void theRootIsNoFile() {
        assertThatThrownBy(() -> OutputTarget.file(Path.of("/"))).isInstanceOf(FileSystemException.class);
    }
}
