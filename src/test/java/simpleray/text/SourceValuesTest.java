package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** What a reader lists of the values that it reads. */
class SourceValuesTest {
    private final SourceValues values = new SourceValues();

    private static String told(SourceValue value) {
        return value.span().start() + "-" + value.span().end() + ' ' + value.type() + ' ' + value;
    }

    @Test
    void eachValueHasItsPlaceItsTypeAndItsName() throws IOException {
        SceneReader is = reader("12 0 1.5 \"a.obj\"\nup smooth 7");
        is.list(values);
        is.readInt("the number of balls", 0, 100);
        is.enter("ball", 3);
        is.readInt("a kind", 0, 1);
        is.specify(12, "sphere", "kind");
        is.enter("skin", 0);
        is.readDouble("shine");
        is.leave();
        is.readQuoted("a file");
        is.leave();
        assertThat(is.takeKeyword(Set.of("up"))).isEqualTo("up");
        is.readWord("a curve", Set.of("smooth"));
        is.list(null);
        is.readInt();

        assertThat(values.all()).extracting(SourceValuesTest::told).containsExactly("0-2 INTEGER the number of balls",
            "3-4 INTEGER ball 3 of 12, sphere: kind", "5-8 NUMBER ball 3 of 12, sphere: skin shine", "9-16 WORD ball 3 of 12, sphere: a file",
            "17-19 WORD keyword up", "20-26 WORD a curve");
    }

    @Test
    void aWordThatIsNoKeywordIsNotListed() throws IOException {
        SceneReader is = reader("upwards 1");
        is.list(values);

        assertThat(is.takeKeyword(Set.of("up"))).isNull();
        assertThat(values.all()).isEmpty();
    }

    @Test
    void aReaderThatIsNotAskedListsNothing() throws IOException {
        SceneReader is = reader("0 1");
        is.enter("ball", 1);
        is.readInt();
        is.specify(1, "sphere", "kind");
        is.readInt();

        assertThat(values.all()).isEmpty();
    }
}
