package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/** The largest numbers that a shape may have are good, and the next ones are not. */
class LengthsTest {
    private static final String MATERIAL = "  1 1 1  1 1 1  0 0 0  2";
    private static final String END = "\n0 0 0\n0\n";

    private static void read(String object) throws IOException {
        new Scene().read(reader("1\n" + object + MATERIAL + END));
    }

    @ParameterizedTest
    @CsvSource({"0  1e100 -1e100 1e100 1e100", "1  -1e100 1e100 1e100 1e100", "1  0 1 0 -1e100", "2  1e100 0 0  0 1e100 0  0 0 -1e100",
        "3  1e100 0 0  0 -1e100 1e100  1e100"})
    void upTo1e100(String object) throws IOException {
        read(object);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "0  1.1e100 0 0 1 | centre of numbers from -1e100 to 1e100", "0  0 0 -1.1e100 1 | centre of numbers from -1e100 to 1e100",
        "0  0 0 0 1.1e100 | radius of 1e100 or less", "0  0 0 0 0 | radius above 0",
        "1  0 -1.1e100 0 1 | normal of numbers from -1e100 to 1e100", "1  0 1 0 1.1e100 | constant from -1e100 to 1e100",
        "1  0 1 0 -1.1e100 | constant from -1e100 to 1e100", "2  1.1e100 0 0  0 1 0  0 0 1 | vertices of numbers from -1e100 to 1e100",
        "2  0 0 0  0 1 0  0 0 1.1e100 | vertices of numbers from -1e100 to 1e100",
        "3  0 0 0  0 1.1e100 0  1 | ends of numbers from -1e100 to 1e100", "3  0 0 0  0 1 0  1.1e100 | radius of 1e100 or less",
        "3  0 0 0  0 1 0  -1 | radius above 0", "3  1 2 3  1 2 3  1 | two ends that differ",
        "2  1 2 3  1 2 3  4 5 6 | three vertices not on one line", "1  0 -0 0  1 | normal other than zero"})
    void noFarther(String object, String message) {
        SceneFormatException e = catchThrowableOfType(SceneFormatException.class, () -> read(object.strip()));

        assertThat(e.problems()).hasSize(1);
        assertThat(e.problems().get(0)).extracting(Diagnostic::message).asString().startsWith("expected object 1's " + message + ", found '");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "0  0 x 0 1 | centre y", "0  0 0 0 x | radius", "1  0 0 x 1 | normal z", "1  0 1 0 x | constant",
        "2  x 0 0  0 1 0  0 0 1 | first vertex x", "2  1 0 0  0 x 0  0 0 1 | second vertex y", "2  1 0 0  0 1 0  0 0 x | third vertex z",
        "3  x 0 0  0 1 0  1 | first end x", "3  0 0 0  0 x 0  1 | second end y", "3  0 0 0  0 1 0  x | radius"})
    void eachNumberHasItsName(String object, String name) {
        SceneFormatException e = catchThrowableOfType(SceneFormatException.class, () -> read(object.strip()));

        assertThat(e.problems().get(0).message()).isEqualTo("expected object 1's " + name + ", found 'x'");
    }
}
