package simpleray.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What other processes do between the opening of the file that is locked and the locking. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class OutputLockRaceTest {
    private final TrickyDisk disk = new TrickyDisk();
    @TempDir
    Path folder;
    private Path real;
    private Path file;

    @BeforeEach
    void nameTheFile() {
        real = folder.resolve("a.lock");
        file = disk.path(real);
    }

    @Test
    void aFileThatItsHolderDeletesMeanwhileIsMadeAndLockedAnew() throws IOException {
        disk.locking.add(OutputLockRaceTest::deleteAsItsHolder);
        disk.locking.add(OutputLockRaceTest::deleteAsItsHolder);

        try (OutputLock lock = new OutputLock(file, "a.png")) {
            assertThat(lock.file()).exists();
            assertThat(disk.channels).hasSize(3);
            assertThat(disk.channels.subList(0, 2)).noneMatch(channel -> channel.isOpen());
            assertThat(disk.channels.get(2).isOpen()).isTrue();
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aFileThatAThirdHasMadeInItsPlaceIsNotTakenForTheOneThatIsLocked() throws IOException {
        disk.locking.add(opened -> {
            deleteAsItsHolder(opened);
            Files.createFile(opened);
        });

        try (OutputLock lock = new OutputLock(file, "a.png")) {
            assertThat(Files.size(real)).as("the one that is locked has a size").isPositive();
            assertThat(lock.file()).isSameAs(file);
            assertThat(disk.channels).hasSize(2);
            assertThat(disk.channels.get(0).isOpen()).isFalse();
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void theSystemsLockEndsWithIt() throws IOException {
        new OutputLock(file, "a.png").close();

        assertThat(disk.channels).hasSize(1).noneMatch(channel -> channel.isOpen());
    }

    @Test
    void aLockThatFailsHoldsNothing() throws IOException {
        disk.locking.add(opened -> {
            throw new FileSystemException(opened.toString(), null, "no more files");
        });
        assertThatThrownBy(() -> new OutputLock(file, "a.png")).hasMessage(real + ": no more files");

        new OutputLock(file, "a.png").close();

        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void whoHasOpenedTheFileBeforeItIsDeletedSeesThatItIs() throws IOException {
        OutputLock lock = new OutputLock(file, "a.png");
        try (FileChannel opened = FileChannel.open(real)) {
            lock.close();

            ByteBuffer mark = ByteBuffer.allocate(1);
            opened.read(mark);
            assertThat(mark.get(0)).isEqualTo(OutputLock.DELETED);
        }
    }

    /** As {@link OutputLock#close} does it, though in the other order, as no test can open what is deleted. */
    private static void deleteAsItsHolder(Path opened) throws IOException {
        Files.write(opened, new byte[] {OutputLock.DELETED});
        Files.delete(opened);
    }
}
