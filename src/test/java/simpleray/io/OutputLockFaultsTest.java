package simpleray.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Locks on disks that refuse something. */
class OutputLockFaultsTest {
    private static final String NOT_NOTICED = "): another run that writes it at the same time is not noticed";

    @TempDir
    private Path folder;
    private final TrickyDisk disk = new TrickyDisk();

    private OutputLock lock() throws IOException {
        return OutputLock.of(disk.path(folder.resolve("out")));
    }

    private Path file() {
        return folder.resolve(".simpleray-out.lock");
    }

    private void refuse(String operation, IOException why) {
        disk.fault = (what, path) -> {
            if (what.equals(operation)) {
                throw why;
            }
        };
    }

    @Test
    void aLockThatTheDiskRefusesIsOneInNameOnly() throws IOException {
        refuse("lock", new IOException("No locks available"));
        try (OutputLock lock = lock(); OutputLock other = lock()) {
            assertThat(lock.refusal()).isEqualTo("cannot be locked (No locks available" + NOT_NOTICED);
            assertThat(other.refusal()).isEqualTo(lock.refusal());
            assertThat(file()).doesNotExist();
        }
        disk.fault = (what, path) -> { };
        try (OutputLock lock = lock()) {
            assertThat(lock.refusal()).isNull();
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aFileThatCannotBeMadeIsNoLockEither() throws IOException {
        refuse("channel", new AccessDeniedException("x"));
        try (OutputLock lock = lock()) {
            assertThat(lock.refusal()).isEqualTo("cannot be locked (permission denied" + NOT_NOTICED);
        }
        refuse("channel", new FileSystemException("x"));
        try (OutputLock lock = lock()) {
            assertThat(lock.refusal()).isEqualTo("cannot be locked (file system" + NOT_NOTICED);
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aLockThatNobodyHasAndNobodyGetsIsRefused() throws IOException {
        disk.lockable = false;
        try (OutputLock lock = lock()) {
            assertThat(lock.refusal()).isEqualTo("cannot be locked (permission denied" + NOT_NOTICED);
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aLockThatSomebodyHasJustTakenIsInUse() throws IOException {
        disk.lockable = false;
        disk.locking.add(path -> new Thread(() -> {
            try {
                Thread.sleep(20);
                Files.write(path, new byte[1]);
            } catch (IOException | InterruptedException e) {
                throw new AssertionError(e);
            }
        }).start());
        assertThatThrownBy(this::lock).isInstanceOf(FileInUseException.class);
        assertThat(file()).exists();
    }

    @Test
    void noRoomForItsMarkIsAnError() throws IOException {
        refuse("write", new IOException("No space left on device"));
        assertThatThrownBy(this::lock).isInstanceOf(IOException.class).hasMessage("No space left on device");
        assertThat(folder).isEmptyDirectory();

        disk.fault = (what, path) -> {
            if (what.equals("write") || what.equals("delete")) {
                throw new IOException("No " + what);
            }
        };
        assertThatThrownBy(this::lock).hasMessage("No write").satisfies(e -> assertThat(e.getCause().getSuppressed()).hasSize(1));
        disk.fault = (what, path) -> { };
        lock().close();
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aMarkOfAnEndThatCannotBeWrittenMattersOnlyIfTheFileStays() throws IOException {
        OutputLock lock = lock();
        refuse("write", new IOException("No space left on device"));
        lock.close();
        assertThat(folder).isEmptyDirectory();

        disk.fault = (what, path) -> { };
        OutputLock other = lock();
        refuse("delete", new IOException("Operation not permitted"));
        assertThatThrownBy(other::close).hasMessage("Operation not permitted");
        assertThat(file()).exists();
        other.close();
        disk.fault = (what, path) -> { };
        lock().close();
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void whatCannotBeDeletedAfterARefusalIsTheSmallerEvil() throws IOException {
        disk.fault = (what, path) -> {
            if (what.equals("lock") || what.equals("delete")) {
                throw new IOException("No " + what);
            }
        };
        try (OutputLock lock = lock()) {
            assertThat(lock.refusal()).isEqualTo("cannot be locked (No lock" + NOT_NOTICED);
        }
        assertThat(file()).exists();
    }
}
