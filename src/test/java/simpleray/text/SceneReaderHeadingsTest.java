package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SceneReaderHeadingsTest {
    private static final Set<String> KEYWORDS = Set.of("background", "window");
    private static final int MAX_WARNINGS = 1000;

    @Test
    void aLineThatBeginsWithALetterIsSkippedWithAWarning() throws IOException {
        SceneReader is = reader("number of objects\n9\n\t light 1 - point light \n0.5\n");

        assertThat(is.readInt()).isEqualTo(9);
        assertThat(is.readDouble()).isEqualTo(0.5);
        assertThat(is.warnings().stream().map(Diagnostic::toString).collect(Collectors.toList())).containsExactly("""
            <stdin>:1:1: warning: expected a value or a comment, found the heading 'number of objects', which is skipped
            number of objects
            ^""", """
            <stdin>:3:3: warning: expected a value or a comment, found the heading 'light 1 - point light', which is skipped
            \t light 1 - point light\s
            \t ^""");
    }

    @Test
    void aHeadingMayStandBetweenTheNumbersOfOneThing() throws IOException {
        SceneReader is = reader("1\nand then 5\n2");

        assertThat(is.readInt()).isEqualTo(1);
        assertThat(is.readInt()).isEqualTo(2);
        assertThat(is.warnings()).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"Nancy's room", "nanometres 1 2 3", "Infinitely far", "e5", "x 1", "Überschrift", "物体", "\uD801\uDC00"})
    void anyLetterBeginsAHeading(String line) throws IOException {
        SceneReader is = reader(line + "\n7");

        assertThat(is.readInt()).isEqualTo(7);
        assertThat(is.warnings()).singleElement().extracting(Diagnostic::headline).isEqualTo(
            "<stdin>:1:1: warning: expected a value or a comment, found the heading '" + line + "', which is skipped");
    }

    @ParameterizedTest
    @ValueSource(strings = {"NaN", "nan", "NAN", "Infinity", "infinity", "INFINITY", "NaN,", "nan0", "Infinity."})
    void aNumberThatIsNoneBeginsNone(String word) {
        SceneReader is = reader("  " + word + " 1 2\n");

        assertThatThrownBy(is::readDouble).isInstanceOf(SceneFormatException.class).hasMessage(
            "<stdin>:1:3: error: expected a number, found " + BadNumber.describe(word) + "\n  " + word + " 1 2\n  ^");
        assertThat(is.warnings()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"_objects", "\"objects\"", "-objects", "*", "(1)"})
    void norDoesAnythingThatIsNoLetter(String word) {
        assertThatThrownBy(reader(word)::readDouble).isInstanceOf(SceneFormatException.class).hasMessage(
            "<stdin>:1:1: error: expected a number, found " + BadNumber.describe(word) + "\n" + word + "\n^");
    }

    @Test
    void aLetterAfterAValueOfItsLineIsNoHeading() throws IOException {
        SceneReader is = reader("9 objects");
        is.readInt();

        assertThatThrownBy(is::readDouble).hasMessage(
            "<stdin>:1:3: error: expected a number, found 'objects'\n9 objects\n  ^");
        assertThat(is.warnings()).isEmpty();
    }

    @Test
    void aKeywordIsTakenWhereItMayStand() throws IOException {
        SceneReader is = reader("1\n  window 0 1 0 1\n");
        is.readInt();

        assertThat(is.takeKeyword(KEYWORDS)).isEqualTo("window");
        assertThat(is.readInt()).isZero();
        assertThat(is.warnings()).isEmpty();
    }

    @Test
    void aKeywordThatIsMisspeltOrStandsElsewhereIsAHeading() throws IOException {
        SceneReader is = reader("window\n1\nWindow\nwindows\n2");
        is.readInt();

        assertThat(is.takeKeyword(KEYWORDS)).isNull();

        assertThat(is.readInt()).isEqualTo(2);
        assertThat(is.warnings()).extracting(Diagnostic::line).containsExactly(1, 3, 4);
    }

    @Test
    void noKeywordIsTakenAtTheEndOfTheFileOrBeforeAValue() throws IOException {
        SceneReader is = reader("1 2");
        is.readInt();
        assertThat(is.takeKeyword(KEYWORDS)).isNull();
        assertThat(is.readInt()).isEqualTo(2);

        assertThat(is.takeKeyword(KEYWORDS)).isNull();

        assertThat(is.eof()).isTrue();
    }

    @Test
    void noMoreThanAThousandWarningsAreKept() throws IOException {
        SceneReader is = reader("Call me Ishmael.\n".repeat(MAX_WARNINGS + 1) + "1");

        assertThat(is.readInt()).isEqualTo(1);
        assertThat(is.warnings()).hasSize(MAX_WARNINGS).last().extracting(Diagnostic::line).isEqualTo(MAX_WARNINGS);
    }

    @Test
    void aLongHeadingIsQuotedInPart() throws IOException {
        SceneReader is = reader("x".repeat(61) + "\n" + "y".repeat(60) + "\n1");
        is.readInt();

        assertThat(is.warnings()).extracting(Diagnostic::message).containsExactly(
            "expected a value or a comment, found the heading '" + "x".repeat(60) + "...', which is skipped",
            "expected a value or a comment, found the heading '" + "y".repeat(60) + "', which is skipped");
    }
}
