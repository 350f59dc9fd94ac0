package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Targets that are special. */
class PictureFileTargetTest {
    @TempDir
    private Path folder;
    private Path target;

    @BeforeEach
    void nameTheTarget() {
        target = folder.resolve("picture.png");
    }

    @Test
    void aMissingFolderIsAnError() {
        Path lost = folder.resolve("none").resolve("picture.png");
        assertThatThrownBy(() -> new PictureFile(lost)).isInstanceOf(FileSystemException.class)
            .hasMessage(lost + ": there is no folder " + folder.resolve("none"));
        assertThat(folder.resolve("none")).doesNotExist();
    }

    @Test
    void aFolderIsNoTarget() throws IOException {
        Files.createDirectory(target);
        assertThatThrownBy(() -> new PictureFile(target)).isInstanceOf(FileSystemException.class)
            .hasMessage(target + ": is a folder");
        assertThat(target).isEmptyDirectory();
    }

    @Test
    void aSymbolicLinkStaysAndItsFileIsReplaced() throws IOException {
        Path real = Files.createFile(Files.createDirectory(folder.resolve("elsewhere")).resolve("real.png"));
        Files.createSymbolicLink(target, real);

        PictureFileTest.write(target, 0.5);

        assertThat(target).isSymbolicLink();
        assertThat(Files.readAllBytes(real)).isEqualTo(PictureFileTest.png(0.5));
        assertThat(PictureFileTest.names(folder)).containsExactly("elsewhere", "picture.png");
    }

    @Test
    void aSymbolicLinkToNoFileYetIsFollowed() throws IOException {
        Path real = folder.resolve("real.png");
        Files.createSymbolicLink(target, real.getFileName());

        PictureFileTest.write(target, 0.5);

        assertThat(target).isSymbolicLink();
        assertThat(Files.readAllBytes(real)).isEqualTo(PictureFileTest.png(0.5));
    }

    @Test
    void permissionsAreThoseOfTheFileReplaced() throws IOException {
        assumeTrue(Files.getFileStore(folder).supportsFileAttributeView("posix"), "no POSIX permissions here");
        Files.createFile(target);
        Files.setPosixFilePermissions(target, PosixFilePermissions.fromString("rw-r-----"));

        PictureFileTest.write(target, 0.5);

        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(target))).isEqualTo("rw-r-----");
    }

    @Test
    void permissionsAreThoseOfAnyNewFile() throws IOException {
        assumeTrue(Files.getFileStore(folder).supportsFileAttributeView("posix"), "no POSIX permissions here");
        Path usual = Files.createFile(folder.resolve("usual"));

        PictureFileTest.write(target, 0.5);

        assertThat(Files.getPosixFilePermissions(target)).isEqualTo(Files.getPosixFilePermissions(usual));
    }

    @Test
    void aWriteProtectedFileIsRefused() throws IOException {
        Files.createFile(target);
        assumeTrue(target.toFile().setReadOnly(), "nothing can be write-protected here");
        assumeFalse(Files.isWritable(target), "nothing is write-protected for root");

        assertThatThrownBy(() -> new PictureFile(target)).isInstanceOf(FileSystemException.class)
            .hasMessage(target + ": is write-protected");
        assertThat(PictureFileTest.names(folder)).containsExactly("picture.png");
    }

    /** A pipe stands for all that is there and is no file, such as /dev/stdout. */
    @Test
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void aPipeIsWrittenToAsItIs() throws Exception {
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/mkfifo")), "no mkfifo here");
        assertThat(new ProcessBuilder("/usr/bin/mkfifo", target.toString()).start().waitFor()).isZero();
        CompletableFuture<byte[]> received = CompletableFuture.supplyAsync(() -> contentOf(target));

        PictureFileTest.write(target, 0.5);

        assertThat(received.get()).isEqualTo(PictureFileTest.png(0.5));
        assertThat(Files.isRegularFile(target, LinkOption.NOFOLLOW_LINKS)).isFalse();
        assertThat(PictureFileTest.names(folder)).containsExactly("picture.png");
    }

    private static byte[] contentOf(Path path) {
        try {
            return Files.readAllBytes(path);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
