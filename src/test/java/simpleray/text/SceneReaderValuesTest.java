package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.ByteArrayInputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneReaderValuesTest {
    @Test
    void eachMethodReadsOneValue() throws IOException {
        SceneReader is = reader("-7 9000000000 0.5 0.25 x 3.5");

        assertThat(is.readInt()).isEqualTo(-7);
        assertThat(is.readLong()).isEqualTo(9_000_000_000L);
        assertThat(is.readDouble()).isEqualTo(0.5);
        assertThat(is.readFloat()).isEqualTo(0.25f);
        assertThat(is.readChar()).isEqualTo('x');
        assertThat(is.readDouble("radius")).isEqualTo(3.5);
        assertThat(is.eof()).isTrue();
    }

    @Test
    void integersReachTheEndsOfTheirTypes() throws IOException {
        SceneReader is = reader("2147483647 -2147483648 9223372036854775807 -9223372036854775808 +5 007");

        assertThat(is.readInt()).isEqualTo(Integer.MAX_VALUE);
        assertThat(is.readInt()).isEqualTo(Integer.MIN_VALUE);
        assertThat(is.readLong()).isEqualTo(Long.MAX_VALUE);
        assertThat(is.readLong()).isEqualTo(Long.MIN_VALUE);
        assertThat(is.readInt()).isEqualTo(5);
        assertThat(is.readInt()).isEqualTo(7);
    }

    @Test
    void aFloatIsTheOneNearestToTheDecimalNotToTheDouble() throws IOException {
        // a hair above 1 + 2^-24, which lies half-way between two floats: as a double it is that tie, which goes to the even 1.0
        assertThat(reader("1.00000005960464478").readFloat()).isEqualTo(1 + 0x1p-23f);
        assertThat((float) 1.00000005960464478).isEqualTo(1f);
    }

    @Test
    void aCharacterIsTheNextThatIsNoWhiteSpaceAndNoComment() throws IOException {
        SceneReader is = reader(" \t# (\n (1.5,2)");

        assertThat(is.readChar()).isEqualTo('(');
        assertThat(is.readChar()).isEqualTo('1');
        assertThat(is.readChar()).isEqualTo('.');
        assertThat(is.readChar()).isEqualTo('5');
        assertThat(is.readChar()).isEqualTo(',');
        assertThat(is.readChar()).isEqualTo('2');
        assertThat(is.readChar()).isEqualTo(')');
    }

    @Test
    void aLetterAtTheStartOfALineIsACharacterWhenOneIsWanted() throws IOException {
        SceneReader is = reader("a\nb");

        assertThat(is.readChar()).isEqualTo('a');
        assertThat(is.readChar()).isEqualTo('b');
        assertThat(is.warnings()).isEmpty();
    }

    @Test
    void aMissingCharacterIsAnError() {
        assertThatThrownBy(() -> reader(" ").readChar()).isInstanceOf(SceneFormatException.class)
            .hasMessage("<stdin>:1:2: error: expected a character, found the end of the file\n \n ^");
    }

    @Test
    void commentsEndAnywhereAndRunToTheEndOfTheLine() throws IOException {
        SceneReader is = reader("# 1\n2.0#x 3\n 4.0 # 5.0 # 6.0\n#\n##7\n8.0#");

        assertThat(is.readDouble()).isEqualTo(2.0);
        assertThat(is.readDouble()).isEqualTo(4.0);
        assertThat(is.readDouble()).isEqualTo(8.0);
        assertThat(is.eof()).isTrue();
    }

    @Test
    void lineBreaksCarryNoMeaning() throws IOException {
        SceneReader is = reader("1\n\n2\r3\r\n4\t5\f6\u00A07\u20038");

        for (int i = 1; i <= 8; i++) {
            assertThat(is.readInt()).isEqualTo(i);
        }
        assertThat(is.eof()).isTrue();
    }

    @Test
    void eofLooksPastWhiteSpaceCommentsAndHeadingsButTakesNoValue() throws IOException {
        SceneReader is = reader("\n# only this\nand a heading\n 1");

        assertThat(is.eof()).isFalse();
        assertThat(is.readInt()).isEqualTo(1);
        assertThat(is.eof()).isTrue();
        assertThat(is.eof()).isTrue();
    }

    @Test
    void wordsAndLinesMayStraddleTheBuffer() throws IOException {
        int many = 40_000;                                    // 7 characters each: four buffers of 65536
        SceneReader is = reader("12345\r\n".repeat(many));

        for (int i = 0; i < many; i++) {
            assertThat(is.readInt()).isEqualTo(12345);
        }
        assertThatThrownBy(is::readInt).hasMessage(
            "<stdin>:40001:1: error: expected an integer, found the end of the file\n\n^");
    }

    @Test
    void aFileIsCalledByItsPathAsGiven(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("räume.scene"), "1 x");
        try (SceneReader is = new SceneReader(file.toFile())) {
            assertThat(is.readInt()).isEqualTo(1);
            assertThatThrownBy(is::readInt).hasMessage(file + ":1:3: error: expected an integer, found 'x'\n1 x\n  ^");
        }
    }

    @Test
    void aMissingFileCannotBeOpened(@TempDir Path folder) {
        assertThatThrownBy(() -> new SceneReader(folder.resolve("none").toFile()))
            .isInstanceOf(FileNotFoundException.class);
    }

    @Test
    void closingClosesTheStream() throws IOException {
        boolean[] closed = new boolean[1];
        new SceneReader(new ByteArrayInputStream(new byte[0]) {
            @Override
            public void close() {
                closed[0] = true;
            }
        }, "name", Path.of("")).close();

        assertThat(closed).containsExactly(true);
    }
}
