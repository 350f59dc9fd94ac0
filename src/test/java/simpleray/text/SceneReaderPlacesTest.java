package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SceneReaderPlacesTest {
    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r", "\r\n"})
    void linesEndWithLineFeedOrCarriageReturnOrBoth(String lineBreak) throws IOException {
        SceneReader is = reader("1" + lineBreak + lineBreak + " 2 x" + lineBreak + "3");
        is.readInt();
        is.readInt();

        assertThatThrownBy(is::readInt).hasMessage("<stdin>:3:4: error: expected an integer, found 'x'\n 2 x\n   ^");
    }

    @Test
    void lineFeedThenCarriageReturnAreTwoLineBreaks() {
        assertThatThrownBy(reader("\n\r*")::readInt).hasMessage(
            "<stdin>:3:1: error: expected an integer, found '*'\n*\n^");
    }

    @Test
    void aByteOrderMarkIsNoColumn() {
        assertThatThrownBy(reader("\uFEFF*")::readInt).hasMessage(
            "<stdin>:1:1: error: expected an integer, found '*'\n*\n^");
    }

    @Test
    void aByteOrderMarkThatBeginsALaterLineIsText() {
        assertThatThrownBy(reader("\n\uFEFF1")::readInt).hasMessage(
            "<stdin>:2:1: error: expected an integer, found '\uFFFD1' (with the invisible character U+FEFF)\n\uFFFD1\n^");
    }

    @Test
    void aTabIsOneColumnAndStaysATabInTheCaretLine() throws IOException {
        SceneReader is = reader("\t12\t*");
        is.readInt();

        assertThatThrownBy(is::readInt).hasMessage(
            "<stdin>:1:5: error: expected an integer, found '*'\n\t12\t*\n\t  \t^");
    }

    @Test
    void aCharacterBeyondTheBasicPlaneIsOneColumn() throws IOException {
        SceneReader is = reader("1 \uD83D\uDE00 *");
        is.readInt();
        is.tolerate(2);
        is.readDouble();

        assertThatThrownBy(is::readDouble).hasMessage("""
            <stdin>:1:3: error: expected a number, found '\uD83D\uDE00'
            1 \uD83D\uDE00 *
              ^
            <stdin>:1:5: error: expected a number, found '*'
            1 \uD83D\uDE00 *
                ^
            2 errors: reading stopped here""");
    }

    @Test
    void aCommentRightBehindAWordIsNoPartOfIt() {
        assertThatThrownBy(reader("*#x")::readInt).hasMessage("<stdin>:1:1: error: expected an integer, found '*'\n*#x\n^");
    }

    @Test
    void withoutAFinalLineBreakTheEndIsBehindTheLastCharacter() throws IOException {
        SceneReader is = reader("1\n23 # x");
        is.readInt();
        is.readInt();

        assertThatThrownBy(is::readInt).hasMessage(
            "<stdin>:2:7: error: expected an integer, found the end of the file\n23 # x\n      ^");
    }

    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r", "\r\n"})
    void withAFinalLineBreakTheEndIsTheNextLine(String lineBreak) throws IOException {
        SceneReader is = reader("1" + lineBreak);
        is.readInt();

        assertThatThrownBy(is::readInt).hasMessage(
            "<stdin>:2:1: error: expected an integer, found the end of the file\n\n^");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "\uFEFF"})
    void theEndOfAnEmptyFileIsLineOneColumnOne(String text) {
        assertThatThrownBy(reader(text)::readInt).hasMessage(
            "<stdin>:1:1: error: expected an integer, found the end of the file\n\n^");
    }

    @Test
    void theEndStaysWhereItIsWhenAskedTwice() throws IOException {
        SceneReader is = reader("1 ");
        is.readInt();
        assertThat(is.eof()).isTrue();
        assertThat(is.eof()).isTrue();

        assertThatThrownBy(is::readInt).hasMessage(
            "<stdin>:1:3: error: expected an integer, found the end of the file\n1 \n  ^");
    }

    @Test
    void controlCharactersAreMadePrintable() {
        assertThatThrownBy(reader("*\0\u001B[31m\u0007\u0085")::readInt).hasMessage(
            "<stdin>:1:1: error: expected an integer, found '*\uFFFD\uFFFD[31m\uFFFD\uFFFD' (with NUL bytes; is the file UTF-16, or no text?)\n*\uFFFD\uFFFD[31m\uFFFD\uFFFD\n^");
    }

    @Test
    void aWordOfMoreThanSixtyCharactersIsQuotedInPart() {
        String sixty = "*" + "\uD83D\uDE00".repeat(59);
        assertThatThrownBy(reader(sixty + "9")::readInt).hasMessage(
            "<stdin>:1:1: error: expected an integer, found '" + sixty + "...'\n" + sixty + "9\n^");
    }
}
