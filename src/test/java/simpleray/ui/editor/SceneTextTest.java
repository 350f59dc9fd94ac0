package simpleray.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A scene file's text on its way into an editor and back. */
class SceneTextTest {
    @ParameterizedTest
    @ValueSource(strings = {"", "1", "1\n", "1\r\n2\r\n", "1\r2\r", "1\r\n2\n3\r4", "\n\r\n\r", "\uFEFF1\r\n", "# süß \uD83D\uDE00\n\n"})
    void aTextThatIsNotEditedIsWrittenByteForByte(String file) throws Exception {
        byte[] bytes = file.getBytes(StandardCharsets.UTF_8);
        SceneText read = SceneText.of(bytes);

        assertThat(read.bytes(read.text())).isEqualTo(bytes);
    }

    @Test
    void theEditorHasNeitherMarksNorReturns() {
        assertThat(SceneText.of(utf8("\uFEFF1\r\n2\r3\n4")).text()).isEqualTo("1\n2\n3\n4");
    }

    @Test
    void newLinesEndAsTheFirstDoes() throws Exception {
        assertThat(SceneText.of(utf8("1\r\n2\r\n")).bytes("1\n9\n8\n2\n")).isEqualTo(utf8("1\r\n9\r\n8\r\n2\r\n"));
        assertThat(SceneText.of(utf8("")).bytes("1\n2")).isEqualTo(utf8("1\n2"));
    }

    @Test
    void linesAboveAndBelowAnEditKeepTheirEnds() throws Exception {
        SceneText read = SceneText.of(utf8("a\nb\r\nc\rd\r\ne\n"));

        assertThat(read.bytes("a\nb\nnew\nd\ne\n")).isEqualTo(utf8("a\nb\r\nnew\nd\r\ne\n"));
        assertThat(read.bytes("a\ne\n")).isEqualTo(utf8("a\ne\n"));
        assertThat(read.bytes("a\nb\nc\nmore\nand more\nd\ne\n")).isEqualTo(utf8("a\nb\r\nc\rmore\nand more\nd\r\ne\n"));
    }

    @Test
    void pastedReturnsAreLineEndsToo() throws Exception {
        assertThat(SceneText.of(utf8("1\n")).bytes("1\r\n2\r3")).isEqualTo(utf8("1\n2\n3"));
    }

    @Test
    void aFileThatIsNotUtf8KeepsItsBytes() throws Exception {
        byte[] latin = "# süß\n1".getBytes(StandardCharsets.ISO_8859_1);
        SceneText read = SceneText.of(latin);

        assertThat(read.text()).isEqualTo("# süß\n1");
        assertThat(read.bytes(read.text() + 2)).isEqualTo("# süß\n12".getBytes(StandardCharsets.ISO_8859_1));
        assertThatThrownBy(() -> read.bytes("\u20AC")).isInstanceOf(CharacterCodingException.class);
    }

    private static byte[] utf8(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
