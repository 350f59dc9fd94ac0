package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A word that is one of some, and errors that are noted later than their value is read. */
class SceneReaderWordTest {
    private static final Set<String> COLOURS = Set.of("red", "blue");

    @ParameterizedTest
    @ValueSource(strings = {"red 7", "  red#x\n7", "# a comment\n\n red\n 7", "a heading\nred\n7"})
    void oneOfTheWordsIsRead(String text) throws IOException {
        SceneReader is = reader(text);

        assertThat(is.readWord("red or blue", COLOURS)).isEqualTo("red");
        assertThat(is.readInt()).isEqualTo(7);
    }

    @ParameterizedTest
    @ValueSource(strings = {"reds", "Red", "7", "\"red\""})
    void anotherWordIsRefused(String word) throws IOException {
        SceneReader is = reader("1 " + word);
        is.readInt();

        assertThatThrownBy(() -> is.readWord("red or blue", COLOURS)).isInstanceOf(SceneFormatException.class)
            .hasMessage("<stdin>:1:3: error: expected red or blue, found '" + word + "'\n1 " + word + "\n  ^");
    }

    @Test
    void aMissingWordIsRefused() {
        assertThatThrownBy(() -> reader("reds\n").readWord("red or blue", COLOURS)).isInstanceOf(SceneFormatException.class).hasMessage(
            "<stdin>:2:1: error: expected red or blue, found the end of the file (1 line was skipped as a heading)\n\n^");
    }

    @Test
    void anErrorCanBeNotedAtAValueThatWasReadBefore() throws IOException {
        SceneReader is = reader("1 22\n333 4");
        is.tolerate(2);
        is.readInt();
        is.readInt();
        SourceLocation place = is.location();
        is.readInt();
        is.readInt();
        is.enter("ball", 2);
        is.rejectAt(place, "less", "more");

        assertThatThrownBy(() -> is.complete("the end")).isInstanceOf(SceneFormatException.class)
            .hasMessage("<stdin>:1:3: error: expected ball 2's less, found more\n1 22\n  ^");
        assertThatThrownBy(() -> is.rejectAt(place, "less", "more")).isInstanceOf(SceneFormatException.class).hasMessageEndingWith(
            "2 errors: reading stopped here");
    }
}
