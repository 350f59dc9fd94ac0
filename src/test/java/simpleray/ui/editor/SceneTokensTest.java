package simpleray.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.swing.text.Segment;
import org.fife.ui.rsyntaxtextarea.Token;
import org.fife.ui.rsyntaxtextarea.TokenTypes;
import org.junit.jupiter.api.Test;
import simpleray.scene.Setting;

/** What is coloured how in a scene's text. */
class SceneTokensTest {
    private static final Map<Integer, String> NAMES = Map.of(TokenTypes.COMMENT_EOL, "comment", TokenTypes.COMMENT_DOCUMENTATION,
        "heading", TokenTypes.RESERVED_WORD, "keyword", TokenTypes.LITERAL_NUMBER_FLOAT, "number",
        TokenTypes.LITERAL_STRING_DOUBLE_QUOTE, "name", TokenTypes.ERROR_STRING_DOUBLE, "bad name", TokenTypes.ERROR_IDENTIFIER, "bad");

    @Test
    void numbersAreThoseThatTheReaderReads() {
        assertThat(tokens("0 -0.5 .5 2. +3 1e-3")).containsExactly("number 0", "number -0.5", "number .5", "number 2.", "number +3",
            "number 1e-3");
        assertThat(tokens("0 1f 1,5 0x10 1e999 abc")).containsExactly("number 0", "bad 1f", "bad 1,5", "bad 0x10", "bad 1e999", "bad abc");
    }

    @Test
    void aCommentGoesToTheEndOfItsLine() {
        assertThat(tokens("9 # two \"objects\" 7")).containsExactly("number 9", "comment # two \"objects\" 7");
        assertThat(tokens("9#two")).containsExactly("number 9", "comment #two");
    }

    @Test
    void keywordsAreMarkedWhereverTheyStand() {
        assertThat(tokens("  background 0 0 1")).containsExactly("keyword background", "number 0", "number 0", "number 1");
        assertThat(tokens("20 transmit 1 1 1 1.5")).startsWith("number 20", "keyword transmit");
        assertThat(tokens("mirror 0 0 0")).startsWith("keyword mirror");
        assertThat(tokens("mtl")).startsWith("keyword mtl");
        assertThat(Setting.keywords()).isNotEmpty()
            .allSatisfy(keyword -> assertThat(tokens(keyword + " 1")).startsWith("keyword " + keyword));
    }

    @Test
    void theWordsBehindKeywordsAreMarkedThereAlone() {
        assertThat(tokens("key 1 object 2 0 0 1")).startsWith("keyword key", "number 1", "keyword object", "number 2");
        assertThat(tokens("key 1 light 2")).contains("keyword light");
        assertThat(tokens("key 1 colour 2")).contains("keyword colour");
        assertThat(tokens("key 1 camera 2")).contains("keyword camera");
        assertThat(tokens("curve linear")).containsExactly("keyword curve", "keyword linear");
        assertThat(tokens("curve smooth")).containsExactly("keyword curve", "keyword smooth");
        assertThat(tokens("background none")).containsExactly("keyword background", "keyword none");
        assertThat(tokens("curve curly")).containsExactly("keyword curve", "bad curly");
        assertThat(tokens("object 1 is red")).containsExactly("heading object 1 is red");
    }

    @Test
    void aLineThatBeginsWithALetterIsAHeading() {
        assertThat(tokens("LEFT WALL 1 # and all")).containsExactly("heading LEFT WALL 1 # and all");
        assertThat(tokens("transmitt 1 1 1")).containsExactly("heading transmitt 1 1 1");
        assertThat(tokens("NaN 1")).containsExactly("bad NaN", "number 1");
        assertThat(tokens("infinity 1")).containsExactly("bad infinity", "number 1");
    }

    @Test
    void aNameStandsBetweenQuotes() {
        assertThat(tokens("4 \"a #1.obj\" 0")).containsExactly("number 4", "name \"a #1.obj\"", "number 0");
        assertThat(tokens("4 \"a.obj 0")).containsExactly("number 4", "bad name \"a.obj", "number 0");
        assertThat(tokens("\"a\"b")).containsExactly("bad name \"a\"b");
    }

    @Test
    void anEmptyLineHasNothing() {
        assertThat(tokens("")).isEmpty();
        assertThat(tokens(" \t\u00A0")).isEmpty();
    }

    /** {@return the tokens of a line but for white space; that they are the whole line is asserted} */
    private static List<String> tokens(String line) {
        char[] all = ("before" + line).toCharArray();
        List<String> found = new ArrayList<>();
        StringBuilder whole = new StringBuilder();
        int offset = 100;
        for (Token t = new SceneTokens().getTokenList(new Segment(all, 6, line.length()), TokenTypes.NULL, 100); t != null
                && t.isPaintable(); t = t.getNextToken()) {
            assertThat(t.getOffset()).isEqualTo(offset);
            offset = t.getEndOffset();
            whole.append(t.getLexeme());
            if (!t.isWhitespace()) {
                found.add(NAMES.get(t.getType()) + ' ' + t.getLexeme());
            }
        }
        assertThat(whole).hasToString(line);
        return found;
    }
}
