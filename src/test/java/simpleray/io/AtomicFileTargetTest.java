package simpleray.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.google.common.jimfs.Configuration;
import com.google.common.jimfs.Jimfs;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What may be a target and what may not, and what becomes of links, devices and permissions; on a disk in memory. */
class AtomicFileTargetTest {
    private final TrickyDisk tricky = new TrickyDisk();
    private FileSystem disk;
    private Path target;

    @BeforeEach
    void makeDisk() {
        disk = Jimfs.newFileSystem(Configuration.unix().toBuilder().setWorkingDirectory("/pictures")
            .setAttributeViews("basic", "posix").build());
        target = disk.getPath("/pictures/picture.png");
    }

    @AfterEach
    void endDisk() throws IOException {
        disk.close();
    }

    @Test
    void aFolderIsNoTarget() {
        assertRefused(disk.getPath("/pictures"), "/pictures: is a folder");
    }

    /** Another program writes a film. */
    @Test
    void whatIsWrittenIsAFileBesideTheTargetOrTheDeviceItself() throws IOException {
        try (AtomicFile file = new AtomicFile(target)) {
            assertThat(file.file()).isNotEqualTo(target).exists().hasParent(target.getParent());
        }
        Path device = Path.of("/dev/null");
        assumeTrue(Files.isWritable(device), "there is no such device here");
        try (AtomicFile file = new AtomicFile(device)) {
            assertThat(file.file()).isEqualTo(device);
        }
    }

    @Test
    void norIsAFileInAFolderThatIsNotThere() {
        assertRefused(disk.getPath("none/picture.png"), "none/picture.png: there is no folder /pictures/none");
    }

    @Test
    void norIsAFileThatIsWriteProtected() throws IOException {
        write(target, "the old picture");
        tricky.asking = asked -> {
            throw new AccessDeniedException(asked.toString());
        };

        assertRefused(tricky.path(target), "/pictures/picture.png: is write-protected");
        assertThat(Files.readString(target)).isEqualTo("the old picture");
    }

    @Test
    void norIsAFileInAFolderThatIs() throws IOException {
        tricky.locking.add(opened -> {
            Files.delete(opened);
            throw new AccessDeniedException(opened.toString());
        });
        tricky.writing = begun -> {
            throw new AccessDeniedException(begun.toString());
        };

        assertRefused(tricky.path(target), "/pictures/picture.png: its folder is write-protected");
        assertThat(names()).isEmpty();
    }

    @Test
    void aFileThatCannotBeBegunLeavesNothingAndIsNobodys() throws IOException {
        tricky.writing = begun -> {
            throw new FileSystemException(begun.toString(), null, "too many open files");
        };
        assertThatThrownBy(() -> new AtomicFile(tricky.path(target))).hasMessageEndingWith(".part: too many open files");
        assertThat(names()).isEmpty();

        tricky.writing = begun -> { };
        write(tricky.path(target), "a picture");
        assertThat(Files.readString(target)).isEqualTo("a picture");
    }

    @Test
    void aLinkStaysALinkWhetherItLeadsToAFileAlreadyOrNot() throws IOException {
        Path link = Files.createSymbolicLink(disk.getPath("/pictures/link.png"), disk.getPath("picture.png"));

        write(link, "first");
        assertThat(Files.readString(target)).isEqualTo("first");
        write(link, "second");
        assertThat(Files.readString(target)).isEqualTo("second");

        assertThat(Files.readSymbolicLink(link)).hasToString("picture.png");
        assertThat(names()).containsExactly("link.png", "picture.png");
    }

    @Test
    void aLinkToALinkToNoFileYetIsFollowedToItsEnd() throws IOException {
        Path inner = Files.createSymbolicLink(disk.getPath("/pictures/inner.png"), disk.getPath("picture.png"));
        Path outer = Files.createSymbolicLink(disk.getPath("/pictures/outer.png"), disk.getPath("inner.png"));

        write(outer, "a picture");

        assertThat(Files.readString(target)).isEqualTo("a picture");
        assertThat(Files.isSymbolicLink(inner)).isTrue();
        assertThat(names()).containsExactly("inner.png", "outer.png", "picture.png");
    }

    @Test
    void aLinkToAFolderThatIsNotThereIsNoTarget() throws IOException {
        Path link = Files.createSymbolicLink(disk.getPath("/pictures/link.png"), disk.getPath("/none/picture.png"));

        assertRefused(link, "/pictures/link.png: there is no folder /none");
    }

    @Test
    void aDeviceIsWrittenToAsItIs() throws IOException {
        Files.createFile(target);
        tricky.devices = true;
        try (AtomicFile file = new AtomicFile(tricky.path(target))) {
            file.out().write("a picture".getBytes(StandardCharsets.US_ASCII));
            assertThat(names()).as("nothing beside it").containsExactly("picture.png");
            file.commit();
        }
        assertThat(Files.readString(target)).isEqualTo("a picture");
    }

    @Test
    void whoMayReadTheOldFileMayReadTheNewOne() throws IOException {
        write(target, "the old picture");
        Files.setPosixFilePermissions(target, PosixFilePermissions.fromString("rw-r-----"));

        write(target, "the new picture");

        assertThat(Files.getPosixFilePermissions(target)).isEqualTo(PosixFilePermissions.fromString("rw-r-----"));
        assertThat(Files.readString(target)).isEqualTo("the new picture");
    }

    @Test
    void whatIsClosedCannotBeWritten() throws IOException {
        AtomicFile file = new AtomicFile(target);
        file.close();

        assertThatThrownBy(() -> file.out().write(new byte[1 << 16])).isInstanceOf(IOException.class);
        assertThat(names()).isEmpty();
    }

    private static void assertRefused(Path path, String message) {
        assertThatThrownBy(() -> new AtomicFile(path)).isInstanceOf(FileSystemException.class).hasMessage(message);
    }

    private static void write(Path path, String text) throws IOException {
        try (AtomicFile file = new AtomicFile(path)) {
            file.out().write(text.getBytes(StandardCharsets.US_ASCII));
            file.commit();
        }
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(target.getParent())) {
            return files.map(file -> file.getFileName().toString()).sorted().collect(Collectors.toList());
        }
    }
}
