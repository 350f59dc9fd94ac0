package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.ByteArrayOutputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneWriterTest {
    @Test
    void eachMethodWritesItsValue() {
        assertThat(written(os -> os.writeDouble(-0.5))).isEqualTo("-0.5");
        assertThat(written(os -> os.writeFloat(0.1f))).isEqualTo("0.1");
        assertThat(written(os -> os.writeInt(Integer.MIN_VALUE))).isEqualTo("-2147483648");
        assertThat(written(os -> os.writeLong(Long.MAX_VALUE))).isEqualTo("9223372036854775807");
        assertThat(written(os -> os.writeChar('('))).isEqualTo("(");
        assertThat(written(os -> os.writeString("two words"))).isEqualTo("two words");
        assertThat(written(SceneWriter::writeNewline)).isEqualTo("\n");
    }

    @Test
    void numbersInARowAreKeptApartByASpace() {
        assertThat(written(os -> {
            os.writeInt(1);
            os.writeLong(2);
            os.writeFloat(3);
            os.writeDouble(4);
        })).isEqualTo("1 2 3.0 4.0");
    }

    @Test
    void anEmptyTextBetweenThemKeepsThemApartToo() {
        assertThat(written(os -> {
            os.writeInt(1);
            os.writeString("");
            os.writeInt(2);
        })).isEqualTo("1 2");
    }

    @Test
    void whereAnythingStandsBetweenThemNoSpaceIsAdded() {
        assertThat(written(os -> {
            os.writeInt(1);
            os.writeChar(',');
            os.writeInt(2);
            os.writeString("  ");
            os.writeInt(3);
            os.writeNewline();
            os.writeInt(4);
            os.writeString("");
            os.writeString("x");
            os.writeInt(5);
        })).isEqualTo("1,2  3\n4x5");
    }

    @Test
    void textIsUtf8() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (SceneWriter os = new SceneWriter(bytes)) {
            os.writeString("Ä");
        }
        assertThat(bytes.toByteArray()).containsExactly(0xC3, 0x84);
    }

    @Test
    void flushHandsOnWhatWasWritten() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (SceneWriter os = new SceneWriter(bytes)) {
            os.writeInt(1);
            os.flush();
            assertThat(bytes).hasToString("1");
        }
    }

    @Test
    void aFileIsEmptiedFirst(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("a.scene"), "much that was here before");
        try (SceneWriter os = new SceneWriter(file.toFile())) {
            os.writeInt(7);
        }
        assertThat(file).hasContent("7");
    }

    @Test
    void aFileInAMissingFolderCannotBeCreated(@TempDir Path folder) {
        assertThatThrownBy(() -> new SceneWriter(folder.resolve("none").resolve("a.scene").toFile()))
            .isInstanceOf(FileNotFoundException.class);
    }

    @Test
    void aReaderReadsWhatWasWritten() throws IOException {
        SceneReader is = reader(written(os -> {
            os.writeDouble(0.1);
            os.writeDouble(-1e-300);
            os.writeFloat(16777216f);
            os.writeLong(Long.MIN_VALUE);
            os.writeInt(-1);
            os.writeChar('x');
        }));

        assertThat(is.readDouble()).isEqualTo(0.1);
        assertThat(is.readDouble()).isEqualTo(-1e-300);
        assertThat(is.readFloat()).isEqualTo(16777216f);
        assertThat(is.readLong()).isEqualTo(Long.MIN_VALUE);
        assertThatThrownBy(is::readInt).hasMessageContaining("found '-1x'");
    }
}
