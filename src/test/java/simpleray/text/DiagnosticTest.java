package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class DiagnosticTest {
    private static final String SMILE = "\uD83D\uDE00";

    @Test
    void theHeadlineIsFileLineColumnKindAndMessage() {
        assertThat(new Diagnostic("room.scene", 7, 31, true, "expected a, found b", "").headline())
            .isEqualTo("room.scene:7:31: error: expected a, found b");
        assertThat(new Diagnostic("room.scene", 7, 31, false, "expected a, found b", "").headline())
            .isEqualTo("room.scene:7:31: warning: expected a, found b");
    }

    @Test
    void underItStandTheSourceLineAndACaret() {
        assertThat(new Diagnostic("f", 1, 3, true, "m", "0 abc 1")).hasToString("f:1:3: error: m\n0 abc 1\n  ^");
    }

    @Test
    void noneDoesIfNothingButBytesThatAreNoTextStandsThere() {
        assertThat(new Diagnostic("f", 1, 3, true, "m", "0 " + "\uFFFD".repeat(8))).hasToString("f:1:3: error: m");
        assertThat(new Diagnostic("f", 1, 3, true, "m", "0 " + "\0".repeat(9))).hasToString("f:1:3: error: m");
        assertThat(new Diagnostic("f", 1, 3, true, "m", "0 a" + "\uFFFD".repeat(8) + "b")).hasToString("f:1:3: error: m\n0 a...\n  ^");
        assertThat(new Diagnostic("f", 1, 3, true, "m", "0 " + "\uFFFD".repeat(7))).hasToString("f:1:3: error: m\n0 " + "\uFFFD".repeat(7) + "\n  ^");
    }

    @Test
    void aLineOf160CharactersIsShownWhole() {
        String source = "x".repeat(160);
        assertThat(new Diagnostic("f", 1, 160, true, "m", source)).hasToString(
            "f:1:160: error: m\n" + source + '\n' + " ".repeat(159) + '^');
    }

    @Test
    void ofALongerLineTheCharactersAboutThePlaceAreShown() {
        // 300 characters, the word at index 150: from 150 - 80 = 70 to 70 + 160 = 230
        String source = "a".repeat(150) + "b".repeat(150);
        assertThat(new Diagnostic("f", 1, 151, true, "m", source)).hasToString(
            "f:1:151: error: m\n..." + "a".repeat(80) + "b".repeat(80) + "...\n" + " ".repeat(83) + '^');
    }

    @Test
    void atItsStartNothingIsCutOnTheLeft() {
        assertThat(new Diagnostic("f", 1, 1, true, "m", "b".repeat(161))).hasToString(
            "f:1:1: error: m\n" + "b".repeat(160) + "...\n^");
    }

    @Test
    void atItsEndNothingIsCutOnTheRight() {
        // the place after the last of 200 characters: from 200 - 80 = 120
        assertThat(new Diagnostic("f", 1, 201, true, "m", "b".repeat(200))).hasToString(
            "f:1:201: error: m\n..." + "b".repeat(80) + '\n' + " ".repeat(83) + '^');
    }

    @Test
    void aCutNeverHalvesACharacter() {
        // 151 characters in 301 chars: x, then 150 pairs at the odd indices. Column 77 is index 1 + 2·75 = 151; the cut would be at
        // 71 and at 231, both odd: between pairs. Column 1 cuts at 160, within a pair, which goes.
        String source = "x" + SMILE.repeat(150);
        assertThat(new Diagnostic("f", 1, 1, true, "m", source)).hasToString(
            "f:1:1: error: m\nx" + SMILE.repeat(79) + "...\n^");
        // y x and the pairs at even indices; column 78 is index 152, less 80 is 72: between pairs; a tab less on the left is not
        String even = "xy" + SMILE.repeat(150) + "z*";
        // '*' is index 303: the cut at 223, within the pair 222, which comes whole
        assertThat(new Diagnostic("f", 1, 154, true, "m", even)).hasToString(
            "f:1:154: error: m\n..." + SMILE.repeat(40) + "z*\n" + " ".repeat(3 + 41) + '^');
    }

    @Test
    void aVeryLongLineIsShownInPart() {
        String source = "1 ".repeat(1_000_000) + "*";
        assertThat(new Diagnostic("f", 1, 2_000_001, true, "m", source)).hasToString(
            "f:1:2000001: error: m\n..." + "1 ".repeat(40) + "*\n" + " ".repeat(83) + '^');
    }

    @Test
    void tabsStayTabsUnderThem() {
        assertThat(new Diagnostic("f", 1, 4, true, "m", "\ta\tb")).hasToString("f:1:4: error: m\n\ta\tb\n\t \t^");
    }

    @Test
    void controlCharactersAreReplacedButTabsAreNot() {
        assertThat(Diagnostic.printable("a\0\t\u001B\u007F\u009Bb" + SMILE)).isEqualTo("a\uFFFD\t\uFFFD\uFFFD\uFFFDb" + SMILE);
    }

    @Test
    void theExceptionKeepsTheProblemsAndTheirWholeReport() {
        Diagnostic first = new Diagnostic("f", 1, 1, true, "m", "a");
        Diagnostic second = new Diagnostic("f", 2, 1, true, "n", "b");
        List<Diagnostic> both = new ArrayList<>(List.of(first, second));

        SceneFormatException e = new SceneFormatException(both, false);
        both.clear();

        assertThat(e).hasMessage("f:1:1: error: m\na\n^\nf:2:1: error: n\nb\n^");
        assertThat(e.problems()).containsExactly(first, second);
        assertThatThrownBy(() -> e.problems().clear()).isInstanceOf(UnsupportedOperationException.class);
    }

    @Test
    void theExceptionSaysWhetherReadingStopped() {
        Diagnostic problem = new Diagnostic("f", 1, 1, true, "m", "a");
        assertThat(new SceneFormatException(List.of(problem, problem), true)).hasMessage(
            "f:1:1: error: m\na\n^\nf:1:1: error: m\na\n^\n2 errors: reading stopped here");
    }
}
