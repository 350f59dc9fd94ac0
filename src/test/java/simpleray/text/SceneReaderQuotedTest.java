package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SceneReaderQuotedTest {
    @Test
    void betweenQuotesBlanksAndHashesBelongToTheName() throws IOException {
        SceneReader is = reader("1 \"a b\t#2/\u00e4.obj\" 3 # \"no\"\n\"c\"#comment\n\"d\"");
        is.readInt();
        assertThat(is.readQuoted("name")).isEqualTo("a b\t#2/\u00e4.obj");
        assertThat(is.readInt()).isEqualTo(3);
        assertThat(is.readQuoted("name")).isEqualTo("c");
        assertThat(is.readQuoted("name")).isEqualTo("d");
        assertThat(is.eof()).isTrue();
        assertThat(is.warnings()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r", "\r\n"})
    void aQuoteEndsOnItsLine(String lineBreak) {
        assertThatThrownBy(() -> reader(" \"a" + lineBreak + "b\"").readQuoted("name")).hasMessage(
            "<stdin>:1:2: error: expected name between double quotes, found '\"a'\n \"a\n ^");
    }

    @Test
    void aMissingNameIsNamed() {
        assertThatThrownBy(() -> reader("# x").readQuoted("name")).hasMessage(
            "<stdin>:1:4: error: expected name, found the end of the file\n# x\n   ^");
    }

    @Test
    void aQuotedWordIsNoNumber() {
        assertThatThrownBy(() -> reader("\"1 2\" 3").readDouble()).hasMessage(
            "<stdin>:1:1: error: expected a number, found '\"1 2\"'\n\"1 2\" 3\n^");
    }

    @Test
    void filesAreFoundBesideTheScene(@TempDir Path folder) throws IOException {
        try (SceneReader is = new SceneReader(Files.writeString(folder.resolve("a.scene"), "").toFile())) {
            assertThat(is.resolve("b/c.obj")).isEqualTo(folder.resolve("b/c.obj"));
            assertThat(is.resolve("/x.obj")).isEqualTo(Path.of("/x.obj"));
        }
        assertThat(reader("").resolve("b/c.obj")).isEqualTo(Path.of("b/c.obj"));
        File here = new File("build.gradle");
        try (SceneReader is = new SceneReader(here)) {
            assertThat(is.resolve("c.obj")).isEqualTo(Path.of("c.obj"));
        }
    }

    @Test
    void problemsOfOtherFilesCountAmongTheOwn() throws IOException {
        Diagnostic bad = new Diagnostic("b.obj", 2, 1, true, "expected more, found less", "x");
        SceneReader is = reader("y");
        is.tolerate(2);
        is.report(new Diagnostic("b.obj", 1, 1, false, "expected less, found more", "x"));
        is.report(bad);

        assertThat(is.warnings()).hasSize(1);
        assertThatThrownBy(() -> is.report(bad)).hasMessage(bad + "\n" + bad + "\n2 errors: reading stopped here");
    }
}
