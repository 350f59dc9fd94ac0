package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/** Frames, keys and curve in a scene file, and what is wrong with them. */
class KeyReaderTest {
    private static final String GREY = "  0 0 0 0.5 0.5 0.5 0 0 0 0\n";
    /** Ten lines: object 1 is a sphere at 1 0 0, 2 a cylinder, 3 a triangle; light 1 is a point light, 2 a directional one. */
    private static final String SCENE = "3\n0 1 0 0 0.5" + GREY + "3 0 0 0 0 1 0 0.25" + GREY + "2 0 0 0 1 0 0 0 1 0" + GREY
        + "0.1 0.1 0.1\n2\n0 1 0.5 0.25 4 5 6\n1 0.5 0.5 0.5 0 -1 0\n# the tenth is the first below\n";
    private static final String FILM = "frames 10 25\n";

    private static Scene scene(String lines) throws IOException {
        Scene scene = new Scene();
        scene.read(reader(SCENE + lines));
        return scene;
    }

    /** {@return the places and messages of the errors; lines count from the first of these} */
    private static List<String> errors(String lines) {
        try {
            scene(lines);
            return List.of();
        } catch (SceneFormatException e) {
            return e.problems().stream().map(KeyReaderTest::told).toList();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static String told(Diagnostic problem) {
        return problem.line() - 9 + ":" + problem.column() + ' ' + problem.message();
    }

    private static Key key(double frame, Key.Kind kind, int number, Double... values) {
        return new Key(frame, new Key.Thing(kind, number), List.of(values));
    }

    @Test
    void aFilmIsReadAndWrittenTheSame() throws IOException {
        String lines = "frames 10 23.976\ncurve linear\nkey 9.0 object 3 1.0 2.0 3.0\nkey 0.5 camera 1.0 2.0 3.0 0.0 0.0 0.0 40.0\n"
            + "key 0.0 light 1 -1.0 0.0 0.0\nkey 0.0 colour 2 0.0 0.5 1.5\n";
        SceneSettings settings = scene(lines).settings;

        assertThat(settings.frames).isEqualTo(new SceneSettings.Frames(10, 23.976));
        assertThat(settings.curve).isEqualTo(Curve.LINEAR);
        assertThat(settings.keys).containsExactly(key(9, Key.Kind.OBJECT, 3, 1.0, 2.0, 3.0),
            key(0.5, Key.Kind.CAMERA, 0, 1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 40.0), key(0, Key.Kind.LIGHT, 1, -1.0, 0.0, 0.0),
            key(0, Key.Kind.COLOUR, 2, 0.0, 0.5, 1.5));
        assertThat(written(scene(lines)::write)).endsWith(lines);
        assertThat(written(scene(lines)::print)).endsWith('\n' + lines);
    }

    @Test
    void anyOrderAndAnyWhiteSpaceWillDo() throws IOException {
        String lines = "key 9 colour 1\n  1 1 1 # white\nresolution 4 3\nkey\n 0\n colour 1 0.5 0.5 0.5\n  curve\n\n smooth\nkey 4\ncolour 1 0.5 0.5 0.5\nframes 10\n 25 # as PAL\n";

        assertThat(scene(lines).settings.lines()).isEqualTo("resolution 4 3\nframes 10 25.0\ncurve smooth\nkey 9.0 colour 1 1.0 1.0 1.0\n"
            + "key 0.0 colour 1 0.5 0.5 0.5\nkey 4.0 colour 1 0.5 0.5 0.5\n");
    }

    @ParameterizedTest
    @CsvSource({"1, 0.0001", "1000000, 1000"})
    void theEndsOfTheRangesAreWithin(int count, double rate) throws IOException {
        assertThat(scene("frames " + count + ' ' + rate).settings.frames).isEqualTo(new SceneSettings.Frames(count, rate));
        assertThat(errors("frames " + count + " 1\nkey 0 object 1 0 0 1\nkey " + (count - 1) + ".0 object 3 0 0 1")).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', value = {
        "frames 0 25 | 8 | frames's number from 1 to 1000000 | '0'", "frames 1000001 25 | 8 | frames's number from 1 to 1000000 | '1000001'",
        "frames 2.0 25 | 8 | frames's number from 1 to 1000000 | '2.0' (an integer has only digits)",
        "frames 2 0 | 10 | frames's frames a second above 0 and up to 1000 | '0'",
        "frames 2 -1 | 10 | frames's frames a second above 0 and up to 1000 | '-1'",
        "frames 2 1000.0000001 | 10 | frames's frames a second above 0 and up to 1000 | '1000.0000001'",
        "frames 2 x | 10 | frames's frames a second | 'x'", "frames 2 | 9 | frames's frames a second | the end of the file",
        "curve curly | 7 | curve's linear or smooth | 'curly'", "curve Linear | 7 | curve's linear or smooth | 'Linear'",
        "curve 1 | 7 | curve's linear or smooth | '1'", "curve | 6 | curve's linear or smooth | the end of the file",
        "key x object 1 0 0 0 | 5 | key's frame | 'x'", "key 0 sphere 1 0 0 0 | 7 | key's camera, object, light or colour | 'sphere'",
        "key 0 1 0 0 0 | 7 | key's camera, object, light or colour | '1'", "key 0 | 6 | key's camera, object, light or colour | the end of the file",
        "key 0 object 0 0 0 0 | 14 | key's object from 1 to 3 | '0'", "key 0 object 4 0 0 0 | 14 | key's object from 1 to 3 | '4'",
        "key 0 object -1 0 0 0 | 14 | key's object from 1 to 3 | '-1'",
        "key 0 object 1.5 0 0 0 | 14 | key's object from 1 to 3 | '1.5' (an integer has only digits)",
        "key 0 light 0 0 0 0 | 13 | key's light from 1 to 2 | '0'", "key 0 light 3 0 0 0 | 13 | key's light from 1 to 2 | '3'",
        "key 0 colour 3 0 0 0 | 14 | key's light from 1 to 2 | '3'",
        "key 0 light 2 0 0 0 | 13 | key's light that is not directional: such a light cannot be moved | '2'",
        "key 0 object 1 0 y 0 | 18 | key's object 1's y | 'y'", "key 0 object 3 0 0 | 19 | key's object 3's z | the end of the file",
        "key 0 object 2 1f 0 0 | 16 | key's object 2's x | '1f' (a number ends with a digit)", "key 0 light 1 0 0 NaN | 19 | key's light 1's z | 'NaN' (numbers must be finite)",
        "key 0 colour 2 0 -0.5 0 | 18 | key's colour 2's green of 0 or more | '-0.5'",
        "key 0 camera 0 0 5 0 0 0 180 | 26 | key's camera's field of view above 0 and below 180 degrees | '180'",
        "key 0 camera 0 0 5 0 0 5 40 | 14 | key's camera's look-at point other than the eye | '0 0 5 0 0 5 40'",
        "key 0 camera 0 0 5 0 0 | 23 | key's camera's look-at z | the end of the file",
        "key -0.5 object 1 0 0 0 | 5 | key's frame from 0 to 9 | '-0.5'", "key 10 object 1 0 0 0 | 5 | key's frame from 0 to 9 | '10'",
        "key 9.000000001 object 1 0 0 0 | 5 | key's frame from 0 to 9 | '9.000000001'"})
    void whatIsWrongIsNamedWithItsPlace(String line, int column, String wanted, String found) {
        boolean film = line.startsWith("frames");

        assertThat(errors((film ? "" : FILM) + line)).containsExactly((film ? 1 : 2) + ":" + column + " expected " + wanted + ", found " + found);
    }

    @Test
    void whereThereIsNothingThatIsSaid() {
        assertThatThrownBy(() -> new Scene().read(reader("0 0 0 0 0\nframes 1 1\nkey 0 object 1 0 0 0"))).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith("<stdin>:3:14: error: expected key's object (the scene has none), found '1'\n");
        assertThatThrownBy(() -> new Scene().read(reader("0 0 0 0 0\nframes 1 1\nkey 0 colour 1 0 0 0"))).isInstanceOf(SceneFormatException.class)
            .hasMessageStartingWith("<stdin>:3:14: error: expected key's light (the scene has none), found '1'\n");
    }

    @Test
    void keysWithoutFramesAreNamedOnce() {
        assertThat(errors("key 0 object 1 0 0 0\nkey 5 object 1 0 0 0\ndepth 3"))
            .containsExactly("1:1 expected the keyword frames, which keys need, found a key");
    }

    @ParameterizedTest
    @CsvSource({"3, 3.0, object 1 0 0 0", "0, -0.0, colour 2 0 0 0", "1e0, 1, light 1 0 0 0", "2.50, 2.5, camera 0 0 5 0 0 0 40"})
    void twoKeysOfOneThingForOneFrameAreAnError(String one, String other, String values) {
        String thing = values.startsWith("camera") ? "camera" : values.substring(0, values.indexOf(' ') + 2);

        assertThat(errors(FILM + "key " + one + ' ' + values + "\nkey 7 object 3 0 0 1\nkey " + other + ' ' + values)).containsExactly(
            "4:5 expected key's frame " + Film.text(Double.parseDouble(one)) + " only once for " + thing + ", found '" + other + ' ' + thing + "'");
    }

    @Test
    void oneFrameMayHaveKeysOfManyThings() {
        assertThat(errors(FILM + "key 0 object 1 0 0 1\nkey 0 object 2 0 0 1\nkey 0 light 1 0 0 0\nkey 0 colour 1 0 0 0\nkey 0 camera 0 0 5 0 0 0 40\n"
            + "key 0.1 object 1 0 0 2")).isEmpty();
    }

    @Test
    void severalMistakesAreToldInOneRun() {
        assertThat(errors(FILM + "key 11 object 1 0 0 0\nkey 1 object 1 0 0 zero\nkey 1 object 1 0 0 0\nkey 99 light 2 0 0 0")).containsExactly(
            "3:20 expected key's object 1's z, found 'zero'", "4:5 expected key's frame 1 only once for object 1, found '1 object 1'",
            "5:14 expected key's light that is not directional: such a light cannot be moved, found '2'",
            "2:5 expected key's frame from 0 to 9, found '11'", "5:5 expected key's frame from 0 to 9, found '99'");
        assertThat(errors(FILM + "key x object 1 0 0 0\nkey y object 1 0 0 0")).containsExactly("2:5 expected key's frame, found 'x'",
            "3:5 expected key's frame, found 'y'");
    }

    @ParameterizedTest
    @ValueSource(strings = {"cop 3", "window -1 1 -1 1", "parallel 0 0 5 0 0 0 4"})
    void aKeyOfTheCameraExcludesOtherCameras(String line) {
        String key = "key 0 camera 0 0 5 0 0 0 40";

        assertThat(errors(FILM + line + '\n' + key)).containsExactly("3:7 expected key's camera without the settings of another one, found 'camera'");
        assertThat(errors(FILM + key + '\n' + line))
            .containsExactly("3:1 expected either camera, or parallel, or window and cop (up goes with the first two), found '"
                + line.split(" ")[0] + "'");
        assertThat(errors(FILM + line + "\nkey 0 object 1 0 0 1")).isEmpty();
        assertThat(errors(FILM + "camera 0 0 2 0 0 0 20\n" + key)).isEmpty();
    }

    @Test
    void upGoesWithKeysOfTheCameraAlone() {
        assertThat(errors(FILM + "key 0 camera 0 0 5 0 0 0 40\nup 1 1 0")).isEmpty();
        assertThat(errors(FILM + "up 1 1 0\nkey 0 camera 0 0 5 0 0 0 40")).isEmpty();
        assertThat(errors(FILM + "up 1 1 0\nkey 0 object 1 0 0 5"))
            .containsExactly("2:1 expected a camera or parallel, which up needs, found up alone");
    }

    /** From (0, 0, 5) to (0, 4, 5), linearly in 4 frames, the camera goes by (0, 2, 5) at frame 2, where the view is along (0, -2, -5). */
    @Test
    void aFrameThatLooksAlongUpIsNamed() {
        String keys = "curve linear\nkey 0 camera 0 0 5 0 0 0 40\nkey 4 camera 0 4 5 0 0 0 40\n";

        assertThat(errors(FILM + keys + "up 0 -4 -10")).containsExactly(
            "3:5 expected frame 2's camera with a view that is not along up, found 0.0 2.0 5.0 0.0 0.0 0.0 40.0");
        assertThat(errors(FILM + "up 0 4 10\n" + keys)).containsExactly(
            "4:5 expected frame 2's camera with a view that is not along up, found 0.0 2.0 5.0 0.0 0.0 0.0 40.0");
        assertThat(errors(FILM + keys + "up 0 5 10")).as("between two frames").isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"frames 10 25", "curve linear"})
    void framesAndCurveStandOnlyOnce(String line) {
        assertThat(errors(line + '\n' + line)).containsExactly("2:1 expected keyword " + line.split(" ")[0] + " only once, found '"
            + line.split(" ")[0] + "'");
    }

    @Test
    void aKeyStandsOnALineOfItsOwn() {
        assertThat(errors(FILM + "depth 3 key 0 object 1 0 0 0")).hasSize(1);
    }

    /** Smooth keys 0, 0, 1 at 0, 4, 8: at 4 the slope is 1/8, and at 1, u = 1/4, the value is -(1/16) (3/4) 4/8 < 0. */
    @Test
    void aColourThatTheCurveTakesBelow0IsAnErrorThatNamesTheFirstSuchFrame() {
        String keys = "key 8 colour 1 1 1 1\nkey 0 colour 1 0 1 1\nkey 4 colour 1 0 1 1\n";

        assertThat(errors(FILM + keys)).containsExactly(
            "3:5 expected frame 1's colour 1 with components of 0 or more, found -0.0234375 1.0 1.0");
        assertThat(errors(FILM + "curve linear\n" + keys)).isEmpty();
        assertThat(errors(FILM + keys.replace(" 0 1 1", " 1 0 1"))).containsExactly(
            "3:5 expected frame 1's colour 1 with components of 0 or more, found 1.0 -0.0234375 1.0");
        assertThat(errors(FILM + keys.replace(" 0 1 1", " 1 1 0"))).containsExactly(
            "3:5 expected frame 1's colour 1 with components of 0 or more, found 1.0 1.0 -0.0234375");
    }

    /** The same curve between frames 0 and 1 is at no frame below 0. */
    @Test
    void onlyFramesCount() {
        assertThat(errors(FILM + "key 2 colour 1 1 1 1\nkey 0 colour 1 0 1 1\nkey 1 colour 1 0 1 1")).isEmpty();
    }

    @Test
    void aCameraThatLooksAtItselfIsAnErrorThatNamesTheFrame() {
        String keys = "curve linear\nkey 0 camera 0 0 5 0 0 0 40\nkey 8 camera 0 0 0 0 0 5 40";

        assertThat(errors(FILM + keys)).containsExactly(
            "3:5 expected frame 4's camera with a look-at point other than the eye, found 0.0 0.0 2.5 0.0 0.0 2.5 40.0");
        assertThat(errors(FILM + keys.replace("key 8", "key 9"))).isEmpty();
    }

    @Test
    void aFieldOfViewOutOfItsRangeIsAnErrorThatNamesTheFrame() {
        String keys = "key 0 camera 0 0 5 0 0 0 160\nkey 4 camera 0 0 5 0 0 0 160\nkey 8 camera 0 0 5 0 0 0 10";

        assertThat(errors(FILM + keys)).isEmpty();
        assertThat(errors(FILM + keys.replace("160", "179"))).hasSize(1).first().asString()
            .isEqualTo("2:5 expected frame 1's camera with a field of view above 0 and below 180 degrees, found 0.0 0.0 5.0 0.0 0.0 0.0 182.9609375");
        assertThat(errors(FILM + keys.replace("160", "1").replace(" 10", " 170"))).hasSize(1).first().asString()
            .startsWith("2:5 expected frame 1's camera with a field of view above 0 and below 180 degrees, found 0.0 0.0 5.0 0.0 0.0 0.0 -");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"object 1 2e100 0 0 | object 1 with numbers from -1e100 to 1e100 | 2.0E100 0.0 0.0",
        "object 2 0 0 1e20 | | ", "object 2 0 1e20 0 | object 2 with two ends that differ | 0.0 1.0E20 0.0",
        "object 3 1e20 0 0 | object 3 with three vertices not on one line | 1.0E20 0.0 0.0",
        "object 3 0 0 -1.1e100 | object 3 with numbers from -1e100 to 1e100 | 0.0 0.0 -1.1E100",
        "light 1 0 1.7976931348623157e308 0 | | "})
    void anObjectThatIsMovedTooFarIsAnErrorThatNamesTheFrame(String key, String wanted, String found) {
        List<String> told = wanted == null ? List.of() : List.of("2:5 expected frame 0's " + wanted + ", found it moved by " + found);

        assertThat(errors(FILM + "key 5 " + key)).isEqualTo(told);
    }

    @Test
    void whatOvershootsOnlyBetweenTwoKeysIsFoundAtItsFrame() {
        assertThat(errors(FILM + "key 0 object 1 0 0 0\nkey 1 object 1 9.9e99 0 0\nkey 5 object 1 9.9e99 0 0\nkey 6 object 1 0 0 0")).hasSize(1)
            .first().asString().startsWith("3:5 expected frame 2's object 1 with numbers from -1e100 to 1e100, found it moved by 1.");
        assertThat(errors(FILM + "key 0 light 1 0 0 0\nkey 1 light 1 1.7e308 0 0\nkey 5 light 1 1.7e308 0 0\nkey 6 light 1 0 0 0")).hasSize(1)
            .first().asString().startsWith("3:5 expected frame 2's light 1 with finite numbers, found it moved by Infinity");
        assertThat(errors(FILM + "curve linear\nkey 0 camera 1.7e308 0 0 0 0 0 40\nkey 3 camera -1.7e308 0 1 0 0 0 40")).containsExactly(
            "3:5 expected frame 1's camera with finite numbers, found -Infinity 0.0 0.3333333333333333 0.0 0.0 0.0 40.0");
        assertThat(errors(FILM + "curve smooth\nkey 0 colour 1 0 0 0\nkey 1 colour 1 1.7e308 0 0\nkey 5 colour 1 1.7e308 0 0\nkey 6 colour 1 0 0 0"))
            .hasSize(1).first().asString().startsWith("4:5 expected frame 2's colour 1 with finite numbers, found Infinity");
    }

    /** The key of a frame that is not whole may be what no frame shows. */
    @Test
    void aConstantEndIsLookedAtWhereItsFirstFrameIs() {
        assertThat(errors(FILM + "curve linear\nkey 0 object 1 0 0 0\nkey 8.5 object 1 2e100 0 0")).hasSize(1).first().asString()
            .startsWith("3:5 expected frame 5's object 1 with");
        assertThat(errors("frames 2 25\ncurve linear\nkey 0 object 1 0 0 0\nkey 0.25 object 1 0 2e100 0")).containsExactly(
            "4:5 expected frame 1's object 1 with numbers from -1e100 to 1e100, found it moved by 0.0 2.0E100 0.0");
        assertThat(errors("frames 3 25\ncurve linear\nkey 0 object 1 0 0 0\nkey 0.25 object 1 0 2e100 0\nkey 0.75 object 1 0 0 0")).isEmpty();
    }

    @Test
    void eachThingThatIsWrongSomewhereIsNamed() {
        assertThat(errors(FILM + "key 5 object 1 2e100 0 0\nkey 5 object 2 2e100 0 0\nkey 5 object 3 2e100 0 0")).hasSize(3);
    }

    @Test
    void aSceneWithAnErrorOfItsFilmStaysWhatItWas() throws IOException {
        Scene scene = scene("depth 3");

        assertThatThrownBy(() -> scene.read(reader(SCENE + FILM + "key 5 object 1 2e100 0 0"))).isInstanceOf(SceneFormatException.class);
        assertThat(scene.settings.lines()).isEqualTo("depth 3\n");
    }

    /** A million frames of fifty things: only those are computed that may be wrong. */
    @Test
    void aMillionFramesAreCheckedAtOnce() {
        String one = "frames 1000000 25\nkey 0 colour 1 0 0 0\nkey 500000 colour 1 0 0 0\nkey 999999 colour 1 1 1 1\n";
        String keys = IntStream.range(0, 50).mapToObj(i -> "key " + 19999 * i + " object 1 " + i % 7 + " 1 1\nkey " + 19999 * i + " camera " + i % 5
            + " 1 5 0 0 0 40\n").collect(Collectors.joining());

        assertThat(errors("frames 1000000 25\n" + keys)).isEmpty();
        assertThat(errors(one)).hasSize(1).first().asString().startsWith("2:5 expected frame 1's colour 1 with components of 0 or more, found -");
    }
}
