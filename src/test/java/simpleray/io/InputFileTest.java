package simpleray.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class InputFileTest {
    @TempDir
    private Path folder;

    @Test
    void whatIsInTheWayIsNamed() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "a");

        assertThat(InputFile.refusal(file)).isNull();
        assertThat(InputFile.refusal(folder)).isEqualTo("is a folder");
        assertThat(InputFile.refusal(Path.of(""))).isEqualTo("the name is empty");
        assertThat(InputFile.refusal(folder.resolve("b"))).isEqualTo("no such file");
        assertThat(InputFile.refusal(file.resolve("b"))).isEqualTo("no such file");
        assertThat(InputFile.refusal(Path.of("/dev/null"))).isNull();
    }

    @Test
    void aFolderThatMayNotBeEnteredIsNoMissingFile() {
        TrickyDisk disk = new TrickyDisk();
        disk.asking = path -> {
            throw new AccessDeniedException(path.toString());
        };
        assertThat(InputFile.refusal(disk.path(folder.resolve("a")))).isEqualTo("may not be read");
    }
}
