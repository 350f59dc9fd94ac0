package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simpleray.Project;

/** What the fuzzer begins with, and what it found, read once more; a new crash is put into the folder crashes. */
class SceneFileFuzzTest {
    static List<Path> files() throws IOException {
        try (Stream<Path> files = Files.walk(Project.root().resolve("src/test/resources/fuzz"))) {
            return files.filter(file -> Files.isRegularFile(file) && !file.toString().endsWith(".dict")).sorted().toList();
        }
    }

    @ParameterizedTest
    @MethodSource("files")
    void isASceneOrHasErrorsWithTheirPlaces(Path file) {
        assertThatCode(() -> SceneFuzzer.fuzzerTestOneInput(Files.readAllBytes(file))).doesNotThrowAnyException();
    }
}
