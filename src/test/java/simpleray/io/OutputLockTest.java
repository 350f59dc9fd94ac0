package simpleray.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OutputLockTest {
    @TempDir
    Path folder;
    private Path file;

    @BeforeEach
    void nameTheFile() {
        file = folder.resolve("a.lock");
    }

    @Test
    void oneHasItAndAnotherGetsItOnlyAfterwards() throws IOException {
        OutputLock one = new OutputLock(file, "a.png");
        assertThatThrownBy(() -> new OutputLock(file, "a.png")).isInstanceOf(FileInUseException.class);
        one.close();

        new OutputLock(file, "a.png").close();

        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void closingTwiceHarmsNobody() throws IOException {
        OutputLock one = new OutputLock(file, "a.png");
        one.close();
        try (OutputLock other = new OutputLock(file, "a.png")) {
            one.close();
            assertThat(other.file()).exists();
        }
    }

    @Test
    void theFileNeedNotBeThereAndIsNamed() throws IOException {
        Path target = folder.resolve("a.png");
        try (OutputLock lock = OutputLock.of(target)) {
            assertThat(lock.file()).exists();
            assertThatThrownBy(() -> OutputLock.of(target)).isInstanceOf(FileInUseException.class).hasMessageStartingWith(target + ": ");
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aNameThatNoFileCanHaveIsNotLocked() {
        assertThatThrownBy(() -> OutputLock.of(folder.resolve("a".repeat(300)))).isInstanceOf(FileSystemException.class);
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void whatAKilledProcessLeftIsNoLock() throws IOException {
        Files.writeString(file, "left");

        try (OutputLock lock = new OutputLock(file, "a.png")) {
            assertThat(lock.file()).isEqualTo(file);
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aLinkIsNotFollowed() throws IOException {
        Path other = Files.writeString(folder.resolve("other"), "not to be touched");
        Files.createSymbolicLink(file, other);

        assertThatThrownBy(() -> new OutputLock(file, "a.png")).isInstanceOf(IOException.class);
        assertThat(other).hasContent("not to be touched");
    }

    @Test
    void thatItCannotBeMadeIsAnErrorOnlyAsLongAsThatIsSo() throws IOException {
        Path lost = folder.resolve("none").resolve("a.lock");
        assertThatThrownBy(() -> new OutputLock(lost, "a.png")).isInstanceOf(IOException.class);
        Files.createDirectory(lost.getParent());

        new OutputLock(lost, "a.png").close();
    }

    @Test
    void ofManyThreadsOneHasItAtATime() throws Exception {
        AtomicInteger holders = new AtomicInteger();
        Callable<Integer> task = () -> {
            int got = 0;
            for (int i = 0; i < 200; i++) {
                try (OutputLock lock = new OutputLock(file, "a.png")) {
                    assertThat(lock.file()).exists();
                    assertThat(holders.incrementAndGet()).isEqualTo(1);
                    holders.decrementAndGet();
                    got++;
                } catch (FileInUseException e) {
                    Thread.onSpinWait();
                }
            }
            return got;
        };
        ExecutorService threads = Executors.newFixedThreadPool(4);
        try {
            List<Future<Integer>> all = threads.invokeAll(IntStream.range(0, 4).mapToObj(i -> task).toList());
            int sum = 0;
            for (Future<Integer> one : all) {
                sum += one.get();
            }
            assertThat(sum).isPositive();
        } finally {
            threads.shutdown();
        }
        assertThat(folder).isEmptyDirectory();
    }
}
