package simpleray.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** How long the text may be on which a checkpoint's picture depends. */
class CheckpointTextTest {
    /** Longer texts are taken for damage. */
    private static final int LONGEST = 65_536;
    /** What stands in the text beside a value whose name has one letter: the name, a colon, a space, and the line's end. */
    private static final int BESIDE = 4;

    @TempDir
    Path folder;

    private Map<String, String> comesBack(Map<String, String> identity) throws IOException {
        Path path = folder.resolve("picture.part");
        Checkpoint.create(path, identity, 6, 5).close();
        return Checkpoint.identity(path);
    }

    @Test
    void aTextOfNothingComesBackAsNothing() throws IOException {
        assertThat(comesBack(Map.of())).isNotNull().isEmpty();
    }

    @Test
    void theLongestTextComesBack() throws IOException {
        Map<String, String> longest = Map.of("a", "x".repeat(LONGEST - BESIDE));
        assertThat(comesBack(longest)).isEqualTo(longest);
    }

    @Test
    void aLongerTextIsTakenForDamage() throws IOException {
        assertThat(comesBack(Map.of("a", "x".repeat(LONGEST - BESIDE + 1)))).isNull();
    }
}
