package simpleray.ui.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whether two looks at a file show that it has changed. */
class FileStampTest {
    @TempDir
    private Path folder;

    @Test
    void twoWritesInOneSecondAreToldApartOnADiskThatCountsSeconds() throws IOException {
        Path scene = Files.writeString(folder.resolve("room.scene"), "4");
        Instant second = Instant.parse("2026-01-02T03:04:05Z");
        Files.setLastModifiedTime(scene, FileTime.from(second));
        FileStamp before = FileStamp.of(scene, second.plusMillis(700));
        Files.writeString(scene, "5");
        Files.setLastModifiedTime(scene, FileTime.from(second));
        FileStamp after = FileStamp.of(scene, second.plusMillis(1900));
        FileStamp later = FileStamp.of(scene, second.plusMillis(2000));

        assertThat(after.isSame(before)).isFalse();
        assertThat(later.isSame(after)).as("the same file when its bytes do not count any more").isTrue();
    }

    @Test
    void aFileThatIsNotThereIsAnotherThanOneThatIs() throws IOException {
        Path scene = folder.resolve("room.scene");
        FileStamp before = FileStamp.of(scene);
        Files.writeString(scene, "");

        assertThat(before).isEqualTo(FileStamp.NONE).isEqualTo(FileStamp.of(folder));
        assertThat(FileStamp.of(scene).isSame(before)).isFalse();
        assertThat(FileStamp.of(scene).isSame(FileStamp.of(scene))).isTrue();
    }
}
