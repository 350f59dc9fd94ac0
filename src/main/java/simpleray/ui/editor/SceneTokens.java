package simpleray.ui.editor;

import java.util.Arrays;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.text.Segment;
import org.fife.ui.rsyntaxtextarea.Token;
import org.fife.ui.rsyntaxtextarea.TokenMakerBase;
import org.fife.ui.rsyntaxtextarea.TokenTypes;
import simpleray.scene.Curve;
import simpleray.scene.Key;
import simpleray.scene.Setting;
import simpleray.text.NumberParser;

/** Finds what is to be coloured in a line of a scene file: comments, headings, keywords, numbers, names, and words that are none. */
final class SceneTokens extends TokenMakerBase {
    /** The keywords of materials, beside those of settings. */
    private static final Set<String> OF_MATERIAL = Set.of("mirror", "transmit", "mtl");
    /** The words behind other keywords; a line that begins with one is a heading. */
    private static final Set<String> BEHIND = Stream.concat(Stream.of(Setting.NONE),
        Stream.concat(Arrays.stream(Key.Kind.values()), Arrays.stream(Curve.values())).map(Enum::toString)).collect(Collectors.toSet());
    private static final char COMMENT = '#';
    private static final char QUOTE = '"';

    @Override
    public Token getTokenList(Segment line, int initialType, int offset) {
        resetTokenList();
        int end = line.offset + line.count;
        int shift = offset - line.offset;
        int at = line.offset;
        boolean first = true;
        while (at < end) {
            int from = at;
            int type;
            char c = line.array[at];
            if (isBlank(c)) {
                while (at < end && isBlank(line.array[at])) {
                    at++;
                }
                type = TokenTypes.WHITESPACE;
            } else if (c == COMMENT) {
                at = end;
                type = TokenTypes.COMMENT_EOL;
            } else {
                at = wordEnd(line, at, end);
                String word = new String(line.array, from, at - from);
                type = !first && BEHIND.contains(word) ? TokenTypes.RESERVED_WORD : type(word);
                if (first && type == TokenTypes.ERROR_IDENTIFIER && isHeading(word)) {
                    at = end;
                    type = TokenTypes.COMMENT_DOCUMENTATION;
                }
                first = false;
            }
            addToken(line, from, at - 1, type, from + shift);
        }
        addNullToken();                                       // no token goes on in the next line
        return firstToken;
    }

    private static boolean isBlank(char c) {
        return Character.isWhitespace(c) || Character.isSpaceChar(c);
    }

    private static int wordEnd(Segment line, int from, int end) {
        int at = from;
        if (line.array[at] == QUOTE) {
            int close = at + 1;
            while (close < end && line.array[close] != QUOTE) {
                close++;
            }
            at = close < end ? close + 1 : at;
        }
        while (at < end && !isBlank(line.array[at]) && line.array[at] != COMMENT) {
            at++;
        }
        return at;
    }

    private static int type(String word) {
        if (!Double.isNaN(NumberParser.parseDouble(word))) {
            return TokenTypes.LITERAL_NUMBER_FLOAT;
        }
        if (word.charAt(0) == QUOTE) {
            boolean closed = word.length() > 1 && word.indexOf(QUOTE, 1) == word.length() - 1;
            return closed ? TokenTypes.LITERAL_STRING_DOUBLE_QUOTE : TokenTypes.ERROR_STRING_DOUBLE;
        }
        return OF_MATERIAL.contains(word) || Setting.keywords().contains(word) ? TokenTypes.RESERVED_WORD : TokenTypes.ERROR_IDENTIFIER;
    }

    /** {@return whether a line that begins with the word is skipped} */
    private static boolean isHeading(String word) {
        return Character.isLetter(word.codePointAt(0)) && !word.matches("(?i)(nan|infinity)(?!\\p{L}).*");
    }

    @Override
    public String[] getLineCommentStartAndEnd(int language) {
        return new String[] {"#", null};
    }

    @Override
    public boolean getMarkOccurrencesOfTokenType(int type) {
        return false;
    }
}
