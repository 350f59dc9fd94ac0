package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What other processes do between the opening of the file that is locked and the locking. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class FileClaimRaceTest {
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
        disk.locking.add(Files::delete);
        disk.locking.add(Files::delete);

        try (FileClaim claim = new FileClaim(file, "a.png")) {
            assertThat(claim.file()).exists();
            assertThat(disk.channels).hasSize(3);
            assertThat(disk.channels.subList(0, 2)).noneMatch(channel -> channel.isOpen());
            assertThat(disk.channels.get(2).isOpen()).isTrue();
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aFileThatAThirdHasMadeInItsPlaceIsNotTakenForTheOneThatIsLocked() throws IOException {
        disk.locking.add(opened -> {
            Files.delete(opened);
            Files.createFile(opened);
        });

        try (FileClaim claim = new FileClaim(file, "a.png")) {
            assertThat(Files.size(real)).as("the one that is locked has a size").isPositive();
            assertThat(claim.file()).isSameAs(file);
            assertThat(disk.channels).hasSize(2);
            assertThat(disk.channels.get(0).isOpen()).isFalse();
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void theLockEndsWithTheClaim() throws IOException {
        new FileClaim(file, "a.png").close();

        assertThat(disk.channels).hasSize(1).noneMatch(channel -> channel.isOpen());
    }

    @Test
    void aClaimThatFailsHoldsNothing() throws IOException {
        disk.locking.add(opened -> {
            throw new FileSystemException(opened.toString(), null, "no more files");
        });
        assertThatThrownBy(() -> new FileClaim(file, "a.png")).hasMessage(real + ": no more files");

        new FileClaim(file, "a.png").close();

        assertThat(folder).isEmptyDirectory();
    }
}
