package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Where a word begins and ends, and what is known of the last one. */
class SceneReaderWordsTest {
    @ParameterizedTest
    @ValueSource(strings = {"\u000B", "\f", "\u001C", "\u001F", "\u00A0", "\u1680", "\u2000", "\u200A", "\u2028", "\u2029", "\u202F",
        "\u205F", "\u3000"})
    void anyWhiteSpaceIsBetweenWordsAndAtBothEnds(String blank) throws IOException {
        SceneReader is = reader(blank + "1" + blank + "2" + blank + blank + "+3" + blank);

        assertThat(is.readInt()).isEqualTo(1);
        assertThat(is.readDouble()).isEqualTo(2);
        assertThat(is.readInt()).isEqualTo(3);
        assertThat(is.eof()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"\u0000", "\u0085", "\u00A1", "\u167F", "\u200B", "\u3001", "\u4E00"})
    void whatIsNoWhiteSpaceIsPartOfItsWord(String character) {
        String word = "1" + character + "2";

        assertThatThrownBy(reader(word)::readInt).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith("<stdin>:1:1: error: expected an integer, found " + BadNumber.describe(word) + "\n");
    }

    @Test
    void whiteSpaceOfAllKindsIsNoPartOfAHeading() throws IOException {
        SceneReader is = reader("\u3000Ishmael \u2003\u3000\n1");

        assertThat(is.readInt()).isEqualTo(1);
        assertThat(is.warnings()).singleElement().extracting(Diagnostic::headline).isEqualTo(
            "<stdin>:1:2: warning: expected a value or a comment, found the heading 'Ishmael', which is skipped");
    }

    @Test
    void theLineOfAValueIsKnownAndWhetherItIsTheFirstThere() throws IOException {
        SceneReader is = reader("1 2.0\n\n+3 4\nabc\n5.0\nwindow 6\n7 8");

        is.readInt();
        assertAt(is, 1, true);
        is.readDouble();
        assertAt(is, 1, false);
        is.readInt();
        assertAt(is, 3, true);
        is.readInt();
        assertAt(is, 3, false);
        is.readChar();
        assertAt(is, 4, true);
        is.readChar();
        assertAt(is, 4, false);
        is.readChar();
        is.readDouble();
        assertAt(is, 5, true);
        is.takeKeyword(Set.of("window"));
        assertAt(is, 6, true);
        is.readInt();
        assertAt(is, 6, false);
        is.readInt();
        assertAt(is, 7, true);
        is.readFloat();
        assertAt(is, 7, false);
    }

    private static void assertAt(SceneReader is, int line, boolean first) {
        assertThat(is.line()).isEqualTo(line);
        assertThat(is.isFirstOnLine()).as("in line " + line).isEqualTo(first);
    }

    @Test
    void aCharacterIsRejectedWhereItStands() throws IOException {
        SceneReader is = reader("ab cd");
        is.readChar();
        assertThat(is.stop("x")).hasMessage("<stdin>:1:1: error: expected x, found 'ab'\nab cd\n^");

        SceneReader other = reader("ab cd");
        other.readChar();
        other.readChar();
        other.readChar();
        assertThat(other.stop("x")).hasMessage("<stdin>:1:4: error: expected x, found 'cd'\nab cd\n   ^");
    }

    @Test
    void theBytesOfTheLastValueCanBeFound() throws IOException {
        byte[] bytes = "\uFEFF1 \u00E4\n-2.5e0 # 3\n+4".getBytes(StandardCharsets.UTF_8);
        SceneReader is = SourceSpan.reader(bytes, Path.of("a.scene"));

        is.readInt();
        assertThat(SourceSpan.last(is)).isEqualTo(new SourceSpan(3, 4));
        is.readChar();
        assertThat(SourceSpan.last(is)).isEqualTo(new SourceSpan(5, 7));
        is.readDouble();
        assertThat(SourceSpan.last(is)).isEqualTo(new SourceSpan(8, 14));
        is.readInt();
        assertThat(SourceSpan.last(is)).isEqualTo(new SourceSpan(19, 21));
        assertThatThrownBy(is::readInt).hasMessage("a.scene:3:3: error: expected an integer, found the end of the file\n+4\n  ^");
    }

    @Test
    void aPieceOfAFileIsTakenApartIntoItsWords() throws IOException {
        byte[] bytes = "0 0 1 22 # 3\n\"a b\" 4 5".getBytes(StandardCharsets.UTF_8);

        assertThat(new SourceSpan(4, 21).words(bytes)).containsExactly(new SourceSpan(4, 5), new SourceSpan(6, 8),
            new SourceSpan(13, 18), new SourceSpan(19, 20));
        assertThat(new SourceSpan(8, 13).words(bytes)).isEmpty();
    }

    @Test
    void whatReadersShareIsMadeOnce() {
        SceneReader is = reader("");

        StringBuilder first = is.kept(StringBuilder.class, type -> new StringBuilder());

        assertThat(first).isNotNull().isSameAs(is.kept(StringBuilder.class, type -> new StringBuilder("another")));
    }

    @Test
    void ownersMayBeManyDeep() {
        SceneReader is = reader("*");
        for (int i = 1; i <= 20; i++) {
            is.enter("part", i);
        }
        is.leave();

        assertThatThrownBy(() -> is.readDouble("x")).hasMessageStartingWith("<stdin>:1:1: error: expected part 1's part 2's ")
            .hasMessageContaining(" part 18's part 19's x, found '*'");
    }

    @Test
    void aNumberTooSmallIsReadAsZeroWithAWarning() throws IOException {
        SceneReader is = reader("1e-400 0e-400 -0.001e-999 +0 +0.0e+5 9e-999");

        assertThat(is.readDouble("radius")).isZero();
        assertThat(is.readDouble("radius")).isZero();
        assertThat(is.readDouble("radius")).isZero();
        assertThat(is.readDouble("radius")).isZero();
        assertThat(is.readDouble("radius")).isZero();
        assertThat(is.readDouble("radius")).isZero();
        assertThat(is.warnings()).extracting(Diagnostic::headline).containsExactly(
            "<stdin>:1:1: warning: radius '1e-400' is too small for a number, and read as 0",
            "<stdin>:1:15: warning: radius '-0.001e-999' is too small for a number, and read as 0",
            "<stdin>:1:38: warning: radius '9e-999' is too small for a number, and read as 0");
    }

    @Test
    void howManyHeadingsWereSkippedIsToldWhereAValueIsMissing() {
        assertThatThrownBy(reader("a\n")::readInt).hasMessageStartingWith(
            "<stdin>:2:1: error: expected an integer, found the end of the file (1 line was skipped as a heading)\n");
        assertThatThrownBy(reader("a\nb\n")::readInt).hasMessageStartingWith(
            "<stdin>:3:1: error: expected an integer, found the end of the file (2 lines were skipped as headings)\n");
    }
}
