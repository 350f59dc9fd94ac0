package simpleray.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** The letters of labels. */
class PixelFontTest {
    private static final char FIRST = ' ';
    private static final char LAST = '~';

    @Test
    void everyPrintableCharacterLooksLikeNoOther() {
        Map<String, Character> drawings = new HashMap<>();
        for (char c = FIRST; c <= LAST; c++) {
            Character other = drawings.put(drawing(String.valueOf(c)), c);
            assertThat(other).as("looks like " + c).isNull();
        }
        assertThat(drawings).hasSize(95);
    }

    @Test
    void onlyTheSpaceIsEmpty() {
        for (char c = FIRST; c <= LAST; c++) {
            assertThat(drawing(String.valueOf(c)).contains("#")).as("something of '" + c + "' is seen").isEqualTo(c != ' ');
        }
    }

    @Test
    void aCharacterStaysWithinItsBox() {
        for (char c = FIRST; c <= LAST; c++) {
            for (int y = 0; y < PixelFont.HEIGHT; y++) {
                for (int x = PixelFont.WIDTH; x < 3 * PixelFont.WIDTH; x++) {
                    assertThat(PixelFont.isDark(String.valueOf(c), x, y)).as("dot %d of row %d of '%s'", x, y, c).isFalse();
                }
            }
        }
    }

    @Test
    void aLetterIsDrawnAsInTheSource() {
        assertThat(drawing("g")).isEqualTo("""
            .....
            .....
            .####
            #...#
            #...#
            #...#
            .####
            ....#
            .###.
            """);
    }

    @Test
    void lettersStandNextToEachOther() {
        assertThat(drawing("L1~")).isEqualTo("""
            #.......#........
            #......##........
            #.......#....#...
            #.......#...#.#.#
            #.......#......#.
            #.......#........
            #####..###.......
            .................
            .................
            """);
    }

    @Test
    void whatIsNotPrintableAsciiLooksLikeAQuestionMark() {
        for (String odd : new String[] {"\n", "\u001F", "\u007F", "ä", "\uFFFF"}) {
            assertThat(drawing(odd)).isEqualTo(drawing("?"));
        }
    }

    @Test
    void theWidthLeavesOutTheSpaceAfterTheLastLetter() {
        assertThat(PixelFont.width(0)).isZero();
        assertThat(PixelFont.width(1)).isEqualTo(5);
        assertThat(PixelFont.width(2)).isEqualTo(11);
    }

    private static String drawing(String text) {
        StringBuilder drawing = new StringBuilder();
        for (int y = 0; y < PixelFont.HEIGHT; y++) {
            for (int x = 0; x < PixelFont.width(text.length()); x++) {
                drawing.append(PixelFont.isDark(text, x, y) ? '#' : '.');
            }
            drawing.append('\n');
        }
        return drawing.toString();
    }
}
