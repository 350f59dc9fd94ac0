package simpleray.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files written on disks that refuse something. */
class AtomicFileFaultsTest {
    private static final String BUSY = "Device or resource busy";
    private static final String NOT_LOCKED = "cannot be locked (" + BUSY + "): another run that writes it at the same time is not noticed";

    @TempDir
    private Path folder;
    private final TrickyDisk disk = new TrickyDisk();
    private final List<String> notes = new ArrayList<>();

    private Path file() {
        return folder.resolve("out");
    }

    private AtomicFile begin(String text) throws IOException {
        AtomicFile file = new AtomicFile(disk.path(file()), notes::add);
        file.out().write(text.getBytes(StandardCharsets.US_ASCII));
        return file;
    }

    private void write(String text) throws IOException {
        try (AtomicFile file = begin(text)) {
            file.commit();
        }
    }

    private void refuse(String operation) {
        refuse(operation, "");
    }

    /** Has an operation refused on files whose names end so. */
    private void refuse(String operation, String ending) {
        disk.fault = (what, path) -> {
            if (what.equals(operation) && path.toString().endsWith(ending)) {
                throw new FileSystemException(path.toString(), null, BUSY);
            }
        };
    }

    private void assertOnlyTheFile(String text) throws IOException {
        assertThat(file()).hasContent(text);
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).containsExactly(file());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"old", "an old file that is longer", "same", ""})
    void aFileThatCannotBeReplacedIsOverwritten(String old) throws IOException {
        Files.writeString(file(), old);
        refuse("move");
        write("file");

        assertOnlyTheFile("file");
        assertThat(notes).containsExactly("cannot be replaced (" + BUSY + "): it was overwritten in place");
    }

    @Test
    void whatCannotBeMovedToANewNameIsWrittenThere() throws IOException {
        refuse("move");
        write("new");

        assertOnlyTheFile("new");
    }

    @Test
    void aDiskThatIsTooFullToOverwriteLeavesTheOldFile() throws IOException {
        Files.writeString(file(), "old");
        disk.fault = (what, path) -> {
            if (what.equals("move") || what.equals("write") && path.endsWith("out")) {
                throw new IOException("No space left on device");
            }
        };
        assertThatThrownBy(() -> write("new and longer")).isInstanceOf(IOException.class).hasMessage("No space left on device");

        assertOnlyTheFile("old");
        assertThat(notes).isEmpty();

        Files.delete(file());
        assertThatThrownBy(() -> write("new")).hasMessage("No space left on device");
        assertThat(folder).isEmptyDirectory();
    }

    @ParameterizedTest
    @ValueSource(strings = {"ol", "old", "older"})
    void whatCanNeitherBeReplacedNorCutOffStaysIfItIsLonger(String old) throws IOException {
        Files.writeString(file(), old);
        disk.fault = (what, path) -> {
            if (what.equals("move") || what.equals("truncate")) {
                throw new FileSystemException(path.toString(), null, BUSY);
            }
        };
        if (old.equals("older")) {
            assertThatThrownBy(() -> write("new")).isInstanceOf(FileSystemException.class).hasMessageEndingWith(BUSY);
            assertThat(notes).isEmpty();
            assertOnlyTheFile("older");
        } else {
            write("new");
            assertOnlyTheFile("new");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"a longer old file", "old"})
    void whatIsLostHalfWayStaysInThePart(String old) throws IOException {
        Files.writeString(file(), old);
        disk.fault = (what, path) -> {
            if (what.equals("move") || what.equals("write") && path.endsWith("out")) {
                throw new FileSystemException(path.toString(), null, "Input/output error");
            }
        };
        Path part = folder.toRealPath().resolve(".simpleray-out.part");
        assertThatThrownBy(() -> write("new")).isExactlyInstanceOf(IOException.class)
            .hasMessage("Input/output error (the whole file is " + part + ')');

        assertThat(part).hasContent("new");
        assertThat(folder.resolve(".simpleray-out.lock")).doesNotExist();
        assertThat(notes).isEmpty();
    }

    @Test
    void whereTheFolderTakesNoNewFileAnOldOneIsOverwritten() throws IOException {
        Files.writeString(file(), "old");
        refuse("bytes", ".part");
        write("new");

        assertOnlyTheFile("new");
        assertThat(notes).containsExactly("its folder takes no new file (" + BUSY + "): the old file is overwritten in place");
    }

    @Test
    void whereTheFolderTakesNoNewFileANewOneIsRefused() {
        refuse("bytes", ".part");
        assertThatThrownBy(() -> begin("new")).isInstanceOf(FileSystemException.class).hasMessageContaining(BUSY);
        assertThat(folder).isEmptyDirectory();

        disk.fault = (what, path) -> {
            if (what.equals("bytes")) {
                throw new AccessDeniedException(path.toString());
            }
        };
        assertThatThrownBy(() -> begin("new")).isInstanceOfSatisfying(FileSystemException.class,
            e -> assertThat(e.getReason()).isEqualTo("its folder is write-protected"));
        assertThat(folder).isEmptyDirectory();
        assertThat(notes).isEmpty();
    }

    @Test
    void anOldFileThatCannotBeOpenedIsKnownAtOnce() throws IOException {
        Files.writeString(file(), "old");
        refuse("bytes", "out");
        assertThatThrownBy(() -> begin("new")).isInstanceOf(FileSystemException.class).hasMessageContaining(BUSY);

        assertOnlyTheFile("old");
    }

    @Test
    void aPartThatIsInTheWayHasAnotherBeside() throws IOException {
        refuse("bytes", ".simpleray-out.part");
        write("new");

        assertOnlyTheFile("new");
        assertThat(notes).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"lock", "channel"})
    void whereNothingCanBeLockedItIsWrittenWithout(String operation) throws IOException {
        Files.writeString(file(), "old");
        refuse(operation, ".lock");
        try (AtomicFile file = begin("new"); AtomicFile other = begin("other")) {
            assertThat(file()).hasContent("old");
            file.commit();
            other.commit();
        }

        assertOnlyTheFile("other");
        assertThat(notes).containsExactly(NOT_LOCKED, NOT_LOCKED);
    }

    @Test
    void noRoomForALockEndsIt() {
        refuse("write", ".lock");
        assertThatThrownBy(() -> begin("new")).isInstanceOf(IOException.class).hasMessageContaining(BUSY);
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void whatCannotBeDeletedIsNamed() throws IOException {
        AtomicFile file = begin("new");
        refuse("delete");
        file.close();
        Path real = folder.toRealPath();

        assertThat(notes).containsExactly(real.resolve(".simpleray-out.part") + " cannot be deleted: " + BUSY + "; "
            + real.resolve(".simpleray-out.lock") + " cannot be deleted: " + BUSY);
        assertThat(file()).doesNotExist();

        disk.fault = (what, path) -> { };
        write("new");
        assertOnlyTheFile("new");
    }

    @Test
    void permissionsThatCannotBeKeptAreTold() throws IOException {
        assumeThat(folder.getFileSystem().supportedFileAttributeViews()).contains("posix");
        disk.views = Set.of("basic", "posix");
        Files.writeString(file(), "old");
        Files.setPosixFilePermissions(file(), PosixFilePermissions.fromString("rw-rw-rw-"));
        write("kept");
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file()))).isEqualTo("rw-rw-rw-");
        assertThat(notes).isEmpty();

        refuse("permissions");
        write("new");
        assertOnlyTheFile("new");
        assertThat(notes).containsExactly("the old file's permissions cannot be kept (" + BUSY + ')');
    }

    @Test
    void whatIsRemovedAtTheProgramsEndIsNotMovedAfterwards() throws IOException {
        Files.writeString(file(), "old");
        try (AtomicFile file = begin("new")) {
            AtomicFile.removeBegun();
            assertOnlyTheFile("old");
            assertThatThrownBy(file::commit).isInstanceOf(IOException.class).hasMessage("the program is told to stop");
        }
        assertOnlyTheFile("old");
        assertThat(notes).isEmpty();
    }

    @Test
    void whatIsGivenUpHasNoNotes() throws IOException {
        refuse("lock");
        begin("new").close();
        assertThat(notes).isEmpty();
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aFileThatMayNotBeWrittenIsWriteProtected() throws IOException {
        Files.writeString(file(), "old");
        disk.asking = path -> {
            throw new AccessDeniedException(path.toString());
        };
        assertThatThrownBy(() -> begin("new")).isInstanceOfSatisfying(FileSystemException.class,
            e -> assertThat(e.getReason()).isEqualTo("is write-protected"));
        disk.devices = true;
        assertThatThrownBy(() -> begin("new")).isInstanceOfSatisfying(FileSystemException.class,
            e -> assertThat(e.getReason()).isEqualTo("is write-protected"));
        disk.devices = false;
        assertOnlyTheFile("old");
    }

    @Test
    void aPartThatIsCutOffMeanwhileIsNoticed() throws IOException {
        Files.writeString(file(), "old");
        Path part = folder.resolve(".simpleray-out.part");
        disk.fault = (what, path) -> {
            if (what.equals("move")) {
                throw new FileSystemException(path.toString(), null, BUSY);
            }
            if (what.equals("write") && path.endsWith("out") && Files.size(part) > 10_000) {
                Files.writeString(part, "x".repeat(10_000));
            }
        };
        assertThatThrownBy(() -> write("x".repeat(100_000))).isInstanceOf(IOException.class)
            .hasMessage("the file in the making has been cut off");
        assertOnlyTheFile("old");
    }
}
