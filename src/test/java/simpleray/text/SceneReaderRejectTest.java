package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/** Values that are numbers and yet wrong, and what is left over. */
class SceneReaderRejectTest {
    @Test
    void aValueOutOfItsRangeIsRejectedAtItsPlace() throws IOException {
        SceneReader is = reader("7 -1 2");
        is.readInt();
        is.readDouble();

        assertThatThrownBy(() -> is.reject("radius above 0")).hasMessage(
            "<stdin>:1:3: error: expected radius above 0, found '-1'\n7 -1 2\n  ^");
    }

    @Test
    void aGroupOnOneLineIsQuotedWhole() throws IOException {
        SceneReader is = reader("7 0 0\t0 # zero");
        is.readInt();
        is.group();
        is.readDouble();
        is.readDouble();
        is.readDouble();

        assertThatThrownBy(() -> is.rejectGroup("normal other than zero")).hasMessage(
            "<stdin>:1:3: error: expected normal other than zero, found '0 0\t0'\n7 0 0\t0 # zero\n  ^");
    }

    @Test
    void aGroupOnTwoLinesIsQuotedByItsFirstWord() throws IOException {
        SceneReader is = reader(" 00 0 # one\n0");
        is.group();
        is.readDouble();
        is.readDouble();
        is.readDouble();

        assertThatThrownBy(() -> is.rejectGroup("normal other than zero")).hasMessage(
            "<stdin>:1:2: error: expected normal other than zero, found '00'\n 00 0 # one\n ^");
    }

    @Test
    void stopGivesTheExceptionAtTheValueJustRead() throws IOException {
        SceneReader is = reader("5 6");
        is.readInt();

        assertThat(is.stop("type")).hasMessage("<stdin>:1:1: error: expected type, found '5'\n5 6\n^");
    }

    @Test
    void whatIsLeftAtTheEndIsAnError() throws IOException {
        SceneReader is = reader("1\na heading\n 2 # left");
        is.readInt();

        assertThatThrownBy(() -> is.complete("the end of the scene")).hasMessage(
            "<stdin>:3:2: error: expected the end of the scene, found '2'\n 2 # left\n ^");
    }

    @Test
    void onlyCommentsAndHeadingsMayBeLeft() throws IOException {
        SceneReader is = reader("1\na heading\n# a comment");
        is.readInt();

        is.complete("the end of the scene");

        assertThat(is.eof()).isTrue();
    }
}
