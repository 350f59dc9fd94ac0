package simpleray.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.common.jimfs.Configuration;
import com.google.common.jimfs.Jimfs;
import com.google.common.jimfs.PathNormalization;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A file in the making on a disk of 64 KiB, in memory. */
class AtomicFileTest {
    private static final int SIZE = 1 << 16;

    private FileSystem disk;
    private Path target;

    @BeforeEach
    void makeDisk() {
        disk = Jimfs.newFileSystem(Configuration.unix().toBuilder().setWorkingDirectory("/pictures")
            .setMaxSize(SIZE).setBlockSize(1024).build());
        target = disk.getPath("/pictures/picture.png");
    }

    @AfterEach
    void endDisk() throws IOException {
        disk.close();
    }

    @Test
    void anotherProgramMayWriteTheFileBesideTheTarget() throws IOException {
        try (AtomicFile file = new AtomicFile(target)) {
            assertThat(file.file()).isNotEqualTo(target).hasParent(target.getParent());
            Files.writeString(file.file(), "a film");
            assertThat(file.isWhole()).isFalse();
            file.commit();
            assertThat(file.isWhole()).isTrue();
        }
        assertThat(Files.readString(target)).isEqualTo("a film");
    }

    @Test
    void aDiskThatBecomesFullLeavesTheOldFileAndNothingElse() throws IOException {
        Files.writeString(target, "the old picture");
        try (AtomicFile file = new AtomicFile(target)) {
            assertThatThrownBy(() -> {
                file.out().write(new byte[SIZE]);
                file.commit();
            }).isInstanceOf(IOException.class).hasMessage("out of disk space");
        }
        assertThat(Files.readString(target)).isEqualTo("the old picture");
        assertThat(names()).containsExactly("picture.png");
    }

    @Test
    void aDiskThatIsFullOnlyWhenTheLastBytesAreWrittenLeavesNothingToo() throws IOException {
        try (AtomicFile file = new AtomicFile(target)) {
            file.out().write(new byte[SIZE / 2]);
            fill(disk.getPath("/pictures/other"));
            file.out().write(new byte[100]);                  // still in the buffer
            assertThatThrownBy(file::commit).isInstanceOf(IOException.class).hasMessage("out of disk space");
        }
        assertThat(names()).containsExactly("other");
    }

    @Test
    void aDiskThatIsFullFromTheBeginningIsKnownAtOnce() throws IOException {
        Files.write(disk.getPath("/pictures/other"), new byte[SIZE]);

        assertThatThrownBy(() -> new AtomicFile(target)).isInstanceOf(IOException.class).hasMessage("out of disk space");
        assertThat(names()).containsExactly("other");
    }

    @Test
    void whatAKilledProcessLeftIsUsedAndGone() throws IOException {
        List<String> left;
        try (AtomicFile file = new AtomicFile(target)) {
            file.out().write(1);
            left = names();
        }
        for (String name : left) {
            Files.writeString(target.resolveSibling(name), "half a picture");
        }

        try (AtomicFile file = new AtomicFile(target)) {
            file.out().write("whole".getBytes(StandardCharsets.US_ASCII));
            file.commit();
        }
        assertThat(left).hasSize(2).allMatch(name -> name.matches("\\.simpleray-picture\\.png\\.(part|lock)"));
        assertThat(Files.readString(target)).isEqualTo("whole");
        assertThat(names()).containsExactly("picture.png");
    }

    @Test
    void oneTargetHasOneInTheMakingHoweverItIsNamed() throws IOException {
        Path other = disk.getPath("/pictures/../pictures/./picture.png");
        try (AtomicFile file = new AtomicFile(target)) {
            assertThatThrownBy(() -> new AtomicFile(other)).isInstanceOf(FileInUseException.class);
            new AtomicFile(disk.getPath("/pictures/another.png")).close();
            file.commit();
            assertThatThrownBy(() -> new AtomicFile(other)).as("until it is closed").isInstanceOf(FileInUseException.class);
        }
        new AtomicFile(other).close();
    }

    @Test
    void closingTwiceHarmsNobody() throws IOException {
        AtomicFile first = new AtomicFile(target);
        first.close();
        try (AtomicFile second = new AtomicFile(target)) {
            first.close();
            second.out().write(1);
            second.commit();
        }
        assertThat(Files.readAllBytes(target)).containsExactly(1);
        assertThat(names()).containsExactly("picture.png");
    }

    @Test
    void whatIsBegunWhenTheProgramEndsIsRemoved() throws IOException {
        try (AtomicFile file = new AtomicFile(target)) {
            file.out().write(1);
            AtomicFile.removeBegun();
            assertThat(names()).isEmpty();
        }
        assertThat(names()).isEmpty();
    }

    /** The program is told to stop while a slow disk still closes the file; then the next run has begun its own of that name. */
    @Test
    void whatTheEndOfTheProgramHasRemovedIsNotMoved() throws IOException {
        Files.writeString(target, "the old picture");
        try (AtomicFile first = new AtomicFile(target)) {
            first.out().write("the first".getBytes(StandardCharsets.US_ASCII));
            AtomicFile.removeBegun();
            try (AtomicFile second = new AtomicFile(target)) {
                assertThatThrownBy(first::commit).isInstanceOf(IOException.class).hasMessage("the program is told to stop");
                assertThat(Files.readString(target)).isEqualTo("the old picture");
                second.out().write("the second".getBytes(StandardCharsets.US_ASCII));
                second.commit();
            }
        }
        assertThat(Files.readString(target)).isEqualTo("the second");
        assertThat(names()).containsExactly("picture.png");
    }

    @Test
    void namesThatDifferInCaseAreOneWhereTheDiskIgnoresIt() throws IOException {
        try (FileSystem other = Jimfs.newFileSystem(Configuration.unix().toBuilder().setWorkingDirectory("/pictures")
                .setNameCanonicalNormalization(PathNormalization.CASE_FOLD_ASCII).build());
             AtomicFile first = new AtomicFile(other.getPath("picture.png"))) {
            assertThatThrownBy(() -> new AtomicFile(other.getPath("Picture.PNG"))).isInstanceOf(FileInUseException.class);
            first.out().write(1);
            first.commit();
        }
        try (AtomicFile first = new AtomicFile(target); AtomicFile another = new AtomicFile(disk.getPath("Picture.PNG"))) {
            first.commit();
            another.commit();
        }
        assertThat(names()).containsExactly("Picture.PNG", "picture.png");
    }

    @Test
    void twoNamesThatAreTooLongForAnAdditionHaveEachTheirOwn() throws IOException {
        try (AtomicFile first = new AtomicFile(target.resolveSibling("a".repeat(250)));
             AtomicFile second = new AtomicFile(target.resolveSibling("a".repeat(251)))) {
            assertThat(names()).hasSize(4);
            first.commit();
            second.commit();
        }
        assertThat(names()).hasSize(2);
    }

    @Test
    void aNameMayBeAsLongAsNamesMayBe() throws IOException {
        Path longest = target.resolveSibling("a".repeat(251) + ".png");
        try (AtomicFile file = new AtomicFile(longest)) {
            assertThat(names()).allMatch(name -> name.length() < 40);
            file.commit();
        }
        assertThat(longest).exists();
    }

    private static void fill(Path file) throws IOException {
        try (OutputStream out = Files.newOutputStream(file)) {
            assertThatThrownBy(() -> {
                while (true) {
                    out.write(new byte[1024]);
                }
            }).hasMessage("out of disk space");
        }
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(target.getParent())) {
            return files.map(file -> file.getFileName().toString()).sorted().collect(Collectors.toList());
        }
    }
}
