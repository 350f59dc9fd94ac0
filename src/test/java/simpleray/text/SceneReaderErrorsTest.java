package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import org.junit.jupiter.api.Test;

class SceneReaderErrorsTest {
    @Test
    void theFirstErrorThrowsUnlessMoreAreTolerated() {
        assertThatThrownBy(reader("* +")::readDouble).hasMessage(
            "<stdin>:1:1: error: expected a number, found '*'\n* +\n^");
    }

    @Test
    void anErrorNamesTheOwnersOfTheField() throws IOException {
        SceneReader is = reader("* * * *");
        is.tolerate(4);
        is.enter("object", 3);
        is.enter("diffuse");
        is.readDouble("blue");
        is.leave();
        is.readDouble("shininess");
        is.leave();
        is.readDouble("red");

        assertThatThrownBy(is::readDouble).isInstanceOf(SceneFormatException.class).hasMessage("""
            <stdin>:1:1: error: expected object 3's diffuse blue, found '*'
            * * * *
            ^
            <stdin>:1:3: error: expected object 3's shininess, found '*'
            * * * *
              ^
            <stdin>:1:5: error: expected red, found '*'
            * * * *
                ^
            <stdin>:1:7: error: expected a number, found '*'
            * * * *
                  ^
            4 errors: reading stopped here""");
    }

    @Test
    void aToleratedBadNumberReadsAsNaN() throws IOException {
        SceneReader is = reader("* * 1");
        is.tolerate(3);

        assertThat(is.readDouble()).isNaN();
        assertThat(is.readFloat()).isNaN();
        assertThat(is.readDouble()).isEqualTo(1);
        assertThatThrownBy(() -> is.complete("the end")).isInstanceOf(SceneFormatException.class)
            .hasMessage("""
                <stdin>:1:1: error: expected a number, found '*'
                * * 1
                ^
                <stdin>:1:3: error: expected a number, found '*'
                * * 1
                  ^""");
    }

    @Test
    void theTwentiethErrorStopsTheReading() throws IOException {
        SceneReader is = reader("*\n".repeat(21));
        is.tolerate(20);
        for (int i = 1; i < 20; i++) {
            assertThat(is.readDouble()).isNaN();
        }

        SceneFormatException stopped = catchThrowableOfType(SceneFormatException.class, is::readDouble);

        assertThat(stopped.problems()).hasSize(20).extracting(Diagnostic::line).startsWith(1, 2).endsWith(20);
        assertThat(stopped).hasMessageEndingWith(
            "\n<stdin>:20:1: error: expected a number, found '*'\n*\n^\n20 errors: reading stopped here");
    }

    @Test
    void aBadCountThrowsAtOnceWithTheErrorsBeforeIt() throws IOException {
        SceneReader is = reader("* 1.5");
        is.tolerate(20);
        is.readDouble();

        assertThatThrownBy(() -> is.readInt("type", 0, Integer.MAX_VALUE)).hasMessage("""
            <stdin>:1:1: error: expected a number, found '*'
            * 1.5
            ^
            <stdin>:1:3: error: expected type, found '1.5' (an integer has only digits)
            * 1.5
              ^""");
    }

    @Test
    void theEndOfTheFileThrowsAtOnceWithTheErrorsBeforeIt() throws IOException {
        SceneReader is = reader("*");
        is.tolerate(20);
        is.readDouble();

        assertThatThrownBy(() -> is.readDouble("x")).hasMessage("""
            <stdin>:1:1: error: expected a number, found '*'
            *
            ^
            <stdin>:1:2: error: expected x, found the end of the file
            *
             ^""");
    }
}
